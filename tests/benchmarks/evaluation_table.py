#!/usr/bin/env python3
"""Mean and median absolute errors by measurement, from folders that `regarment evaluate` wrote,
side by side, and beneath them 95th percentile, slope of estimate on truth, errors over 3 cm, and how
often and how wide 90 % intervals hold: of all visible dimensions, or with --undamaged of those of
single garments on scans whose table names no damage (and, for the scans of the paper's tables, no
name that says so). --flared: hems half as wide again as the hip and wider, alone.

    evaluation_table.py [--undamaged] [--flared] EVALUATION [EVALUATION ...]
"""
import argparse
import collections
import json
import pathlib
import statistics

FLARED = 1.5


def is_single(scan):
    damaged = scan["damage"] or scan["name"].startswith(("corrupt", "layered"))
    return len(scan["garments"]) == 1 and not damaged


def flared_hem(scan, d):
    hip = [o["truth_cm"] for o in scan["dimensions"]
           if o["measurement"] == "hip" and o["layer"] == d["layer"]]
    return d["template"] == "skirt" and d["measurement"] == "width" and hip \
        and d["truth_cm"] > FLARED * hip[0]


def found_in(folder, undamaged, flared):
    """(template, measurement) -> visible, measured dimensions"""
    out = collections.defaultdict(list)
    evaluation = json.loads((pathlib.Path(folder) / "evaluation.json").read_text())
    for scan in evaluation["scans"]:
        if undamaged and not is_single(scan):
            continue
        for d in scan.get("dimensions", []):
            seen = d["truth_observable"] and d.get("observable") and "estimate_cm" in d
            if seen and (not flared or flared_hem(scan, d)):
                out[d["template"], d["measurement"]].append(d)
    return out


def flat(dimensions):
    return [d["estimate_cm"] - d["truth_cm"] for d in dimensions]


def worn(dimensions):
    return [d["worn_cm"] - d["worn_truth_cm"] for d in dimensions
            if d.get("worn_cm") is not None and d.get("worn_truth_cm") is not None]


def cell(values):
    if not values:
        return f"{'-':>20}"
    size = [abs(v) for v in values]
    return f"{len(size):5} {statistics.fmean(size):6.2f} ({statistics.median(size):5.2f})"


def further(dimensions):
    """p95, slope, share over 3 cm, share of intervals that hold, their median width"""
    size = sorted(abs(e) for e in flat(dimensions))
    truth = [d["truth_cm"] for d in dimensions]
    p95 = size[min(len(size) - 1, round(0.95 * (len(size) - 1)))]
    slope = statistics.linear_regression(truth, [d["estimate_cm"] for d in dimensions]).slope \
        if len(set(truth)) > 1 else float("nan")
    held = statistics.fmean(d["low_cm"] <= d["truth_cm"] <= d["high_cm"] for d in dimensions)
    width = statistics.median(d["high_cm"] - d["low_cm"] for d in dimensions)
    over = statistics.fmean(e > 3 for e in size)
    return f"{p95:7.2f} {slope:6.3f} {over:6.3f} {held:6.2f} {width:6.1f}"


def main():
    parse = argparse.ArgumentParser(description=__doc__,
                                    formatter_class=argparse.RawDescriptionHelpFormatter)
    parse.add_argument("--undamaged", action="store_true")
    parse.add_argument("--flared", action="store_true")
    parse.add_argument("evaluation", nargs="+")
    a = parse.parse_args()
    found = [found_in(folder, a.undamaged, a.flared) for folder in a.evaluation]
    for folder in a.evaluation:
        print(f"{folder}: count, mean and (median) absolute error, flat | worn, cm")
    keys = sorted(set().union(*found))
    for key in keys:
        cells = [cell(flat(f[key])) + " |" + cell(worn(f[key])) for f in found]
        print(f"{' '.join(key):24}", "   ".join(cells))
    all_of = [[d for part in f.values() for d in part] for f in found]
    print(f"{'all, flat':24}", "   ".join(cell(flat(each)) for each in all_of))
    print(f"\n{'':24} p95 cm  slope  >3 cm   held  width, cm")
    for key in keys:
        for f in found:
            if f[key]:
                print(f"{' '.join(key):24}{further(f[key])}")
    for each in all_of:
        if each:
            print(f"{'all':24}{further(each)}")


main()
