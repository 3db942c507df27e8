"""From what was measured: what a campaign asks of each part, and how long it takes."""
import statistics

from capacity_law import power_law
from capacity_queue import Campaign, Parts, Scan

CAMPAIGNS = (10_000, 10_000_000)
# SQLite serves the workers of one machine.
WORKERS = {"sqlite": (2, 8, 32, 128), "postgres": (2, 8, 32, 128, 512, 2048)}
HTTP_THREADS = 2  # ServiceConfig::http_threads
PARTS = ("workers", "store", "disk", "network", "http")


def growth_laws(measured, key):
    """Of each kind of scan: factor and exponent of a cost over the vertices."""
    return {kind: power_law([(row["vertices"], row[key]) for row in rows])
            for kind, rows in measured["growth"].items()}


class StoreRates:
    """A job's seconds in a store, and its bytes. SQLite has one writer; elsewhere as many commits
    go side by side as several workers get done while one does one."""

    def __init__(self, name, figures):
        one, many = figures["one"], figures["many"]
        beside = round(many["ended_per_s"] / one["ended_per_s"])
        self.places = 1 if name == "sqlite" else max(1, beside)
        self.transaction = self.places / many["ended_per_s"] / (2 + many["notes"])
        self.made = 1 / many["made_per_s"]
        # Two sizes, so that what an empty database takes is not counted.
        self.bytes = ((many["database_bytes"] - one["database_bytes"])
                      / (many["jobs"] - one["jobs"]))


class Plan:
    """`network`: bytes a second, which nothing here measures."""

    def __init__(self, measured, network):
        fits = measured["people"]["busy"]
        kept = [row for row in fits if "failed" not in row]
        self.measured, self.network = measured, network
        self.fits = [row["seconds"] for row in fits]
        self.fit = statistics.mean(self.fits)
        self.alone = statistics.mean(row["seconds"] for row in measured["people"]["alone"])
        self.upload = statistics.mean(row["upload_bytes"] for row in fits)
        self.kept = statistics.mean(row["kept_bytes"] for row in kept)
        self.vertices = statistics.mean(row["vertices"] for row in kept)
        self.memory = max(row["memory_bytes"] for row in fits)
        self.entries = measured["job"]["entries"]
        self.stores = {name: StoreRates(name, rates) for name, rates in measured["stores"].items()}

    def scan(self, store):
        """What one asks. Workers beside the store have the data folder on their own machine."""
        over = 0.0 if store == "sqlite" else 1.0
        rates, sent = self.stores[store], self.measured["upload"]
        disk = self.measured["disk"]["write_bytes_per_s"]
        pause = self.measured["check"]["pause_s"]
        return Scan(http=max(0.0, sent["tiny_s"] - rates.made) + self.upload / sent["bytes_per_s"],
                    made=rates.made, taken=rates.transaction, note=rates.transaction,
                    notes=self.measured["job"]["notes"], ended=rates.transaction,
                    pause=max(0.0, pause - rates.transaction),
                    upload_disk=self.upload / disk, kept_disk=self.kept / disk,
                    upload_network=self.upload / self.network,
                    read_network=over * self.upload / self.network,
                    kept_network=over * self.kept / self.network)

    def parts(self, store):
        return Parts(store=self.stores[store].places, http=HTTP_THREADS)

    def full_rates(self, store):
        """Scans a second at which each part is full."""
        scan = self.scan(store)
        return {name: len(server.free) / scan.of(name)
                for name, server in self.parts(store).named().items()}

    def full_workers(self, store):
        """Workers at which each part is full, those first that are full first."""
        cycle = self.fit + self.scan(store).pause
        return dict(sorted(((name, rate * cycle) for name, rate in self.full_rates(store).items()),
                           key=lambda item: item[1]))

    def campaign(self, store, workers):
        """Of both campaigns the seconds, and what is busiest; ten million go at the steady rate of
        a simulated run in which every worker has at least twenty scans."""
        small, large = CAMPAIGNS
        run = self._run(store, small, workers)
        steady = run if 20 * workers <= small else self._run(store, 20 * workers, workers)
        shares = steady.shares()
        busiest = max(PARTS, key=lambda name: shares[name])
        return {"workers": workers, "seconds": {small: run.seconds, large: large / steady.rate},
                "rate": steady.rate, "busiest": busiest, "share": shares[busiest]}

    def _run(self, store, jobs, workers):
        return Campaign(jobs, workers, self.fits, self.scan(store), self.parts(store))

    def table(self, store):
        return [self.campaign(store, workers) for workers in WORKERS[store]]


def predict_tiny(jobs, workers, service, pause, rates, notes):
    """Seconds from the first of `jobs` tiny ones begun to the last ended; `service` and `pause` are
    those of a single worker, whose store never waits."""
    inside = rates.transaction * (1 + notes)
    scan = Scan(taken=rates.transaction, note=rates.transaction, notes=notes,
                ended=rates.transaction, pause=max(0.0, pause - rates.transaction))
    own = [max(0.0, seconds - inside) for seconds in service]
    run = Campaign(jobs, workers, own, scan, Parts(store=rates.places), sent=True)
    return run.seconds
