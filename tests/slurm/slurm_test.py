#!/usr/bin/env python3
"""A batch by Slurm against the same batch on this machine, while its parts are killed.

    slurm_test.py PROGRAM EXAMPLES

Starts munge, slurmctld and slurmd on loopback, as root and without systemd. Of the tasks of an array
some are killed, then a task's script, then the controller, then the node with everything on it; one
scan is killed whenever anybody fits it. The results must be those of the local engine, byte by byte.
Leaves with 77 where Slurm is missing.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import time

from cluster import Cluster, kill, processes, until, what_is_missing

PROGRAM, EXAMPLES = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()


def write_table(home):
    """Eight scans that can be fitted, one nobody can read, one that is killed by whoever sees it."""
    rows = (EXAMPLES / "ground_truth.csv").read_text().splitlines()
    table = [rows[0]]
    for i in range(9):
        scan = "poison" if i == 3 else f"skirt-{i}"
        shutil.copy(EXAMPLES / "skirt-1.mesh.ply", home / f"{scan}.ply")
        table += [f"{scan}.ply," + row.split(",", 1)[1] for row in rows if row.startswith("skirt-1,")]
    (home / "unreadable.ply").write_text("ply\nformat ascii 1.0\n")
    table.append("unreadable.ply,1,skirt,hip,94,,true")
    (home / "table.csv").write_text("\n".join(table) + "\n")
    return home / "table.csv"


class Poison(threading.Thread):
    """Kills every fit of poison.ply as soon as it is seen."""

    def __init__(self, home):
        super().__init__(daemon=True)
        self.home, self.over, self.killed = home, threading.Event(), set()

    def run(self):
        while not self.over.wait(0.02):
            self.killed.update(kill(processes(PROGRAM + " fit ", str(self.home / "poison.ply"))))


def batch(*words, environment=None):
    done = subprocess.run([PROGRAM, "batch", *map(str, words)], text=True, capture_output=True,
                          env=environment)
    print("batch", " ".join(map(str, words[1:])), "->", done.returncode,
          done.stdout.strip().splitlines()[:1], done.stderr.strip().splitlines()[-1:], flush=True)
    return done


def files_of(folder):
    """Every file of a batch but what belongs to an engine."""
    own = {"log", "array.sbatch", "merge.sbatch", "submit.sh"}
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*")
            if path.is_file() and path.relative_to(folder).parts[0] not in own}


def ended(folder):
    return len(list((folder / "status").glob("*.json")))


def harass(cluster, folder):
    """Kills what runs, part by part; no shard's own process more than twice."""
    for shard in (0, 3):
        number = until(f"shard {shard}", lambda: processes("batch-task", str(folder), f"--shard {shard} "))
        kill(number)
        print("killed shard", shard, flush=True)
    script = until("a script", lambda: processes(str(cluster.home / "spool"), "slurm_script"))
    kill(script[:1])
    print("killed a script", flush=True)
    cluster.crash("controller")
    cluster.start_controller()
    print("killed the controller at", ended(folder), "of 10", flush=True)
    until("the poison", (folder / "status/poison.json").exists)
    until("work on the node", lambda: processes("batch-task", str(folder), "--shard "))
    cluster.crash("node")
    kill(processes("slurmstepd") + processes(str(cluster.home / "spool"), "slurm_script") +
         processes("batch-task", str(folder)))
    print("killed the node at", ended(folder), "of 10", flush=True)
    cluster.start_node()


def check(cluster, home):
    table = write_table(home)
    how = ["--method", "direct", "--shard-size", "2"]
    # A folder whose name a shell would trip over.
    local, folder = home / "local", home / "by Slurm's \"$HOME\" `x` ; #%A é"
    poison = Poison(home)
    poison.start()
    assert batch(table, "-o", local, *how, "--quiet").returncode == 4
    begun = time.monotonic()
    sent = batch(table, "-o", folder, *how, "--engine", "slurm", environment=cluster.environment)
    assert sent.returncode == 0 and "array" in sent.stdout, sent.stderr
    harass(cluster, folder)
    until("the jobs", lambda: not cluster.jobs() or (folder / "evaluation.html").exists())
    print(f"ended after {time.monotonic() - begun:.0f} s", flush=True)
    poison.over.set()
    for log in sorted((folder / "log").iterdir()):
        print(log.name, log.read_text().strip().replace("\n", " | "), flush=True)
    status = json.loads(batch("--status", folder, "--json").stdout)
    assert (status["succeeded"], status["failed"], status["parked"]) == (8, 1, 1), status
    ours, theirs = files_of(local), files_of(folder)
    assert ours.keys() == theirs.keys(), ours.keys() ^ theirs.keys()
    different = [str(name) for name in ours if ours[name] != theirs[name]]
    assert not different, different
    print(f"{len(ours)} files of the same bytes; {len(poison.killed)} fits of the poison killed")


def main():
    missing = what_is_missing()
    if missing:
        print("skipped: needs", missing)
        return 77
    home = pathlib.Path(tempfile.mkdtemp(prefix="regarment-slurm-"))
    home.chmod(0o755)  # munge's user must get through
    cluster = None
    try:
        cluster = Cluster(home)
        check(cluster, home)
    finally:
        if cluster:
            cluster.stop()
        shutil.rmtree(home, ignore_errors=True)
    return 0


sys.exit(main())
