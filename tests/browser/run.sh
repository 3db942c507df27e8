#!/bin/sh
# Opens every kind of page in headless Chromium:  run.sh REGARMENT WORK_FOLDER
# Pages are made of examples/data, modules installed (by the lock file) in the work folder; pictures
# taken stay there. Ends with 77, which CTest counts as skipped, where node, npm or Chromium is
# missing. UPDATE_BASELINES=1 keeps the pictures taken as tests/baselines/pages.
set -eu
program=$(realpath "$1")
work=$2
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)

chromium=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || true)}
for needed in node npm; do
  if ! command -v $needed >/dev/null; then
    echo "skipped: there is no $needed here; packages.txt names what these tests need"
    exit 77
  fi
done
if [ -z "$chromium" ]; then
  echo "skipped: there is no chromium here; packages.txt names what these tests need"
  exit 77
fi

mkdir -p "$work"
rm -f "$work"/*.mjs
cp "$here"/*.mjs "$here/package.json" "$here/.npmrc" "$work/"
if ! cmp -s "$here/package-lock.json" "$work/installed.lock"; then
  rm -rf "$work/node_modules"
  cp "$here/package-lock.json" "$work/"
  (cd "$work" && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error) || {
    echo "skipped: npm cannot fetch the modules of package-lock.json"
    exit 77
  }
  cp "$here/package-lock.json" "$work/installed.lock"
fi

data=$source/examples/data
# Another's estimates, all 1 cm too large, are what the evaluation is compared with.
awk -F, -v OFS=, 'NR == 1 { print; next } { $6 += 1; print }' "$data/ground_truth.csv" >"$work/other.csv"
"$program" evaluate "$data/ground_truth.csv" --estimates "$work/other.csv" --out "$work/before" --quiet
"$program" evaluate "$data/ground_truth.csv" --out "$work/evaluation" --no-timing --quiet \
  --baseline "$work/before/evaluation.json" --gate 'mae_cm<=20' --gate 'failures<=0'
"$program" review "$work/evaluation" --out "$work/review.html" --force --quiet

cd "$work"
CHROMIUM=$chromium PROGRAM=$program EXAMPLES=$data PAGES=$work PAPER=$source/examples/paper/index.html \
  BASELINES=$source/tests/baselines/pages node --test
