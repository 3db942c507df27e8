"""A service of the program under test, and a client for it; Python's standard library alone."""
import http.client
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import uuid

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCAN = os.path.join(SOURCE, "examples", "data", "skirt-1.mesh.ply")


class Service:
    """Runs `regarment serve` in an empty folder until the `with` block ends."""

    def __init__(self, *options, data=None, **environment):
        self.made = None if data else tempfile.mkdtemp(prefix="regarment-service-")
        self.data = data or self.made
        os.makedirs(self.data, exist_ok=True)
        self.log = open(os.path.join(self.data, "..", os.path.basename(self.data) + ".log"), "a+b")
        command = [sys.argv[1], "serve", "--port", "0", "--data", self.data, *options]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=self.log,
                                        env={**os.environ, **environment})
        line = self.process.stdout.readline().decode()
        if not line.startswith("listening on http://"):
            raise RuntimeError("the service did not start: " + self.log_text())
        self.host, _, port = line.strip().rpartition("/")[2].rpartition(":")
        self.port = int(port)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGKILL)
            self.process.wait()
        self.process.stdout.close()
        self.log.close()
        os.unlink(self.log.name)
        if self.made:
            shutil.rmtree(self.made, ignore_errors=True)

    def log_text(self):
        self.log.flush()
        with open(self.log.name, "rb") as log:
            return log.read().decode()

    def stop(self):
        """Asks it to end, and gives back its exit status."""
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(timeout=30)

    def ask(self, method, path, body=None, headers=None):
        """Status, headers and body of an answer; a dict as body goes as JSON."""
        headers = dict(headers or {})
        if isinstance(body, dict):
            body = json.dumps(body)
            headers.setdefault("Content-Type", "application/json")
        connection = http.client.HTTPConnection(self.host, self.port, timeout=60)
        try:
            connection.request(method, path, body, headers)
            response = connection.getresponse()
            return response.status, dict(response.getheaders()), response.read()
        finally:
            connection.close()

    def memory(self):
        """Resident bytes of the server."""
        with open(f"/proc/{self.process.pid}/status") as status:
            for line in status:
                if line.startswith("VmRSS:"):
                    return int(line.split()[1]) * 1024
        raise RuntimeError("no VmRSS")


def form(fields):
    """A multipart form: {name: text or (file name, bytes)}; its body and headers."""
    boundary = uuid.uuid4().hex
    parts = []
    for name, value in fields.items():
        head = f'Content-Disposition: form-data; name="{name}"'
        data = value if isinstance(value, str) else value[1]
        if not isinstance(value, str):
            head += f'; filename="{value[0]}"'
        data = data.encode() if isinstance(data, str) else data
        parts.append(f"--{boundary}\r\n{head}\r\n\r\n".encode() + data + b"\r\n")
    parts.append(f"--{boundary}--\r\n".encode())
    return b"".join(parts), {"Content-Type": f"multipart/form-data; boundary={boundary}"}


def scan_form(**fields):
    with open(SCAN, "rb") as scan:
        return form({"scan": ("skirt-1.mesh.ply", scan.read()), "garments": '["skirt"]', **fields})


def finish(failures):
    """Ends the program: says what failed."""
    for failure in failures:
        print("FAILED:", failure)
    sys.exit(1 if failures else 0)
