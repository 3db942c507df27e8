#!/bin/bash
# Installs build/release into an empty folder, builds examples/library against it with nothing else,
# and fits the example scan with that program. Every file of the package but those of "dev" is
# named by the Debian package as well.
set -eu
cd "$(dirname "$0")/../.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cmake --install build/release --prefix "$folder/all" >/dev/null
cmake -S examples/library -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/all" \
  -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$folder/build" >/dev/null
"$folder/build/fit_a_scan" examples/data/skirt-1.mesh.ply | tee "$folder/sizes"
grep -q '^length' "$folder/sizes"

"$folder/all/bin/regarment" --version
zcat "$folder/all/share/man/man1/regarment.1.gz" | grep -q '^.SS regarment fit'

cpack --config build/release/CPackConfig.cmake -B "$folder" >/dev/null 2>&1
dpkg-deb --fsys-tarfile "$folder"/*.deb | tar -t | sed -n 's#^\./usr/\(.*[^/]\)$#\1#p' | sort >"$folder/packed"
cmake --install build/release --component program --prefix "$folder/program" >/dev/null
(cd "$folder/program" && find . -type f -o -type l) | sed 's#^\./##' | sort >"$folder/installed"
diff "$folder/installed" "$folder/packed"
