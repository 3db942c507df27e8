#!/usr/bin/python3
"""Writes what a built program consists of as SPDX 2.3 (JSON) to standard output:

    sbom.py PROGRAM VERSION

Shared libraries as the dynamic linker finds them, and what is compiled in, each with the Debian package
it comes from. The same program on the same system gives the same bytes; SOURCE_DATE_EPOCH is its time.
"""
import datetime
import hashlib
import json
import os
import re
import subprocess
import sys

# Compiled in, or linked statically: header of the library, its licence.
COMPILED_IN = {
    "libeigen3-dev": "MPL-2.0",
    "libcgal-dev": "GPL-3.0-or-later AND LGPL-3.0-or-later",
    "libboost-dev": "BSL-1.0",
    "nlohmann-json3-dev": "MIT",
    "libvalijson-dev": "BSD-2-Clause",
    "libkainjow-mustache-dev": "BSL-1.0",
    "libcli11-dev": "BSD-3-Clause",
    "libtbb-dev": "Apache-2.0",
}
QUERY = "${Package}\t${Version}\t${Architecture}\t${Homepage}\n"


def lines_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()


def shared_libraries(program):
    """Real paths of all it loads, its libraries' libraries too."""
    paths = (re.match(r"\s*(?:\S+ => )?(/\S+) \(0x", line) for line in lines_of("ldd", program))
    return sorted({os.path.realpath(path[1]) for path in paths if path})


def owner(path):
    """The package of an installed file; Debian 12 may know it without /usr."""
    for known in (path, path.removeprefix("/usr")):
        found = subprocess.run(["dpkg-query", "-S", known], capture_output=True, text=True, check=False)
        if found.returncode == 0:
            return found.stdout.split(":")[0].split(",")[0]
    raise SystemExit(f"sbom.py: no package owns {path}")


def installed(name):
    """Version, architecture and home page of the package with these files; its virtual names too."""
    rows = lines_of("dpkg-query", "-W", "-f", QUERY, name)
    _, version, architecture, home = rows[0].split("\t")
    return version, architecture, home


def reference(name):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)


def package(name, licence):
    version, architecture, home = installed(name)
    locator = f"pkg:deb/debian/{name}@{version.replace(':', '%3A').replace('+', '%2B')}?arch={architecture}"
    return {
        "SPDXID": reference(name),
        "name": name,
        "versionInfo": version,
        "downloadLocation": "NOASSERTION",
        "homepage": home or "NOASSERTION",
        "filesAnalyzed": False,
        "licenseConcluded": "NOASSERTION",
        "licenseDeclared": licence,
        "copyrightText": "NOASSERTION",
        "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                          "referenceLocator": locator}],
    }


def main(program, version):
    with open(program, "rb") as file:
        content = file.read()
    digest = hashlib.sha256(content).hexdigest()
    loaded = sorted({owner(path) for path in shared_libraries(program)})
    itself = {
        "SPDXID": reference("regarment"),
        "name": "regarment",
        "versionInfo": version,
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False,
        "licenseConcluded": "GPL-3.0-or-later",
        "licenseDeclared": "GPL-3.0-or-later",
        "copyrightText": "NOASSERTION",
        "primaryPackagePurpose": "APPLICATION",
        "checksums": [{"algorithm": "SHA256", "checksumValue": digest}],
    }
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", itself["SPDXID"])]
    relations += [(itself["SPDXID"], "DYNAMIC_LINK", reference(name)) for name in loaded]
    relations += [(itself["SPDXID"], "STATIC_LINK", reference(name)) for name in sorted(COMPILED_IN)]
    created = datetime.datetime.fromtimestamp(int(os.environ.get("SOURCE_DATE_EPOCH", "0")),
                                              datetime.timezone.utc)
    document = {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"regarment-{version}",
        "documentNamespace": f"urn:regarment:{version}:{digest}",
        "creationInfo": {"created": created.strftime("%Y-%m-%dT%H:%M:%SZ"),
                         "creators": ["Tool: regarment-sbom"]},
        "packages": [itself] + [package(name, "NOASSERTION") for name in loaded]
                    + [package(name, COMPILED_IN[name]) for name in sorted(COMPILED_IN)],
        "relationships": [{"spdxElementId": a, "relationshipType": kind, "relatedSpdxElement": b}
                          for a, kind, b in relations],
    }
    json.dump(document, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__.strip())
    main(sys.argv[1], sys.argv[2])
