#!/usr/bin/env python3
"""How the error grows with damage. Takes undamaged scans of single garments that `regarment
synthesize` made, damages each by kind and amount, has `regarment evaluate` fit them, prints a table
and writes OUT/damage.csv: mean and median absolute error, largest error, 90 % intervals that hold,
how wide they are, and how many scans came to no result.

  hole      cloth round one place is missing
  holes     cloth round several places, 10 cm wide each
  column    what one side of a scanner sees is missing, of the person too
  outliers  stray points within 15 cm of the cloth (of a mesh: small triangles)
  noise     1 mm per 10 %, across the surface on average

Amounts are shares of the garment's surface. The same arguments give the same scans.

    damage_curve.py PROGRAM MADE OUT [--cases 6] [--amounts 0,10,20,30,40] [--kinds hole,...]
                    [--seed 1] [--method joint] [--jobs 1] [further arguments of evaluate]
"""
import argparse
import csv
import math
import pathlib
import random
import statistics

from made_scans import (axes, cases, evaluate, metres, read_scan, spread, write_scan,
                        write_table)

HOLE = 0.05  # m, radius
STRAY = 0.15  # m


def garment_of(scan):
    return [v for v, label in enumerate(scan.labels) if 0 < label < 255]


def without(scan, gone):
    return scan.keep(set(range(len(scan.rows))) - gone)


def hole(scan, row, share, dice):
    cloth = garment_of(scan)
    middle = scan.rows[dice.choice(cloth)][:3]
    order = sorted(cloth, key=lambda v: math.dist(scan.rows[v][:3], middle))
    return without(scan, set(order[:round(share * len(cloth))]))


def holes(scan, row, share, dice):
    cloth = garment_of(scan)
    left, gone = set(cloth), set()
    while len(gone) < share * len(cloth):
        middle = scan.rows[dice.choice(sorted(left))][:3]
        near = {v for v in left if math.dist(scan.rows[v][:3], middle) < HOLE / metres(row)}
        gone |= near
        left -= near
    return without(scan, gone)


def column(scan, row, share, dice):
    cloth = garment_of(scan)
    _, level = axes(row)
    middle = [statistics.fmean(scan.rows[v][a] for v in cloth) for a in level]
    start = dice.uniform(0, 2 * math.pi)

    def turn(v):
        d = [scan.rows[v][a] - m for a, m in zip(level, middle)]
        return (math.atan2(d[1], d[0]) - start) % (2 * math.pi)

    most = sorted(turn(v) for v in cloth)[round(share * len(cloth)) - 1]
    return without(scan, {v for v in range(len(scan.rows)) if turn(v) <= most})


def outliers(scan, row, share, dice):
    cloth = garment_of(scan)
    reach = STRAY / metres(row)
    out = scan.keep(range(len(scan.rows)))
    labels = bytearray(out.labels)
    corners = 3 if scan.faces else 1
    for _ in range(round(share * len(cloth)) // corners):
        base = scan.rows[dice.choice(cloth)]
        at = [c + dice.uniform(-reach, reach) for c in base[:3]]
        first = len(out.rows)
        for _ in range(corners):
            moved = [c + dice.uniform(-reach, reach) / 30 for c in at]
            out.rows.append(tuple(moved) + tuple(base[3:]))
            labels.append(255)
        if scan.faces:
            out.faces.append((first, first + 1, first + 2))
    out.labels = bytes(labels)
    return out


def noise(scan, row, share, dice):
    sigma = 0.01 * share / metres(row)
    out = scan.keep(range(len(scan.rows)))
    out.rows = [tuple(c + dice.gauss(0, sigma) for c in r[:3]) + tuple(r[3:]) for r in out.rows]
    return out


KINDS = {"hole": hole, "holes": holes, "column": column, "outliers": outliers, "noise": noise}


def make(a):
    """Writes the damaged scans and their truth table."""
    truth = a.out / "truth"
    truth.mkdir(parents=True, exist_ok=True)
    whole = [c for c in cases(a.made) if {r["layer"] for r in c[1]} == {"1"}
             and not c[1][0]["damage"] and c[1][0]["kind"] != "closed"]
    table = []
    for path, rows, labels in spread(whole, a.cases):
        scan = read_scan(path, labels)
        for kind in a.kinds:
            for amount in a.amounts:
                if amount == 0 and kind != a.kinds[0]:
                    continue  # the whole scan stands for all kinds
                name = f"{path.name.split('.')[0]}-{kind if amount else 'whole'}-{amount}"
                dice = random.Random(f"{a.seed} {name}")
                hurt = KINDS[kind](scan, rows[0], amount / 100, dice) if amount else scan
                suffix = "mesh" if scan.faces else "cloud"
                file = a.out / f"{name}.{suffix}.ply"
                found = truth / f"{name}.{suffix}.labels.u8"
                write_scan(hurt, file, found)
                table += [dict(r, scan=f"../{file.name}", labels=found.name,
                               damage=f"{kind} {amount} %" if amount else "") for r in rows]
    return write_table(table, a.out)


def line_of(scans):
    """One row of the table from the scans of a kind and amount."""
    done = [s for s in scans if not s.get("failure")]
    seen = [d for s in done for d in s["dimensions"]
            if d["truth_observable"] and d.get("observable") and "estimate_cm" in d]
    flagged = sum(not d.get("observable", True) for s in done for d in s["dimensions"])
    out = {"scans": len(scans), "no": len(scans) - len(done), "flagged": flagged}
    if seen:
        off = [abs(d["estimate_cm"] - d["truth_cm"]) for d in seen]
        held = [d["low_cm"] <= d["truth_cm"] <= d["high_cm"] for d in seen]
        out |= {"mean_cm": statistics.fmean(off), "median_cm": statistics.median(off),
                "largest_cm": max(off), "held": statistics.fmean(held),
                "width_cm": statistics.median(d["high_cm"] - d["low_cm"] for d in seen)}
    return out


def main():
    parse = argparse.ArgumentParser(description=__doc__,
                                    formatter_class=argparse.RawDescriptionHelpFormatter)
    parse.add_argument("program")
    parse.add_argument("made", type=pathlib.Path)
    parse.add_argument("out", type=pathlib.Path)
    parse.add_argument("--cases", type=int, default=6)
    parse.add_argument("--amounts", default="0,10,20,30,40",
                       type=lambda t: [int(x) for x in t.split(",")])
    parse.add_argument("--kinds", default=",".join(KINDS), type=lambda t: t.split(","))
    parse.add_argument("--seed", type=int, default=1)
    parse.add_argument("--method", default="joint")
    parse.add_argument("--jobs", type=int, default=1)
    a, further = parse.parse_known_args()
    evaluation = evaluate(a.program, make(a), a.out / f"evaluation-{a.method}", a.method, a.jobs,
                          further)
    columns = ["scans", "no", "flagged", "mean_cm", "median_cm", "largest_cm", "held", "width_cm"]
    print(f"{'damage':14}" + "".join(f"{c:>12}" for c in columns))
    with open(a.out / "damage.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["kind", "amount_percent", *columns])
        for kind in a.kinds:
            for amount in a.amounts:
                part = f"-{kind if amount else 'whole'}-{amount}"
                scans = [s for s in evaluation["scans"] if s["name"].rsplit(".", 1)[0].endswith(part)]
                line = line_of(scans)
                values = [line.get(c, "") for c in columns]
                writer.writerow([kind, amount, *values])
                print(f"{kind + ' ' + str(amount) + ' %':14}" + "".join(
                    f"{v:12.2f}" if isinstance(v, float) else f"{v:>12}" for v in values))
        for scan in evaluation["scans"]:
            if scan.get("failure"):
                print(f"{scan['name']}: {scan['failure']['line']}")


if __name__ == "__main__":
    main()
