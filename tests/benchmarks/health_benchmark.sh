#!/bin/bash
# How many requests to /healthz the service answers while two fits run, and how fast 99 of 100 of
# them are:  health_benchmark.sh PROGRAM SCAN GARMENT [SECONDS]
# Needs wrk and curl. Fits are sent again until wrk has ended, so that two run all the time.
set -eu
program=$1 scan=$2 garment=$3 seconds=${4:-10}
data=$(mktemp -d)
"$program" serve --data "$data" --port 0 --workers 2 >"$data/out" 2>"$data/log" &
server=$!
trap 'kill $server; wait $server || true; rm -rf "$data"' EXIT
until grep -q listening "$data/out"; do kill -0 $server; done
address=$(sed -n 's/^listening on //p' "$data/out")

send() { curl -sS -o /dev/null -F "scan=@$scan" -F "garments=$garment" "$address/v1/jobs"; }
running() { curl -sS "$address/metrics" | sed -n 's/^regarment_jobs{state="running"} //p'; }
for _ in $(seq $((2 + seconds * 2))); do send; done
until [ "$(running)" = 2 ]; do :; done
wrk -t1 -c32 -d"${seconds}s" --latency "$address/healthz"
echo "fits running at the end: $(running); peak memory of the server:" \
  "$(sed -n 's/^VmHWM:[[:space:]]*//p' /proc/$server/status)"
