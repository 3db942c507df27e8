"""Scans that `regarment synthesize` wrote, read and written again: for the benchmarks that change
them. Plain Python; a scan is a header of names and rows of numbers."""
import csv
import json
import pathlib
import struct
import subprocess

FORMATS = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
           "float": "f", "double": "d"}


class Scan:
    """`rows`: a tuple per vertex, the first three x, y, z; `faces`: corner triples, none for a
    cloud; `labels`: one per vertex, 0 person, 1.. garments, 255 surface that was made up."""

    def __init__(self, properties, rows, faces, labels):
        self.properties, self.rows, self.faces, self.labels = properties, rows, faces, labels

    def keep(self, kept):
        """The scan of the vertices whose indices are in `kept`, and the faces among them."""
        order = sorted(kept)
        new = {old: i for i, old in enumerate(order)}
        faces = [tuple(new[v] for v in f) for f in self.faces if all(v in new for v in f)]
        return Scan(self.properties, [self.rows[v] for v in order], faces,
                    bytes(self.labels[v] for v in order))


def read_scan(path, labels):
    data = pathlib.Path(path).read_bytes()
    head, body = data.split(b"end_header\n", 1)
    properties, vertices, faces, of_vertex = [], 0, 0, False
    for line in head.decode().splitlines():
        word = line.split()
        if word[0] == "element":
            of_vertex = word[1] == "vertex"
            vertices, faces = (int(word[2]), faces) if of_vertex else (vertices, int(word[2]))
        elif word[0] == "property" and of_vertex:
            properties.append((word[1], word[2]))
    row = struct.Struct("<" + "".join(FORMATS[kind] for kind, _ in properties))
    end = vertices * row.size
    face = struct.Struct("<B3i")
    corners = [f[1:] for f in face.iter_unpack(body[end:end + faces * face.size])]
    return Scan(properties, list(row.iter_unpack(body[:end])), corners,
                pathlib.Path(labels).read_bytes())


def write_scan(scan, path, labels):
    lines = ["ply", "format binary_little_endian 1.0", f"element vertex {len(scan.rows)}"]
    lines += [f"property {kind} {name}" for kind, name in scan.properties]
    if scan.faces:
        lines += [f"element face {len(scan.faces)}", "property list uchar int vertex_indices"]
    row = struct.Struct("<" + "".join(FORMATS[kind] for kind, _ in scan.properties))
    with open(path, "wb") as out:
        out.write("\n".join(lines + ["end_header\n"]).encode())
        out.writelines(row.pack(*r) for r in scan.rows)
        out.writelines(struct.pack("<B3i", 3, *f) for f in scan.faces)
    pathlib.Path(labels).write_bytes(scan.labels)


def cases(folder):
    """Per scan file of the truth table, in its order: (path, rows of the table, path of labels)"""
    truth = pathlib.Path(folder) / "truth"
    found = {}
    with open(truth / "ground_truth.csv", newline="") as table:
        for row in csv.DictReader(table):
            found.setdefault(row["scan"], []).append(row)
    return [((truth / scan).resolve(), rows, (truth / rows[0]["labels"]).resolve())
            for scan, rows in found.items()]


def spread(found, n):
    """`n` of them, from first to last."""
    return [found[i * len(found) // n] for i in range(min(n, len(found)))]


def write_table(rows, folder):
    """Writes the truth table of a folder of scans; returns its path."""
    path = pathlib.Path(folder) / "truth" / "ground_truth.csv"
    with open(path, "w", newline="") as out:
        writer = csv.DictWriter(out, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    return path


def evaluate(program, table, folder, method, jobs, further):
    """Has the program fit all scans of a table; what it found of them."""
    command = [program, "evaluate", table, "--out", folder, "--method", method, "--jobs", jobs,
               *further]
    run = subprocess.run([str(c) for c in command], stdout=subprocess.DEVNULL, check=False)
    if run.returncode not in (0, 4):
        raise SystemExit(f"{' '.join(map(str, command))} ended with {run.returncode}")
    return json.loads((pathlib.Path(folder) / "evaluation.json").read_text())


def metres(row):
    """One unit of the scan file, m."""
    return {"mm": 0.001, "cm": 0.01, "m": 1.0, "inch": 0.0254}[row["units"]]


def axes(row):
    """Index of the upright axis and those of the two level ones."""
    up = "xyz".index(row["up"][-1])
    return up, [a for a in range(3) if a != up]
