#!/usr/bin/env python3
"""Implicit cycle jumps beside constant extrapolation, on several meshes.

    benchmarks/wear_steps.py build/release/tribody prm/mukras2010_validation.prm

Rate evaluations, contact problems and times are counted over whole runs. "At
equal accuracy" means that both state a similar error: constant extrapolation
takes steps as long as they are stable, which are more accurate than asked for.
The depth of both is shown, so that the difference can be judged.
"""

import json
import subprocess
import sys
import tempfile


def run(program, case, bushing, n_nodes, extrapolation):
    with tempfile.TemporaryDirectory() as directory:
        subprocess.run(
            [program, case, "--output", directory + "/run",
             "--set", f"Bushing {bushing}/Mesh/Bore cells={n_nodes // 2}",
             "--set", f"Wear/Extrapolation={extrapolation}"],
            check=True, stdout=subprocess.DEVNULL)
        with open(directory + "/run/summary.json", encoding="utf-8") as file:
            return json.load(file)


def main():
    program, case = sys.argv[1:3]
    bushing = sys.argv[3] if len(sys.argv) > 3 else "crank_pin"
    print("bore nodes  extrapolation  steps  rates  contacts  time [s]"
          "  depth [mm]  estimate")
    for n_nodes in (180, 360, 720):
        times = []
        for extrapolation in ("implicit", "constant"):
            summary = run(program, case, bushing, n_nodes, extrapolation)
            counts = summary["counts"]
            depth = summary["joints"][bushing]["bushing"]["max_wear_depth_m"]
            estimate = summary["error_estimate"]["max_wear_depth_relative"]
            times.append(summary["wall_time_s"])
            print(f"{n_nodes:10}  {extrapolation:13}  {counts['wear_steps']:5}"
                  f"  {counts['rate_evaluations']:5}"
                  f"  {counts['contact_solves']:8}  {times[-1]:8.1f}"
                  f"  {1e3 * depth:10.5f}  {estimate:8.1e}", flush=True)
        print(f"{'':10}  time, constant over implicit: "
              f"{times[1] / times[0]:.2f}")


if __name__ == "__main__":
    main()
