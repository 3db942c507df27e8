#!/bin/bash
# Installs the Debian package on a bare Debian 12 (mmdebstrap, as root) and fits its example there,
# with nothing on it but what the package holds and asks for. Prints how large the package is and what
# it draws in.
set -eu
cd "$(dirname "$0")/../.."
scripts/install_packages.sh full
folder=$(mktemp -d)
trap 'rm -rf --one-file-system "$folder"' EXIT
mirror=$(sed -n 's/^URIs: *//p' /etc/apt/sources.list.d/debian.sources 2>/dev/null | head -1)
[ -n "$mirror" ] || mirror=$(sed -n 's/^deb \(\[[^]]*\] \)\?\([^ ]*\) .*/\2/p' /etc/apt/sources.list | head -1)

cpack --config build/release/CPackConfig.cmake -B "$folder" >/dev/null
package=$(ls "$folder"/*.deb)
mmdebstrap --variant=minbase --quiet bookworm "$folder/root" "$mirror"
before=$(du -sm "$folder/root" | cut -f1)
cp "$package" "$folder/root/tmp"
chroot "$folder/root" apt-get update -qq
chroot "$folder/root" apt-get install -y -qq --no-install-recommends "/tmp/$(basename "$package")" >/dev/null
chroot "$folder/root" apt-get clean
examples=/usr/share/doc/regarment/examples
chroot "$folder/root" regarment fit "$examples/skirt-1.mesh.ply" --garment skirt --out /tmp/skirt-1 --quiet \
  --ground-truth "$examples/ground_truth.csv" --ground-truth-labels "$examples/skirt-1.mesh.labels.u8"
test -s "$folder/root/tmp/skirt-1/report.html"
echo "package $(stat -c %s "$package") bytes; on a bare system $(( $(du -sm "$folder/root" | cut -f1) - before )) MB with all it needs"
