#!/bin/sh
# Builds Regarment on a bare Debian 12 and measures the skirt of an example scan, whose true sizes
# are known. Ends with the path of the report. Can be run again at little cost.
set -eu
cd "$(dirname "$0")"

scripts/install_packages.sh build
cmake --preset release >build-configure.log 2>&1 || { cat build-configure.log; exit 1; }
rm -f build-configure.log
cmake --build --preset release --target regarment

build/release/regarment fit examples/data/skirt-1.mesh.ply --garment skirt --out out/demo --force \
  --ground-truth examples/data/ground_truth.csv \
  --ground-truth-labels examples/data/skirt-1.mesh.labels.u8 --quiet
cat out/demo/measurements.csv
echo
echo "$PWD/out/demo/report.html"
