#!/usr/bin/env python3
"""Does it matter whether a scan is closed under the hem (Hasler et al. 2007, Fig. 5)? Takes closed
scans of single garments that `regarment synthesize` made, cuts off the surface that the
reconstruction made up, has `regarment evaluate` fit both, and prints how far both lie apart. With
--method annealing also the paper's variants: the cap left in, and a border that attracts, which
pushes the hem up.

    closed_and_cut.py PROGRAM MADE OUT [--cases 6] [--method joint] [--jobs 1]
                      [further arguments of evaluate]
"""
import argparse
import pathlib
import statistics

from made_scans import cases, evaluate, read_scan, spread, write_scan, write_table

MADE_UP = 255
# name, which scans, further arguments of fit
VARIANTS = {
    "joint": [("closed", "closed", ""), ("cut", "cut", "")],
    "annealing": [("closed, cap masked", "closed", ""), ("cut", "cut", ""),
                  ("closed, cap kept", "closed", "--no-cap-detection"),
                  ("cut, border attracts", "cut", "--no-border-rejection")],
}


def cut(scan):
    """Without the made-up surface."""
    return scan.keep({v for v, label in enumerate(scan.labels) if label != MADE_UP})


def make(a):
    """Writes both versions with a truth table each."""
    whole = [c for c in cases(a.made) if {r["layer"] for r in c[1]} == {"1"}
             and c[1][0]["kind"] == "closed" and not c[1][0]["damage"]]
    chosen = spread(whole, a.cases)
    for version, change in (("closed", lambda scan: scan), ("cut", cut)):
        truth = a.out / version / "truth"
        truth.mkdir(parents=True, exist_ok=True)
        table = []
        for path, rows, labels in chosen:
            found = truth / labels.name
            write_scan(change(read_scan(path, labels)), a.out / version / path.name, found)
            table += [dict(r, scan=f"../{path.name}", labels=found.name) for r in rows]
        write_table(table, a.out / version)


def fitted(a, number, version, options, further):
    """(scan, measurement) -> (estimate, truth), cm"""
    further = further + ([f"--args={options}"] if options else [])
    evaluation = evaluate(a.program, a.out / version / "truth" / "ground_truth.csv",
                          a.out / f"evaluation-{a.method}-{number}", a.method, a.jobs, further)
    return {(s["name"], d["measurement"]): (d["estimate_cm"], d["truth_cm"])
            for s in evaluation["scans"] if not s.get("failure")
            for d in s["dimensions"] if d.get("observable")}


def main():
    parse = argparse.ArgumentParser(description=__doc__,
                                    formatter_class=argparse.RawDescriptionHelpFormatter)
    parse.add_argument("program")
    parse.add_argument("made", type=pathlib.Path)
    parse.add_argument("out", type=pathlib.Path)
    parse.add_argument("--cases", type=int, default=6)
    parse.add_argument("--method", default="joint", choices=list(VARIANTS))
    parse.add_argument("--jobs", type=int, default=1)
    a, further = parse.parse_known_args()
    make(a)
    found = {name: fitted(a, number, version, options, further)
             for number, (name, version, options) in enumerate(VARIANTS[a.method])}
    names = list(found)
    print("cm".ljust(34) + "truth".rjust(10) + "".join(name.rjust(22) for name in names))
    for key in sorted({k for each in found.values() for k in each}):
        each = [found[name].get(key) for name in names]
        truth = next(e[1] for e in each if e)
        print(" ".join(key).ljust(34) + f"{truth:10.1f}"
              + "".join(f"{e[0]:22.1f}" if e else "no".rjust(22) for e in each))
    for measurement in sorted({k[1] for k in found[names[0]]}):
        apart = [abs(found[names[0]][k][0] - found[names[1]][k][0]) for k in found[names[0]]
                 if k[1] == measurement and k in found[names[1]]]
        off = [statistics.fmean([abs(e[0] - e[1]) for k, e in found[n].items()
                                 if k[1] == measurement] or [float("nan")]) for n in names]
        if apart:
            print(f"{measurement:16} {names[0]} and {names[1]} apart: mean "
                  f"{statistics.fmean(apart):.2f}, largest {max(apart):.2f}; mean error "
                  + ", ".join(f"{n} {o:.2f}" for n, o in zip(names, off)))


if __name__ == "__main__":
    main()
