"""Every bad file that the reader is tested against, sent to a service: each gets an answer with a
code and one line, at once or as the job's error, and the service goes on.

    bad_scans_test.py PROGRAM WRITE_BAD_FILES
"""
import json
import os
import subprocess
import sys
import tempfile

from running_service import Service, finish, form, scan_form

failures = []


def expect(right, what):
    if not right:
        failures.append(what)


def is_line(text):
    return bool(text.strip()) and "\n" not in text and "/tmp/" not in text


def ended(service, job):
    """The job once it has ended: its events come until then."""
    service.ask("GET", f"/v1/jobs/{job}/events")
    return json.loads(service.ask("GET", f"/v1/jobs/{job}")[2])


with tempfile.TemporaryDirectory() as folder, Service("--workers", "2") as service:
    subprocess.run([sys.argv[2], folder], check=True)
    jobs, refused = {}, 0
    for number in sorted(os.listdir(folder), key=int):
        name, = os.listdir(os.path.join(folder, number))
        with open(os.path.join(folder, number, name), "rb") as file:
            safe = "".join(c if c.isprintable() and c not in '"\\' else "_" for c in name)
            body, headers = form({"scan": (safe, file.read()), "garments": '["skirt"]'})
        status, _, answer = service.ask("POST", "/v1/jobs", body, headers)
        answer = json.loads(answer)
        if status == 202:
            jobs[answer["id"]] = name
            continue
        refused += 1
        expect(400 <= status < 500 and answer.get("code") and is_line(answer.get("detail", "")),
               f"{name}: {status} {answer}")
    for job, name in jobs.items():
        found = ended(service, job)
        error = found.get("error") or {}
        expect(found["state"] == "failed" and error.get("code") and is_line(error["message"]),
               f"{name}: {found['state']} {error}")
    expect(len(jobs) + refused >= 40, f"only {len(jobs) + refused} files were sent")
    status, _, answer = service.ask("POST", "/v1/jobs", *scan_form())
    good = ended(service, json.loads(answer)["id"])
    expect(good["state"] == "succeeded", f"a good scan after them: {good}")
    print(f"{len(jobs)} bad scans ended as failed jobs, {refused} were refused at once")
finish(failures)
