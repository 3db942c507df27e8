"""How a service begins and ends: ready, told to stop, with jobs that outlive it."""
import json
import os
import sqlite3
import subprocess
import sys
import tempfile

from running_service import Service, finish, scan_form

failures = []


def expect(right, what):
    if not right:
        failures.append(what)


def refused(*options):
    """The exit status and the line of a service that does not start."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([sys.argv[1], "serve", "--data", os.path.join(folder, "data"),
                              *options], capture_output=True, text=True, timeout=60, check=False)
    return run.returncode, run.stderr


status, line = refused("--port", "0", "--bind", "127.0.0.2")
expect(status == 2 and "API key" in line and line.count("\n") == 1, f"bound without a key: {line}")
status, line = refused("--port", "0", "--bind", "here")
expect(status == 2 and line.count("\n") == 1, f"an address that is none: {status} {line}")

with tempfile.TemporaryDirectory() as folder:
    data = os.path.join(folder, "data")
    with Service("--workers", "0", data=data) as service:
        status, line = refused("--port", str(service.port), "--workers", "0")
        expect(status == 2 and str(service.port) in line, f"a port that is taken: {status} {line}")
        status, _, body = service.ask("POST", "/v1/jobs", *scan_form())
        expect(status == 202, f"not taken: {status} {body}")
        job = json.loads(body)["id"]
        expect(service.stop() == 0, "SIGTERM did not end it well")
    with Service("--workers", "0", data=data) as service:
        status, _, body = service.ask("GET", "/v1/jobs/" + job)
        expect(status == 200 and json.loads(body)["state"] == "queued", "the job did not outlive it")
        # Another process that looks into the store must not take its log along when it leaves.
        store = sqlite3.connect(os.path.join(data, "store.sqlite3"))
        expect(store.execute("SELECT count(*) FROM jobs").fetchone() == (1,), "not one job")
        store.close()
        expect(os.path.exists(os.path.join(data, "store.sqlite3-wal")), "the log is gone")
        status, headers, _ = service.ask("GET", "/v1/jobs/" + job)
        again, _, body = service.ask("GET", "/v1/jobs/" + job,
                                     headers={"If-None-Match": headers["ETag"]})
        expect((again, body) == (304, b""), "the same job was sent twice")
        # Another site's page, and another name for this machine.
        for status, headers in ((403, {"Origin": "http://evil.example"}),
                                (403, {"Sec-Fetch-Site": "cross-site"}),
                                (421, {"Host": "evil.example"}), (421, {"Host": "127.0.0.1.evil"})):
            got, _, _ = service.ask("POST", f"/v1/jobs/{job}/cancel", headers=headers)
            expect(got == status, f"{headers}: {got}")
        own = {"Origin": f"http://127.0.0.1:{service.port}", "Sec-Fetch-Site": "same-origin"}
        got, _, _ = service.ask("POST", f"/v1/jobs/{job}/cancel", headers=own)
        expect(got == 202, f"its own page was refused: {got}")

# A queue takes no more than it may, and again once there is room.
with Service("--workers", "0", REGARMENT_MAX_QUEUE="2") as service:
    answers = [service.ask("POST", "/v1/jobs", *scan_form()) for _ in range(3)]
    expect([status for status, _, _ in answers] == [202, 202, 429], "not two jobs and a full queue")
    expect(json.loads(answers[2][2]).get("code") == "queue_full", f"not full: {answers[2][2]}")
    service.ask("POST", f"/v1/jobs/{json.loads(answers[0][2])['id']}/cancel")
    status, _, body = service.ask("POST", "/v1/jobs", *scan_form())
    expect(status == 202, f"there is room again: {status} {body}")
finish(failures)
