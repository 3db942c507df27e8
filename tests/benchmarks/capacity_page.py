"""The page of a capacity plan: one file that requests nothing, in the look of the other pages."""
import base64
import hashlib
import html
import os

from capacity_law import power_law
from capacity_markup import about, duration, figure, keys, lead, section, size, table
from capacity_plan import CAMPAIGNS, HTTP_THREADS, PARTS, growth_laws
from capacity_plots import plot, short

HERE = os.path.dirname(os.path.abspath(__file__))
STYLES = ("report.css", "report_pictures.css", "report_media.css", "evaluation.css")
STORES = {"sqlite": "SQLite", "postgres": "PostgreSQL"}
NAMES = {"workers": "the workers", "store": "the job store", "disk": "the disk",
         "network": "the network", "http": "the server that takes uploads"}
REMEDIES = {
    "workers": "Add workers: any number of machines share store and data folder.",
    "store": "Put the job store on PostgreSQL and a disk that commits faster, or run several "
             "services, each with a store of its own.",
    "disk": "Stripe the data folder over more disks, keep less (--no-state), or give each group of "
            "workers a service and a disk of its own.",
    "network": "Use a faster line to the data folder, or put workers and data on one machine.",
    "http": "Give the server more http_threads, or run several servers over one store.",
}


class Page:
    def __init__(self, plan):
        self.plan, self.m = plan, plan.measured
        self.tables = {store: plan.table(store) for store in plan.stores}
        self.best = "postgres" if "postgres" in plan.stores else "sqlite"

    def verdict(self):
        full = self.plan.full_workers(self.best)
        part, workers = next(iter(full.items()))
        cores = self.m["machine"]["cores"]
        rate = self.plan.full_rates(self.best)[part]
        head = (f"Up to about {about(workers)} workers a campaign is as quick as its workers are "
                f"many; then {NAMES[part]} is full.")
        words = (f"A machine like this runs {cores} workers, so that is {about(workers / cores)} "
                 f"machines and {about(rate)} scans a second. {REMEDIES[part]}")
        if part == "network":
            found = next(name for name in full if name != "network")
            words += (f" The network is assumed, {size(self.plan.network)} a second; of what was "
                      f"measured {NAMES[found]} is full first, at {about(full[found])} workers.")
        return head, words

    def facts(self):
        plan = self.plan
        small, large = CAMPAIGNS
        two = self.tables[self.best][0]
        return [
            ("A scan", duration(plan.fit), f"of one core, all cores busy ({duration(plan.alone)} "
                                           f"alone); {short(plan.vertices)} vertices on average"),
            ("Sent, kept", f"{size(plan.upload)}, {size(plan.kept)}",
             f"{plan.entries} files and folders; {size(plan.memory)} of memory at most"),
            (f"{small:,} scans", duration(two["seconds"][small]),
             f"with two workers; {size(small * (plan.upload + plan.kept))}"),
            (f"{large:,} scans", duration(two["seconds"][large]),
             f"with two workers; {size(large * (plan.upload + plan.kept))}"),
        ]

    def campaigns(self):
        small, large = CAMPAIGNS
        plan, parts = self.plan, []
        stores = list(plan.stores)
        rows = [[f"{count:,} scans", size(count * (plan.upload + plan.kept)),
                 *(size(count * plan.stores[store].bytes) for store in stores),
                 figure(count * plan.entries)] for count in CAMPAIGNS]
        parts.append(table("What campaigns take on disk",
                           ["", "Scans and results", *(f"{STORES[s]} database" for s in stores),
                            "Files and folders"], rows))
        for store in stores:
            rows = [[f"{run['workers']:,} workers", duration(run["seconds"][small]),
                     duration(run["seconds"][large]), figure(run["rate"]),
                     f"{run['busiest']} {100 * run['share']:.0f} %"] for run in self.tables[store]]
            parts.append(f"<h3>Jobs in {STORES[store]}</h3>")
            parts.append(table(f"Time by workers, {STORES[store]}",
                               ["Workers", f"{small:,} scans", f"{large:,} scans", "Scans/s",
                                "Busiest part"], rows))
        return section("campaigns", "What campaigns need", lead(
            "Every row is a simulated run: scans drawn from those measured, sent one after the "
            "other while workers fit. SQLite serves the workers of one machine, PostgreSQL those of "
            "many."),
            *parts)

    def full(self):
        plan = self.plan
        rows = []
        for store in plan.stores:
            scan, places = plan.scan(store), plan.parts(store).named()
            for part, workers in plan.full_workers(store).items():
                if part != "store" and store != self.best:
                    continue
                name = f"{STORES[store]}, {len(places['store'].free)} at a time" \
                    if part == "store" else {"http": f"HTTP server, {HTTP_THREADS} threads",
                                             "disk": "Disk", "network": "Network (assumed)"}[part]
                rows.append((workers, [name, duration(scan.of(part)),
                                       figure(plan.full_rates(store)[part]), figure(workers, 2)]))
        rows = [row for _, row in sorted(rows)]
        lines = {STORES[store]: ([(run["workers"], run["rate"]) for run in runs],) * 2
                 for store, runs in self.tables.items()}
        chart = plot("Scans a second by workers", "workers", "scans/s", lines)
        remedies = "".join(f"<li>{html.escape(NAMES[part][0].upper() + NAMES[part][1:])}: "
                           f"{html.escape(REMEDIES[part])}</li>" for part in PARTS)
        return section(
            "full", "What is full first",
            lead("What a scan asks of each part, how many scans a second the part can serve, and "
                 "how many workers ask for that much."),
            table("Parts and the workers that fill them",
                  ["Part", "Asked by a scan", "Scans/s", "Full at workers"], rows),
            "<h3>How far more workers help</h3>"
            f'<div class="plots"><figure class="panel"><figcaption><b>Scans a second</b> by '
            f"workers: a straight line until a part is full</figcaption>{chart}</figure><div><h3>And then"
            f"</h3><ul class=\"remarks\">{remedies}</ul></div></div>")

    def growth(self):
        plots = []
        for key, title, unit, scale in (("seconds", "Seconds of a fit", "s", 1),
                                        ("memory_bytes", "Memory at most", "MB", 1e6),
                                        ("kept_bytes", "Result kept", "MB", 1e6),
                                        ("upload_bytes", "Scan sent", "MB", 1e6)):
            laws, series = growth_laws(self.m, key), {}
            for kind, rows in self.m["growth"].items():
                dots = [(row["vertices"], row[key] / scale) for row in rows]
                factor, exponent = laws[kind]
                series[kind] = (dots, [(n, factor * n ** exponent / scale)
                                       for n in (dots[0][0], dots[-1][0])])
            powers = ", ".join(f"{kind} {law[1]:.2f}" for kind, law in laws.items())
            last = ", ".join(f"{kind} {self.last_power(kind, key):.2f}" for kind in laws)
            plots.append(f'<figure class="panel"><figcaption><b>{title}</b>: vertices to the power '
                         f"of {powers}<span class=\"aside\">between the two largest: {last}</span>"
                         f"</figcaption>{plot(title, 'vertices', unit, series)}</figure>")
        return section("growth", "How cost grows", lead(
            "One person as meshes and as clouds of more and more vertices, each fitted twice by a "
            "process of one thread; dots are medians, lines the power laws that come closest, both "
            "axes logarithmic. Small scans cost what any fit does; the power between the two "
            "largest tells how it goes on."),
            f'<div class="plots">{"".join(plots)}</div>', self.sizes(), self.stages())

    def sizes(self):
        rows = []
        for kind, found in self.m["growth"].items():
            for row in found:
                stored = row["upload_bytes"] + row["kept_bytes"]
                rows.append([f"{kind}, {row['vertices']:,.0f} vertices", duration(row["seconds"]),
                             size(row["memory_bytes"]), size(row["upload_bytes"]),
                             size(row["kept_bytes"]),
                             *(f"{duration(count * row['seconds'])}, {size(count * stored)}"
                               for count in CAMPAIGNS)])
        return "<h3>Campaigns of scans of one size, by one worker</h3>" + table(
            "Costs by size", ["Scan", "A fit", "Memory", "Sent", "Kept",
                              *(f"{count:,} of them" for count in CAMPAIGNS)], rows)

    def last_power(self, kind, key):
        return power_law([(row["vertices"], row[key]) for row in self.m["growth"][kind][-2:]])[1]

    def stages(self):
        rows = self.m["growth"]["mesh"]
        names = list(rows[-1]["stages"])
        return "<h3>Where the time of a mesh goes</h3>" + table(
            "Share of each stage by size", ["Mesh", *names],
            [[f"{row['vertices']:,.0f} vertices", *(f"{100 * row['stages'][name] / row['seconds']:.0f} %"
                                        for name in names)] for row in rows])

    def store(self):
        rows = []
        for store, figures in self.m["stores"].items():
            rates = self.plan.stores[store]
            rows.append([STORES[store], figure(figures["many"]["made_per_s"]),
                         figure(figures["one"]["ended_per_s"]),
                         figure(figures["many"]["ended_per_s"]), size(rates.bytes),
                         size(10_000 * rates.bytes)])
        many = self.m["stores"]["sqlite"]["many"]
        filled = [[f"{row['jobs']:,}", duration(row["sent_s"]), duration(row["job_s"]),
                   duration(row["pause_s"]), duration(row["metrics_s"])]
                  for row in self.m["filled"]]
        return section(
            "store", "The job store", lead(
                f"Jobs a second, every commit on the disk: made by one process, then taken and ended "
                f"by one or {many['workers']} workers that tell of their progress {many['notes']} "
                "times, as a fit of the example does."),
            table("Rates of the stores", ["Store", "Made/s", "Done/s, one worker",
                                          f"Done/s, {many['workers']} workers", "Bytes a job",
                                          "10,000 jobs"], rows),
            "<h3>With many ended jobs in it (SQLite)</h3>",
            table("A tiny job beside many", ["Jobs in the store", "Sending one", "Doing one",
                                             "Between two", "/metrics"], filled))

    def disk(self):
        disk, rows = self.m["disk"], []
        for row in self.m["folders"]:
            spread = "one folder" if row["shards"] == 1 else f"{row['shards']} folders"
            rows.append([f"{row['entries']:,} in {spread}", *(f"{1e6 * row[key]:.1f} µs" for key in
                                                              ("make_s", "find_s", "list_s"))])
        flat, spread = self.m["folders"][-2:]
        change = flat["find_s"] / spread["find_s"]
        needed = "Sharded folders would help." if change > 1.5 else \
            "Sharded folders are not needed."
        return section("disk", "Disk and folders", lead(
            f"The disk takes {size(disk['write_bytes_per_s'])} a second of large files and "
            f"{figure(disk['commits_per_s'])} small commits a second. Each job is a folder in one "
            f"folder of all jobs, with {self.plan.entries} files and folders in all. With "
            f"{flat['entries']:,} of them on {self.m['machine']['file_system']} one is found in "
            f"{change:.2f} times the time it takes among the same number spread over "
            f"{spread['shards']}. {needed}"),
            table("One job folder among many", ["Job folders", "Made in", "Found in", "Listed in"],
                  rows))

    def check(self):
        check = self.m["check"]
        rows = [[f"{run['jobs']:,} jobs, {run['workers']} "
                 f"worker{'' if run['workers'] == 1 else 's'}", duration(run["predicted_s"]),
                 duration(run["taken_s"]), f"{run['taken_s'] / run['predicted_s']:.3f}",
                 figure(run["jobs"] / run["taken_s"])] for run in check["runs"]]
        return section("check", "Predicted against real", lead(
            f"The simulation was given {check['sample']} tiny jobs done by one worker "
            f"({duration(check['job_s'])} each, {duration(check['pause_s'])} between two), the "
            "store's rates and how much fits slow each other down; then the jobs were really sent "
            "and done. Tiny jobs are scans of three points, which a fit turns down."),
            table("Predicted and taken", ["Run", "Predicted", "Taken", "Ratio", "Jobs/s"], rows))

    def assumptions(self):
        cores = self.m["machine"]["cores"]
        words = [
            f"The network carries {size(self.plan.network)} a second (110 MB is a gigabit line). "
            "This is not measured; --network sets it. Each scan goes over it twice, to the server "
            "and on to a worker, its result once.",
            f"Scans are like the {len(self.plan.fits)} made people measured here; larger ones cost "
            "more by the laws above.",
            f"All machines are like this one and run as many workers as cores, {cores} each, of one "
            "thread.",
            "One disk and one store serve all. A scan and its result are written once; what was just "
            "written is read from memory. Results stay, with all their files.",
            f"At most {self.limit():,} jobs wait; senders that are turned down try again after a "
            "second.",
            f"{CAMPAIGNS[1]:,} scans go at the steady rate of a simulated run of at least twenty "
            "scans a worker; the store was tried with as many jobs in it as its table says.",
            "Nothing fails: no job is tried again, no machine goes away.",
        ]
        items = "".join(f"<li>{html.escape(word)}</li>" for word in words)
        return section("assumptions", "Assumptions", f'<ul class="remarks">{items}</ul>')

    @staticmethod
    def limit():
        return 1000  # ServiceConfig::max_queue

    def html(self):
        style = ""
        for name in STYLES:
            with open(os.path.join(HERE, "..", "..", "report_templates", name),
                      encoding="utf-8") as file:
                style += file.read()
        digest = base64.b64encode(hashlib.sha256(style.encode()).digest()).decode()
        head, words = self.verdict()
        m = self.m["machine"]
        body = "".join((self.campaigns(), self.full(), self.growth(), self.store(), self.disk(),
                        self.check(), self.assumptions()))
        links = "".join(f'<li><a href="#{name}">{title}</a></li>' for name, title in (
            ("campaigns", "Campaigns"), ("full", "Full first"), ("growth", "Growth"),
            ("store", "Store"), ("disk", "Disk"), ("check", "Prediction"),
            ("assumptions", "Assumptions")))
        tried = " · a quick try, not to be relied on" if self.m["quick"] else ""
        return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'sha256-{digest}'; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="referrer" content="no-referrer">
<title>Capacity · Regarment</title>
<style>{style}</style>
</head>
<body>
<a class="skip" href="#content">To the figures</a>
<header class="masthead">
<p class="brand">Regarment <span>Capacity</span></p>
<h1>What a campaign needs</h1>
<p class="subject">Measured on {html.escape(m['processor'])}, {m['cores']} cores, {size(m['memory_bytes'])}, {html.escape(m['file_system'])} · {html.escape(self.m['program'])}{tried}</p>
</header>
<nav aria-label="Sections"><ul>{links}</ul></nav>
<main id="content">
<section class="verdict clear" aria-labelledby="verdict"><div class="words"><h2 id="verdict">{html.escape(head)}</h2><p>{html.escape(words)}</p></div></section>
{keys(self.facts())}
{body}
</main>
</body>
</html>
"""


def write_page(plan, out):
    page = Page(plan)
    with open(out, "w", encoding="utf-8") as file:
        file.write(page.html())
    print(*page.verdict(), sep="\n")
    for name, value, note in page.facts():
        print(f"{name}: {value} ({note})")
    for store, runs in page.tables.items():
        for run in runs:
            print(f"{STORES[store]}, {run['workers']:,} workers: " + ", ".join(
                f"{count:,} scans {duration(run['seconds'][count])}" for count in CAMPAIGNS)
                + f"; busiest: {run['busiest']}, {100 * run['share']:.0f} %")
