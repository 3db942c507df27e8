"""packaging/regarment.service by systemd itself: it is understood whole, and leaves little open. Ends
with 77, which CTest counts as skipped, where there is no systemd-analyze."""
import os
import re
import shutil
import subprocess
import sys
import tempfile

from running_service import SOURCE, finish

PROGRAM = os.path.abspath(sys.argv[1])
UNIT = os.path.join(SOURCE, "packaging", "regarment.service")
MOST_EXPOSED = 20  # tenths; systemd calls 2.0 and less OK
failures = []


def analyze(*words):
    run = subprocess.run(["systemd-analyze", "--no-pager", *words], capture_output=True, text=True,
                         timeout=60, check=False)
    return run.returncode, run.stdout + run.stderr


def faults(folder, text):
    """What systemd says of a unit; it warns of what it does not know and goes on."""
    place = os.path.join(folder, "regarment.service")
    with open(place, "w") as file:
        file.write(text)
    status, words = analyze("verify", "--man=no", place)
    # Of other units of this machine it may say what it likes.
    ours = [line for line in words.splitlines() if "regarment" in line]
    return ours or ([f"status {status}: {words}"] if status else [])


def exposed(folder, text, most):
    place = os.path.join(folder, "regarment.service")
    with open(place, "w") as file:
        file.write(text)
    return analyze("security", "--offline=true", f"--threshold={most}", place)


if shutil.which("systemd-analyze") is None:
    print("skipped: there is no systemd-analyze here")
    sys.exit(77)
with open(UNIT) as unit:
    written = unit.read()
# It is installed to a place where this test has put nothing.
unit, commands = re.subn(r"^ExecStart=\S+", "ExecStart=" + PROGRAM, written, flags=re.M)
if commands != 1:
    failures.append(f"{commands} commands to start")
with tempfile.TemporaryDirectory() as folder:
    failures += faults(folder, unit)
    # It does find what is wrong.
    for wrong, line in (("an option nobody knows", "ProtectAll=yes"), ("no number", "TasksMax=few"),
                        ("a program that is not there", "ExecStartPre=/nowhere/regarment")):
        if not faults(folder, unit.replace("[Service]\n", f"[Service]\n{line}\n")):
            failures.append(f"systemd takes {wrong}: {line}")
    status, words = exposed(folder, unit, MOST_EXPOSED)
    if status:
        failures.append("too much is open: " + words.strip().splitlines()[-1])
    bare = re.sub(r"^(Protect|Private|Restrict|SystemCall|Capability|NoNew|Dynamic).*\n", "", unit,
                  flags=re.M)
    if exposed(folder, bare, MOST_EXPOSED)[0] == 0:
        failures.append("a unit that protects nothing would do as well")
    # The software renderer compiles its shaders.
    if re.search(r"^MemoryDenyWriteExecute=(?!no)", written, flags=re.M):
        failures.append("MemoryDenyWriteExecute would end every fit")
finish(failures)
