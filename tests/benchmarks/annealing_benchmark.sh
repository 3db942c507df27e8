#!/bin/sh
# Prints what the paper's method gives and costs, and what each departure from the paper is worth:
# one line a variant with the mean absolute error over the scans (cm), the seconds of the search and
# of one evaluation a thread, and the peak memory in MiB.
# usage: annealing_benchmark.sh [--short] [--quick] [PROGRAM [TRUTH.csv SCAN GARMENT [SCAN GARMENT]...]]
#   --short   the method as it is, without the variants
#   --quick   one run of 200 evaluations instead of three of 500
set -eu
cd "$(dirname "$0")/../.."
variants="|--free-edges|--no-border-rejection|--no-cap-detection|--drape-from last|--no-rough-search"
variants="$variants|--no-hesitation|--no-square-root|--attraction closest|--collisions|--as-printed"
if [ "${1:-}" = --short ]; then
  variants=""
  shift
fi
common=""
if [ "${1:-}" = --quick ]; then
  common="--runs 1 --evaluations 200"
  shift
fi
program=${1:-build/release/regarment}
[ $# = 0 ] || shift
[ $# -ge 3 ] || set -- examples/data/ground_truth.csv examples/data/skirt-1.mesh.ply skirt \
  examples/data/tshirt-5.mesh.ply tshirt
exec python3 - "$program" "$variants" "$common" "$@" <<'PY'
import json, os, resource, subprocess, sys, tempfile
program, variants, common, truth, *rest = sys.argv[1:]
scans = list(zip(rest[0::2], rest[1::2]))
print(f"{'variant':24s} {'MAE cm':>7s} {'search s':>9s} {'s/evaluation':>13s} {'peak MiB':>9s}  by scan")
for variant in variants.split("|"):
    errors, seconds, per_drape, by_scan = [], [], [], []
    for scan, garment in scans:
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "out")
            done = subprocess.run([program, "fit", scan, "--garment", garment, "--out", out, "--quiet",
                                   "--method", "annealing", "--ground-truth", truth, *common.split(), *variant.split()],
                                  stdout=subprocess.DEVNULL)
            if done.returncode:
                by_scan.append(f"{os.path.basename(scan)} exit {done.returncode}")
                continue
            result = json.load(open(os.path.join(out, "result.json")))
        found = result["garments"][0]
        here = [abs(m["error_cm"]) for m in found["measurements"]]
        errors += here
        seconds.append(result["timing_s"]["fit"])
        drapes = sum(r["evaluations"] for r in found["runs"])
        threads = min(result["program"]["threads"], len(found["runs"]))
        per_drape.append(seconds[-1] * threads / drapes)
        by_scan.append(f"{os.path.basename(scan)} {sum(here) / len(here):.2f}")
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    mean = lambda values: sum(values) / len(values) if values else float("nan")
    print(f"{variant or 'as it is':24s} {mean(errors):7.2f} {mean(seconds):9.1f} {mean(per_drape):13.3f}"
          f" {peak:9.0f}  {', '.join(by_scan)}", flush=True)
PY
