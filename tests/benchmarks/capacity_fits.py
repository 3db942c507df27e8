"""What fits cost: seconds, memory and bytes, by the size of the scan and over made people."""
import json
import os
import statistics
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

from made_scans import cases

HERE = os.path.dirname(os.path.abspath(__file__))
EXAMPLE = os.path.join(HERE, "..", "..", "examples", "data", "skirt-1.mesh.ply")


def folder_facts(folder):
    """Bytes of all files below a folder, and how many entries it has, itself too."""
    sizes, entries = 0, 1
    for path, folders, files in os.walk(folder):
        entries += len(folders) + len(files)
        sizes += sum(os.path.getsize(os.path.join(path, name)) for name in files)
    return sizes, entries


def fit(program, scan, garments, out):
    """One fit as a worker runs it: a process of one thread. Its costs; `failed` with a status that
    is no success, as of a scan that does not show the garment."""
    command = [program, "fit", scan, "--out", out, "--force", "--threads", "1"]
    command += ["--progress", "json", *(f"--garment={garment}" for garment in garments)]
    began = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    costs = {"seconds": time.monotonic() - began,
             "processor_s": usage.ru_utime + usage.ru_stime,
             "memory_bytes": usage.ru_maxrss * 1024, "upload_bytes": os.path.getsize(scan)}
    if process.returncode != 0:
        return {**costs, "failed": process.returncode, "kept_bytes": 0, "entries": 0}
    costs["kept_bytes"], costs["entries"] = folder_facts(out)
    with open(os.path.join(out, "result.json"), encoding="utf-8") as file:
        result = json.load(file)
    stages = {name: s for name, s in result["timing_s"].items() if name != "total"}
    stages["report"] = max(0.0, costs["seconds"] - sum(stages.values()))
    return {**costs, "vertices": result["scan"]["vertices"], "stages": stages}


def median_of(runs):
    """Of several fits of one scan: each cost's median."""
    out = {key: statistics.median(run[key] for run in runs)
           for key in runs[0] if key not in ("stages", "failed")}
    if "stages" in runs[0]:
        out["stages"] = {name: statistics.median(run["stages"][name] for run in runs)
                         for name in runs[0]["stages"]}
    return out


def growth(program, work, sizes, repeats=2):
    """The same person as meshes and clouds of so many vertices, each fitted `repeats` times."""
    subprocess.run([sys.executable, os.path.join(HERE, "capacity_scans.py"), EXAMPLE, work,
                    *map(str, sizes)], check=True)
    found = {}
    for kind in ("mesh", "cloud"):
        found[kind] = []
        for size in sizes:
            scan = os.path.join(work, f"{kind}-{size}.ply")
            out = os.path.join(work, "fit")
            runs = [fit(program, scan, ["skirt"], out) for _ in range(repeats)]
            if any("failed" in run for run in runs):
                raise SystemExit(f"the {kind} of {size} vertices was not fitted")
            found[kind].append(median_of(runs))
            print(f"  {kind} of {size} vertices: {found[kind][-1]['seconds']:.2f} s", flush=True)
    return found


def crowding(program, work, scan, at_once, count):
    """How much longer a fit takes with so many at once, all cores but these idle."""
    path = os.path.join(work, "crowd.ply")
    with open(path, "wb") as file:
        file.write(scan)

    def mean(hands):
        tasks = [(program, path, ["skirt"], os.path.join(work, f"crowd-{i}")) for i in range(count)]
        with ThreadPoolExecutor(hands) as pool:
            return statistics.mean(f["seconds"] for f in pool.map(lambda task: fit(*task), tasks))

    return mean(at_once) / mean(1)


def people(program, work, count):
    """Made people fitted alone, then as many at once as there are cores."""
    made = os.path.join(work, "people")
    subprocess.run([program, "synthesize", "--out", made, "--cases", str(count), "--seed", "1",
                    "--quiet"], check=True, stdout=subprocess.DEVNULL)
    tasks = []
    for number, (scan, rows, _) in enumerate(cases(made)):
        layers = sorted({(int(row["layer"]), row["template"]) for row in rows})
        tasks.append((program, str(scan), [name for _, name in layers],
                      os.path.join(work, f"fit-{number}")))
    alone = [fit(*task) for task in tasks]
    cores = os.cpu_count()
    with ThreadPoolExecutor(cores) as hands:
        busy = list(hands.map(lambda task: fit(*task), tasks))
    print(f"  {len(tasks)} people: {statistics.mean(f['seconds'] for f in alone):.2f} s alone, "
          f"{statistics.mean(f['seconds'] for f in busy):.2f} s with {cores} at once", flush=True)
    return {"at_once": cores, "alone": alone, "busy": busy}
