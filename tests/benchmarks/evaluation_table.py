#!/usr/bin/env python3
"""Mean and median absolute errors by measurement, from folders that `regarment evaluate` wrote,
side by side: all visible dimensions, or with --undamaged those of single garments on scans whose
table names no damage (and, for the scans of the paper's tables, no name that says so).

    evaluation_table.py [--undamaged] EVALUATION [EVALUATION ...]
"""
import collections
import json
import pathlib
import statistics
import sys


def is_single(scan):
    damaged = scan["damage"] or scan["name"].startswith(("corrupt", "layered"))
    return len(scan["garments"]) == 1 and not damaged


def errors(folder, undamaged):
    """(template, measurement) -> flat and worn errors of visible, measured dimensions, cm"""
    out = collections.defaultdict(lambda: ([], []))
    evaluation = json.loads((pathlib.Path(folder) / "evaluation.json").read_text())
    for scan in evaluation["scans"]:
        if undamaged and not is_single(scan):
            continue
        for d in scan.get("dimensions", []):
            if not (d["truth_observable"] and d.get("observable")) or "estimate_cm" not in d:
                continue
            flat, worn = out[d["template"], d["measurement"]]
            flat.append(d["estimate_cm"] - d["truth_cm"])
            if d.get("worn_cm") is not None and d.get("worn_truth_cm") is not None:
                worn.append(d["worn_cm"] - d["worn_truth_cm"])
    return out


def cell(values):
    if not values:
        return f"{'-':>20}"
    size = [abs(v) for v in values]
    return f"{len(size):5} {statistics.fmean(size):6.2f} ({statistics.median(size):5.2f})"


def main():
    folders = [a for a in sys.argv[1:] if a != "--undamaged"]
    if not folders:
        sys.exit(__doc__)
    found = [errors(folder, "--undamaged" in sys.argv) for folder in folders]
    for folder in folders:
        print(f"{folder}: count, mean and (median) absolute error, flat | worn, cm")
    for key in sorted(set().union(*found)):
        cells = [cell(f[key][0]) + " |" + cell(f[key][1]) for f in found]
        print(f"{' '.join(key):24}", "   ".join(cells))
    everything = [cell([e for flat, _ in f.values() for e in flat]) for f in found]
    print(f"{'all, flat':24}", "   ".join(everything))


main()
