"""What this machine's disk, folders and job stores give."""
import json
import os
import random
import shutil
import subprocess
import time

MEGA = 1_000_000


def file_system(folder):
    """Kind of the file system that holds a folder."""
    best, kind = "", "unknown"
    with open("/proc/mounts", encoding="utf-8") as mounts:
        for line in mounts:
            _, place, this, *_ = line.split()
            if len(place) >= len(best) and os.path.realpath(folder).startswith(place):
                best, kind = place, this
    return kind


def machine(folder):
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
    return {"processor": names[0] if names else "unknown", "cores": os.cpu_count(),
            "memory_bytes": os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES"),
            "file_system": file_system(folder)}


def disk(folder, size=1000 * MEGA, commits=1000):
    """Bytes a second written and on the disk, and small writes a second, each on the disk before
    the next."""
    path, block = os.path.join(folder, "disk"), os.urandom(10 * MEGA)
    began = time.monotonic()
    with open(path, "wb", buffering=0) as file:
        for _ in range(size // len(block)):
            file.write(block)
        os.fsync(file.fileno())
    rate = size / (time.monotonic() - began)
    began = time.monotonic()
    with open(path, "wb", buffering=0) as file:
        for _ in range(commits):
            file.write(block[:4096])
            os.fdatasync(file.fileno())
    took = time.monotonic() - began
    os.unlink(path)
    return {"write_bytes_per_s": rate, "commits_per_s": commits / took}


def folders(folder, entries, shards=1, looks=20_000):
    """Seconds of making, finding and listing one of `entries` job folders, spread over `shards`."""
    draw = random.Random(entries)
    names = [f"{draw.getrandbits(128):032x}" for _ in range(entries)]
    root = os.path.join(folder, "many")
    places = [root] if shards == 1 else [os.path.join(root, f"{s:03x}") for s in range(shards)]
    for place in places:
        os.makedirs(place)
    paths = [os.path.join(places[int(name[:3], 16) % shards], name) for name in names]

    def each(work, items):
        began = time.monotonic()
        for item in items:
            work(item)
        return (time.monotonic() - began) / len(items)

    made = each(os.mkdir, paths)
    found = each(os.stat, draw.choices(paths, k=looks))
    listed = each(os.listdir, places) * len(places) / entries
    shutil.rmtree(root)
    return {"entries": entries, "shards": shards, "make_s": made, "find_s": found, "list_s": listed}


def stores(benchmark, jobs, workers, notes):
    """Both stores with one worker and with several, by `queue_benchmark`."""
    found = {}
    for count, hands in ((jobs // 4, 1), (jobs, workers)):
        run = subprocess.run([benchmark, str(count), str(hands), str(notes)], check=True,
                             stdout=subprocess.PIPE)
        for line in run.stdout.splitlines():
            figures = json.loads(line)
            name = "one" if hands == 1 else "many"
            found.setdefault(figures.pop("store"), {})[name] = figures
            print(f"  {line.decode()}", flush=True)
    return found
