#!/bin/bash
# Builds docker/Dockerfile and runs what it makes, with buildah alone (as root, no daemon): the image
# fits its example with nothing but itself, says what it consists of, and is healthy while it
# serves. Its base, Debian 12 as docker.io has it, is made by mmdebstrap. Prints the image's size.
set -eu
cd "$(dirname "$0")/../.."
scripts/install_packages.sh full
folder=$(mktemp -d)
trap 'buildah rm --all >/dev/null 2>&1; rm -rf --one-file-system "$folder"' EXIT
export STORAGE_DRIVER=vfs
buildah() { command buildah --root "$folder/storage" --runroot "$folder/run" "$@"; }
mirror=$(sed -n 's/^URIs: *//p' /etc/apt/sources.list.d/debian.sources 2>/dev/null | head -1)
[ -n "$mirror" ] || mirror=$(sed -n 's/^deb \(\[[^]]*\] \)\?\([^ ]*\) .*/\2/p' /etc/apt/sources.list | head -1)

mmdebstrap --variant=minbase --quiet bookworm "$folder/base.tar" "$mirror"
base=$(buildah from scratch)
tar -C "$(buildah mount "$base")" -xf "$folder/base.tar"
buildah umount "$base" >/dev/null
buildah commit -q "$base" localhost/bookworm >/dev/null
rm "$folder/base.tar"

# What was compiled before need not be compiled again, nor what is committed be copied with the rest.
git archive --prefix=source/ HEAD | tar -x -C "$folder"
cache=${CCACHE_DIR:-$HOME/.cache/ccache}
mkdir -p "$cache"
buildah bud -q --isolation chroot --network host --format docker --volume "$cache:/root/.cache/ccache" \
  --build-arg BASE=localhost/bookworm --target run -t localhost/regarment \
  -f "$folder/source/docker/Dockerfile" "$folder/source" >/dev/null

image=$(buildah from localhost/regarment)
root=$(buildah mount "$image")
in_image() { buildah run --isolation chroot "$image" -- "$@"; }
[ "$(in_image id -un)" = regarment ] || { echo "it runs as $(in_image id -un)"; exit 1; }
in_image regarment fit /usr/share/doc/regarment/examples/skirt-1.mesh.ply --garment skirt --out skirt --quiet
test -s "$root/home/regarment/skirt/report.html"
grep -q '"SPDX-2.3"' "$root/usr/share/doc/regarment/regarment.spdx.json"
in_image regarment doctor --data /data --quiet

check=$(buildah inspect --format '{{index .Docker.Config.Healthcheck.Test 3}}' "$image")
in_image sh -c 'regarment serve --data /data --workers 1 >/tmp/serve.log 2>&1 & echo $! >/tmp/server
  for _ in $(seq 100); do grep -q listening /tmp/serve.log && break; sleep 0.1; done
  bash -c "$1"; healthy=$?; kill "$(cat /tmp/server)"; wait; exit $healthy' sh "$check"

size() { du -sm --apparent-size "$1" | cut -f1; }
echo "image $(size "$root") MB, $(size "$(buildah mount "$base")") MB of it its base; the program $(stat -c %s "$root/usr/bin/regarment") bytes"
