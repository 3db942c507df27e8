"""Reads a DXF pattern with ezdxf and prints what it found as JSON: per block its outline's corners,
the lengths of its seams, notches and text, and how often ezdxf found fault with the file."""
import json
import math
import sys

import ezdxf
from ezdxf import recover


def points(polyline):
    found = [(v.dxf.location.x, v.dxf.location.y) for v in polyline.vertices]
    return found + found[:1] if polyline.is_closed else found


def length(line):
    return sum(math.dist(a, b) for a, b in zip(line, line[1:]))


def area(line):
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(line, line[1:]))) / 2


def of_layer(block, kind, layer):
    return [e for e in block if e.dxftype() == kind and e.dxf.layer == layer]


def describe(block):
    outlines = [points(e) for e in of_layer(block, "POLYLINE", "1")]
    grains = of_layer(block, "LINE", "7")
    return {
        "outlines": outlines,
        "perimeters": [length(o) for o in outlines],
        "areas": [area(o) for o in outlines],
        "seams": [length(points(e)) for e in of_layer(block, "POLYLINE", "14")],
        "turns": len(of_layer(block, "POINT", "2")),
        "notches": [
            [e.dxf.location.x, e.dxf.location.y, e.dxf.thickness, e.dxf.angle]
            for e in of_layer(block, "POINT", "4")
        ],
        "grains": [[e.dxf.start.x, e.dxf.start.y, e.dxf.end.x, e.dxf.end.y] for e in grains],
        "internal": len(of_layer(block, "LINE", "8")),
        "text": [e.dxf.text for e in block if e.dxftype() == "TEXT"],
    }


def own_faults(fixes):
    """ezdxf deletes the SEQEND of every R12 polyline, also of those it wrote itself."""
    return [f.message for f in fixes if "SEQEND" not in f.message]


document, audit = recover.readfile(sys.argv[1])
model = document.modelspace()
print(json.dumps({
    "version": document.dxfversion,
    "errors": [e.message for e in audit.errors],
    "fixes": own_faults(audit.fixes),
    "text": [e.dxf.text for e in model if e.dxftype() == "TEXT"],
    "inserts": [e.dxf.name for e in model if e.dxftype() == "INSERT"],
    "blocks": {b.name: describe(b) for b in document.blocks if not b.name.startswith("*")},
}))
