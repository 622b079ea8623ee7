#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Implicit cycle jumps beside constant extrapolation, on several meshes.

    benchmarks/wear_steps.py build/release/tribody \\
        prm/mukras2010_validation.prm [BUSHING [NODES ...]]

Whole runs: wear steps, rate evaluations, contact problems, processor and wall
time, memory. Constant extrapolation takes 80 % of the stable step, so that its
rate is smooth from node to node (last column; an unstable step brings it to
order one). Longer steps are not open to it, so that "at equal accuracy" the
implicit run has to follow: its tolerance is tightened by tens until its error
is no larger than that of constant extrapolation, or 1e-4. Errors of the largest
depth are differences from an implicit run with a tolerance of 1e-5 and new
dynamics after each step; "estimate" is what a run says about itself.

The lines "implicit - constant" show the difference of depth of the two runs
beside the estimate of the implicit one, within which it must be.
"""

import json
import subprocess
import sys
import tempfile

DEFAULT = ("Wear/Extrapolation=implicit",)
CONSTANT = ("Wear/Extrapolation=constant",)
REFERENCE = ("Wear/Extrapolation=implicit", "Wear/Tolerance=1e-5",
             "Wear/Dynamics update=0")


def run(program, case, bushing, n_nodes, settings):
    settings = (f"Bushing {bushing}/Mesh/Bore cells={n_nodes // 2}",
                "Wear/Mesh error estimate=none") + settings
    with tempfile.TemporaryDirectory() as directory:
        command = [program, case, "--output", directory + "/run"]
        for setting in settings:
            command += ["--set", setting]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        with open(directory + "/run/summary.json", encoding="utf-8") as file:
            return json.load(file)


def depth_of(summary, bushing):
    return summary["joints"][bushing]["bushing"]["max_wear_depth_m"]


def estimate_of(summary):
    return summary["error_estimate"]["max_wear_depth_relative"]


def print_run(name, n_nodes, bushing, summary, error):
    counts = summary["counts"]
    surface = summary["joints"][bushing]["bushing"]
    print(f"{n_nodes:5}  {name:15}  {counts['wear_steps']:5}"
          f"  {counts['rate_evaluations']:5}  {counts['contact_solves']:8}"
          f"  {summary['cpu_time_s']:7.1f}  {summary['wall_time_s']:8.1f}"
          f"  {summary['peak_memory_bytes'] / 1e6:6.0f}"
          f"  {1e3 * surface['max_wear_depth_m']:10.6f}"
          f"  {100 * error:8.4f}  {100 * estimate_of(summary):8.4f}"
          f"  {surface['wear_rate_mesh_oscillation']:8.1e}", flush=True)


def print_ratios(text, constant, implicit):
    ratios = [constant["counts"][key] / implicit["counts"][key]
              for key in ("rate_evaluations", "contact_solves")]
    ratios.append(constant["cpu_time_s"] / implicit["cpu_time_s"])
    print(text + "rates {:.2f}, contacts {:.2f}, CPU {:.2f}".format(*ratios),
          flush=True)


def main():
    program, case = sys.argv[1:3]
    bushing = sys.argv[3] if len(sys.argv) > 3 else "crank_pin"
    meshes = [int(n) for n in sys.argv[4:]] or [180, 360, 720]
    print("nodes  extrapolation    steps  rates  contacts  CPU [s]  wall [s]"
          "      MB  depth [mm]  error[%]  estim[%]  oscillation")
    for n_nodes in meshes:
        exact = depth_of(run(program, case, bushing, n_nodes, REFERENCE),
                         bushing)

        def error_of(summary):
            return abs(depth_of(summary, bushing) / exact - 1)

        constant = run(program, case, bushing, n_nodes, CONSTANT)
        print_run("constant", n_nodes, bushing, constant, error_of(constant))

        implicit = run(program, case, bushing, n_nodes, DEFAULT)
        print_run("implicit", n_nodes, bushing, implicit, error_of(implicit))
        difference = abs(depth_of(implicit, bushing) /
                         depth_of(constant, bushing) - 1)
        within = difference <= estimate_of(implicit)
        print(f"{n_nodes:5}  implicit - constant: depth {100 * difference:.4f}"
              f" %, estimate {100 * estimate_of(implicit):.4f} %: "
              f"{'within' if within else 'NOT WITHIN'}")
        print_ratios(f"{n_nodes:5}  constant over implicit: ", constant,
                     implicit)

        equal, tolerance = implicit, 1e-3
        while error_of(equal) > error_of(constant) and tolerance > 1e-5:
            equal = run(program, case, bushing, n_nodes,
                        DEFAULT + (f"Wear/Tolerance={tolerance:g}",))
            print_run(f"implicit, {tolerance:g}", n_nodes, bushing, equal,
                      error_of(equal))
            tolerance /= 10
        if equal is not implicit:
            print_ratios(f"{n_nodes:5}  constant over the last implicit: ",
                         constant, equal)


if __name__ == "__main__":
    main()
