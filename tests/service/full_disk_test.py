"""A disk that is full while a scan arrives and while it is fitted, and has room again: typed answers,
nothing half done, and the service goes on. Mounts a small file system, which needs rights; ends with
77, which CTest counts as skipped, where it has none."""
import json
import os
import subprocess
import sys
import tempfile

from running_service import Service, finish, scan_form

failures = []


def expect(right, what):
    if not right:
        failures.append(what)


def mount(folder, *options):
    return subprocess.run(["mount", "-t", "tmpfs", "-o", ",".join(options), "tmpfs", folder],
                          capture_output=True, check=False).returncode == 0


def ended(service, job):
    """The job once it has ended: its events come until then."""
    service.ask("GET", f"/v1/jobs/{job}/events")
    return json.loads(service.ask("GET", f"/v1/jobs/{job}")[2])


with tempfile.TemporaryDirectory() as folder:
    data = os.path.join(folder, "data")
    os.mkdir(data)
    if not mount(data, "size=7m", "mode=700"):
        print("skipped: no file system can be mounted here")
        sys.exit(77)
    try:
        with Service("--workers", "1", data=data, REGARMENT_MIN_FREE_MB="0") as service:
            status, _, answer = service.ask("POST", "/v1/jobs", *scan_form())
            expect(status == 202, f"a scan that fits: {status} {answer}")
            job = json.loads(answer)["id"]
            found = ended(service, job)
            expect(found["state"] == "dead" and found["attempts"] == 3, f"without room: {found}")
            expect("\n" not in found["error"]["message"], f"more than a line: {found['error']}")

            filler = os.path.join(data, "filler")
            try:
                with open(filler, "wb", buffering=0) as file:
                    while file.write(b"x" * 65536) > 0:
                        pass
            except OSError:
                pass  # full, perhaps already
            status, _, answer = service.ask("POST", "/v1/jobs", *scan_form())
            expect(status == 507 and json.loads(answer)["code"], f"a full disk: {status} {answer}")
            expect(service.ask("GET", "/healthz")[0] == 200, "it is gone")
            expect(service.ask("GET", "/readyz")[0] == 503, "it calls itself ready")

            if os.path.exists(filler):
                os.unlink(filler)
            subprocess.run(["mount", "-o", "remount,size=200m", data], check=True)
            status, _, answer = service.ask("POST", f"/v1/jobs/{job}/requeue")
            expect(status in (200, 202), f"not taken up again: {status} {answer}")
            found = ended(service, job)
            expect(found["state"] == "succeeded", f"with room again: {found}")
            status, _, report = service.ask("GET", f"/v1/jobs/{job}/report")
            expect(status == 200 and report.rstrip().endswith(b"</html>"), f"its report: {status}")
    finally:
        subprocess.run(["umount", "-l", data], check=False)
finish(failures)
