"""A queue simulated event by event: what a campaign takes when its parts are shared.

A process is a generator that yields the moment at which it goes on and is sent that moment back; one
that yields nothing rests until it is woken.
What many share is a `Server`: so many places, first come, first served.
"""
import collections
import heapq
import itertools
import random


class Server:
    """`places` that serve one each at a time, in the order in which they are asked."""

    def __init__(self, places=1):
        self.free = [0.0] * places
        self.busy = 0.0  # seconds served, of all places

    def serve(self, now, seconds):
        """The moment at which who comes `now` has been served."""
        end = max(now, heapq.heappop(self.free)) + seconds
        heapq.heappush(self.free, end)
        self.busy += seconds
        return end


class Simulation:
    """Runs processes; those that go on at the same moment do so in the order in which they said so."""

    def __init__(self):
        self.now, self.running = 0.0, None
        self._events, self._number = [], itertools.count()

    def start(self, process, at=0.0):
        """`process` is new and begins at the moment `at`."""
        self.wake(process, at, first=True)

    def wake(self, process, at, first=False):
        heapq.heappush(self._events, (at, next(self._number), process, first))

    def run(self):
        while self._events:
            self.now, _, self.running, first = heapq.heappop(self._events)
            process = self.running
            try:
                at = next(process) if first else process.send(self.now)
            except StopIteration:
                continue
            if at is not None:
                self.wake(process, at)


class Parts:
    """What the processes of a campaign share. Seconds are of one scan."""

    def __init__(self, store=1, disk=1, network=1, http=2):
        self.store, self.disk = Server(store), Server(disk)
        self.network, self.http = Server(network), Server(http)

    def named(self):
        return {"store": self.store, "disk": self.disk, "network": self.network, "http": self.http}


class Scan:
    """What one scan asks of the parts, s: of the server that takes the upload, of the store for the
    job made, taken, each of `notes` of progress, and ended, of disk and network for the scan sent,
    read by a worker, and the result kept. `pause`: a worker's own time between two jobs."""

    def __init__(self, http=0.0, made=0.0, taken=0.0, note=0.0, notes=0, ended=0.0, pause=0.0,
                 upload_disk=0.0, kept_disk=0.0, upload_network=0.0, read_network=0.0,
                 kept_network=0.0):
        self.http, self.made, self.taken, self.ended = http, made, taken, ended
        self.note, self.notes, self.pause = note, notes, pause
        self.upload_disk, self.kept_disk = upload_disk, kept_disk
        self.upload_network, self.read_network = upload_network, read_network
        self.kept_network = kept_network

    def of(self, part):
        """All that one scan asks of a part."""
        return {"store": self.made + self.taken + self.note * self.notes + self.ended,
                "disk": self.upload_disk + self.kept_disk,
                "network": self.upload_network + self.read_network + self.kept_network,
                "http": self.http}[part]


POLL = 0.2  # s between two looks of an idle worker at the queue (WorkerOptions::poll)
RETRY = 1.0  # s until who was turned down by a full queue sends again


class Campaign:
    """`jobs` scans sent one after the other by `senders`, fitted by `workers`. `fits`: seconds of
    fits seen, drawn from with replacement by `seed`. No more than `queue` wait; with `sent`, all
    do from the start."""

    def __init__(self, jobs, workers, fits, scan, parts, senders=16, queue=1000, sent=False, seed=1):
        self.jobs, self.fits, self.scan, self.parts = jobs, fits, scan, parts
        self.simulation, self._draw = Simulation(), random.Random(seed)
        self.workers, self.queue, self.fitting = workers, queue, 0.0
        self.to_send, self.waiting, self.taken = (0, jobs, 0) if sent else (jobs, 0, 0)
        self.ends, self.idle = [], collections.deque()
        for _ in range(0 if sent else senders):
            self.simulation.start(self._sender(0.0))
        for _ in range(workers):
            self.simulation.start(self._worker(0.0))
        self.simulation.run()

    @property
    def seconds(self):
        """From the first job begun or sent to the last one ended."""
        return self.ends[-1] if self.ends else 0.0

    @property
    def rate(self):
        """Jobs a second between a quarter and three quarters of them."""
        first, last = len(self.ends) // 4, 3 * len(self.ends) // 4
        return (last - first) / (self.ends[last] - self.ends[first])

    def shares(self):
        """Of each part, workers too: how much of its time it was busy."""
        found = {name: server.busy / (len(server.free) * self.seconds)
                 for name, server in self.parts.named().items()}
        return {"workers": self.fitting / (self.workers * self.seconds), **found}

    def _sender(self, now):
        scan, parts = self.scan, self.parts
        while self.to_send > 0:
            if self.waiting >= self.queue:
                now = yield now + RETRY
                continue
            self.to_send -= 1
            now = yield parts.network.serve(now, scan.upload_network)
            now = yield parts.http.serve(now, scan.http)
            now = yield parts.disk.serve(now, scan.upload_disk)
            now = yield parts.store.serve(now, scan.made)
            self.waiting += 1
            if self.idle:
                # As soon as the first of those looks who look every so often, each on its own.
                soon = now + POLL / (len(self.idle) + 1)
                self.simulation.wake(self.idle.popleft(), soon)

    def _worker(self, now):
        scan, parts = self.scan, self.parts
        while self.taken < self.jobs:
            if self.waiting == 0:
                self.idle.append(self.simulation.running)
                now = yield None
                continue
            self.waiting -= 1
            self.taken += 1
            now = yield parts.store.serve(now, scan.taken)
            now = yield parts.network.serve(now, scan.read_network)
            fit = self._draw.choice(self.fits)
            self.fitting += fit
            for _ in range(scan.notes):
                now = yield now + fit / (scan.notes + 1)
                now = yield parts.store.serve(now, scan.note)
            now = yield now + fit / (scan.notes + 1)
            now = yield parts.disk.serve(now, scan.kept_disk)
            now = yield parts.network.serve(now, scan.kept_network)
            now = yield parts.store.serve(now, scan.ended)
            self.ends.append(now)
            now = yield now + scan.pause
