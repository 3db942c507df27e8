#!/usr/bin/env python3
"""Prints how often labels are right at the probability they are given.

    label_reliability.py FITS TRUTH

FITS: the folder `fits` of an evaluation, with segmented.ply of each scan; TRUTH: the folder with
NAME.labels.u8 of the same scans. Outliers and invented surface (255) are not counted. Where labels
are calibrated, `right` is `stated` in every row.
"""
import bisect
import collections
import pathlib
import struct
import sys

BOUNDS = (0.5, 0.55, 0.6, 0.7, 0.8, 0.9, 0.95, 0.99)
TYPES = {"float": "f", "double": "d", "uchar": "B", "int": "i", "uint": "I"}


def labels_of(path):
    """The label and the probability of each vertex of a segmented.ply."""
    data = path.read_bytes()
    head, _, body = data.partition(b"end_header\n")
    count, names, layout, inside = 0, [], "<", False
    for line in head.decode().splitlines():
        words = line.split()
        if words[:1] == ["element"]:
            inside = words[1] == "vertex"
            count = int(words[2]) if inside else count
        elif inside and words[:1] == ["property"]:
            names.append(words[2])
            layout += TYPES[words[1]]
    label, probability = names.index("label"), names.index("probability")
    rows = struct.iter_unpack(layout, body[:count * struct.calcsize(layout)])
    return [(row[label], row[probability]) for row in rows]


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    fits, truth = map(pathlib.Path, sys.argv[1:])
    count, right, stated = collections.Counter(), collections.Counter(), collections.Counter()
    for file in sorted(fits.glob("*/segmented.ply")):
        labels = truth / (file.parent.name + ".labels.u8")
        if not labels.exists():
            continue
        for (label, probability), true in zip(labels_of(file), labels.read_bytes()):
            if true == 255:
                continue
            row = max(0, bisect.bisect_right(BOUNDS, probability) - 1)
            count[row] += 1
            right[row] += label == true
            stated[row] += probability
    every = sum(count.values())
    if every == 0:
        sys.exit(f"{fits}: no segmented.ply with true labels in {truth}")
    print(f"{every} vertices, {100 * sum(right.values()) / every:.2f} % right, "
          f"{100 * sum(stated.values()) / every:.2f} % stated")
    print("probability      share   stated   right")
    for row, (low, high) in enumerate(zip(BOUNDS, BOUNDS[1:] + (1,))):
        if count[row]:
            print(f"{low:.2f} - {high:.2f}  {100 * count[row] / every:6.2f} %  "
                  f"{stated[row] / count[row]:.3f}    {right[row] / count[row]:.3f}")


main()
