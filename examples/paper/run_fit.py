"""Runs one fit and keeps what the page needs of it: a small JSON and a few pictures."""

import csv
import json
import os
import shutil
import subprocess
import tempfile
import time


def truth_of(scans, stem):
    """The rows of the scans' truth: what tells flat sizes from hidden ones."""
    with open(os.path.join(scans, "truth", "ground_truth.csv"), newline="") as table:
        return [row for row in csv.DictReader(table) if row["scan"] == stem]


def held_at_truth(fit, scans):
    """--fix of all dimensions but the one that is searched."""
    if not fit.free:
        return []
    rows = truth_of(scans, fit.scan.split(".")[0])
    return ["--fix", ",".join(f"{row['measurement']}={row['value_cm']}"
                              for row in rows if row["measurement"] != fit.free)]


def command_of(fit, binary, scans, out):
    command = [binary, "fit", os.path.join(scans, fit.scan + ".ply"), "--out", out, "--quiet",
               "--no-state", "--method", fit.method,
               "--ground-truth", os.path.join(scans, "truth", "ground_truth.csv"),
               "--ground-truth-labels", os.path.join(scans, "truth", fit.scan + ".labels.u8")]
    for garment in fit.garments:
        command += ["--garment", garment]
    return command + held_at_truth(fit, scans) + fit.options


def evaluations_of(folder, number):
    """What a search tried, as lists of numbers under the names of the table's columns."""
    path = os.path.join(folder, f"evaluations-{number}.csv")
    if not os.path.exists(path):
        return None
    with open(path, newline="") as table:
        rows = list(csv.DictReader(table))
    wanted = [name for name in rows[0]
              if name.endswith("_cm") or name in ("distance_m", "stretch", "silhouette", "error",
                                                  "drape_steps")]
    return {name: [float(row[name]) for row in rows] for name in wanted}


def garment_record(garment, folder, number, keep_evaluations):
    out = {"template": garment["template"], "layer": garment["layer"], "error": garment["error"],
           "measurements": [{key: m.get(key) for key in (
               "name", "value_cm", "worn_cm", "interval_cm", "observable", "fixed", "truth_cm",
               "error_cm")} for m in garment["measurements"]]}
    if "search" in garment:
        out["weights"] = garment["search"]["weights"]
        out["runs"] = garment["runs"]
        tried = evaluations_of(folder, number)
        out["drapes"] = len(tried["error"])
        out["drape_steps"] = sum(tried["drape_steps"])
        if keep_evaluations:
            out["evaluations"] = tried
    return out


def record_of(fit, folder, seconds):
    with open(os.path.join(folder, "result.json")) as file:
        result = json.load(file)
    garments = [garment_record(garment, folder, number + 1, bool(fit.free))
                for number, garment in enumerate(result["garments"])]
    times = result.get("timing_s", {})
    return {"name": fit.name, "scan": fit.scan, "method": fit.method, "free": fit.free,
            "options": fit.options, "version": result["program"]["version"],
            "sha256": result["scan"]["sha256"], "caps": result["scan"]["caps"],
            "garments": garments, "segmentation": result.get("segmentation"),
            "warnings": result.get("warnings", []),
            "fit_s": times.get("fit", times.get("measure")), "wall_s": round(seconds, 1)}


def keep_pictures(fit, folder, pictures):
    """JPEG pictures by "LOOK-SIDE", drawings by their file name."""
    for name in fit.pictures:
        drawing = name.endswith(".svg")
        source = os.path.join(folder, name if drawing else f"pictures/{name}.jpg")
        if os.path.exists(source):
            shutil.copyfile(source, os.path.join(
                pictures, f"{fit.name}.{name if drawing else name + '.jpg'}"))


def write_whole(path, text):
    """A result stands whole or not at all, so that a run can be stopped at any time."""
    with open(path + ".new", "w") as file:
        file.write(text)
    os.replace(path + ".new", path)


def run_fit(fit, binary, scans, out):
    """Writes OUT/fits/NAME.json. A fit without a result is a result: its one line is kept."""
    with tempfile.TemporaryDirectory(dir=out) as work:
        folder = os.path.join(work, "result")
        started = time.monotonic()
        done = subprocess.run(command_of(fit, binary, scans, folder), capture_output=True,
                              text=True)
        seconds = time.monotonic() - started
        if done.returncode in (1, 2) or done.returncode < 0 or done.returncode > 75:
            raise RuntimeError(f"{fit.name}: {done.stderr.strip() or done.returncode}")
        if done.returncode == 0:
            record = record_of(fit, folder, seconds)
            keep_pictures(fit, folder, os.path.join(out, "pictures"))
        else:
            record = {"name": fit.name, "scan": fit.scan, "method": fit.method, "free": fit.free,
                      "options": fit.options, "failure": done.stderr.strip().splitlines()[-1],
                      "wall_s": round(seconds, 1)}
    write_whole(os.path.join(out, "fits", fit.name + ".json"), json.dumps(record))
    return record
