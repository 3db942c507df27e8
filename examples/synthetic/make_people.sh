#!/bin/sh
# Makes people, draws them and measures them. Usage: make_people.sh OUT [CASES]
set -eu
out=${1:?usage: make_people.sh OUT [CASES]}
cases=${2:-12}
root=$(cd "$(dirname "$0")/../.." && pwd)
regarment=${REGARMENT:-$root/build/release/regarment}

"$regarment" synthesize --out "$out/scans" --cases "$cases" --seed 1 --force
"$regarment" render "$out"/scans/*.ply --out "$out/pictures" --force
# All of them on one sheet, where ImageMagick is installed.
if command -v montage > /dev/null; then
  montage "$out"/pictures/*-front.png -background white -tile 6x -geometry 200x340 "$out/people.png"
fi
# A scan that comes to no result is told in the page and does not end this script.
"$regarment" evaluate "$out/scans/truth/ground_truth.csv" --out "$out/evaluation" --force ||
  echo "some scans came to no result, see the page"
echo "$out/evaluation/evaluation.html"
