#!/bin/bash
# How much faster two workers finish a batch than one, on the same scans one after the other:
#   batch_benchmark.sh PROGRAM TABLE [OPTIONS OF batch]
# Prints both times and their ratio; the machine should have two cores with nothing else to do.
set -eu
program=$1 table=$2
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# seconds WORKERS: of a whole batch, plan and merge included; status 4 only says that scans failed.
seconds() {
  local begun=$EPOCHREALTIME status=0
  "$program" batch "$table" -o "$folder/$1" --workers "$1" --quiet "${@:2}" 2>"$folder/said" || status=$?
  [ "$status" = 0 ] || [ "$status" = 4 ] || { cat "$folder/said" >&2; exit "$status"; }
  awk -v a="$begun" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.1f", b - a }'
}

one=$(seconds 1 "$@")
two=$(seconds 2 "$@")
diff -rq "$folder/1" "$folder/2"
awk -v a="$one" -v b="$two" 'BEGIN { printf "one worker %s s, two %s s: %.2f times as fast\n", a, b, a / b }'
