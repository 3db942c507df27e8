#!/usr/bin/env python3
"""Runs `regarment bench` without a scan and with the paper's search, which takes minutes, and looks
at what it says: every part is there, every figure is one, and the two methods stand beside each
other. How fast anything is, is not judged.

bench_command_test.py PROGRAM
"""

import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

PARTS = ["A fit", "Reading", "Silhouettes", "Nearest points", "Solver"]
ROWS = {"from the file to the report": "s", "fitted again from its state": "s",
        "two layers, to the report": "s", "start of the program": "ms"}
CURVES = {"a fit": "vertices", "nearest points, 3 mm away": "triangles",
          "a step of the joint fit": "particles"}


def fail(words):
    sys.exit(f"bench_command_test.py: {words}")


def positive(value):
    return isinstance(value, (int, float)) and math.isfinite(value) and value > 0


def check_rows(rows):
    parts = list(dict.fromkeys(row["group"] for row in rows))
    if parts != PARTS:
        fail(f"the parts are {parts}, not {PARTS}")
    for row in rows:
        if not row["unit"] or not positive(row["value"]):
            fail(f"no figure: {row}")
        if "other" in row:
            ratio = row["other_value"] / row["value"]  # of figures with four digits
            if not math.isclose(row["ratio"], ratio, rel_tol=2e-3):
                fail(f"the ratio is not that of its figures: {row}")
    for begin, unit in ROWS.items():
        units = [row["unit"] for row in rows if row["name"].startswith(begin)]
        if units != [unit]:
            fail(f"'{begin}' has the rows {units}, not one in {unit}")
    beside = {row["other"]: row["name"] for row in rows if "other" in row}
    if set(beside) != {"annealing", "CGAL", "Eigen"}:
        fail(f"what is compared with is {sorted(beside)}")
    names = [row["name"] for row in rows if row.get("other") == "annealing"]
    if len(names) != 2 or "mean error" not in names:
        fail(f"annealing stands beside {names}, not beside time and error")


def check_curves(curves):
    if {curve["name"]: curve["size_unit"] for curve in curves} != CURVES:
        fail(f"the curves are {[curve['name'] for curve in curves]}")
    for curve in curves:
        sizes = [point["size"] for point in curve["points"]]
        if len(sizes) < 2 or sizes != sorted(set(sizes)):
            fail(f"sizes of '{curve['name']}' do not grow: {sizes}")
        if not all(positive(point["seconds"]) for point in curve["points"]):
            fail(f"'{curve['name']}' has times that are none")
        if not math.isfinite(curve["exponent"]):
            fail(f"'{curve['name']}' has no exponent")


def check_page(page, rows):
    if re.search(r"(src|href)\s*=\s*[\"']?\s*(https?:|//)", page):
        fail("the page asks for something elsewhere")
    if page.count("<tr>") != len(rows) + 1:
        fail(f"the page has {page.count('<tr>') - 1} rows, the JSON {len(rows)}")
    if page.count("<svg") != len(CURVES):
        fail(f"the page has {page.count('<svg')} curves")


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: bench_command_test.py PROGRAM")
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder, "bench.html")
        run = subprocess.run(
            [sys.argv[1], "bench", "--annealing", "--repeats", "1", "--most-vertices", "60000",
             "--out", page, "--json", "--quiet"], stdout=subprocess.PIPE, text=True)
        if run.returncode != 0:
            fail(f"ended with {run.returncode}")
        bench = json.loads(run.stdout)
        if bench["schema"] != "regarment.bench/1":
            fail(f"the schema is {bench['schema']}")
        check_rows(bench["rows"])
        check_curves(bench["curves"])
        check_page(page.read_text(), bench["rows"])
    print(f"bench_command_test.py: {len(bench['rows'])} figures, {len(bench['curves'])} curves")


if __name__ == "__main__":
    main()
