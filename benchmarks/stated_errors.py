#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later

"""Stated error of the depth beside the true one, over many wear cases.

Each case is run as it is and tight: tolerance of the wear steps 1e-5, motion
renewed with every 0.1 % of the clearance, twice as many cells, four times as
many samples, an accuracy of 3e-5 where the motion is integrated. The difference
of the deepest wear of each joint is its true error, as far as the tight run is
right; the stated one is that of summary.json.

Usage: stated_errors.py PROGRAM [--only WORD] [--jobs N] [--output FILE.md]
"""

import argparse
import concurrent.futures
import json
import os
import subprocess
import sys
import tempfile
import time

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
QUICK = "prm/quickstart.prm"
FOUR_BAR = "prm/four_bar_three_joints.prm"
STEEL = "prm/mukras2010_steel_wear.prm"
HALF_STEEL = "prm/mukras2010_steel_wear_half_length.prm"
ARM = "prm/swinging_arm.prm"
WIPER = "prm/wiper.prm"
PULSE = "tests/app/pulses.prm"
UNBALANCE = "prm/rotating_unbalance.prm"

PTFE = "Material PTFE/Young's modulus"
SPEED = "Driver motor/Speed"
PIN = "Joint crank_pin/Pin radius"
FRICTION = "Joint crank_pin/Friction coefficient"
BUSHING = "Bushing crank_pin"

# Name, file, what is set.
CASES = [
    ("quick start", QUICK, []),
    ("15 rpm", QUICK, [SPEED + "=15 rpm"]),
    ("60 rpm", QUICK, [SPEED + "=60 rpm"]),
    ("120 rpm", QUICK, [SPEED + "=120 rpm"]),
    ("180 rpm", QUICK, [SPEED + "=180 rpm"]),
    ("300 rpm", QUICK, [SPEED + "=300 rpm"]),
    ("modulus 0.07 GPa", QUICK, [PTFE + "=0.07 GPa"]),
    ("modulus 0.5 GPa", QUICK, [PTFE + "=0.5 GPa"]),
    ("modulus 2 GPa", QUICK, [PTFE + "=2 GPa"]),
    ("modulus 20 GPa", QUICK, [PTFE + "=20 GPa"]),
    ("modulus 110 GPa", QUICK, [PTFE + "=110 GPa"]),
    ("modulus 200 GPa", QUICK, [PTFE + "=200 GPa"]),
    ("clearance 2 um", QUICK, [PIN + "=9.533 mm"]),
    ("clearance 50 um", QUICK, [PIN + "=9.485 mm"]),
    ("clearance 150 um", QUICK, [PIN + "=9.385 mm"]),
    ("clearance 50 um, bronze", QUICK, [PIN + "=9.485 mm", PTFE + "=110 GPa"]),
    ("no friction", QUICK, ["Joint crank_pin/Friction law=none"]),
    ("friction 0.3", QUICK, [FRICTION + "=0.3"]),
    ("500 cycles", QUICK, ["Cycles=500"]),
    ("3000 cycles", QUICK, ["Cycles=3000"]),
    ("500 cycles, bronze", QUICK, ["Cycles=500", PTFE + "=110 GPa"]),
    ("40 bore cells", QUICK, [BUSHING + "/Mesh/Bore cells=40"]),
    ("Winkler layer", QUICK, [BUSHING + "/Pressure model=Winkler layer"]),
    (
        "both surfaces",
        QUICK,
        [BUSHING + "/Pin wear coefficient=1e-5 mm^3/(N m)"],
    ),
    ("integrated motion", QUICK, ["Dynamics/Joint motion=dynamic"]),
    (
        "integrated motion, 60 rpm",
        QUICK,
        ["Dynamics/Joint motion=dynamic", SPEED + "=60 rpm"],
    ),
    ("steel", STEEL, []),
    ("steel, half length", HALF_STEEL, []),
    ("four-bar, three joints", FOUR_BAR, ["Cycles=2000"]),
    ("wiper, 60 rpm", WIPER, []),
    ("wiper, 600 rpm", WIPER, ["Driver motor/Speed=600 rpm"]),
    ("swinging arm", ARM, []),
    ("swinging arm, polymer", ARM, ["Material bronze/Young's modulus=3 GPa"]),
    ("pulses", PULSE, []),
    ("rotating unbalance", UNBALANCE, []),
]


def run(program, file_name, overrides, directory):
    """Summary and processor time [s] of a run; None if it fails."""
    command = [program, os.path.join(ROOT, file_name), "--output", directory]
    for override in overrides:
        command += ["--set", override]
    begin = time.time()
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(done.stdout[-500:] + done.stderr[-500:], file=sys.stderr)
        return None, time.time() - begin
    with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
        return json.load(file), time.time() - begin


def parameter(text, path, bushing=None):
    """The value of an entry in a written parameter file."""
    current, wanted = [], path.split("/")
    for line in text.splitlines():
        words = line.strip()
        if words.startswith("subsection "):
            current.append(words[len("subsection ") :])
        elif words == "end":
            current.pop()
        elif words.startswith("set ") and current == wanted[:-1]:
            name, _, value = words[len("set ") :].partition("=")
            if name.strip() == wanted[-1]:
                return value.split("#")[0].strip()
    raise KeyError(path)


def tighten(directory, summary):
    """Settings of the tight run of a case whose results are in directory."""
    with open(os.path.join(directory, "parameters.prm"), encoding="utf-8") as file:
        text = file.read()
    samples = int(parameter(text, "Dynamics/Samples per cycle"))
    tight = [
        "Wear/Tolerance=1e-5",
        "Wear/Dynamics update=0.001",
        "Wear/Mesh error estimate=none",
        "Dynamics/Sampling tolerance=0",
        "Dynamics/Accuracy=3e-5",
        f"Dynamics/Samples per cycle={4 * samples}",
    ]
    for name, joint in summary["joints"].items():
        if "bushing" in joint:
            for entry in ("Bore cells", "Radial cells"):
                path = f"Bushing {name}/Mesh/{entry}"
                tight.append(f"{path}={2 * int(parameter(text, path))}")
    return tight


def compare(program, case):
    """Rows of the table: one per joint that wears."""
    name, file_name, overrides = case
    with tempfile.TemporaryDirectory() as directory:
        plain = os.path.join(directory, "plain")
        summary, seconds = run(program, file_name, overrides, plain)
        if summary is None:
            return [(name, "", None, None, None, seconds, 0.0)]
        tight, tight_seconds = run(
            program,
            file_name,
            overrides + tighten(plain, summary),
            os.path.join(directory, "tight"),
        )
        if tight is None:
            return [(name, "", None, None, None, seconds, tight_seconds)]
    rows = []
    for joint, results in summary["joints"].items():
        if "bushing" not in results:
            continue
        depth = results["bushing"]["max_wear_depth_m"]
        true = tight["joints"][joint]["bushing"]["max_wear_depth_m"]
        rows.append(
            (
                name,
                joint,
                1e6 * depth,
                results["depth_error"]["sum"],
                abs(depth / true - 1.0),
                seconds,
                tight_seconds,
            )
        )
    return rows


def write_table(rows, out):
    """As Markdown."""
    print(
        "| Case | Joint | Depth [um] | Stated [%] | True [%] | Stated/true |"
        " Time [s] | Tight [s] |\n|---|---|---|---|---|---|---|---|",
        file=out,
    )
    for name, joint, depth, stated, true, seconds, tight in rows:
        if depth is None:
            print(f"| {name} | failed | | | | | {seconds:.0f} | {tight:.0f} |", file=out)
            continue
        ratio = stated / true if true > 0 else float("inf")
        print(
            f"| {name} | {joint} | {depth:.4g} | {100 * stated:.2g} |"
            f" {100 * true:.2g} | {ratio:.2g} | {seconds:.0f} | {tight:.0f} |",
            file=out,
        )


def main():
    """Run the cases and write the table; 1 if an error is not stated."""
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--only", default="")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--output")
    arguments = parser.parse_args()
    cases = [case for case in CASES if arguments.only in case[0]]
    rows = []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for of_case in pool.map(lambda case: compare(arguments.program, case), cases):
            rows += of_case
            write_table(of_case, sys.stderr)
    if arguments.output:
        with open(arguments.output, "w", encoding="utf-8") as file:
            write_table(rows, file)
    else:
        write_table(rows, sys.stdout)
    bad = [r for r in rows if r[2] is None or r[3] < r[4] / 3.0]
    print(f"{len(cases)} cases, {len(bad)} with an error above three times the stated one")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
