#!/usr/bin/python3
"""Packs bodies of one topology into one file, see README.md beside this.

usage: pack.py OUT BODY.ply...     binary PLY, metres, z up, facing -y, float x y z and triangles
"""
import os, struct, sys


def read_body(path):
    with open(path, "rb") as file:
        data = file.read()
    end = data.index(b"end_header\n") + 11
    counts = [int(line.split()[2]) for line in data[:end].decode("ascii").splitlines()
              if line.startswith("element")]
    xyz = struct.unpack_from("<%df" % (3 * counts[0]), data, end)
    faces = struct.iter_unpack("<Biii", data[end + 12 * counts[0]:])
    # Into the body frame: y up, z to the front, x to the person's left.
    points = [(x, z, -y) for x, y, z in zip(xyz[0::3], xyz[1::3], xyz[2::3])]
    return points, [face[1:] for face in faces]


def box(points):
    return [[side(p[k] for p in points) for k in range(3)] for side in (min, max)]


def pack(out, paths):
    bodies = [read_body(path) for path in paths]
    triangles = bodies[0][1]
    assert all(body[1] == triangles for body in bodies), "the bodies differ in their triangles"
    points = len(bodies[0][0])
    assert points <= 65536, "an index does not fit into 16 bits"
    parts = [b"RGBODY1\n", struct.pack("<3I", len(bodies), points, len(triangles))]
    boxes = [box(positions) for positions, _ in bodies]
    for path, (low, high) in zip(paths, boxes):
        name = os.path.splitext(os.path.basename(path))[0].encode("ascii")
        parts.append(struct.pack("<32s6f", name, *low, *high))
    parts += [struct.pack("<3H", *triangle) for triangle in triangles]
    for (positions, _), (low, high) in zip(bodies, boxes):
        for p in positions:
            parts.append(struct.pack("<3H", *(round((p[k] - low[k]) / (high[k] - low[k]) * 65535)
                                              for k in range(3))))
    with open(out, "wb") as file:
        file.write(b"".join(parts))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    pack(sys.argv[1], sys.argv[2:])
