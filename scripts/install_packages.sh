#!/bin/sh
# Installs what packages.txt lists for the purposes named: install_packages.sh build test
# Asks apt only when something is missing, as root or through sudo.
set -eu
cd "$(dirname "$0")/.."

missing=""
for purpose in "$@"; do
  for line in $(awk -v want="$purpose" '!/^#/ && $2 == want { print $1 ":" $3 }' packages.txt); do
    package=${line%%:*}
    command=${line#*:}
    if [ -n "$command" ] && command -v "$command" >/dev/null; then continue; fi
    state=$(dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null || true)
    case "$state" in
      ii*) ;;
      *) missing="$missing $package" ;;
    esac
  done
done
[ -n "$missing" ] || exit 0

as_root=""
if [ "$(id -u)" != 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "install_packages.sh: missing:$missing; run it as root or install sudo" >&2
    exit 1
  fi
  as_root="sudo"
fi
echo "installing:$missing"
$as_root env DEBIAN_FRONTEND=noninteractive apt-get update -qq
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
