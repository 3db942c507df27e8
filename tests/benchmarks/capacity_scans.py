#!/usr/bin/python3
"""One person as scans of many sizes: `capacity_scans.py SCAN.ply DIR VERTICES...` writes
DIR/mesh-N.ply and DIR/cloud-N.ply for each number N of vertices.

A mesh becomes coarser by joining what lies in one cell of a grid, finer by splitting its longest
sides; a cloud is the vertices of the mesh. A process of its own, so that whoever weighs the memory of
fits stays small.
"""
import pathlib
import struct
import sys

from made_scans import read_scan


def read_mesh(path):
    scan = read_scan(path, "/dev/null")
    return [row[:3] for row in scan.rows], scan.faces


def write_ply(path, points, faces):
    head = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
    head += "".join(f"property float {axis}\n" for axis in "xyz")
    if faces:
        head += f"element face {len(faces)}\nproperty list uchar int vertex_indices\n"
    vertex, face = struct.Struct("<3f"), struct.Struct("<B3i")
    with open(path, "wb") as out:
        out.write((head + "end_header\n").encode())
        out.writelines(vertex.pack(*p) for p in points)
        out.writelines(face.pack(3, *f) for f in faces)


def joined(points, faces, cell):
    """Each cell's points become their mean; faces that collapse or come twice go."""
    number, sums = {}, []
    new = []
    for x, y, z in points:
        key = (int(x // cell), int(y // cell), int(z // cell))
        at = number.setdefault(key, len(sums))
        if at == len(sums):
            sums.append([0.0, 0.0, 0.0, 0])
        s = sums[at]
        s[0] += x
        s[1] += y
        s[2] += z
        s[3] += 1
        new.append(at)
    kept = {}
    for a, b, c in faces:
        corners = (new[a], new[b], new[c])
        if len(set(corners)) == 3:
            kept.setdefault(tuple(sorted(corners)), corners)
    return [(x / n, y / n, z / n) for x, y, z, n in sums], list(kept.values())


def coarser(points, faces, vertices):
    """By the cell that comes closest to so many vertices in twelve halvings."""
    low, high = 0.0, max(max(p[k] for p in points) - min(p[k] for p in points) for k in range(3))
    for _ in range(12):
        cell = (low + high) / 2
        found = joined(points, faces, cell)
        low, high = (cell, high) if len(found[0]) > vertices else (low, cell)
    return found


def sides(face):
    return tuple(tuple(sorted((face[k], face[(k + 1) % 3]))) for k in range(3))


def split(face, middles):
    """A face into one for each of its sides that is split, and one more."""
    a, b, c = face
    p, q, r = found = [middles.get(side) for side in sides(face)]
    if None not in found:
        return [(a, p, r), (p, b, q), (q, c, r), (p, q, r)]
    for k, middle in enumerate(found):
        if middle is not None:
            a, b, c = face[k], face[(k + 1) % 3], face[(k + 2) % 3]
            return split((a, middle, c), middles) + split((middle, b, c), middles)
    return [face]


def finer(points, faces, vertices):
    """A new vertex in the middle of the longest sides, until there are so many."""
    points, faces = list(points), list(faces)
    while len(points) < vertices:
        def squared(side):
            return sum((p - q) ** 2 for p, q in zip(points[side[0]], points[side[1]]))
        every = sorted({side for face in faces for side in sides(face)},
                       key=lambda side: (-squared(side), side))
        middles = {}
        for side in every[:vertices - len(points)]:
            middles[side] = len(points)
            points.append(tuple((p + q) / 2 for p, q in zip(points[side[0]], points[side[1]])))
        faces = [part for face in faces for part in split(face, middles)]
    return points, faces


def main():
    source, folder, sizes = sys.argv[1], pathlib.Path(sys.argv[2]), sorted(map(int, sys.argv[3:]))
    first = finest = read_mesh(source)
    for vertices in sizes:
        small = vertices < len(first[0])
        mesh = coarser(*first, vertices) if small else finer(*finest, vertices)
        finest = finest if small else mesh
        write_ply(folder / f"mesh-{vertices}.ply", *mesh)
        write_ply(folder / f"cloud-{vertices}.ply", mesh[0], [])


if __name__ == "__main__":
    main()
