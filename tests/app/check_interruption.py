# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that are told to stop. Known: what doc/parameters.md says of signals.

    check_interruption.py PROGRAM PRM_DIRECTORY WORK_DIRECTORY

A signal comes as soon as a run has said where its results go. Then only seconds may
pass, whatever the run is doing, and a summary must be there.
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

# A run that does not look at a signal takes minutes.
PATIENCE = 20.

SAMPLES = "Dynamics/Samples per cycle"

# Name: (parameter file, settings that make it last long).
RUNS = {
    "impacts": ("mukras2010_steel_impact.prm", ["Dynamics/Averaged cycles=1000"]),
    "motion": ("mukras2010_steel_5mm_literal.prm",
               ["Dynamics/Maximum settling cycles=1000", "Dynamics/Accuracy=1e-7",
                "Dynamics/Settling tolerance=1e-12"]),
    "kinematics": ("scotch_yoke.prm", [f"{SAMPLES}=100000"]),
    "followed": ("quickstart.prm", [f"{SAMPLES}=100000"]),
    "static": ("four_bar.prm", [f"{SAMPLES}=100000",
                                "Dynamics/Analysis=static equilibrium"]),
    "wear": ("quickstart.prm", ["Wear/Extrapolation=constant",
                                "Wear/Cycles per step=1"]),
}


def start(program, prm, name, ignored=None):
    """A run that has begun, and what it has said until then."""
    shutil.rmtree(name, ignore_errors=True)
    file, settings = RUNS[name.split(".")[0]]
    arguments = [word for s in settings for word in ("--set", s)]
    process = subprocess.Popen(
        [program, prm / file, "--output", name, *arguments],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        preexec_fn=lambda: ignored and signal.signal(ignored, signal.SIG_IGN))
    for line in process.stdout:
        if line.startswith("Results go to"):
            break
    time.sleep(0.3)
    return process


def finish(process, name):
    """Exit status and stderr of a run that should end by itself."""
    try:
        _, stderr = process.communicate(timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        sys.exit(f"{name}: goes on")
    return process.returncode, stderr


def expect(what, value, right):
    """One comparison."""
    if value != right:
        sys.exit(f"{what} is {value!r}, should be {right!r}")


def check_one_signal(program, prm, name, number):
    """A first signal: the run says so, writes its summary and ends."""
    process = start(program, prm, name)
    process.send_signal(number)
    status, stderr = finish(process, name)
    expect(f"{name}: exit status", status, 128 + number)
    expect(f"{name}: message", stderr,
           "Stopping after this step, to write what is reached; again to stop at "
           f"once.\nThe run was interrupted by {signal.Signals(number).name}; what "
           "it had reached is written.\n")
    summary = json.loads(pathlib.Path(name, "summary.json").read_text())
    expect(f"{name}: status", summary["status"], "stopped")
    expect(f"{name}: message", summary["message"],
           f"interrupted by {signal.Signals(number).name}")
    print(f"{name}: stopped by {signal.Signals(number).name}")


def check_two_signals(program, prm):
    """A second signal ends the run at once; another kind will do."""
    process = start(program, prm, "wear.twice")
    process.send_signal(signal.SIGINT)
    process.send_signal(signal.SIGTERM)
    status, _ = finish(process, "twice")
    if status not in (-signal.SIGINT, -signal.SIGTERM):
        sys.exit(f"twice: exit status {status}")
    print("twice: ended at once")


def check_nohup(program, prm):
    """Who has asked for SIGHUP to be ignored keeps the run."""
    process = start(program, prm, "wear.nohup", signal.SIGHUP)
    process.send_signal(signal.SIGHUP)
    time.sleep(1.)
    expect("nohup: exit status so far", process.poll(), None)
    process.send_signal(signal.SIGTERM)
    status, _ = finish(process, "nohup")
    expect("nohup: exit status", status, 128 + signal.SIGTERM)
    print("nohup: went on")


def check_closed_pipe(program, prm):
    """Nobody reads what the run says: it is completed, and its log too."""
    shutil.rmtree("pipe", ignore_errors=True)
    process = subprocess.Popen([program, prm / "quickstart.prm", "--output", "pipe"],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    process.stdout.readline()
    process.stdout.close()
    stderr = process.stderr.read()
    expect("pipe: exit status", process.wait(), 0)
    expect("pipe: stderr", stderr, b"")
    summary = json.loads(pathlib.Path("pipe", "summary.json").read_text())
    expect("pipe: status", summary["status"], "completed")
    log = pathlib.Path("pipe", "log.txt").read_text()
    if "Results after" not in log or "Mechanism:" not in log:
        sys.exit(f"pipe: the log is\n{log}")
    print("pipe: completed, with its log")


def check_set_up(program, prm):
    """A signal before anything is written: nothing is."""
    shutil.rmtree("set_up", ignore_errors=True)
    process = subprocess.Popen(
        [program, prm / "quickstart.prm", "--output", "set_up",
         "--set", f"{SAMPLES}=100000",
         "--set", "Bushing crank_pin/Mesh/Nodes across contact=20"],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    process.stdout.readline()
    time.sleep(0.3)
    process.send_signal(signal.SIGTERM)
    status, _ = finish(process, "set-up")
    expect("set-up: exit status", status, 128 + signal.SIGTERM)
    expect("set-up: directory", pathlib.Path("set_up").exists(), False)
    print("set-up: nothing written")


def main(program, prm, work):
    """All of them, each in a directory of its own."""
    pathlib.Path(work).mkdir(parents=True, exist_ok=True)
    program, prm = pathlib.Path(program).resolve(), pathlib.Path(prm).resolve()
    os.chdir(work)
    for name, number in [("impacts", signal.SIGINT), ("motion", signal.SIGTERM),
                         ("kinematics", signal.SIGHUP),
                         ("followed", signal.SIGTERM), ("static", signal.SIGINT),
                         ("wear", signal.SIGUSR1)]:
        check_one_signal(program, prm, name, number)
    check_two_signals(program, prm)
    check_nohup(program, prm)
    check_closed_pipe(program, prm)
    check_set_up(program, prm)


if __name__ == "__main__":
    main(*sys.argv[1:])
