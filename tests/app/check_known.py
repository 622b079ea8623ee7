# SPDX-License-Identifier: LGPL-2.1-or-later

"""Run a case and compare summary.json with what its head knows.

Lines of the head that begin with '# known: ' say what must be there:

    # known: status = stopped
    # known: joints/J/peak_force_N = 45.6e3 +- 1 %
    # known: joints/J/bushing/max_wear_depth_m > 0
    # known: warnings = held_by_friction J, depth J

Names lead through the members of the file; a number that must be met exactly has
no tolerance. Warnings are codes with their joints; without a line there must be none.

Usage: check_known.py PROGRAM CASE DIRECTORY
"""

import json
import re
import shutil
import subprocess
import sys

KNOWN = re.compile(r"# known: (\S+) (=|<|>) (.*?)(?: \+- (\S+) %)?$")


def find(summary, path):
    value = summary
    for name in path.split("/"):
        value = value[name]
    return value


def warnings_of(summary):
    return ", ".join(
        f"{warning['code']} {warning['joint']}".strip()
        for warning in summary["warnings"]
    )


def holds(value, sign, expected, tolerance):
    if isinstance(value, str):
        return expected in value if tolerance is None else False
    difference = value - float(expected)
    if sign == "<":
        return difference < 0
    if sign == ">":
        return difference > 0
    return abs(difference) <= float(tolerance or 0) / 100 * abs(float(expected))


def main():
    program, case, directory = sys.argv[1:]
    shutil.rmtree(directory, ignore_errors=True)
    run = subprocess.run(
        [program, case, "--output", directory], capture_output=True, text=True
    )
    with open(directory + "/summary.json", encoding="utf-8") as file:
        summary = json.load(file)
    with open(case, encoding="utf-8") as file:
        known = [KNOWN.match(line.rstrip()) for line in file]
    known = [match.groups() for match in known if match]
    offences = []
    if run.returncode != (1 if summary["status"] == "failed" else 0):
        offences.append(f"exit status {run.returncode}")
    expected_warnings = [value for path, _, value, _ in known if path == "warnings"]
    if warnings_of(summary) != "".join(expected_warnings):
        offences.append(f"warnings are '{warnings_of(summary)}'")
    for path, sign, expected, tolerance in known:
        if path != "warnings" and not holds(
            find(summary, path), sign, expected, tolerance
        ):
            offences.append(f"{path} is {find(summary, path)}, not {sign} {expected}")
    if not known:
        offences.append("nothing is known")
    print("\n".join(offences + ([run.stdout + run.stderr] if offences else [])))
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
