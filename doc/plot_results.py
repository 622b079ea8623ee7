#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the curves of a run: forces, contact angles, worn profiles, wear.

    doc/plot_results.py OUTPUT_DIR [JOINT ...] -o results.png

A row for each joint (default: all), with what there is of it: the joint force
and the angle of contact in the bushing frame against the phase of the cycle (of
the first and the last cycle, or the last one of each load case), the worn profile
(and, dashed, that of a pin that wears, in its own frame), depth and volume
against cycles. --compare draws a second run, dotted, into the last panel. The
picture's format follows its name (.png, .pdf, .svg). Needs Matplotlib: apt-get install python3-matplotlib
"""

import argparse
import csv
import glob
import os
import re
import sys
from xml.etree import ElementTree

try:
    import numpy as np
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot
    from PIL import Image
except ImportError as error:
    # The first python3 of the path need not be the one that apt installs for.
    system_python = "/usr/bin/python3"
    if os.path.exists(system_python) and not os.path.samefile(
        sys.executable, system_python
    ):
        os.execv(system_python, [system_python, os.path.abspath(__file__)] + sys.argv[1:])
    sys.exit(f"plot_results: {error}: apt-get install python3-matplotlib")


def read_csv(file_name):
    """Columns of a table by name, for example "force [N]"; '#' starts a comment."""
    with open(file_name, encoding="utf-8", newline="") as file:
        lines = [line for line in file if line.strip() and not line.startswith("#")]
    rows = list(csv.reader(lines, skipinitialspace=True))
    if not rows:
        sys.exit(f"plot_results: {file_name} has no header")
    try:
        values = np.array(rows[1:], dtype=float).reshape(-1, len(rows[0]))
    except ValueError as error:
        sys.exit(f"plot_results: {file_name}: {error}")
    return {name.strip(): values[:, i] for i, name in enumerate(rows[0])}


def column(table, name, file_name):
    if name not in table:
        sys.exit(
            f"plot_results: {file_name} has no column '{name}'; "
            f"it has {', '.join(table)}"
        )
    return table[name]


def numbered_files(directory, stem):
    """Pairs (number, file) of directory/stem_NNNN.csv, by number."""
    pairs = []
    for file_name in glob.glob(os.path.join(glob.escape(directory), f"{stem}_*.csv")):
        match = re.fullmatch(rf"{stem}_(\d+)\.csv", os.path.basename(file_name))
        if match:
            pairs.append((int(match.group(1)), file_name))
    return sorted(pairs)


def duty_cycles(directory):
    """Pairs (number, file) of the duty cycles of each load case, by its name."""
    cases = {}
    for file_name in glob.glob(os.path.join(glob.escape(directory), "duty_cycle_*.csv")):
        name = os.path.basename(file_name)
        match = re.fullmatch(r"duty_cycle_(?:(.+)_)?(\d+)\.csv", name)
        if match:
            cases.setdefault(match.group(1) or "", []).append(
                (int(match.group(2)), file_name)
            )
    return {case: sorted(pairs) for case, pairs in sorted(cases.items())}


def spread(items, n):
    """At most n of the items, evenly spread, the first and the last among them."""
    if len(items) <= n:
        return items
    return [items[i] for i in sorted(set(np.linspace(0, len(items) - 1, n).astype(int)))]


def read_cycles(output_dir):
    """Cycles by number of output, from the bushings' lists for ParaView."""
    cycles = {}
    pattern = os.path.join(glob.escape(output_dir), "*", "bushing.pvd")
    for file_name in glob.glob(pattern):
        for entry in ElementTree.parse(file_name).iter("DataSet"):
            match = re.fullmatch(r"bushing_(\d+)\.p?vtu", entry.get("file", ""))
            if match:
                cycles[int(match.group(1))] = float(entry.get("timestep"))
    return cycles


class Run:
    def __init__(self, output_dir):
        self.output_dir = output_dir
        self.history_file = os.path.join(output_dir, "history.csv")
        self.history = {}
        if os.path.isfile(self.history_file):
            self.history = read_csv(self.history_file)
        self.cycles = read_cycles(output_dir)

    def joints(self):
        """Names of the joints, in alphabetical order."""
        return [
            name
            for name in sorted(os.listdir(self.output_dir))
            if duty_cycles(os.path.join(self.output_dir, name))
            or numbered_files(os.path.join(self.output_dir, name), "profile")
        ]

    def label(self, number):
        """How many cycles had passed at an output."""
        if number not in self.cycles:
            return f"output {number}"
        return f"{self.cycles[number]:,.0f} cycles".replace(",", "\u2009")


def colours_for(pairs):
    colours = matplotlib.colormaps["viridis"]
    return [colours(0.9 * i / max(len(pairs) - 1, 1)) for i in range(len(pairs))]


def cycles_to_draw(run, joint):
    """Label, table, file, colour and line width: the first and the last cycle, or
    the last one of each load case."""
    cases = duty_cycles(os.path.join(run.output_dir, joint))
    if list(cases) == [""]:
        pairs = cases[""]
        pairs = [pairs[0], pairs[-1]] if len(pairs) > 2 else pairs
        # The first line is the wider one: it stays visible where the two coincide.
        styles = [("0.7", 3.0), ("C3", 1.2)][-len(pairs) :]
        return [
            (run.label(number), read_csv(file_name), file_name, colour, width)
            for (number, file_name), (colour, width) in zip(pairs, styles)
        ]
    return [
        (case, read_csv(pairs[-1][1]), pairs[-1][1], f"C{i % 10}", 1.2)
        for i, (case, pairs) in enumerate(cases.items())
    ]


def label_phase(axes):
    axes.set_xlim(0, 360)
    axes.set_xticks(range(0, 361, 90))
    axes.set_xlabel("phase of the cycle [deg]")


def draw_force(axes, run, joint):
    for label, table, file_name, colour, width in cycles_to_draw(run, joint):
        name = "force [N]" if "force [N]" in table else "normal_force [N]"
        force = column(table, name, file_name)
        phase = column(table, "phase [deg]", file_name)
        axes.plot(phase, force, color=colour, linewidth=width, label=label)
    label_phase(axes)
    axes.set_ylim(bottom=0)
    axes.set_ylabel("joint force [N]")
    axes.legend(frameon=False, fontsize="small")


def has_contact_angle(run, joint):
    """Joints with clearance have one."""
    cases = duty_cycles(os.path.join(run.output_dir, joint))
    return any(
        "contact_angle_bushing [deg]" in read_csv(pairs[0][1])
        for pairs in cases.values()
    )


def draw_contact_angle(axes, run, joint):
    for label, table, file_name, colour, width in cycles_to_draw(run, joint):
        phase = column(table, "phase [deg]", file_name)
        angle = column(table, "contact_angle_bushing [deg]", file_name).copy()
        # Nothing is drawn where the pin flies, nor across 360 deg.
        angle[column(table, "state [-]", file_name) == 0] = np.nan
        jumps = np.flatnonzero(np.abs(np.diff(angle)) > 180) + 1
        axes.plot(
            np.insert(phase, jumps, np.nan),
            np.insert(angle, jumps, np.nan),
            color=colour,
            linewidth=width,
            label=label,
        )
    label_phase(axes)
    axes.set_ylim(0, 360)
    axes.set_yticks(range(0, 361, 90))
    axes.set_ylabel("contact angle in bushing [deg]")


def draw_profile(axes, run, joint):
    pairs = spread(numbered_files(os.path.join(run.output_dir, joint), "profile"), 5)
    for (number, file_name), colour in zip(pairs, colours_for(pairs)):
        table = read_csv(file_name)
        angle = np.radians(column(table, "angle [deg]", file_name))
        depth = 1e6 * column(table, "bushing_wear_depth [m]", file_name)
        order = np.argsort(angle)
        axes.plot(
            np.append(angle[order], angle[order][:1] + 2 * np.pi),
            np.append(depth[order], depth[order][:1]),
            color=colour,
            linewidth=1.2,
            label=run.label(number),
        )
    for number, file_name in numbered_files(
        os.path.join(run.output_dir, joint), "pin_profile"
    )[-1:]:
        table = read_csv(file_name)
        angle = np.radians(column(table, "angle [deg]", file_name))
        depth = 1e6 * column(table, "pin_wear_depth [m]", file_name)
        order = np.argsort(angle)
        axes.plot(
            np.append(angle[order], angle[order][:1] + 2 * np.pi),
            np.append(depth[order], depth[order][:1]),
            "C3--",
            linewidth=1.0,
            label=f"pin, {run.label(number)}",
        )
    axes.set_rlabel_position(20)
    axes.set_ylim(bottom=0)
    axes.tick_params(labelsize="small")
    axes.set_title("wear depth in the bushing frame [µm]", fontsize="medium")
    axes.legend(
        frameon=False, fontsize="small", loc="upper center", bbox_to_anchor=(0.5, -0.08),
        ncols=2,
    )


def draw_history(axes, run, joint, other=None):
    cycles = column(run.history, "cycles [-]", run.history_file)
    depth_name = f"{joint} max_wear_depth [m]"
    volume_name = f"{joint} worn_volume [m^3]"
    depth = 1e6 * column(run.history, depth_name, run.history_file)
    # Marks show the wear steps, as long as they can be told apart.
    size = 2.5 if len(cycles) <= 40 else 0
    axes.plot(cycles, depth, "o-", color="C0", markersize=size, linewidth=1.2)
    if other is not None and depth_name in other.history:
        axes.plot(
            column(other.history, "cycles [-]", other.history_file),
            1e6 * other.history[depth_name],
            ":",
            color="black",
            linewidth=1.5,
            label=f"depth, {os.path.basename(os.path.normpath(other.output_dir))}",
        )
        axes.legend(frameon=False, fontsize="small")
    axes.set_xlabel("cycles")
    axes.set_ylabel("deepest wear [µm]", color="C0")
    axes.tick_params(axis="y", colors="C0")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    if volume_name in run.history:
        volume_axes = axes.twinx()
        volume = 1e9 * run.history[volume_name]
        volume_axes.plot(
            cycles, volume, "s--", color="C1", markersize=size, linewidth=1.2
        )
        volume_axes.set_ylabel("worn volume [mm³]", color="C1")
        volume_axes.tick_params(axis="y", colors="C1")
        volume_axes.set_ylim(bottom=0)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("output_dir", metavar="OUTPUT_DIR")
    parser.add_argument("joints", metavar="JOINT", nargs="*")
    parser.add_argument("-o", "--output", default="results.png", metavar="PICTURE")
    parser.add_argument(
        "--compare", metavar="DIR", help="a second run, for depth against cycles"
    )
    parser.add_argument(
        "--dpi", type=float, default=150, help="pixels per inch (default: 150)"
    )
    arguments = parser.parse_args()

    for directory in filter(None, (arguments.output_dir, arguments.compare)):
        if not os.path.isdir(directory):
            sys.exit(f"plot_results: there is no directory {directory}")
    run = Run(arguments.output_dir)
    other = Run(arguments.compare) if arguments.compare else None
    joints = run.joints()
    for joint in arguments.joints:
        if joint not in joints:
            sys.exit(
                f"plot_results: no results of a joint {joint}; there are: "
                f"{', '.join(joints) or 'none'}"
            )
    joints = arguments.joints or joints
    if not joints:
        sys.exit(f"plot_results: no results of any joint in {arguments.output_dir}")

    figure = pyplot.figure(figsize=(15, 3.6 * len(joints)), layout="constrained")
    figure.get_layout_engine().set(w_pad=0.12, h_pad=0.08)
    for row, (joint, strip) in enumerate(
        zip(joints, np.atleast_1d(figure.subfigures(len(joints), 1)))
    ):
        strip.suptitle(joint.replace("_", " "), weight="bold")
        directory = os.path.join(run.output_dir, joint)
        if duty_cycles(directory):
            draw_force(strip.add_subplot(1, 4, 1), run, joint)
        if has_contact_angle(run, joint):
            draw_contact_angle(strip.add_subplot(1, 4, 2), run, joint)
        if numbered_files(directory, "profile"):
            draw_profile(strip.add_subplot(1, 4, 3, projection="polar"), run, joint)
        if f"{joint} max_wear_depth [m]" in run.history:
            draw_history(strip.add_subplot(1, 4, 4), run, joint, other)

    try:
        figure.savefig(arguments.output, dpi=arguments.dpi)
        if arguments.output.lower().endswith(".png"):
            # A palette makes a small file.
            picture = Image.open(arguments.output).convert("RGB").quantize(256)
            picture.save(arguments.output, optimize=True)
    except (OSError, ValueError) as error:
        sys.exit(f"plot_results: cannot write {arguments.output}: {error}")
    print(f"Wrote {arguments.output}")


if __name__ == "__main__":
    main()
