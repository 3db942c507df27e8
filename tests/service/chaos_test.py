"""The service under fire: `serve` and its workers are killed without warning while a client submits
jobs, and started again. Every job must end once, none lost, none twice, every result whole.

  chaos_test.py PROGRAM JOBS SERVER_KILLS WORKER_KILLS

The full measure is 200 jobs, 5 and 50 kills; it prints one line of figures. The jobs are real and
quick: pictures of a mesh of twelve triangles. The client does what one should: it sends a job again
under its Idempotency-Key until it has an answer."""
import http.client
import json
import os
import random
import signal
import sqlite3
import sys
import tempfile
import threading
import time

from running_service import Service, finish, form

JOBS, SERVER_KILLS, WORKER_KILLS = (int(word) for word in sys.argv[2:5])
PATIENCE = 1200  # s
# A box of the size of a person, its corners counted in binary.
CORNERS = [(i & 1, i >> 1 & 1, 2 * (i >> 2)) for i in range(8)]
FACES = ((0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4),
         (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5))
SCAN = "\n".join([f"v {x} {y} {z}" for x, y, z in CORNERS] +
                 [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in FACES]) + "\n"
AWAY = (OSError, http.client.HTTPException)  # what a client sees of a server that was killed
failures = []


class Home:
    """The service that runs now; another one after each kill."""

    def __init__(self, data):
        self.data = data
        self.kills = 0
        self.service = self.start()

    def start(self):
        return Service("--workers", "2", data=self.data, REGARMENT_LEASE_SECONDS="2",
                       REGARMENT_MAX_ATTEMPTS="100")

    def kill(self):
        self.service.__exit__()
        self.kills += 1
        self.service = self.start()

    def ask(self, *request):
        """As Service.ask, of whatever service there is, until one answers."""
        until = time.monotonic() + 60
        while True:
            try:
                return self.service.ask(*request)
            except AWAY:
                if time.monotonic() > until:
                    raise


def submit(home, ids):
    body, headers = form({"scan": ("box.obj", SCAN), "kind": "render"})
    for i in range(JOBS):
        status = 0
        while status != 202:
            status, _, answer = home.ask("POST", "/v1/jobs", body,
                                         {**headers, "Idempotency-Key": f"job-{i}"})
            if status not in (202, 429, 503, 507):
                failures.append(f"job {i}: {status} {answer[:200]}")
                return
        ids.append(json.loads(answer)["id"])


def children(process):
    try:
        with open(f"/proc/{process}/task/{process}/children") as file:
            return [int(word) for word in file.read().split()]
    except OSError:
        return []


def busy_workers(process):
    """Workers that have a child of their own just now: a job."""
    return [worker for worker in children(process) if children(worker)]


def ended(home):
    """How many jobs have, by the metrics."""
    metrics = home.ask("GET", "/metrics")[2].decode()
    return sum(int(line.rpartition(" ")[2]) for line in metrics.splitlines()
               if line.startswith("regarment_jobs{") and
               not any(f'"{state}"' in line for state in ("queued", "running")))


def fire(home, dice):
    """Kills, spread over the jobs, until all have ended; how many workers were killed."""
    killed, begin = 0, time.monotonic()
    while True:
        done = ended(home)
        if done >= JOBS or time.monotonic() > begin + PATIENCE:
            return killed
        # So many kills are due by now; the last falls before the last jobs.
        share = done / max(1.0, 0.8 * JOBS)
        if home.kills < min(SERVER_KILLS, 1 + share * SERVER_KILLS):
            home.kill()
        busy = busy_workers(home.service.process.pid)
        if busy and killed < min(WORKER_KILLS, 1 + share * WORKER_KILLS):
            try:
                os.kill(dice.choice(busy), signal.SIGKILL)
                killed += 1
            except ProcessLookupError:
                pass  # it was faster
        time.sleep(dice.uniform(0.001, 0.06))  # any moment of a job may be hit


def listed(home):
    """All jobs there are, page by page."""
    jobs, after = [], ""
    while after is not None:
        page = json.loads(home.ask("GET", "/v1/jobs?limit=100" + (after and f"&after={after}"))[2])
        jobs += page["jobs"]
        after = page["next"]
    return jobs


def is_whole(home, job):
    """Four pictures, each a PNG that ends with the mark that stands at the end of one."""
    files = json.loads(home.ask("GET", f"/v1/jobs/{job}")[2])["files"]
    pictures = [home.ask("GET", f"/v1/jobs/{job}/{name}")[2] for name in files]
    return len(pictures) == 4 and all(one[-8:-4] == b"IEND" for one in pictures)


with tempfile.TemporaryDirectory() as folder:
    home = Home(os.path.join(folder, "data"))
    try:
        ids = []
        client = threading.Thread(target=submit, args=(home, ids))
        client.start()
        workers_killed = fire(home, random.Random(1))
        client.join()
        jobs = listed(home)
        states = [job["state"] for job in jobs]
        successes = [home.ask("GET", f"/v1/jobs/{job['id']}/events")[2].count(b'"state":"succeeded"')
                     for job in jobs]
        broken = [job["id"] for job in jobs if not is_whole(home, job["id"])]
        uploads = os.listdir(os.path.join(home.data, "incoming"))
    finally:
        home.service.__exit__()
    with sqlite3.connect(os.path.join(home.data, "store.sqlite3")) as store:
        sound = store.execute("PRAGMA integrity_check").fetchone()[0]
print(f"{JOBS} jobs: {len(jobs)} listed, {states.count('succeeded')} succeeded, "
      f"{sum(n > 1 for n in successes)} twice, {len(broken)} broken; {home.kills} servers and "
      f"{workers_killed} workers killed; {sum(job['attempts'] for job in jobs)} attempts; "
      f"{len(uploads)} uploads left over; store {sound}")
if sorted(job["id"] for job in jobs) != sorted(ids) or len(set(ids)) != JOBS:
    failures.append("not the jobs that were submitted")
if set(states) != {"succeeded"} or set(successes) != {1} or broken or sound != "ok":
    failures.append("a job did not end well, or once")
if home.kills < SERVER_KILLS or workers_killed < WORKER_KILLS:
    failures.append("fewer were killed than was asked for")
finish(failures)
