#!/bin/sh
# Prints, for each scan given (default: the example scans), the time of every stage of
# `regarment fit`, median of five runs, seconds of wall time, and the peak memory in MiB.
# usage: fit_benchmark.sh [PROGRAM [SCAN GARMENT]...]
set -eu
cd "$(dirname "$0")/../.."
program=${1:-build/release/regarment}
[ $# = 0 ] || shift
[ $# -ge 2 ] || set -- examples/data/skirt-1.mesh.ply skirt examples/data/tshirt-5.mesh.ply tshirt
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
while [ $# -ge 2 ]; do
  for run in 1 2 3 4 5; do
    python3 - "$program" "$1" "$2" "$folder/out" >>"$folder/times" <<'PY'
import json, resource, subprocess, sys
program, scan, garment, out = sys.argv[1:]
subprocess.run([program, "fit", scan, "--garment", garment, "--out", out, "--force", "--quiet"],
               check=True, stdout=subprocess.DEVNULL)
times = json.load(open(out + "/result.json"))["timing_s"]
times["peak_MiB"] = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
print(json.dumps(times))
PY
  done
  python3 - "$1" "$folder/times" <<'PY'
import json, statistics, sys
runs = [json.loads(line) for line in open(sys.argv[2])]
print(sys.argv[1], *(f"{k} {statistics.median(r[k] for r in runs):.3f}" for k in runs[0]), sep="  ")
PY
  : >"$folder/times"
  shift 2
done
