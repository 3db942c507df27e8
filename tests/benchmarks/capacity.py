#!/usr/bin/python3
"""What a campaign of many scans needs, from what was measured on this machine.

    capacity.py check PROGRAM [--jobs 10000] [--workers 2]
        Measures tiny jobs with one worker, says by simulation how long JOBS of them take with WORKERS,
        then runs them and prints both. The jobs are boxes, which a fit turns down as no person.
    capacity.py plan EVALUATION [--store-rate N] [--disk MB/s] [--network MB/s]
        From the times and sizes of an evaluation's fits (`regarment evaluate`): hours, bytes and what
        is full first, for 10,000 and for 10 million scans and growing numbers of workers.

The queue in both: workers take the next job when they are free; every job costs the store a time of
its own in which it serves nobody else, when it is submitted, taken and ended.
"""
import argparse
import heapq
import json
import os
import random
import statistics
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "service"))


def simulate(jobs, workers, service, pause, store, seed=1):
    """Seconds until `jobs`, all there at the start, are done. `service`: seconds of jobs seen, drawn
    from with replacement; `pause`: a worker's own seconds between two; `store`: the store's for each."""
    draw = random.Random(seed)
    store_free, end = 0.0, 0.0
    free = [(0.0, worker) for worker in range(workers)]
    heapq.heapify(free)
    for _ in range(jobs):
        now, worker = heapq.heappop(free)
        store_free = max(now, store_free) + store
        done = store_free + draw.choice(service)
        end = max(end, done)
        heapq.heappush(free, (done + pause, worker))
    return end


# -- check ---------------------------------------------------------------------------------------

BOX = b"""ply
format ascii 1.0
element vertex 8
property float x
property float y
property float z
element face 12
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
1 1 0
0 0 2
1 0 2
0 1 2
1 1 2
3 0 2 1
3 1 2 3
3 4 5 6
3 5 7 6
3 0 1 4
3 1 5 4
3 2 6 3
3 3 6 7
3 0 4 2
3 2 4 6
3 1 3 5
3 3 7 5
"""


def jobs_in(data):
    """Seconds at which each job was begun and ended, from the store, in the order they began."""
    import sqlite3
    with sqlite3.connect(f"file:{data}/store.sqlite3?mode=ro", uri=True) as store:
        rows = store.execute("SELECT started, ended FROM jobs WHERE ended IS NOT NULL").fetchall()
    return sorted((begun / 1000, over / 1000) for begun, over in rows)


def run_tiny(program, jobs, workers):
    """Begin and end of all jobs, submitted before the first worker starts, and seconds a submission."""
    from running_service import Service, form
    import subprocess
    sys.argv[1] = program
    limits = {"REGARMENT_MAX_QUEUE": "100000", "REGARMENT_MAX_JOBS_PER_KEY": "100000"}
    with Service("--workers", "0", **limits) as service:
        began = time.monotonic()
        for _ in range(jobs):
            body, headers = form({"scan": ("scan.ply", BOX), "garments": '["skirt"]'})
            status, _, answer = service.ask("POST", "/v1/jobs", body, headers)
            if status != 202:
                raise SystemExit(f"a job was turned down: {status} {answer}")
        each = (time.monotonic() - began) / jobs
        command = [program, "worker", "--data", service.data, "--quiet"]
        hands = [subprocess.Popen(command) for _ in range(workers)]
        try:
            while len(done := jobs_in(service.data)) < jobs:
                time.sleep(1)
        finally:
            for hand in hands:
                hand.terminate()
            for hand in hands:
                hand.wait()
        return done, each


def check(options):
    sample, submission = run_tiny(options.program, min(options.jobs, 300), 1)
    service = [over - begun for begun, over in sample]
    pauses = [sample[i + 1][0] - sample[i][1] for i in range(len(sample) - 1)]
    pause = statistics.mean(pauses)
    predicted = simulate(options.jobs, options.workers, service, pause, options.store)
    done, _ = run_tiny(options.program, options.jobs, options.workers)
    real = done[-1][1] - done[0][0]
    print(f"one worker, {len(sample)} jobs: {1e3 * statistics.mean(service):.1f} ms a job, "
          f"{1e3 * pause:.1f} ms between two, {1e3 * submission:.1f} ms a submission over HTTP")
    print(f"{options.workers} workers, {options.jobs} jobs: predicted {predicted:.0f} s, "
          f"took {real:.0f} s ({real / predicted:.2f}), {options.jobs / real:.1f} jobs/s")


# -- plan ----------------------------------------------------------------------------------------

def folder_bytes(folder):
    return sum(os.path.getsize(os.path.join(path, name))
               for path, _, names in os.walk(folder) for name in names)


def plan(options):
    with open(os.path.join(options.evaluation, "evaluation.json"), encoding="utf-8") as file:
        scans = json.load(file)["scans"]
    seconds = [scan["seconds"] for scan in scans if scan.get("seconds")]
    folders = [os.path.join(options.evaluation, scan["fit"]) for scan in scans if scan.get("fit")]
    sizes = [folder_bytes(folder) for folder in folders if os.path.isdir(folder)]
    # The uploaded scan is about as large as its copy with labels.
    uploads = [os.path.getsize(path) for folder in folders
               if os.path.exists(path := os.path.join(folder, "segmented.ply"))]
    mean, kept, sent = map(statistics.mean, (seconds, sizes, uploads))
    print(f"{len(seconds)} fits: {mean:.2f} s (median {statistics.median(seconds):.2f}, "
          f"95th percentile {sorted(seconds)[int(0.95 * len(seconds))]:.2f}), result {kept / 1e6:.1f} MB, "
          f"scan {sent / 1e6:.1f} MB")
    full = {"store": mean * options.store_rate,
            "disk": mean * options.disk * 1e6 / (kept + 2 * sent),
            "network": mean * options.network * 1e6 / (kept + sent)}
    first = min(full, key=full.get)
    print("workers at which each is full: " +
          ", ".join(f"{name} {workers:,.0f}" for name, workers in sorted(full.items(), key=lambda x: x[1])))
    print(f"{'scans':>12} {'workers':>8} {'hours':>10} {'TB kept':>9} {'scans/s':>9}  full")
    for jobs in (10_000, 10_000_000):
        for workers in (2, 16, 128, 1024, 8192):
            # Ten million draws tell no more than the mean does.
            if jobs <= 10_000:
                took = simulate(jobs, workers, seconds, 0, 1 / options.store_rate)
            else:
                took = jobs * max(mean / workers, 1 / options.store_rate)
            took = max(took, jobs * mean / full["disk"], jobs * mean / full["network"])
            note = first if workers > full[first] else ""
            print(f"{jobs:>12,} {workers:>8,} {took / 3600:>10.2f} {jobs * (kept + sent) / 1e12:>9.2f} "
                  f"{jobs / took:>9.1f}  {note}")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    kinds = parser.add_subparsers(required=True, metavar="check|plan")
    kind = kinds.add_parser("check")
    kind.add_argument("program")
    kind.add_argument("--jobs", type=int, default=10_000)
    kind.add_argument("--workers", type=int, default=2)
    kind.add_argument("--store", type=float, default=0.001, help="seconds of the store, a job")
    kind.set_defaults(work=check)
    kind = kinds.add_parser("plan")
    kind.add_argument("evaluation")
    kind.add_argument("--store-rate", type=float, default=1000, help="jobs/s through the store")
    kind.add_argument("--disk", type=float, default=500, help="MB/s it writes")
    kind.add_argument("--network", type=float, default=110, help="MB/s; 110 is a gigabit line")
    kind.set_defaults(work=plan)
    options = parser.parse_args()
    options.work(options)


if __name__ == "__main__":
    main()
