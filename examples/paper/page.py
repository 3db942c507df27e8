"""The page: what was measured, beside what the paper says. Nothing is claimed that was not run."""

import os

from claims import claims
from experiments import TABLES
from markup import Pictures, number, scatter, table, text
from results import Results, mean_error, published
from sections import figures, section

TITLES = {
    1: ("Table 1", "Three scans of one skirt"),
    2: ("Table 2", "Two T-shirts, two scans each"),
    3: ("Table 3", "Severe data corruption"),
    4: ("Table 4", "A skirt partly covered by a T-shirt"),
}


LENGTH_CHANGE = ("Fig. 3: the length of a T-shirt goes from 62 to 76 cm. Coarse triangles before "
                 "(a), refined ones before (b) and after (c), coarse ones after (d). Each refined "
                 "point keeps its place in its coarse triangle.")


class Page:
    def __init__(self, out, published_table, effort):
        self.results = Results(out)
        self.published = published(published_table)
        self.pictures = Pictures(os.path.join(out, "pictures"))
        self.effort = effort
        self.estimates = []  # rows of estimates.csv

    def columns(self, stem):
        return [("annealing", f"annealing-{self.effort}.{stem}.mesh"),
                ("joint", f"joint.{stem}.mesh"), ("joint, cloud", f"joint.{stem}.cloud")]

    def table_rows(self, number_):
        """Rows of one of the paper's tables, and the errors by column."""
        template = "tshirt" if number_ == 2 else "skirt"
        errors = {"paper": [], "annealing": [], "joint": [], "joint, cloud": []}
        rows = []
        for stem in TABLES[number_]:
            found = [(column, self.results.measurements(name, template))
                     for column, name in self.columns(stem)]
            for (scan, measurement), (truth, paper) in self.published.items():
                if scan != stem:
                    continue
                errors["paper"].append(paper - truth)
                cells = [f"{stem} {measurement.replace('_', ' ')}", (number(truth), "n"),
                         self.estimate(paper, paper - truth)]
                for column, entries in found:
                    entry = entries.get(measurement)
                    cells.append(self.entry(entry))
                    self.note(stem, measurement, truth, paper, column, entry)
                    if entry and entry["observable"]:
                        errors[column].append(entry["error_cm"])
                rows.append(cells)
        sums = ["Mean absolute error, what is shown", ("", "n")]
        for column in errors:
            sums.append((f"{number(mean_error(errors[column]), 1)}"
                         f"<small>of {len(errors[column])}</small>", "n"))
        return rows + [("sum", sums)], errors

    def note(self, stem, measurement, truth, paper, column, entry):
        if entry:
            self.estimates.append([stem, measurement, truth, paper, column, entry["value_cm"],
                                   entry["interval_cm"][0], entry["interval_cm"][1],
                                   entry["observable"]])

    @staticmethod
    def estimate(value, error):
        return (f"{number(value)}<small>{number(error, 1, True)}</small>", "n")

    def entry(self, entry):
        if not entry:
            return ("not run", "n none")
        if not entry["observable"]:
            return ("hidden", "n none")
        return self.estimate(entry["value_cm"], entry["error_cm"])

    def tables(self):
        out, overall = [], []
        for key, (name, title) in TITLES.items():
            rows, errors = self.table_rows(key)
            head = ["Scan and measurement", ("true, cm", "n"), ("paper", "n"),
                    ("annealing", "n"), ("joint", "n"), ("joint, cloud", "n")]
            overall.append((name, errors))
            out.append(f"<h3 id=\"table{key}\">{name}: {title}</h3>"
                       + table(head, rows, f"{name}, true and estimated sizes")
                       + self.pictures.row(self.segmentations(key)))
        return "".join(out), overall

    def segmentations(self, key):
        wanted = []
        for stem in TABLES[key]:
            if key == 3:
                continue
            for method, name in (("annealing", f"annealing-{self.effort}.{stem}.mesh"),
                                 ("joint", f"joint.{stem}.mesh")):
                iou = self.results.mean_iou(name)
                caption = f"{stem}, {method}" + (f": mean IoU {iou:.3f}" if iou else "")
                wanted.append((f"{name}.segmentation-front", caption))
        return wanted

    def summary(self, overall):
        rows = []
        for name, errors in overall:
            rows.append([name] + [(f"{number(mean_error(errors[c]), 1)}", "n") for c in errors])
        merged = {c: sum((errors[c] for _, errors in overall), []) for c in overall[0][1]}
        rows.append(("sum", ["All"] + [(f"{number(mean_error(merged[c]), 1)}<small>of "
                                        f"{len(merged[c])}</small>", "n") for c in merged]))
        head = ["Mean absolute error, cm", ("paper", "n"), ("annealing", "n"), ("joint", "n"),
                ("joint, cloud", "n")]
        return table(head, rows, "Mean absolute errors by table")

    def curves(self):
        """E_sil and the square root along one dimension, others held at their true sizes."""
        out = []
        for stem in TABLES[1]:
            found, garment = self.results.single("usual", stem, "mesh", "length")
            if not found:
                continue
            tried = garment["evaluations"]
            xs = tried["length_cm"]
            out.append(scatter([("one", "E_sil", list(zip(xs, tried["silhouette"])))],
                               found["truth_cm"], "length tried, cm",
                               f"{stem}: E_sil. It falls all the way: a longer skirt divides by "
                               "more.", "E_sil over the length"))
            stretch = [abs(1 - s) for s in tried["stretch"]]
            top = max(stretch) or 1
            out.append(scatter([("two", "plain", [(x, s / top) for x, s in zip(xs, stretch)]),
                                ("one", "root", [(x, (s / top) ** 0.5)
                                                 for x, s in zip(xs, stretch)])],
                               found["truth_cm"], "length tried, cm",
                               f"{stem}: |1 − E_stretch| as a share of its largest value "
                               "(rings), and its square root (dots).",
                               "The stretch term with and without root"))
            break
        return f"<div class=\"half\">{''.join(out)}</div>" if out else ""

    def variant_table(self, label, variants, cases):
        """Errors of the one searched dimension under several variants."""
        rows, sums = [], {v: [] for v, _ in variants}
        for stem, kind, free in cases:
            found = [self.results.single(v, stem, kind, free) for v, _ in variants]
            if not any(entry for entry, _ in found):
                continue
            truth = next(entry["truth_cm"] for entry, _ in found if entry)
            cells = [f"{stem} {free.replace('_', ' ')}", (number(truth), "n")]
            for (variant, _), (entry, garment) in zip(variants, found):
                if entry:
                    sums[variant].append(entry["error_cm"])
                    cells.append((f"{number(entry['error_cm'], 1, True)}"
                                  f"<small>{number(garment['error']['distance_m'] * 1000, 2)} mm, "
                                  f"{garment['drape_steps']:.0f} steps</small>", "n"))
                else:
                    cells.append(("not run", "n none"))
            rows.append(cells)
        if not rows:
            return "<p class=\"soft\">Not run yet.</p>"
        rows.append(("sum", ["Mean absolute error", ("", "n")]
                     + [(number(mean_error(sums[v]), 1), "n") for v, _ in variants]))
        head = ["Searched alone", ("true, cm", "n")] + [(title, "n") for _, title in variants]
        return table(head, rows, label)

    def length_change(self):
        """Fig. 3: one length change of a T-shirt, as the pattern's triangles."""
        return self.pictures.drawing("length-change.svg", LENGTH_CHANGE)

    def missing(self, fits):
        names = [fit.name for fit in fits if fit.name not in self.results.fits]
        failed = [(name, record["failure"]) for name, record in self.results.fits.items()
                  if "failure" in record]
        return names, failed


def claims_table(page):
    rows = []
    for where, claim, figures, verdict in claims(page.results, page.effort):
        kind, word = verdict
        rows.append([f"{text(claim)} <span class=\"soft\">{where}</span>", figures,
                     (word, kind)])
    return table(["What the paper says", "What was measured", "Verdict"], rows,
                 "Claims of the paper", "claims")


def note_on_rest(page, fits):
    names, failed = page.missing(fits)
    out = ""
    if names:
        groups = {}
        for name in names:
            groups.setdefault(name.split(".")[0], []).append(name)
        shown = "".join(f"<li>{text(k)}: {len(v)}</li>" for k, v in groups.items())
        out += f"<p>Not run yet, {len(names)} of {len(fits)}; the script goes on with them:</p>" \
               f"<ul>{shown}</ul>"
    if failed:
        out += "<p>Without a result:</p><ul>" + "".join(
            f"<li>{text(n)}: {text(why)}</li>" for n, why in failed) + "</ul>"
    seconds = sum(r["wall_s"] for r in page.results.fits.values())
    return out + (f"<p>{len(page.results.fits)} fits took {seconds / 3600:.1f} hours added up, on "
                  "a machine that was busy with other work.</p>")


def write_page(out, published_table, effort, fits, here):
    page = Page(out, published_table, effort)
    tables, overall = page.tables()
    with open(os.path.join(here, "style.css")) as file:
        style = file.read()
    runs, evaluations = effort.split("x")
    lead = ("<p>N. Hasler, B. Rosenhahn and H.-P. Seidel, <cite>Reverse Engineering Garments</cite> "
            "(2007), run again on scans whose garments have known sizes. The paper's own scans are "
            "not public: its figures (columns “paper”) are of other people in garments of "
            "the same named sizes. <b>annealing</b> is the paper's method in this program, meshes, "
            f"{runs} search{'es' if runs != '1' else ''} of {evaluations} drapes a scan after a "
            "rough one of 60 (the paper says three searches and no number of drapes); "
            "<b>joint</b> is this program's own. Errors are estimate less truth, cm.</p>")
    nav = [("summary", "Summary"), ("claims", "Claims"), ("tables", "Tables 1–4"),
           ("patterns", "Figs. 1–3"), ("fig4", "Fig. 4"), ("fig5", "Fig. 5"), ("fig6", "Fig. 6"),
           ("contact", "Contact"), ("error", "The error"), ("clouds", "Clouds"), ("rest", "The rest")]
    body = (section("summary", "How far off", page.summary(overall))
            + section("claims", "What the paper says, and what was found", claims_table(page))
            + section("tables", "The tables", tables) + figures(page)
            + section("rest", "The rest", note_on_rest(page, fits)))
    links = "".join(f"<li><a href=\"#{key}\">{title}</a></li>" for key, title in nav)
    html = ("<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\">"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
            "img-src data:; style-src 'unsafe-inline'\">"
            f"<title>Reverse Engineering Garments, run again</title><style>{style}</style></head>"
            f"<body><header><h1>Reverse Engineering Garments, run again</h1>{lead}</header>"
            f"<nav aria-label=\"Contents\"><ul>{links}</ul></nav><main>{body}</main></body></html>")
    return page, html
