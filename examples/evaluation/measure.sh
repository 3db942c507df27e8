#!/bin/sh
# Makes people with known dimensions and measures how well each method finds them again:
# OUT/joint and OUT/direct over all of them, OUT/annealing over ten with one short search each.
set -eu
out=${1:?usage: measure.sh OUT [PEOPLE]}
people=${2:-200}
root=$(cd "$(dirname "$0")/../.." && pwd)
regarment=${REGARMENT:-$root/build/release/regarment}

"$regarment" synthesize --out "$out/people" --cases "$people" --seed 4 --force
# Status 4: some scans came to no result, which the page counts.
"$regarment" evaluate "$out/people/truth/ground_truth.csv" --out "$out/joint" --method joint ||
  [ $? = 4 ]
"$regarment" evaluate "$out/people/truth/ground_truth.csv" --out "$out/direct" --method direct ||
  [ $? = 4 ]
"$regarment" evaluate "$out/people/truth/ground_truth.csv" --out "$out/annealing" \
  --method annealing --only 'case-00?5*' --runs 1 --evaluations 200 || [ $? = 4 ]
