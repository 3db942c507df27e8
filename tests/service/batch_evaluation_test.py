"""The finished fits of a batch beside their truth: what the page's figures say is worked out here
again from the results themselves, and nothing is fitted for it."""
import csv
import io
import json
import os
import sys

from running_service import SOURCE, Service, finish, form, scan_form

failures = []


def expect(right, what):
    if not right:
        failures.append(what)


def ended(service, job):
    """The job once it has ended: its events come until then."""
    service.ask("GET", f"/v1/jobs/{job}/events")
    return json.loads(service.ask("GET", f"/v1/jobs/{job}")[2])


def evaluated(service, batch, *request):
    status, headers, body = service.ask("POST", f"/v1/batches/{batch}/evaluation", *request)
    expect(status == 202, f"not taken: {status} {body}")
    job = ended(service, headers["Location"].rpartition("/")[2])
    expect(job["state"] == "succeeded", f"not evaluated: {job['error']}")
    return job, json.loads(service.ask("GET", f"/v1/jobs/{job['id']}/evaluation.json")[2])


def lengths(service, job):
    result = json.loads(service.ask("GET", f"/v1/jobs/{job}/result.json")[2])
    return {m["name"]: m["value_cm"] for m in result["garments"][0]["measurements"]}


def check_errors(evaluation, values, truth, report):
    scan = evaluation["scans"][0]
    expect(scan["report"] == report, f"another report: {scan.get('report')}")
    found = {one["measurement"]: one["error_cm"] for one in scan["dimensions"]}
    expect(sorted(found) == sorted(truth), f"not the dimensions of the truth: {sorted(found)}")
    for name, value in truth.items():
        # Both are rounded to four digits after the point at the latest.
        expect(abs(found[name] - (values[name] - value)) < 2e-4, f"{name}: {found[name]}")


with open(os.path.join(SOURCE, "examples", "data", "ground_truth.csv")) as file:
    TABLE = file.read()
TRUTH = {row["measurement"]: float(row["value_cm"]) for row in csv.DictReader(io.StringIO(TABLE))
         if row["scan"] == "skirt-1"}

with Service("--workers", "1") as service:
    batch = json.loads(service.ask("POST", "/v1/batches", {"name": "one"})[2])["id"]
    body, headers = scan_form(batch=batch, options='{"method": "direct"}')
    first = json.loads(service.ask("POST", "/v1/jobs", body, headers)[2])["id"]
    expect(ended(service, first)["state"] == "succeeded", "the fit failed")

    address = f"/v1/batches/{batch}/evaluation"
    status, _, body = service.ask("POST", address)
    expect((status, json.loads(body)["code"]) == (422, "no_truth"), f"without truth: {status} {body}")
    for wrong in ("a,b\n1,2\n", "scan,measurement,value_cm\n"):
        status, _, body = service.ask("POST", address, *form({"ground_truth": ("t.csv", wrong)}))
        expect(status == 422, f"a table that says nothing: {status} {body}")
    status, _, _ = service.ask("POST", address, *form({"table": ("t.csv", TABLE)}))
    expect(status == 400, f"a part that is none: {status}")

    _, evaluation = evaluated(service, batch, *form({"ground_truth": ("t.csv", TABLE)}))
    scans = {scan["name"]: scan for scan in evaluation["scans"]}
    expect(sum("failure" not in scan for scan in scans.values()) == 1,
           f"not one scan has a result: {list(scans)}")
    check_errors(evaluation, lengths(service, first), TRUTH, f"/v1/jobs/{first}/report")
    status, fields, page = service.ask("GET", address)
    expect(status == 200 and f"/v1/jobs/{first}/report".encode() in page, f"its page: {status}")
    expect("default-src" in fields["Content-Security-Policy"] or
           "sandbox" in fields["Content-Security-Policy"], "a page without a policy")

    # Fitted again with a known length: the newer result counts.
    status, _, body = service.ask("POST", f"/v1/jobs/{first}/refit",
                                  {"options": {"method": "direct", "fix": {"length": 60}}})
    second = json.loads(body)["id"]
    expect(ended(service, second)["state"] == "succeeded", "the second fit failed")
    values = lengths(service, second)
    expect(values["length"] == 60, f"the length was not held: {values}")
    job, evaluation = evaluated(service, batch, *form({"ground_truth": ("t.csv", TABLE),
                                                       "name": "corrected"}))
    expect(job["name"] == "corrected" and job["batch"] == batch, f"its name and batch: {job}")
    check_errors(evaluation, values, TRUTH, f"/v1/jobs/{second}/report")
    status, fields, _ = service.ask("GET", address)
    expect(fields.get("Content-Location") == f"/v1/jobs/{job['id']}/report",
           "not the newest evaluation")

    # Sent with its truth, under a name that no table should stumble over: no table is needed.
    truth = "template,measurement,value_cm\nskirt,length,55\n"
    body, headers = scan_form(batch=batch, options='{"method": "direct"}', name='=a, "b"',
                              ground_truth=("t.csv", truth))
    third = json.loads(service.ask("POST", "/v1/jobs", body, headers)[2])["id"]
    job = ended(service, third)
    expect(job["state"] == "succeeded", f"with its truth: {job['error']}")
    _, evaluation = evaluated(service, batch)
    check_errors(evaluation, lengths(service, third), {"length": 55}, f"/v1/jobs/{third}/report")
finish(failures)
