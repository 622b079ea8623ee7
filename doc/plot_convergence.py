#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws how contact converges under refinement, from the outputs of tests.

    doc/plot_convergence.py [-o doc/images/convergence.png]

Left: error of the peak pressure (root mean square over loads and directions)
against Persson's solution (tests/contact/persson_01.output) and of the
validation joint against its finest mesh (peak_convergence_01.output). Right:
largest error of the half-angle. Needs Matplotlib: apt-get install
python3-matplotlib
"""

import argparse
import os
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

TESTS = os.path.join(os.path.dirname(__file__), "..", "tests", "contact")


def read_persson():
    """Title -> list of (nodes, peak error, worst half-angle error [deg])."""
    series = {}
    for line in open(os.path.join(TESTS, "persson_01.output"), encoding="utf-8"):
        row = re.match(
            r" +(\d+) bore nodes: .*worst ([\d.]+) deg\), peak by ([\d.]+)e-3", line
        )
        if row:
            series[title].append(
                (int(row[1]), 1e-3 * float(row[3]), float(row[2]))
            )
        elif not line.startswith(" "):
            title = line.strip()
            series[title] = []
    return series


def read_validation():
    text = open(os.path.join(TESTS, "peak_convergence_01.output"), encoding="utf-8")
    rows = re.findall(r"(\d+) bore nodes: error of the peak ([\d.]+)e-3", text.read())
    return [(int(n), 1e-3 * float(error)) for n, error in rows]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", default="convergence.png")
    arguments = parser.parse_args()

    figure, (peak, angle) = plt.subplots(1, 2, figsize=(10, 4.2))
    for title, rows in read_persson().items():
        nodes = [row[0] for row in rows]
        peak.loglog(nodes, [row[1] for row in rows], "o-", label="Persson, " + title)
        angle.loglog(nodes, [row[2] for row in rows], "o-", label=title)
    validation = read_validation()
    peak.loglog(*zip(*validation), "ks-", label="validation joint, degree 2")
    peak.loglog([30, 360], [8e-3, 8e-3 / 144], "k:", label="second order")
    angle.loglog([90, 360], [0.4, 0.1], "k:", label="0.1 node distances")
    angle.axhline(0.3, color="grey", linewidth=0.8)
    peak.axhline(3e-3, color="grey", linewidth=0.8)
    peak.set_title("Peak pressure: relative error, rms")
    angle.set_title("Half-angle of contact: largest error [deg]")
    for axes in (peak, angle):
        axes.set_xlabel("bore nodes")
        axes.grid(True, which="both", alpha=0.3)
        axes.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(arguments.output, dpi=110)


if __name__ == "__main__":
    main()
