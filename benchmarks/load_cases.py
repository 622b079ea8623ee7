#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A four-bar with three joints that wear, under 1 to N load cases.

    benchmarks/load_cases.py build/release/tribody [N [CYCLES [RANKS]]]

Each load case has its speed, 20 to 40 rpm, and a force at the coupler that no
other has. The wear coefficient is a hundredth of that of
prm/four_bar_three_joints.prm, so that ten million cycles wear some tens of um. For
each number of cases: wall time, contact problems, largest depth and the error that
is stated. Time should grow no faster than the number of
samples, which the last but one column has, relative to one case.
"""

import json
import math
import os
import subprocess
import sys
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")


def write_case(file_name, n_cases, n_cycles):
    names = [f"case{i}" for i in range(n_cases)]
    lines = [
        f"include {ROOT}/prm/four_bar_three_joints.prm",
        f"set Cycles = {n_cycles}",
        "set Load cases = " + ", ".join(names),
        "set Forces = load",
        "subsection Force load",
        "  set Marker = coupler.C",
        "  set Vector = 0 N, 0 N",
        "end",
    ]
    for i, name in enumerate(names):
        angle = 2.4 * i
        force = 1 + 0.3 * i
        lines += [
            f"subsection Load case {name}",
            f"  set Share = {1 / n_cases:.15g}",
            "  set Wear coefficient factor = 0.01",
            "  subsection Driver motor",
            f"    set Speed = {20 + 20 * i / max(n_cases - 1, 1):.6g} rpm",
            "  end",
            "  subsection Force load",
            f"    set Vector = {force * math.cos(angle):.6g} N, "
            f"{force * math.sin(angle):.6g} N",
            "  end",
            "end",
        ]
    with open(file_name, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def main():
    program = os.path.abspath(sys.argv[1])
    most = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    n_cycles = int(sys.argv[3]) if len(sys.argv) > 3 else 10000000
    ranks = int(sys.argv[4]) if len(sys.argv) > 4 else 1
    print("| Load cases | Wall time [s] | Contact problems | Times | Largest depth [um] | Stated error [%] |")
    print("|---|---|---|---|---|---|")
    first = None
    for n_cases in [n for n in (1, 2, 5, 10, 20) if n < most] + [most]:
        with tempfile.TemporaryDirectory() as directory:
            case = os.path.join(directory, "case.prm")
            write_case(case, n_cases, n_cycles)
            command = [program, case, "--output", os.path.join(directory, "run")]
            if ranks > 1:
                command = ["mpirun", "-n", str(ranks)] + command
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                sys.exit(done.stdout[-1000:] + done.stderr[-1000:])
            with open(os.path.join(directory, "run", "summary.json"), encoding="utf-8") as file:
                summary = json.load(file)
        solves = summary["counts"]["contact_solves"]
        first = first or solves
        depth = max(
            joint["bushing"]["max_wear_depth_m"]
            for joint in summary["joints"].values()
            if "bushing" in joint
        )
        error = summary["error_estimate"]["max_wear_depth_relative"]
        print(
            f"| {n_cases} | {summary['wall_time_s']:.1f} | {solves} | {solves / first:.1f} "
            f"| {1e6 * depth:.4g} | {100 * error:.2g} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
