"""What hostile clients cost a service: memory, and the time of /healthz meanwhile.

    hostile_test.py PROGRAM          a small version, for every run of the tests
    hostile_test.py PROGRAM --full   the whole: 1,000 slow connections, floods of 200 MB, 1,200
                                     ranges, an upload of 300 MB; prints figures
"""
import os
import socket
import sys
import threading
import time

from running_service import Service, finish

FULL = "--full" in sys.argv
# A sanitizer keeps freed memory and is slow: there only what is answered counts.
STRICT = FULL
MEGA = 1 << 20
failures = []


def connect(service):
    connection = socket.create_connection((service.host, service.port), timeout=60)
    return connection


def flood(service, head, block, size):
    """Sends until `size` bytes are sent or the peer has enough; its status, or 0."""
    with connect(service) as connection:
        sent = 0
        try:
            connection.sendall(head)
            while sent < size:
                connection.sendall(block)
                sent += len(block)
        except OSError:
            pass
        try:
            answer = connection.recv(4096)
        except OSError:
            answer = b""
        return int(answer[9:12]) if answer.startswith(b"HTTP/1.1 ") else 0


class Health(threading.Thread):
    """Asks /healthz all the time, and keeps the longest answer."""

    def __init__(self, service):
        super().__init__(daemon=True)
        self.service, self.worst, self.over = service, 0.0, threading.Event()

    def run(self):
        while not self.over.wait(0.01):
            begin = time.monotonic()
            status, _, _ = self.service.ask("GET", "/healthz")
            self.worst = max(self.worst, time.monotonic() - begin)
            if status != 200:
                failures.append(f"/healthz answered {status}")


def measure(service, name, attack):
    before, health = service.memory(), Health(service)
    health.start()
    answer = attack()
    grown = service.memory() - before
    health.over.set()
    health.join()
    print(f"{name}: answered {answer}, memory {grown / MEGA:+.1f} MiB, "
          f"/healthz at worst {health.worst * 1000:.0f} ms")
    if STRICT and grown > 32 * MEGA:
        failures.append(f"{name}: memory grew by {grown / MEGA:.1f} MiB")
    return answer


def slow(service, count):
    """Connections that never finish their header, all open at once."""
    connections = [connect(service) for _ in range(count)]
    for connection in connections:
        connection.sendall(b"GET / HTTP/1.1\r\nHost: a\r\nX: ")
    time.sleep(2 if FULL else 0.2)  # for /healthz to be asked meanwhile
    for connection in connections:
        connection.close()
    return count


size = 200 * MEGA if FULL else 4 * MEGA
post = (b"POST /v1/jobs?garments=skirt&filename=a.obj HTTP/1.1\r\nHost: localhost\r\n"
        b"Content-Type: application/octet-stream\r\n")
with Service("--workers", "0") as service:
    service.ask("GET", "/v1/jobs")  # what is loaded once is no growth
    measure(service, "slow connections", lambda: slow(service, 1000 if FULL else 50))
    for name, wanted, head, block in (
            ("a request line without end", 414, b"GET /", b"a" * 65536),
            ("a field without end", 431, b"GET / HTTP/1.1\r\nHost: a\r\nX: ", b"a" * 65536),
            ("fields without end", 431, b"GET / HTTP/1.1\r\nHost: a\r\n", b"X: y\r\n" * 10000),
            ("a negative chunk", 400, post + b"Transfer-Encoding: chunked\r\n\r\n",
             b"-2\r\n" + b"a" * 65536),
            ("a chunk size without end", 400, post + b"Transfer-Encoding: chunked\r\n\r\n",
             b"1" * 65536)):
        answer = measure(service, name, lambda h=head, b=block: flood(service, h, b, size))
        if answer not in (wanted, 0):
            failures.append(f"{name}: {answer}, not {wanted}")
    ranges = "bytes=" + ",".join("0-" for _ in range(1200))
    answer = measure(service, "1,200 ranges", lambda: service.ask(
        "GET", "/openapi.json", headers={"Range": ranges})[0])
    if answer != 200:
        failures.append(f"1,200 ranges: {answer}")

with Service("--workers", "0", REGARMENT_MAX_UPLOAD_MB="2") as service:
    chunk = b"10000\r\n" + b"x" * 65536 + b"\r\n"
    answer = measure(service, "chunks beyond the limit", lambda: flood(
        service, post + b"Transfer-Encoding: chunked\r\n\r\n", chunk, size))
    if answer not in (413, 0):
        failures.append(f"chunks beyond the limit: {answer}")

with Service("--workers", "0") as service:
    service.ask("GET", "/v1/jobs")
    length = 300_000_000 if FULL else 3_000_000
    line = b"v 0.123456 0.654321 1.234567\n"
    total = length // len(line) * len(line)
    head = post + b"Content-Length: %d\r\nConnection: close\r\n\r\n" % total
    peak, before, begin = [0], service.memory(), time.monotonic()
    over = threading.Event()

    def watch():
        while not over.wait(0.02):
            peak[0] = max(peak[0], service.memory())

    watcher = threading.Thread(target=watch)
    watcher.start()
    with connect(service) as connection:
        connection.sendall(head)
        sent, block = 0, line * 2048
        while sent < total:
            piece = block[:total - sent]
            connection.sendall(piece)
            sent += len(piece)
        answer = connection.recv(4096)
    seconds = time.monotonic() - begin
    over.set()
    watcher.join()
    grown = peak[0] - before
    print(f"upload of {total / 1e6:.0f} MB: {answer[9:12].decode()}, "
          f"{total / 1e6 / seconds:.0f} MB/s, memory {grown / MEGA:+.1f} MiB")
    if answer[9:12] != b"202":
        failures.append(f"the upload was answered {answer[:200]!r}")
    if STRICT and grown > 40 * MEGA:
        failures.append(f"the upload cost {grown / MEGA:.1f} MiB")
    if not os.listdir(os.path.join(service.data, "jobs")):
        failures.append("the upload made no job")
finish(failures)
