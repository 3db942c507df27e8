#!/bin/sh
# Submits a scan to a running service, follows its events, and saves the report:
#   regarment serve --port 8080 --data out/service &
#   examples/service/submit.sh http://127.0.0.1:8080 examples/data/skirt-1.mesh.ply skirt report.html
# Several garments go with commas, outermost first. REGARMENT_KEY is sent where the service wants a
# key. Needs curl.
set -eu
if [ $# != 4 ]; then
  echo "usage: submit.sh http://ADDRESS:PORT SCAN GARMENTS REPORT.html" >&2
  exit 2
fi
service=$1
scan=$2
garments=$3
report=$4

ask() {
  if [ -n "${REGARMENT_KEY:-}" ]; then
    curl -sS --fail-with-body -H "Authorization: Bearer $REGARMENT_KEY" "$@"
  else
    curl -sS --fail-with-body "$@"
  fi
}

# The answer is 202 with the address of the job.
answer=$(ask -D - -o /dev/null -F "scan=@$scan" -F "garments=$garments" "$service/v1/jobs")
job=$(printf '%s' "$answer" | tr -d '\r' | sed -n 's/^Location: //p')
echo "submitted: $service$job"

# The stream of events ends with the job.
ask -N "$service$job/events" | while IFS= read -r line; do
  case "$line" in
    data:*) printf '%s\n' "${line#data: }" ;;
  esac
done

ask -o "$report" "$service$job/report"
echo "report: $report"
