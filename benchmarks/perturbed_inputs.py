#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later

"""Depths of the shipped wear cases, with one input changed by 1e-12.

Each case is run N times, its pin radii multiplied by 1 + k 1e-12. Depths that
differ by more than the stated error follow noise of the forces, not the input.

Usage: perturbed_inputs.py PROGRAM [--runs N] [--only WORD] [--output FILE.md]
"""

import argparse
import concurrent.futures
import glob
import json
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")


def pin_radii(program, file_name, directory):
    """Paths and values of the pin radii of a case; empty if nothing wears."""
    listed = os.path.join(directory, "plain")
    done = subprocess.run(
        [program, file_name, "--output", listed],
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode != 0:
        raise RuntimeError(f"{file_name}: {done.stdout[-300:]}{done.stderr[-300:]}")
    with open(os.path.join(listed, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    if not any("bushing" in joint for joint in summary["joints"].values()):
        return [], summary
    radii, section = [], ""
    with open(os.path.join(listed, "parameters.prm"), encoding="utf-8") as file:
        for line in file:
            if line.startswith("subsection Joint "):
                section = line[len("subsection ") :].strip()
            found = re.match(r"\s*set Pin radius\s*=\s*([-+.\deE]+)\s*([^#]*)", line)
            if found and section:
                radii.append(
                    (section + "/Pin radius", float(found[1]), found[2].strip())
                )
    return radii, summary


def depths(summary):
    """Deepest wear [m] and stated relative error of each joint that wears."""
    return {
        name: (
            joint["bushing"]["max_wear_depth_m"],
            joint["bushing"]["depth_error"]["sum"]
            if "depth_error" in joint["bushing"]
            else joint["depth_error"]["sum"],
        )
        for name, joint in summary["joints"].items()
        if "bushing" in joint
    }


def spread(program, file_name, n_runs):
    """Rows: case, joint, depth, largest difference, stated error."""
    name = os.path.splitext(os.path.basename(file_name))[0]
    with tempfile.TemporaryDirectory() as directory:
        radii, summary = pin_radii(program, file_name, directory)
        if not radii:
            return []
        runs = [depths(summary)]
        for k in range(1, n_runs):
            command = [program, file_name, "--output", os.path.join(directory, str(k))]
            for path, value, unit in radii:
                command += ["--set", f"{path}={value * (1 + k * 1e-12):.17g} {unit}"]
            subprocess.run(command, capture_output=True, check=True)
            with open(
                os.path.join(directory, str(k), "summary.json"), encoding="utf-8"
            ) as file:
                runs.append(depths(json.load(file)))
    rows = []
    for joint, (depth, stated) in runs[0].items():
        of_joint = [run[joint][0] for run in runs]
        rows.append((name, joint, depth, (max(of_joint) - min(of_joint)) / depth, stated))
    return rows


def main():
    """Run the cases and write the table; 1 if a spread is above what is stated."""
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--runs", type=int, default=10)
    parser.add_argument("--only", default="")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--output")
    arguments = parser.parse_args()
    program = os.path.abspath(arguments.program)
    files = sorted(glob.glob(os.path.join(ROOT, "prm", "*.prm")))
    files = [f for f in files if arguments.only in os.path.basename(f)]
    rows = []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for of_case in pool.map(
            lambda file_name: spread(program, file_name, arguments.runs), files
        ):
            rows += of_case
    with open(arguments.output, "w", encoding="utf-8") if arguments.output else (
        open(sys.stdout.fileno(), "w", encoding="utf-8", closefd=False)
    ) as out:
        print(
            "| Case | Joint | Depth [um] | Spread | Stated error |\n"
            "|---|---|---|---|---|",
            file=out,
        )
        for name, joint, depth, difference, stated in rows:
            print(
                f"| {name} | {joint} | {1e6 * depth:.5g} | {difference:.2g} |"
                f" {stated:.2g} |",
                file=out,
            )
    bad = [row for row in rows if row[3] > row[4]]
    print(f"{len(rows)} joints, {len(bad)} with a spread above the stated error")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
