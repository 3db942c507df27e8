#!/usr/bin/env python3
"""Runs the experiments of the paper on scans with known dimensions and writes one page of them.

Every finished fit is kept in OUT/fits, so that a run that was stopped goes on where it was; --page
writes the page of what is there."""

import argparse
import csv
import json
import os
import sys

from experiments import all_fits
from length_change import write_length_change
from page import write_page
from run_fit import run_fit, write_whole

HERE = os.path.dirname(os.path.abspath(__file__))
BINARY = os.path.join(HERE, "..", "..", "build", "release", "regarment")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scans", help="folder with the scans and their truth/")
    parser.add_argument("--out", required=True, help="folder for results and page")
    parser.add_argument("--quick", action="store_true",
                        help="one search of 100 drapes a scan instead of three of 500")
    parser.add_argument("--page", action="store_true", help="only write the page again")
    parser.add_argument("--only", default="", help="only fits whose name contains this")
    parser.add_argument("--binary", default=BINARY, help="the program regarment")
    return parser.parse_args()


def run_all(fits, args):
    for folder in ("fits", "pictures"):
        os.makedirs(os.path.join(args.out, folder), exist_ok=True)
    for number, fit in enumerate(fits, 1):
        if args.only not in fit.name:
            continue
        if os.path.exists(os.path.join(args.out, "fits", fit.name + ".json")):
            continue
        print(f"{number}/{len(fits)} {fit.name}", file=sys.stderr, flush=True)
        run_fit(fit, args.binary, args.scans, args.out)
    write_length_change(args.binary, os.path.join(args.out, "pictures", "length-change.svg"))


def write_results(fits, effort, out):
    """index.html and its figures: estimates.csv by size, results.json by fit."""
    page, html = write_page(out, os.path.join(HERE, "published_tables.csv"), effort, fits, HERE)
    write_whole(os.path.join(out, "index.html"), html)
    with open(os.path.join(out, "estimates.csv"), "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["scan", "measurement", "truth_cm", "published_estimate_cm", "method",
                        "value_cm", "low_cm", "high_cm", "observable"])
        table.writerows(page.estimates)
    write_whole(os.path.join(out, "results.json"),
                "[\n" + ",\n".join(map(json.dumps, page.results.fits.values())) + "\n]\n")
    print(os.path.join(out, "index.html"))


def main():
    args = arguments()
    runs, evaluations = (1, 100) if args.quick else (3, 500)
    fits = all_fits(runs, evaluations)
    if not args.page:
        run_all(fits, args)
    write_results(fits, f"{runs}x{evaluations}", args.out)


if __name__ == "__main__":
    main()
