"""Every route of schemas/openapi.json is answered as the description says, status and body."""
import hashlib
import json
import os
import sqlite3
import sys

from running_service import SCAN, SOURCE, Service, finish, form, scan_form

with open(os.path.join(SOURCE, "schemas", "openapi.json")) as file:
    API = json.load(file)
failures, answered = [], set()


def resolve(node):
    while "$ref" in node:
        target = API
        for step in node["$ref"][2:].split("/"):
            target = target[step]
        node = target
    return node


TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None)}


def has_type(value, name):
    if name == "number":
        return isinstance(value, (int, float)) and not isinstance(value, bool)
    if name == "integer":
        return isinstance(value, int) and not isinstance(value, bool)
    return isinstance(value, TYPES[name])


def check(value, schema, where):
    """The part of JSON Schema that the description uses."""
    schema = resolve(schema)
    types = schema.get("type", [])
    types = [types] if isinstance(types, str) else types
    if types and not any(has_type(value, t) for t in types):
        failures.append(f"{where}: {value!r} is no {types}")
        return
    if "enum" in schema and value not in schema["enum"]:
        failures.append(f"{where}: {value!r} is none of {schema['enum']}")
    if "minimum" in schema and value < schema["minimum"]:
        failures.append(f"{where}: {value!r} is below {schema['minimum']}")
    if isinstance(value, dict):
        for name in schema.get("required", []):
            if name not in value:
                failures.append(f"{where}: has no {name}")
        known = schema.get("properties", {})
        extra = schema.get("additionalProperties")
        for name, member in value.items():
            if name in known:
                check(member, known[name], f"{where}/{name}")
            elif isinstance(extra, dict):
                check(member, extra, f"{where}/{name}")
    if isinstance(value, list) and "items" in schema:
        for place, member in enumerate(value):
            check(member, schema["items"], f"{where}/{place}")


def ask(service, method, pattern, wanted, body=None, headers=None, query="", **names):
    """Asks, and holds the answer to the description of this method and status."""
    path = pattern
    for name, value in names.items():
        path = path.replace("{" + name + "}", value)
    status, fields, content = service.ask(method, path + query, body, headers)
    where = f"{method} {pattern} {status}"
    if status != wanted:
        failures.append(f"{where}: {wanted} was expected: {content[:300]!r}")
        return fields, None
    described = API["paths"][pattern][method.lower()]["responses"].get(str(status))
    if described is None:
        failures.append(f"{where}: not described")
        return fields, None
    answered.add((pattern, method.lower()))
    described = resolve(described)
    for name in described.get("headers", {}):
        if name not in fields:
            failures.append(f"{where}: no header {name}")
    kind = fields.get("Content-Type", "").partition(";")[0]
    media = described.get("content", {})
    if status not in (204, 304) and kind not in media and "*/*" not in media:
        failures.append(f"{where}: {kind} is not described")
        return fields, None
    value = json.loads(content) if kind.endswith("json") else content
    if kind in media:
        check(value, media[kind]["schema"], where) if kind.endswith("json") else None
    return fields, value


def claim(service, job):
    """What a worker's claim of this job is to the store."""
    with sqlite3.connect(os.path.join(service.data, "store.sqlite3")) as store:
        store.execute("UPDATE jobs SET state = 'running', token = 1 WHERE id = ?", (job,))


def hand_back(service, job):
    with sqlite3.connect(os.path.join(service.data, "store.sqlite3")) as store:
        store.execute("UPDATE jobs SET state = 'queued' WHERE id = ?", (job,))


def check_work(service, job):
    """What a worker asks for that does not share the service's folder."""
    names, query = {"id": job}, "?token=1"
    ask(service, "GET", "/v1/work", 200)
    ask(service, "POST", "/v1/work/{id}/start", 409, query=query, **names)
    claim(service, job)
    ask(service, "POST", "/v1/work/{id}/start", 400, **names)
    _, list_ = ask(service, "POST", "/v1/work/{id}/start", 200, query=query, **names)
    with open(SCAN, "rb") as file:
        scan = file.read()
    if list_["files"] != [{"name": job + "/scan.ply", "bytes": len(scan),
                           "sha256": hashlib.sha256(scan).hexdigest()}]:
        failures.append(f"not what the job reads: {list_}")
    path = "/v1/work/{id}/files/{file}"
    _, sent = ask(service, "GET", path, 200, query=query, file=job + "/scan.ply", **names)
    if sent != scan:
        failures.append("another scan than was sent")
    ask(service, "GET", path, 206, query=query, file=job + "/scan.ply", **names,
        headers={"Range": "bytes=1-2"})
    ask(service, "GET", path, 404, query=query, file=job + "/none", **names)
    path = "/v1/work/{id}/result/{file}"
    hashed = query + "&sha256=" + hashlib.sha256(b"report").hexdigest()
    ask(service, "PUT", path, 204, b"report", query=hashed, file="report.html", **names)
    ask(service, "PUT", path, 422, b"retort", query=hashed, file="report.html", **names)
    ask(service, "PUT", path, 400, b"report", query=hashed, file=".hidden", **names)
    path = "/v1/work/{id}/result"
    files = {"files": [{"name": "report.html", "bytes": 6}]}
    ask(service, "POST", path, 400, {}, query=query, **names)
    ask(service, "POST", path, 409, {"files": files["files"] * 2 + [{"name": "x", "bytes": 1}]},
        query=query, **names)
    ask(service, "POST", path, 200, files, query=query, **names)
    hand_back(service, job)


with Service("--workers", "0") as service:
    for path in ("/healthz", "/version", "/openapi.json", "/metrics", "/v1/templates",
                 "/v1/batches", "/v1/jobs"):
        ask(service, "GET", path, 200)
    ask(service, "GET", "/readyz", 503)  # there is no worker
    ask(service, "GET", "/v1/templates/{name}", 200, name="skirt")
    ask(service, "GET", "/v1/templates/{name}", 404, name="toga")
    _, batch = ask(service, "POST", "/v1/batches", 201, {"name": "three"})
    ask(service, "POST", "/v1/batches", 400, {"nam": "three"})
    ask(service, "POST", "/v1/batches", 415, b"x", {"Content-Type": "text/html"})
    ask(service, "GET", "/v1/batches/{id}", 200, id=batch["id"])
    ask(service, "GET", "/v1/batches/{id}", 404, id="0" * 24)
    for status, name in ((404, batch["id"]), (404, "0" * 24)):
        ask(service, "GET", "/v1/batches/{id}/evaluation", status, id=name)
    for status, name in ((409, batch["id"]), (404, "0" * 24)):
        ask(service, "POST", "/v1/batches/{id}/evaluation", status, id=name)

    body, headers = scan_form(batch=batch["id"], options='{"method": "direct"}')
    fields, job = ask(service, "POST", "/v1/jobs", 202, body, headers)
    if fields.get("Location") != "/v1/jobs/" + job["id"]:
        failures.append("Location is not the job's address")
    ask(service, "GET", "/v1/jobs", 200, query="?state=queued,running&limit=1&kind=fit&text=skirt")
    for query in ("?state=lost", "?limit=0", "?limit=x", "?colour=red", "?reviewed=2", "?kind=x"):
        ask(service, "GET", "/v1/jobs", 400, query=query)
    ask(service, "GET", "/v1/jobs/{id}", 200, id=job["id"])
    for name in ("1" * 24, "x", "..x"):
        ask(service, "GET", "/v1/jobs/{id}", 404, id=name)

    # The same key: the same job; for something else, refused.
    keyed = {"Idempotency-Key": "k-1"}
    body, headers = scan_form()
    _, first = ask(service, "POST", "/v1/jobs", 202, body, {**headers, **keyed})
    body, headers = scan_form()  # another boundary, the same parts
    _, again = ask(service, "POST", "/v1/jobs", 202, body, {**headers, **keyed})
    if first["id"] != again["id"]:
        failures.append("one Idempotency-Key made two jobs")
    body, headers = scan_form(options='{"seed": 2}')
    ask(service, "POST", "/v1/jobs", 422, body, {**headers, **keyed})

    # What is wrong is told before a job is made.
    with open(os.path.join(SOURCE, "README.md"), "rb") as text:
        readme = text.read()
    for status, fields in ((422, {"garments": "[]"}), (422, {"garments": '["toga"]'}),
                           (422, {"options": '{"out": "/etc"}'}), (422, {"options": "[]"}),
                           (422, {"options": '{"fix": {"hemm": 3}}'}), (422, {"kind": "dance"}),
                           (422, {"options": '{"placement": "/etc/passwd"}'}),
                           (422, {"batch": "1" * 24}), (400, {"colour": "red"}),
                           (413, {"options": "x" * 70000}),
                           (422, {"ground_truth": ("t.csv", "a,b\n1,2\n")}),
                           (415, {"scan": ("a.txt", readme)}),
                           (415, {"scan": ("a.ply", b"\x1f\x8b0123")}),
                           (422, {"scan": ("a.ply", b"")})):
        body, headers = scan_form(**fields)
        ask(service, "POST", "/v1/jobs", status, body, headers)
    ask(service, "POST", "/v1/jobs", 422, *form({"garments": '["skirt"]'}))
    ask(service, "POST", "/v1/jobs", 415, b"{}", {"Content-Type": "application/json"})
    ask(service, "POST", "/v1/jobs", 400, b"x", {"Content-Type": "multipart/form-data"})

    # A scan alone, the rest as query.
    obj = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    raw = {"Content-Type": "application/octet-stream"}
    ask(service, "POST", "/v1/jobs", 202, obj, raw, "?garments=skirt&filename=a.obj&name=A")
    ask(service, "POST", "/v1/jobs", 415, obj, raw, "?garments=skirt")

    check_work(service, job["id"])
    for name in ("refit", "review"):
        body = {"options": {}, "verdict": "accepted"}
        ask(service, "POST", "/v1/jobs/{id}/" + name, 409, body, id=job["id"])
    ask(service, "DELETE", "/v1/jobs/{id}/review", 409, id=job["id"])
    for name in ("report", "checks"):
        ask(service, "GET", "/v1/jobs/{id}/" + name, 404, id=job["id"])
    ask(service, "GET", "/v1/jobs/{id}/{file}", 404, id=job["id"], file="result.json")
    ask(service, "POST", "/v1/jobs/{id}/requeue", 409, id=job["id"])
    ask(service, "POST", "/v1/jobs/{id}/cancel", 202, id=job["id"])
    ask(service, "POST", "/v1/jobs/{id}/cancel", 409, id=job["id"])
    _, events = ask(service, "GET", "/v1/jobs/{id}/events", 200, id=job["id"])
    if events.count(b"\nevent: state\n") != 2 or not events.startswith(b"id: 1\n"):
        failures.append(f"not the two states of a cancelled job: {events!r}")
    _, later = ask(service, "GET", "/v1/jobs/{id}/events", 200, id=job["id"],
                   headers={"Last-Event-ID": "1"})
    if not later.startswith(b"id: 2\n"):
        failures.append(f"Last-Event-ID 1 is not followed by event 2: {later!r}")
    ask(service, "GET", "/v1/jobs/{id}/events", 400, id=job["id"], headers={"Last-Event-ID": "x"})
    ask(service, "POST", "/v1/jobs/{id}/requeue", 202, id=job["id"])
    ask(service, "DELETE", "/v1/jobs/{id}", 204, id=job["id"])
    ask(service, "DELETE", "/v1/jobs/{id}", 404, id=job["id"])
    if os.path.exists(os.path.join(service.data, "jobs", job["id"])):
        failures.append("the files of a deleted job are there")

    with open(os.path.join(SOURCE, "examples", "data", "ground_truth.csv")) as table:
        body, headers = form({"table": ("t.csv", table.read()), "a": ("a.obj", obj)})
    ask(service, "POST", "/v1/evaluations", 202, body, headers)
    ask(service, "POST", "/v1/evaluations", 422,
        *form({"table": ("t.csv", "scan\n"), "a": ("../a.obj", obj)}))
    ask(service, "POST", "/v1/session", 401, {"key": "rgm_none"})
    ask(service, "DELETE", "/v1/session", 204)
    if os.listdir(os.path.join(service.data, "incoming")):
        failures.append("something is left of a refused upload")
    log = service.log_text()
    for word in ("skirt-1", "a.obj", job["id"]):
        if word in log:
            failures.append(f"the log has '{word}'")

for path, methods in API["paths"].items():
    for method in methods:
        if (path, method) not in answered:
            failures.append(f"{method.upper()} {path} was never answered as described")
print(f"{len(answered)} operations answered as described")
finish(failures)
