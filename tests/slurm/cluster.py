"""A Slurm of one node on loopback, for tests: munge, slurmctld and slurmd, started as root and without
systemd in a folder of their own."""
import os
import pathlib
import shutil
import signal
import subprocess
import time

NEEDED = ["munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol"]
PATIENCE = 900  # s, for everything together
PATH = "/usr/sbin:/sbin:" + os.environ["PATH"]

CONFIG = """
ClusterName=regarment
SlurmctldHost=localhost(127.0.0.1)
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={home}/munge/munge.socket.2,cred_expire=5
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
RequeueExit=75
JobRequeue=1
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=bf_interval=2,batch_sched_delay=0,sched_min_interval=0,defer_batch
KillWait=3
SlurmdTimeout=20
SlurmctldPort=17917
SlurmdPort=17918
StateSaveLocation={home}/state
SlurmdSpoolDir={home}/spool
SlurmctldPidFile={home}/slurmctld.pid
SlurmdPidFile={home}/slurmd.pid
SlurmctldLogFile={home}/slurmctld.log
SlurmdLogFile={home}/slurmd.log
NodeName=localhost NodeAddr=127.0.0.1 CPUs=2 CoresPerSocket=2 ThreadsPerCore=1 State=UNKNOWN
PartitionName=fit Nodes=localhost Default=YES MaxTime=INFINITE State=UP
"""


def until(what, condition, patience=PATIENCE):
    """Looks until the condition holds, and returns what it gave."""
    end = time.monotonic() + patience
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        time.sleep(0.02)
    raise AssertionError("waited in vain: " + what)


def processes(*words):
    """Numbers of the processes whose command line has all these words in it."""
    out = []
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            line = (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
        except OSError:
            continue
        if all(word in line for word in words):
            out.append(int(entry.name))
    return out


def kill(numbers):
    for number in numbers:
        try:
            os.kill(number, signal.SIGKILL)
        except ProcessLookupError:
            pass
    return numbers


class Cluster:
    """munge, a controller and one node of two processors, in a folder of their own."""

    def __init__(self, home):
        self.home, self.daemons = home, {}
        for name in ("munge", "state", "spool"):
            (home / name).mkdir()
        shutil.chown(home / "munge", "munge")
        (home / "slurm.conf").write_text(CONFIG.format(home=home))
        self.environment = dict(os.environ, SLURM_CONF=str(home / "slurm.conf"), PATH=PATH)
        munge = home / "munge"
        self.daemons["munged"] = self.start(
            "runuser", "-u", "munge", "--", "munged", "--foreground",
            f"--socket={munge}/munge.socket.2", f"--pid-file={munge}/pid",
            f"--log-file={munge}/log", f"--seed-file={munge}/seed")
        until("munge", (munge / "munge.socket.2").exists, 30)
        self.start_controller()
        until("the controller", lambda: self.run("scontrol", "ping").returncode == 0, 60)
        self.start_node()
        until("the node", lambda: "idle" in self.run("sinfo", "-h", "-o", "%t").stdout, 60)

    def start(self, *command):
        log = open(self.home / "daemons.log", "ab")
        return subprocess.Popen(command, env=self.environment, stdout=log, stderr=log,
                                stdin=subprocess.DEVNULL, start_new_session=True)

    def start_controller(self):
        self.daemons["controller"] = self.start("slurmctld", "-D", "-f", self.environment["SLURM_CONF"])

    def start_node(self):
        self.daemons["node"] = self.start("slurmd", "-D", "-N", "localhost", "-f",
                                          self.environment["SLURM_CONF"])

    def crash(self, name):
        self.daemons[name].kill()
        self.daemons[name].wait()

    def run(self, *command):
        return subprocess.run(command, env=self.environment, text=True, capture_output=True)

    def jobs(self):
        return self.run("squeue", "-h", "-o", "%i").stdout.split()

    def stop(self):
        self.run("scancel", "-u", "root")
        for name in ("node", "controller", "munged"):
            if name in self.daemons:
                self.daemons[name].terminate()
        for daemon in self.daemons.values():
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()


def what_is_missing():
    """Nothing where a cluster can be started, else what it wants, in words."""
    missing = [name for name in NEEDED if not shutil.which(name, path=PATH)]
    if not missing and os.geteuid() == 0:
        return ""
    return ("root and " + (", ".join(missing) or "nothing else") +
            " - apt-get install --no-install-recommends slurm-wlm munge")
