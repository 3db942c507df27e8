"""The kept results and the paper's own figures, and what is asked of them."""

import csv
import glob
import json
import os

from experiments import TABLES


def published(path):
    """(scan, measurement) -> the paper's estimate, cm, for the scan that mirrors its experiment."""
    out = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            stem = TABLES[int(row["table"])][int(row["experiment"]) - 1]
            out[stem, row["measurement"]] = (float(row["ground_truth_cm"]),
                                             float(row["published_estimate_cm"]))
    return out


class Results:
    def __init__(self, out):
        self.fits = {}
        for path in sorted(glob.glob(os.path.join(out, "fits", "*.json"))):
            with open(path) as file:
                record = json.load(file)
            self.fits[record["name"]] = record

    def get(self, name):
        """A fit that came to a result, or nothing."""
        record = self.fits.get(name)
        return record if record and "garments" in record else None

    def garment(self, name, template=None):
        record = self.get(name)
        if not record:
            return None
        for garment in record["garments"]:
            if template in (None, garment["template"]):
                return garment
        return None

    def measurements(self, name, template=None):
        """measurement -> its entry; empty without a result."""
        garment = self.garment(name, template)
        return {m["name"]: m for m in garment["measurements"]} if garment else {}

    def single(self, variant, stem, kind, free):
        """The one searched dimension of a fit with all others held, with its evaluations."""
        name = f"single.{variant}.{stem}.{kind}.{free}"
        found = self.measurements(name).get(free)
        return (found, self.garment(name)) if found else (None, None)

    def mean_iou(self, name):
        record = self.get(name)
        truth = (record or {}).get("segmentation", {}).get("truth")
        return truth["mean_iou"] if truth else None


def mean(values):
    values = [v for v in values if v is not None]
    return sum(values) / len(values) if values else None


def mean_error(values):
    return mean([abs(v) for v in values if v is not None])
