"""What the service does with many jobs: sent over HTTP, kept in its store, done by its workers."""
import os
import sqlite3
import statistics
import subprocess
import sys
import time

from capacity_fits import folder_facts

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "service"))
from running_service import Service, form, scan_form  # noqa: E402

LIMITS = {"REGARMENT_MAX_QUEUE": "1000000", "REGARMENT_MAX_JOBS_PER_KEY": "1000000"}
# Read at once and turned down: no person.
TINY = b"ply\nformat ascii 1.0\nelement vertex 3\n" + b"".join(
    b"property float %c\n" % axis for axis in b"xyz") + b"end_header\n0 0 0\n1 0 0\n0 2 0\n"
LOOK = 0.5  # s between two looks at the store


def service(program, **more):
    sys.argv[1] = program  # where running_service.py looks for it
    return Service("--workers", "0", **LIMITS, **more)


def ask(data, question, *values):
    """Rows of the store of a service's data folder."""
    store = sqlite3.connect(f"file:{data}/store.sqlite3?mode=ro", uri=True, timeout=60)
    try:
        return store.execute(question, values).fetchall()
    finally:
        store.close()


def submit(running, jobs, body=None, headers=None):
    """Sends a job so many times; seconds each."""
    if body is None:
        body, headers = form({"scan": ("scan.ply", TINY), "garments": '["skirt"]'})
    began = time.monotonic()
    for _ in range(jobs):
        status, _, answer = running.ask("POST", "/v1/jobs", body, headers)
        if status != 202:
            raise SystemExit(f"a job was turned down: {status} {answer}")
    return (time.monotonic() - began) / jobs


def work(program, data, workers, jobs):
    """Runs workers until the last `jobs` that were sent have ended."""
    # By number alone, so that it costs the same however many ended before.
    open_jobs = ("SELECT count(*) FROM jobs WHERE number > (SELECT max(number) FROM jobs) - ? "
                 "AND +ended IS NULL")
    command = [program, "worker", "--data", data, "--quiet"]
    hands = [subprocess.Popen(command) for _ in range(workers)]
    try:
        while ask(data, open_jobs, jobs)[0][0] > 0:
            if all(hand.poll() is not None for hand in hands):
                raise SystemExit("the workers ended before the jobs did")
            time.sleep(LOOK)
    finally:
        for hand in hands:
            hand.terminate()
        for hand in hands:
            hand.wait()


def times(data, last):
    """Seconds at which each of the `last` jobs was begun and ended, in the order of their begin."""
    rows = ask(data, "SELECT started, ended FROM jobs ORDER BY number DESC LIMIT ?", last)
    return sorted((begun / 1000, ended / 1000) for begun, ended in rows)


def run_tiny(program, jobs, workers):
    """Begin and end of tiny jobs that all wait before the first worker starts, and how often each
    told the store of its progress."""
    with service(program) as running:
        submit(running, jobs)
        work(program, running.data, workers, jobs)
        notes = ask(running.data, "SELECT count(*) FROM events WHERE kind = 'progress'")[0][0]
        return times(running.data, jobs), notes / jobs


def service_and_pause(done):
    """Of jobs that one worker did: seconds of each, and between two of them on average."""
    took = [ended - begun for begun, ended in done]
    return took, statistics.mean(done[i + 1][0] - done[i][1] for i in range(len(done) - 1))


def real_job(program):
    """One fit of the example scan by a worker: what it leaves in store and folder."""
    with service(program) as running:
        submit(running, 1, *scan_form())
        work(program, running.data, 1, 1)
        (begun, ended), = times(running.data, 1)
        events = dict(ask(running.data, "SELECT kind, count(*) FROM events GROUP BY kind"))
        (name, state), = ask(running.data, "SELECT id, state FROM jobs")
        kept, entries = folder_facts(os.path.join(running.data, "jobs", name))
    if state != "succeeded":
        raise SystemExit(f"the example scan's job has {state}")
    return {"seconds": ended - begun, "notes": events.get("progress", 0),
            "events": sum(events.values()), "kept_bytes": kept, "entries": entries}


def uploads(program, scan, times_sent):
    """Bytes a second that one sender gets onto the server's disk, and seconds of a tiny job."""
    with open(scan, "rb") as file:
        body = file.read()
    with service(program) as running:
        submit(running, 20)
        tiny = submit(running, 200)
        large = submit(running, times_sent, *form({"scan": ("scan.ply", body),
                                                   "garments": '["skirt"]'}))
    return {"tiny_s": tiny, "bytes": len(body), "bytes_per_s": len(body) / (large - tiny)}


def fill(data, jobs):
    """Makes as many ended jobs in a store as are missing, all like those that are there."""
    store = sqlite3.connect(f"{data}/store.sqlite3", isolation_level=None)
    columns = [row[1] for row in store.execute("PRAGMA table_info(jobs)")]
    rest = ",".join(name for name in columns if name not in ("number", "id"))
    like, there = store.execute("SELECT max(number), count(*) FROM jobs").fetchone()
    store.execute("PRAGMA synchronous=OFF")
    store.execute("BEGIN")
    store.execute(
        f"INSERT INTO jobs (id, {rest}) WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 "
        f"FROM n WHERE i < ?) SELECT lower(hex(randomblob(length(id) / 2))), {rest} FROM jobs, n "
        "WHERE number = ?", (jobs - there, like))
    store.execute(
        "INSERT INTO events SELECT jobs.number, events.number, time, events.kind, data FROM jobs, "
        "events WHERE events.job = ? AND jobs.number > ?", (like, like))
    store.execute("COMMIT")
    store.close()


def filled(program, sizes, jobs=100):
    """Seconds of sending and of doing a tiny job, with so many ended jobs in the store."""
    found = []
    with service(program) as running:
        submit(running, jobs)
        work(program, running.data, 1, jobs)
        for size in sizes:
            if size > jobs:
                fill(running.data, size)
            sent = submit(running, jobs)
            work(program, running.data, 1, jobs)
            took, pause = service_and_pause(times(running.data, jobs))
            began = time.monotonic()
            running.ask("GET", "/metrics")
            found.append({"jobs": ask(running.data, "SELECT count(*) FROM jobs")[0][0],
                          "sent_s": sent, "job_s": statistics.mean(took), "pause_s": pause,
                          "metrics_s": time.monotonic() - began})
            print(f"  {found[-1]}", flush=True)
    return found
