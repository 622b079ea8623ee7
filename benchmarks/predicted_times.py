#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later

"""What --check says that runs take, beside what they take.

Usage: predicted_times.py PROGRAM [FILE.prm ...]
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
UNITS = {"s": 1.0, "min": 60.0, "h": 3600.0, "days": 86400.0}
# Name, file, what is set.
MORE = [
    ("wiper, 600 rpm", "wiper.prm", ["Driver motor/Speed=600 rpm"]),
    ("validation, 300 rpm", "quickstart.prm", ["Driver motor/Speed=300 rpm"]),
    (
        "validation, 100 cycles a step",
        "quickstart.prm",
        ["Wear/Extrapolation=constant", "Wear/Cycles per step=100"],
    ),
]


def predict(program, arguments):
    """Seconds that --check says; whether that is a lower bound."""
    done = subprocess.run(
        [program, *arguments, "--check"], capture_output=True, text=True, check=True
    )
    found = re.search(r"^Time: (about|more than) (\S+) (\w+)", done.stdout, re.M)
    return float(found[2]) * UNITS[found[3]], found[1] != "about"


def main(program, *files):
    cases = [(pathlib.Path(file).stem, file, []) for file in files]
    if not files:
        cases = [(file.stem, file, []) for file in sorted((ROOT / "prm").glob("*.prm"))]
        cases += [(name, ROOT / "prm" / file, settings) for name, file, settings in MORE]
    print("| Case | Predicted [s] | Taken [s] | Ratio |\n|---|---|---|---|")
    for name, file, settings in cases:
        with tempfile.TemporaryDirectory() as directory:
            arguments = [str(file), "--output", directory + "/results"]
            for setting in settings:
                arguments += ["--set", setting]
            seconds, is_bound = predict(program, arguments)
            subprocess.run([program, *arguments], capture_output=True, check=True)
            with open(directory + "/results/summary.json", encoding="utf-8") as summary:
                taken = json.load(summary)["wall_time_s"]
        print(
            f"| {name} | {'more than ' if is_bound else ''}{seconds:.2g} | {taken:.2g} "
            f"| {taken / seconds:.2f} |",
            flush=True,
        )


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
