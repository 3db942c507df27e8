#!/usr/bin/python3
"""The simulated queue against what queueing theory says in closed form, and the law of growth."""
import math
import random
import unittest

from capacity_law import power_law
from capacity_queue import POLL, Campaign, Parts, Scan, Server, Simulation


def mean_wait(places, arrivals, service, customers, seed=1):
    """Mean seconds before service; `arrivals` and `service` draw seconds."""
    simulation, server = Simulation(), Server(places)
    draw, waits = random.Random(seed), []

    def customer(now, seconds):
        end = yield server.serve(now, seconds)
        waits.append(end - seconds - now)

    def door():
        now = 0.0
        for _ in range(customers):
            now = yield now + arrivals(draw)
            simulation.start(customer(now, service(draw)), at=now)

    simulation.start(door())
    simulation.run()
    return sum(waits) / len(waits)


def erlang_wait(places, load, service):
    """Mean wait of M/M/c; `load` in Erlang."""
    term, total = 1.0, 1.0
    for k in range(1, places):
        term *= load / k
        total += term
    last = term * load / places * places / (places - load)
    return last / (total + last) * service / (places - load)


class QueueTest(unittest.TestCase):
    # A mean of so many waits, each like its neighbours, strays by 1 to 2 %.
    CUSTOMERS, SHARE = 200_000, 0.06

    def test_one_server_of_even_service_waits_as_pollaczek_and_khinchine_say(self):
        for load in (0.3, 0.6, 0.8):
            found = mean_wait(1, lambda r: r.expovariate(load), lambda _: 1.0, self.CUSTOMERS)
            expected = load / (2 * (1 - load))
            self.assertAlmostEqual(found / expected, 1, delta=self.SHARE, msg=load)

    def test_several_servers_wait_as_erlang_says(self):
        for places, load in ((1, 0.5), (2, 1.4), (8, 6.0)):
            found = mean_wait(places, lambda r: r.expovariate(load), lambda r: r.expovariate(1.0),
                              self.CUSTOMERS)
            self.assertAlmostEqual(found / erlang_wait(places, load, 1.0), 1, delta=self.SHARE,
                                   msg=(places, load))

    def test_customers_are_served_in_their_order(self):
        simulation, server, order = Simulation(), Server(), []

        def customer(name, now):
            yield server.serve(now, 1.0)
            order.append(name)

        for name, at in (("c", 0.5), ("a", 0.0), ("b", 0.5)):
            simulation.start(customer(name, at), at)
        simulation.run()
        self.assertEqual(order, ["a", "c", "b"])
        self.assertEqual((simulation.now, server.busy), (3.0, 3.0))


class CampaignTest(unittest.TestCase):
    def test_idle_parts_leave_the_time_to_the_workers(self):
        run = Campaign(1000, 4, [2.0], Scan(pause=0.5), Parts(), sent=True)
        # 250 rounds each; the last pause is not waited for.
        self.assertAlmostEqual(run.seconds, 250 * 2.5 - 0.5, delta=0.2)
        self.assertAlmostEqual(run.rate, 4 / 2.5, delta=0.02)

    def test_a_full_writer_sets_the_rate(self):
        # 16 ms of one writer a job, and workers for ten times as much.
        scan = Scan(taken=0.004, note=0.001, notes=8, ended=0.004)
        run = Campaign(5000, 625, [1.0], scan, Parts(), sent=True)
        self.assertAlmostEqual(run.rate * scan.of("store"), 1, delta=0.01)
        self.assertGreater(run.shares()["store"], 0.97)
        twice = Campaign(5000, 625, [1.0], scan, Parts(store=2), sent=True)
        self.assertAlmostEqual(twice.rate / run.rate, 2, delta=0.03)

    def test_a_full_disk_or_network_sets_the_rate(self):
        for scan, part in ((Scan(upload_disk=0.01, kept_disk=0.03), "disk"),
                           (Scan(upload_network=0.01, read_network=0.01, kept_network=0.03), "network")):
            run = Campaign(4000, 200, [1.0], scan, Parts(), senders=50)
            self.assertAlmostEqual(run.seconds / (4000 * scan.of(part)), 1, delta=0.02, msg=part)

    def test_a_short_queue_changes_nothing_while_workers_are_busy(self):
        # Sent far faster than fitted; a worker of five never finds the queue empty.
        runs = [Campaign(2000, 5, [1.0], Scan(http=0.01), Parts(), queue=queue)
                for queue in (50, 1000)]
        self.assertAlmostEqual(runs[0].seconds, runs[1].seconds, delta=0.001)
        self.assertAlmostEqual(runs[0].seconds, 400, delta=1)
        self.assertGreater(runs[0].shares()["workers"], 0.99)

    def test_idle_workers_find_what_is_sent(self):
        # A scan a second for a hundred workers: each is done a fit and at most a look after it came.
        run = Campaign(50, 100, [3.0], Scan(http=1.0), Parts(http=1))
        for number, end in enumerate(run.ends, 1):
            self.assertGreaterEqual(end, number + 3.0)
            self.assertLessEqual(end, number + 3.0 + POLL)

    def test_every_part_is_asked_for_what_a_scan_asks_of_it(self):
        scan = Scan(http=0.001, made=0.002, taken=0.003, note=0.004, notes=5, ended=0.006,
                    upload_disk=0.007, kept_disk=0.008, upload_network=0.01, read_network=0.012, kept_network=0.011)
        parts = Parts(store=2)
        run = Campaign(300, 3, [0.1, 0.2], scan, parts)
        self.assertEqual(len(run.ends), 300)
        for name, server in parts.named().items():
            self.assertAlmostEqual(server.busy, 300 * scan.of(name), places=9, msg=name)

    def test_the_mean_of_a_sample_sets_the_time_and_the_seed_the_order(self):
        fits = [1.0, 2.0, 6.0]
        runs = [Campaign(20_000, 10, fits, Scan(), Parts(), sent=True, seed=s) for s in (1, 1, 2)]
        self.assertEqual(runs[0].ends, runs[1].ends)
        self.assertNotEqual(runs[0].ends, runs[2].ends)
        # Four standard errors of the sum of 20,000 draws.
        self.assertAlmostEqual(runs[0].rate * 3.0 / 10, 1, delta=4 * math.sqrt(14 / 3 / 10_000) / 3)


class LawTest(unittest.TestCase):
    def test_a_power_law_is_found_again(self):
        factor, exponent = power_law([(n, 3e-5 * n ** 0.7) for n in (4e3, 2e4, 1e5, 1e6)])
        self.assertAlmostEqual(exponent, 0.7, places=9)
        self.assertAlmostEqual(factor, 3e-5, places=12)


if __name__ == "__main__":
    unittest.main()
