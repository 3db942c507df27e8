#!/usr/bin/python3
"""What a campaign of many scans needs, from what is measured on this machine.

    capacity.py measure PROGRAM --out MEASURED.json [--quick]
        Seconds and bytes of fits, what store, disk, folders and HTTP give, and a real run of ten
        thousand tiny jobs beside its prediction: 25 minutes of a machine with nothing else to do,
        and 5 GB of the temporary folder (TMPDIR), whose disk is the one that is measured.
    capacity.py page MEASURED.json --out PAGE.html [--network MB/s]
        Hours, bytes and what is full first for ten thousand and ten million scans: a page, and the
        main figures as text.
    capacity.py check PROGRAM [--jobs 10000] [--workers 1 2]
        The prediction and the real run alone.

Tiny jobs are scans of three points, which a fit turns down: all of a job but the fit itself.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile

import capacity_fits as fits
import capacity_machine as machine
import capacity_service as service
from capacity_page import write_page
from capacity_plan import Plan, StoreRates, predict_tiny

FORMAT = "regarment.capacity/1"
FULL = {"sizes": (4000, 16000, 62500, 250000, 1000000), "people": 12, "store_jobs": 4000,
        "disk": 1000 * machine.MEGA, "folders": (1000, 10_000, 100_000), "uploads": 10,
        "filled": (1000, 100_000, 1_000_000), "sample": 300, "jobs": 10_000}
QUICK = {"sizes": (4000, 16000), "people": 2, "store_jobs": 200, "disk": 100 * machine.MEGA,
         "folders": (1000, 3000), "uploads": 2, "filled": (200, 5000), "sample": 30, "jobs": 60}


def say(words):
    print(words, file=sys.stderr, flush=True)


def benchmark_beside(program):
    path = os.path.join(os.path.dirname(os.path.abspath(program)), "queue_benchmark")
    if not os.access(path, os.X_OK):
        raise SystemExit(f"{path}: is not there; build the target queue_benchmark")
    return path


def checked(program, runs, sample, rates):
    """Real runs of tiny jobs beside what a few of them with one worker let expect."""
    done, notes = service.run_tiny(program, sample, 1)
    took, pause = service.service_and_pause(done)
    found = {"sample": sample, "job_s": statistics.mean(took), "pause_s": pause, "runs": []}
    for jobs, workers in runs:
        crowd = 1.0
        if workers > 1:
            with tempfile.TemporaryDirectory(prefix="regarment-capacity-") as work:
                crowd = fits.crowding(program, work, service.TINY, workers, sample)
        predicted = predict_tiny(jobs, workers, [crowd * seconds for seconds in took], pause, rates,
                                 round(notes))
        done, _ = service.run_tiny(program, jobs, workers)
        real = max(ended for _, ended in done) - done[0][0]
        found["runs"].append({"jobs": jobs, "workers": workers, "crowding": crowd,
                              "predicted_s": predicted, "taken_s": real})
        print(f"{workers} workers, {jobs} tiny jobs: predicted {predicted:.1f} s, took {real:.1f} "
              f"s (ratio {real / predicted:.3f}), {jobs / real:.1f} jobs/s", flush=True)
    return found


def check(options):
    rates = machine.stores(benchmark_beside(options.program), 1000, 8, 2)["sqlite"]
    checked(options.program, [(options.jobs, workers) for workers in options.workers],
            min(options.jobs, FULL["sample"]), StoreRates("sqlite", rates))


def measure(options):
    how, program = QUICK if options.quick else FULL, os.path.abspath(options.program)
    benchmark = benchmark_beside(program)
    folder = os.path.dirname(os.path.abspath(options.out))
    if not os.access(folder, os.W_OK):
        raise SystemExit(f"{folder}: cannot be written to; name another --out")
    version = subprocess.run([program, "--version"], check=True, stdout=subprocess.PIPE)
    with tempfile.TemporaryDirectory(prefix="regarment-capacity-") as work:
        found = {"format": FORMAT, "program": version.stdout.decode().strip(),
                 "quick": options.quick, "machine": machine.machine(work)}
        say("fits by size")
        found["growth"] = fits.growth(program, work, how["sizes"])
        say("made people")
        found["people"] = fits.people(program, work, how["people"])
        say("a job of the service, uploads")
        found["job"] = service.real_job(program)
        largest = os.path.join(work, f"mesh-{how['sizes'][-1]}.ply")
        found["upload"] = service.uploads(program, largest, how["uploads"])
        say("stores")
        found["stores"] = machine.stores(benchmark, how["store_jobs"], 8, found["job"]["notes"])
        say("stores that are full of jobs")
        found["filled"] = service.filled(program, how["filled"])
        say("disk and folders")
        found["disk"] = machine.disk(work, how["disk"])
        found["folders"] = [machine.folders(work, count) for count in how["folders"]]
        found["folders"].append(machine.folders(work, how["folders"][-1], shards=256))
    say("tiny jobs")
    runs = [(how["jobs"] // 5, 1), (how["jobs"], 2)]
    rates = StoreRates("sqlite", found["stores"]["sqlite"])
    found["check"] = checked(program, runs, how["sample"], rates)
    with open(options.out, "w", encoding="utf-8") as file:
        json.dump(found, file, indent=1)
        file.write("\n")
    print(options.out)


def page(options):
    with open(options.measured, encoding="utf-8") as file:
        measured = json.load(file)
    if measured.get("format") != FORMAT:
        raise SystemExit(f"{options.measured}: is no file of capacity.py measure")
    write_page(Plan(measured, options.network * machine.MEGA), options.out)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    kinds = parser.add_subparsers(required=True, metavar="measure|page|check")
    kind = kinds.add_parser("measure")
    kind.add_argument("program")
    kind.add_argument("--out", required=True)
    kind.add_argument("--quick", action="store_true", help="a few minutes, for a try")
    kind.set_defaults(work=measure)
    kind = kinds.add_parser("page")
    kind.add_argument("measured")
    kind.add_argument("--out", required=True)
    kind.add_argument("--network", type=float, default=110, help="MB/s; 110 is a gigabit line")
    kind.set_defaults(work=page)
    kind = kinds.add_parser("check")
    kind.add_argument("program")
    kind.add_argument("--jobs", type=int, default=10_000)
    kind.add_argument("--workers", type=int, nargs="+", default=[1, 2])
    kind.set_defaults(work=check)
    options = parser.parse_args()
    try:
        options.work(options)
    except (OSError, json.JSONDecodeError) as error:
        raise SystemExit(f"capacity.py: {error}") from error


if __name__ == "__main__":
    main()
