#!/usr/bin/env python3
"""One campaign of tiny jobs by every engine there is, its parts killed without warning: the same
results from all, no job lost, none done twice.

    campaign_test.py BUILD JOBS WORKER_KILLS [sqlite] [postgres] [slurm]

BUILD is a folder of a build, with jobs_chaos and tiny_batch. Beside the workers, two servers are
killed with SQLite, two servers and two databases with PostgreSQL, two controllers and a node with
Slurm. Prints a line for each engine; the full measure is 10000 jobs and 100 kills. Without names,
those engines are taken that are installed; leaves with 77 when one that is named is not.
"""
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "slurm"))

from cluster import Cluster, kill, processes, until, what_is_missing

BUILD = pathlib.Path(sys.argv[1]).resolve()
JOBS, WORKER_KILLS = int(sys.argv[2]), int(sys.argv[3])
OTHER_KILLS = 2
PATIENCE = 3600  # s
SKIPPED = 77


def by_store(*store):
    """The line that jobs_chaos prints, and whether all was right."""
    done = subprocess.run([BUILD / "jobs_chaos", "tiny", *map(str, (JOBS, WORKER_KILLS, OTHER_KILLS)),
                           *store], text=True, stdout=subprocess.PIPE, check=False)
    return done.stdout.strip(), done.returncode


class Batch:
    """A batch of tiny jobs on a cluster of one node, and how to kill its parts."""

    def __init__(self, home):
        self.cluster, self.home, self.folder = Cluster(home), home, home / "batch"
        self.dice = random.Random(1)
        self.seen_to = 0.0

    def run(self, *words):
        return subprocess.run([BUILD / "tiny_batch", *map(str, words)], check=False, text=True,
                              env=self.cluster.environment, stdout=subprocess.PIPE)

    def kill_task(self):
        tasks = processes("tiny_batch", "batch-task", str(self.folder), "--shard ")
        return bool(tasks) and bool(kill([self.dice.choice(tasks)]))

    def kill_controller(self):
        self.cluster.crash("controller")
        self.cluster.start_controller()
        return True

    def kill_node(self):
        self.cluster.crash("node")
        kill(processes("slurmstepd") + processes(str(self.cluster.home / "spool"), "slurm_script") +
             processes("batch-task", str(self.folder)))
        self.cluster.start_node()
        return True

    def share_ended(self):
        return sum(entry.name.endswith(".json") for entry in os.scandir(self.folder / "status")) / JOBS

    def submit(self):
        return self.run("submit", self.home, JOBS, max(2, min(50, JOBS // 20))).returncode == 0

    def operate(self):
        """What an operator does after a crash: a controller forgets what it took or began in its last
        seconds, drains the node that runs it still, and holds the job."""
        if time.monotonic() < self.seen_to + 3:
            return
        self.seen_to = time.monotonic()
        ask = self.cluster.run
        if "drain" in ask("sinfo", "-h", "-o", "%T").stdout:
            ask("scontrol", "update", "NodeName=localhost", "State=RESUME")
        jobs = ask("squeue", "-h", "-o", "%A %r")
        for line in jobs.stdout.splitlines():
            if "JobHeld" in line:
                ask("scontrol", "release", line.split()[0])
        if jobs.returncode == 0 and not jobs.stdout and not self.merged():
            print("slurm: submitted again, its job was forgotten", flush=True)
            self.submit()

    def merged(self):
        return (self.folder / "evaluation.json").exists()

    def fire(self):
        """Kills, spread over the jobs, until the merge is there; how many of each."""
        wanted = {self.kill_task: WORKER_KILLS, self.kill_controller: OTHER_KILLS, self.kill_node: 1}
        done = dict.fromkeys(wanted, 0)

        def look():
            # None at once, when Slurm has not yet saved what it took; the last before the last jobs.
            share = self.share_ended()
            for one, most in wanted.items():
                if done[one] < most and 0.8 * (done[one] + 0.5) / most <= share and one():
                    done[one] += 1
            self.operate()
            time.sleep(self.dice.uniform(0.001, 0.06))  # any moment of a job may be hit
            return self.merged()

        until("the merge", look, PATIENCE)
        return wanted, done


def by_slurm():
    with tempfile.TemporaryDirectory(prefix="regarment-campaign-", ignore_cleanup_errors=True) as home:
        os.chmod(home, 0o755)  # munge's user must get through
        batch = Batch(pathlib.Path(home))
        try:
            begin = time.monotonic()
            if not batch.submit():
                return "slurm took nothing", 1
            wanted, done = batch.fire()
            took = time.monotonic() - begin
        finally:
            batch.cluster.stop()
        counted = batch.run("count", home, JOBS)
    killed = ", ".join(f"{count} {kill.__name__.removeprefix('kill_')}s" for kill, count in done.items())
    line = f"slurm, {JOBS} jobs in {took:.0f} s; killed {killed}; {counted.stdout.strip()}"
    return line, counted.returncode or int(done != wanted)


ENGINES = {"sqlite": lambda: by_store("sqlite"), "postgres": lambda: by_store("postgres", str(OTHER_KILLS)),
           "slurm": lambda: by_slurm() if not what_is_missing() else ("skipped: needs " + what_is_missing(), SKIPPED)}


def main():
    sets, status = set(), 0
    for name in sys.argv[4:] or ENGINES:
        line, left = ENGINES[name]()
        print(line, flush=True)
        if left == SKIPPED and not sys.argv[4:]:
            continue
        status = status or left
        sets.update(re.findall(r"results ([0-9a-f]{64})", line))
    if len(sets) != 1:
        print("FAILED: the engines do not agree")
        status = status or 1
    return status


sys.exit(main())
