#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random planar mechanisms, by the program and by an independent formulation.

    compare.py PROGRAM DIRECTORY [--first SEED] [--count N] [--keep] [--verbose]

Each seed is a mechanism (families.py) whose parameter file is written to DIRECTORY and
run; positions, velocities and joint forces at the samples of the program's tables are
compared with a solution in reduced coordinates (reduced.py). Given motions must agree to
1e-9, integrated ones to 1e-4 of their largest values; and what one side refuses the other
must refuse too. Needs python3-numpy and python3-scipy.
"""

import argparse
import csv
import shutil
import subprocess
import sys
import traceback
from pathlib import Path

import numpy as np

import families
from reduced import Refused, Solver

GIVEN_TOLERANCE = 1e-9
FREE_TOLERANCE = 1e-4


def read_table(path):
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    names = [name.split(" ")[0] for name in rows[0]]
    values = np.array(rows[1:], dtype=float)
    return {name: values[:, i] for i, name in enumerate(names)}


def run_program(program, directory, mechanism, accuracy):
    """Tables of bodies and joints, or the message of a refusal."""
    case = directory / "case.prm"
    case.write_text(mechanism.parameter_file(accuracy), encoding="utf-8")
    output = directory / "out"
    shutil.rmtree(output, ignore_errors=True)
    result = subprocess.run([program, case, "--output", output], capture_output=True,
                            text=True, timeout=300, check=False)
    if result.returncode != 0:
        return None, (result.stderr or result.stdout).strip()
    bodies = [read_table(output / "bodies" / f"{b.name}_0000.csv") for b in mechanism.bodies]
    joints = [read_table(output / j.name / "duty_cycle_0000.csv") for j in mechanism.joints]
    return (bodies, joints), ""


def largest(values):
    return max((float(np.max(np.abs(v))) for v in values if np.size(v)), default=0.0)


def differences(mechanism, tables, samples):
    """Largest errors of positions, velocities and forces, relative."""
    bodies, joints = tables
    size = mechanism.size
    position, velocity, force = [], [], []
    speed = max(largest([s["velocity"] for s in samples]),
                size * largest([s["angular_velocity"] for s in samples]),
                1e-3 * size / mechanism.duration)
    for i, table in enumerate(bodies):
        for k, sample in enumerate(samples):
            r, v = sample["position"][i], sample["velocity"][i]
            position += [(table["x"][k] - r.real) / size, (table["y"][k] - r.imag) / size]
            turn = np.radians(table["angle"][k]) - sample["angle"][i]
            position.append(np.remainder(turn + np.pi, 2 * np.pi) - np.pi)
            velocity += [(table["velocity_x"][k] - v.real) / speed,
                         (table["velocity_y"][k] - v.imag) / speed,
                         (table["angular_velocity"][k] - sample["angular_velocity"][i])
                         * size / speed]
    all_forces = largest([np.abs(s["reactions"]) / [1.0, size] for s in samples])
    for i, table in enumerate(joints):
        # Of this joint, unless it carries next to nothing.
        scale = max(largest([np.abs(s["reactions"][i]) / [1.0, size] for s in samples]),
                    0.1 * all_forces, 1e-300)
        for k, sample in enumerate(samples):
            f, moment = sample["reactions"][i]
            force += [(table["force_x"][k] - f.real) / scale,
                      (table["force_y"][k] - f.imag) / scale,
                      (table["moment"][k] - moment.real) / (size * scale)]
    return largest([position]), largest([velocity]), largest([force])


def check(seed, program, directory):
    """Whether both sides agree, and what to print about it."""
    mechanism, is_driven, rng = families.make(seed)
    title = f"{seed:4d} {mechanism.title:18s} {mechanism.size:8.2g} m {'given' if is_driven else 'free'}"
    solver = Solver(mechanism)
    refused = ""
    try:
        wanted = rng.uniform(-0.5, 0.5, solver.n) * solver.scale / mechanism.duration
        if not is_driven:
            solver.start_rates(wanted)
        elif solver.n_free != 0:
            return False, title + f": {solver.n_free} degrees of freedom in a given motion"
    except Refused as error:
        refused = str(error)
    tables, message = run_program(program, directory, mechanism, 1e-6)
    n = mechanism.samples
    times = (np.array(tables[0][0]["time"]) if tables
             else mechanism.duration * (np.arange(n) + 0.5) / n)
    samples = []
    if not refused:
        try:
            samples = (solver.given_motion(list(times)) if is_driven
                       else solver.free_motion(list(times), 1e-9))
        except Refused as error:
            refused = str(error)
    if bool(refused) != bool(message):
        who = f"only the reference refuses: {refused}" if refused else f"only the program refuses: {message}"
        return False, f"{title}: {who}"
    if refused:
        return True, f"{title}: refused by both ({refused})"
    errors = differences(mechanism, tables, samples)
    tolerance = GIVEN_TOLERANCE if is_driven else FREE_TOLERANCE
    text = "position %.1e, velocity %.1e, force %.1e" % errors
    return bool(max(errors) < tolerance), f"{title}: {text}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("directory", type=Path)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--keep", action="store_true", help="keep the files of all cases")
    parser.add_argument("--verbose", action="store_true", help="print all, not only failures")
    arguments = parser.parse_args()
    failures = 0
    for seed in range(arguments.first, arguments.first + arguments.count):
        directory = arguments.directory / f"{seed:04d}"
        directory.mkdir(parents=True, exist_ok=True)
        try:
            agrees, text = check(seed, arguments.program, directory)
        except Exception:  # the others shall run all the same
            agrees, text = False, f"{seed:4d}: {traceback.format_exc()}"
        if arguments.verbose or not agrees:
            print(("       " if agrees else "FAILED ") + text, flush=True)
        if agrees and not arguments.keep:
            shutil.rmtree(directory)
        failures += not agrees
    print(f"{arguments.count - failures} of {arguments.count} mechanisms agree")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
