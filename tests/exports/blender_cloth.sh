#!/bin/sh
# Fits an example and has Blender wear it out:  blender_cloth.sh REGARMENT SCAN
# Ends with 77, skipped, where Blender is not installed (packages.txt).
set -eu
if ! command -v blender >/dev/null; then
  echo "skipped: there is no blender here; packages.txt names what this test needs"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" fit "$2" --garment skirt --out "$work/result" --quiet
# Its settings and caches stay in the folder that is removed.
HOME=$work blender --background --factory-startup --python-exit-code 1 \
  --python "$(dirname "$0")/blender_cloth.py" -- "$work/result"
