"""Workers that reach the store and the server alone, not its folder:

  remote_worker_test.py PROGRAM RUN_POSTGRES [JOBS [SEED]]

Jobs of every kind come to the same bytes as with a shared folder; workers are killed and the server
is started again in the middle of a fetch and of a delivery, and JOBS (12) jobs each end once; TLS
needs a certificate that is to be trusted."""
import http.client
import json
import os
import random
import shutil
import signal
import socket
import ssl
import subprocess
import sys
import tempfile
import threading

from running_service import SCAN, SOURCE, Service, finish, form, scan_form

PROGRAM, RUN_POSTGRES = sys.argv[1:3]
JOBS = int(sys.argv[3]) if len(sys.argv) > 3 else 12
SEED = int(sys.argv[4]) if len(sys.argv) > 4 else 1
CORNERS = [(i & 1, i >> 1 & 1, 2 * (i >> 2)) for i in range(8)]
FACES = ((0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4),
         (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5))
BOX = "\n".join([f"v {x} {y} {z}" for x, y, z in CORNERS] +
                [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in FACES]) + "\n"
DIRECT = '{"method": "direct", "no_timing": true}'
failures = []


def expect(right, what):
    if not right:
        failures.append(what)


def run(*words, **environment):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=120,
                          env={**os.environ, **environment}, check=False)


class Gate:
    """Stands between workers and the service of the moment. `trap` is told of each request's line;
    what it returns is done before the request goes on: a function, or nothing."""

    def __init__(self, home, tls=None):
        self.home, self.tls = home, tls
        self.trap = lambda line: None
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.port = self.socket.getsockname()[1]
        threading.Thread(target=self.accept, daemon=True).start()

    def accept(self):
        while True:
            try:
                client = self.socket.accept()[0]
            except OSError:
                return
            threading.Thread(target=self.serve, args=(client,), daemon=True).start()

    def serve(self, client):
        try:
            if self.tls:
                client = self.tls.wrap_socket(client, server_side=True)
            server = socket.create_connection(("127.0.0.1", self.home.service.port))
        except OSError:
            client.close()
            return
        threading.Thread(target=self.pass_on, args=(server, client, None), daemon=True).start()
        self.pass_on(client, server, self)

    def pass_on(self, source, target, gate):
        try:
            while data := source.recv(65536):
                line = data.split(b"\r\n", 1)[0].decode(errors="replace")
                todo = gate and " HTTP/1.1" in line and gate.trap(line)
                if todo:
                    # Some of what was asked, so that the other side is in the middle of it.
                    target.sendall(data[:len(data) // 2])
                    todo()
                    return
                target.sendall(data)
        except OSError:
            pass
        finally:
            for end in (source, target):
                try:
                    end.shutdown(socket.SHUT_RDWR)
                except OSError:
                    pass
                end.close()


class Home:
    """A service with PostgreSQL, its keys, and workers of both kinds."""

    def __init__(self, store, folder):
        self.store, self.data, self.scratch = store, os.path.join(folder, "data"), os.path.join(folder, "scratch")
        self.service = self.start()
        self.gate = Gate(self)
        self.keys = {}
        for name, scopes in (("client", ("submit", "read")), ("worker", ("work",))):
            words = [word for scope in scopes for word in ("--scope", scope)]
            self.keys[name] = run("key", "add", name, *words, "--store", store).stdout.strip()

    def start(self):
        return Service("--workers", "0", data=self.data, REGARMENT_STORE=self.store,
                       REGARMENT_MIN_FREE_MB="1")

    def restart(self):
        self.service.__exit__()
        self.service = self.start()

    def ask(self, method, path, body=None, headers=None):
        return self.service.ask(method, path, body,
                                {**(headers or {}), "X-API-Key": self.keys["client"]})

    def submit(self, path, body, headers=None):
        status, _, answer = self.ask("POST", path, body, headers)
        if status != 202:
            raise RuntimeError(f"{path}: {status} {answer}")
        return json.loads(answer)["id"]

    def job(self, job):
        return json.loads(self.ask("GET", f"/v1/jobs/{job}")[2])

    def environment(self, **more):
        return {"REGARMENT_STORE": self.store, "REGARMENT_LEASE_SECONDS": "1",
                "REGARMENT_MAX_ATTEMPTS": "100", "REGARMENT_SERVER_KEY": self.keys["worker"], **more}

    def remote(self, *words, server=None, **more):
        """A worker without the folder, as a process."""
        server = server or f"http://127.0.0.1:{self.gate.port}"
        return subprocess.Popen([PROGRAM, "worker", "--server", server, "--data", self.scratch, *words],
                                env={**os.environ, **self.environment(**more)},
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def work_off(self, remote):
        """Does all that waits, with a worker of this kind."""
        if remote:
            worker = self.remote("--until-empty")
            said = worker.communicate(timeout=300)[1]
            expect(worker.returncode == 0, f"a remote worker ended: {worker.returncode} {said}")
        else:
            done = run("worker", "--until-empty", "--data", self.data, **self.environment())
            expect(done.returncode == 0, f"a worker at the folder ended: {done.stderr}")

    def files(self, job):
        state = self.job(job)
        expect(state["state"] == "succeeded", f"{state['kind']}: {state['state']} {state['error']}")
        folders = [name for name in os.listdir(os.path.join(self.data, "jobs", job))
                   if name.startswith("result-")]
        expect(len(folders) == 1, f"not one result: {folders}")
        out = {name: self.ask("GET", f"/v1/jobs/{job}/{name}")[2] for name in state["files"]}
        sizes = [os.path.getsize(os.path.join(folder, name)) for folder, _, names in
                 os.walk(os.path.join(self.data, "jobs", job)) for name in names]
        expect(state["bytes"] == sum(sizes), f"{state['kind']}: not its bytes: {state['bytes']}")
        return out


def check_same(home, what, one, other):
    a, b = home.files(one), home.files(other)
    expect(sorted(a) == sorted(b) and a, f"{what}: other files: {sorted(a)} {sorted(b)}")
    for name in a:
        expect(a[name] == b.get(name), f"{what}: {name} differs")


def every_kind(home):
    """The same requests once for a worker at the folder and once for one without it."""
    with open(os.path.join(SOURCE, "examples", "data", "ground_truth.csv")) as file:
        table = file.read()
    rows = [line for line in table.splitlines(True) if line.startswith(("scan,", "skirt-1,"))]
    with open(SCAN, "rb") as file:
        scan = file.read()
    batch = json.loads(home.ask("POST", "/v1/batches", {"name": "b"})[2])["id"]
    truth = ("t.csv", "template,measurement,value_cm\nskirt,length,55\n")
    found = {"fit": [], "refit": [], "render": [], "evaluate": [], "batch": []}
    for remote in (False, True):
        found["fit"].append(home.submit("/v1/jobs", *scan_form(options=DIRECT, ground_truth=truth,
                                                               batch=batch)))
        found["render"].append(home.submit("/v1/jobs", *form({"scan": ("box.obj", BOX), "kind": "render"})))
        found["evaluate"].append(home.submit("/v1/evaluations", *form(
            {"table": ("t.csv", "".join(rows)), "a": ("skirt-1.mesh.ply", scan),
             "options": DIRECT})))
        home.work_off(remote)
        found["refit"].append(home.submit(f"/v1/jobs/{found['fit'][0]}/refit",
                                          {"options": {"fix": {"length": 60}, "no_timing": True}}))
        home.work_off(remote)
    for remote in (False, True):
        found["batch"].append(home.submit(f"/v1/batches/{batch}/evaluation", b""))
        home.work_off(remote)
    for kind, (one, other) in found.items():
        check_same(home, kind, one, other)
    expect(not os.listdir(home.scratch), f"left in the scratch folder: {os.listdir(home.scratch)}")


def ended(home, job):
    """Waits until the job has: its events come until then."""
    while True:
        try:
            home.ask("GET", f"/v1/jobs/{job}/events")
            state = home.job(job)
        except (OSError, ValueError, http.client.HTTPException):
            continue
        if state["state"] not in ("queued", "running"):
            return state


def killed_and_restarted(home):
    """At each of these moments a worker is killed, or the server started again."""
    dice = random.Random(SEED)
    moments = ("/start", "/files/", "PUT ", "POST .*/result?")
    counts = {"workers": 0, "servers": 0}
    jobs = [home.submit("/v1/jobs", *form({"scan": ("box.obj", BOX), "kind": "render"}))
            for _ in range(JOBS)]
    plan = [(moment, what) for moment in moments for what in ("workers", "servers")]
    plan = [plan[i % len(plan)] for i in range(JOBS)]
    dice.shuffle(plan)
    lock, worker = threading.Lock(), [home.remote()]
    sprung = []

    def strike(what):
        with lock:
            counts[what] += 1
            if what == "workers":
                worker[0].kill()
                worker[0].communicate()
                worker[0] = home.remote()
            else:
                home.restart()

    def trap(line):
        with lock:
            moment, what = plan[0] if plan else (None, None)
            method, _, path = moment.partition(".*") if moment else ("", "", "")
            if not moment or not line.startswith(method if path else "") or (path or moment) not in line:
                return None
            if dice.random() < 0.5:  # another request of the kind may be hit as well
                return None
            sprung.append(plan.pop(0))
        return lambda: strike(what)

    home.gate.trap = trap
    states = [ended(home, job) for job in jobs]
    home.gate.trap = lambda line: None
    with lock:
        worker[0].send_signal(signal.SIGTERM)
        said = worker[0].communicate(timeout=60)[1]
    expect(worker[0].returncode == 0, f"a worker that was asked to end: {worker[0].returncode} {said}")
    for job, state in zip(jobs, states):
        expect(state["state"] == "succeeded", f"killed meanwhile: {state['state']} {state['error']}")
        events = home.ask("GET", f"/v1/jobs/{job}/events")[2]
        expect(events.count(b'"state":"succeeded"') == 1, "a job ended twice, or never")
        files = home.files(job)
        expect(len(files) == 4 and all(data[-8:-4] == b"IEND" for data in files.values()),
               f"not four whole pictures: {list(files)}")
    # What was fetched or delivered in part goes, at the latest when the next one begins.
    home.work_off(True)
    expect(not os.listdir(home.scratch), f"left in the scratch folder: {os.listdir(home.scratch)}")
    print(f"{JOBS} jobs, {counts['workers']} workers killed, {counts['servers']} servers started "
          f"again, {sum(state['attempts'] for state in states)} attempts; struck: {len(sprung)}")
    expect(min(counts.values()) > 0, f"nothing was killed: {counts}")


def let_in(home):
    """Who may come, and by which way."""
    server = f"http://127.0.0.1:{home.gate.port}"
    for key in ("", home.keys["client"], home.keys["worker"] + "0"):
        worker = home.remote("--until-empty", REGARMENT_SERVER_KEY=key)
        said = worker.communicate(timeout=60)[1]
        expect(worker.returncode == 2 and "server_key" in said and said.count("\n") == 1,
               f"a worker with a wrong key: {worker.returncode} {said}")
    worker = home.remote("--until-empty", server="http://127.0.0.1:1")
    said = worker.communicate(timeout=60)[1]
    expect(worker.returncode == 75 and said.count("\n") == 1, f"a server that is away: {said}")
    alone = run("worker", "--server", server, "--data", home.scratch, REGARMENT_STORE="")
    expect(alone.returncode == 2 and "store" in alone.stderr, f"a worker without store: {alone.stderr}")
    words = ("--server", server, "--data", home.scratch + "-doctor", "--json")
    for key, good in ((home.keys["worker"], True), (home.keys["client"], False)):
        doctor = run("doctor", *words, **home.environment(REGARMENT_SERVER_KEY=key))
        parts = {part["part"]: part for part in json.loads(doctor.stdout)}
        expect(parts["server"]["ok"] == good, f"doctor: {parts['server']}")
    shown = run("config", "check", **home.environment()).stdout
    expect("set  (environment)" in shown and home.keys["worker"] not in shown, f"config: {shown}")


def by_tls(home, folder):
    key, certificate = os.path.join(folder, "key.pem"), os.path.join(folder, "cert.pem")
    subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256",
                    "-nodes", "-days", "2", "-subj", "/CN=test", "-addext",
                    "subjectAltName=DNS:localhost", "-keyout", key, "-out", certificate],
                   check=True, capture_output=True)
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(certificate, key)
    gate = Gate(home, context)
    job = home.submit("/v1/jobs", *form({"scan": ("box.obj", BOX), "kind": "render"}))
    for host, trusted in (("localhost", None), ("127.0.0.1", certificate)):
        more = {"SSL_CERT_FILE": trusted} if trusted else {}
        worker = home.remote("--until-empty", server=f"https://{host}:{gate.port}", **more)
        said = worker.communicate(timeout=60)[1]
        expect(worker.returncode == 75 and "certificate" in said, f"not to be trusted: {said}")
    worker = home.remote("--until-empty", server=f"https://localhost:{gate.port}",
                         SSL_CERT_FILE=certificate)
    said = worker.communicate(timeout=120)[1]
    expect(worker.returncode == 0 and home.job(job)["state"] == "succeeded", f"by TLS: {said}")


postgres = subprocess.Popen([RUN_POSTGRES], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
STORE = postgres.stdout.readline().strip()
if not STORE:
    sys.exit(postgres.wait())
folder = tempfile.mkdtemp(prefix="regarment-remote-")
try:
    home = Home(STORE, folder)
    try:
        let_in(home)
        every_kind(home)
        killed_and_restarted(home)
        by_tls(home, folder)
    finally:
        home.service.__exit__()
finally:
    postgres.stdin.close()
    postgres.wait()
    shutil.rmtree(folder, ignore_errors=True)
finish(failures)
