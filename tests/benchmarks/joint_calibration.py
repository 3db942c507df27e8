#!/usr/bin/env python3
"""What src/analysis/weigh_estimates.cpp is made from: how far each source of a worn dimension is
off on made people, and how their distance from each other goes with the error of the flat one.

    regarment synthesize --cases 200 --seed 4 --out people
    regarment evaluate people/truth/ground_truth.csv --out evaluation
    joint_calibration.py evaluation
"""
import collections
import json
import pathlib
import statistics
import sys

SOURCES = ("fit", "line", "scan")


def quantile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def rows(folder):
    """template, measurement, sources, worn truth, flat error, inside its interval"""
    evaluation = json.loads((folder / "evaluation.json").read_text())
    for scan in evaluation["scans"]:
        result = folder / scan.get("fit", "") / "result.json"
        if not result.is_file():
            continue
        garments = json.loads(result.read_text())["garments"]
        found = {(g["layer"], m["name"]): m for g in garments for m in g["measurements"]}
        for d in scan.get("dimensions", []):
            m = found.get((d["layer"], d["measurement"]))
            if m is None or "worn_fit_cm" not in m or not d["truth_observable"]:
                continue
            if d.get("worn_truth_cm") is None:
                continue
            sources = {s: m[f"worn_{s}_cm"] for s in SOURCES if f"worn_{s}_cm" in m}
            low, high = m["interval_cm"]
            yield (d["template"], d["measurement"], sources, d["worn_truth_cm"],
                   m["value_cm"] - d["truth_cm"], low <= d["truth_cm"] <= high, high - low)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    groups = collections.defaultdict(list)
    for template, name, *rest in rows(pathlib.Path(sys.argv[1])):
        groups[template, name].append(rest)
    for (template, name), entries in sorted(groups.items()):
        print(f"{template} {name}: {len(entries)} dimensions")
        for source in SOURCES:
            errors = [s[source] - truth for s, truth, *_ in entries if source in s]
            if errors:
                print(f"  worn by {source:4}: median {statistics.median(errors):6.2f} cm, mean "
                      f"absolute {statistics.fmean(map(abs, errors)):5.2f}, median absolute "
                      f"{statistics.median(map(abs, errors)):5.2f}")
        for low, high in ((0, 0.5), (0.5, 1), (1, 2), (2, 4), (4, 1e9)):
            flat = [abs(e) for s, _, e, _, _ in entries
                    if low <= max(s.values()) - min(s.values()) < high]
            if flat:
                print(f"  {low:3} cm apart or more: {len(flat):3}, flat off by "
                      f"{statistics.median(flat):5.2f} (median), {quantile(flat, 0.9):5.2f} (90 %)")
        inside = statistics.fmean(i for *_, i, _ in entries)
        width = statistics.median(w for *_, w in entries)
        print(f"  intervals hold {100 * inside:.0f} %, {width:.1f} cm wide (median)")


main()
