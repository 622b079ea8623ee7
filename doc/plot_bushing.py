#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws how a bushing wears: stress and contact pressure at three stages.

    doc/plot_bushing.py OUTPUT_DIR JOINT -o picture.png

reads OUTPUT_DIR/JOINT/bushing.pvd and writes one PNG: in the upper row the von
Mises stress in the worn ring, in the lower row the cells and, inwards from the
bore, the contact pressure; one column each for the first, a middle and the
last stage. The shapes are the worn ones; what has been worn away is red, the
bore as manufactured dashed. --scale exaggerates the wear, --zoom enlarges the
deepest place, --temperature shows that of a warm joint instead of the stress.

ParaView draws the rings, Matplotlib puts the picture together:
    apt-get install paraview python3-paraview python3-matplotlib xvfb
The script starts itself again in pvpython, off-screen, so it runs anywhere.
"""

import argparse
import contextlib
import os
import shutil
import subprocess
import sys
import tempfile

INSIDE_PVPYTHON = "TRIBODY_INSIDE_PVPYTHON"


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("output_dir", metavar="OUTPUT_DIR")
    parser.add_argument("joint", metavar="JOINT")
    parser.add_argument("-o", "--output", default="bushing.png", metavar="PICTURE")
    parser.add_argument(
        "--scale",
        type=float,
        default=1,
        metavar="S",
        help="draw the wear S times as deep as it is (default: 1)",
    )
    parser.add_argument(
        "--zoom",
        type=float,
        default=1,
        metavar="Z",
        help="enlarge Z times around the deepest wear (default: 1, the whole ring)",
    )
    parser.add_argument(
        "--cycles",
        type=float,
        nargs="+",
        metavar="N",
        help="stages to draw, the nearest that exist (default: first, middle, last)",
    )
    parser.add_argument(
        "--temperature",
        action="store_true",
        help="draw the temperature instead of the stress",
    )
    parser.add_argument(
        "--width",
        type=int,
        default=1800,
        metavar="PIXELS",
        help="width of the picture (default: 1800)",
    )
    arguments = parser.parse_args()
    if arguments.zoom <= 0 or arguments.scale < 0 or arguments.width < 300:
        parser.error("--zoom and --scale must be positive, --width at least 300")
    return arguments


def restart_in_pvpython():
    """Replaces this process by pvpython, with a virtual screen if possible."""
    pvpython = shutil.which("pvpython") or shutil.which("pvbatch")
    if pvpython is None:
        sys.exit(
            "plot_bushing: ParaView is missing: "
            "apt-get install paraview python3-paraview"
        )
    command = [pvpython, "--force-offscreen-rendering", os.path.abspath(__file__)]
    environment = dict(os.environ)
    environment[INSIDE_PVPYTHON] = "yes"
    environment.setdefault("OMPI_ALLOW_RUN_AS_ROOT", "1")
    environment.setdefault("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1")
    sys.stdout.flush()
    with virtual_screen(environment):
        sys.exit(subprocess.call(command + sys.argv[1:], env=environment))


@contextlib.contextmanager
def virtual_screen(environment):
    """A screen of our own, ready when this has begun. xvfb-run only waits for
    some seconds, which is not enough on a busy machine."""
    if not shutil.which("Xvfb"):
        if not environment.get("DISPLAY"):
            sys.exit(
                "plot_bushing: there is no display, and no virtual one either: "
                "apt-get install xvfb"
            )
        yield
        return
    reader, writer = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writer), "-screen", "0", "1280x1024x24"],
        pass_fds=[writer],
        stderr=subprocess.DEVNULL,
    )
    os.close(writer)
    try:
        # The server writes its number once it answers.
        with os.fdopen(reader) as pipe:
            number = pipe.readline().strip()
        if not number:
            sys.exit("plot_bushing: Xvfb does not start")
        environment["DISPLAY"] = ":" + number
        yield
    finally:
        server.terminate()
        server.wait()


def choose_stages(times, wanted):
    """Indices of the stages to draw; the middle one is nearest to half time."""
    if not wanted:
        wanted = [times[0], 0.5 * (times[0] + times[-1]), times[-1]]
    nearest = [min(range(len(times)), key=lambda i: abs(times[i] - t)) for t in wanted]
    return sorted(set(nearest))


class Stage:
    """What is drawn in one column. Lengths in mm, stresses in MPa."""

    def __init__(self, np, cycles, points, fields, scale, ring_field):
        wear = fields["wear_displacement"][:, :2] * 1e3
        worn = points[:, :2] * 1e3
        new = worn - wear
        radius = np.hypot(new[:, 0], new[:, 1])
        on_bore = radius < radius.min() * (1 + 2e-4)
        # Cells that meet in a point have a copy of it each.
        angle = np.arctan2(new[on_bore, 1], new[on_bore, 0]) % (2 * np.pi)
        _, first, copies = np.unique(
            np.round(angle, 6) % round(2 * np.pi, 6),
            return_index=True,
            return_inverse=True,
        )
        n_copies = np.bincount(copies)

        def mean(values):
            return np.bincount(copies, weights=values[on_bore]) / n_copies

        self.cycles = cycles
        self.shape = worn + (scale - 1) * wear
        self.new_bore = new[on_bore][first]
        self.bore = self.shape[on_bore][first]
        self.pressure = mean(fields["contact_pressure"]) * 1e-6
        self.depth = np.hypot(wear[on_bore, 0], wear[on_bore, 1])[first]
        values = ring_field.shown(fields[ring_field.name])
        self.least, self.largest = values.min(), values.max()


class RingField:
    """What the ring is coloured by: its name in the files, and how it is shown,
    unit = value times factor plus shift."""

    def __init__(self, name, label, words, unit, factor, shift, begins_at_zero):
        self.name, self.label, self.words, self.unit = name, label, words, unit
        self.factor, self.shift, self.begins_at_zero = factor, shift, begins_at_zero

    def shown(self, value):
        return value * self.factor + self.shift

    def stored(self, shown):
        return (shown - self.shift) / self.factor


STRESS = RingField(
    "von_mises_stress", "von Mises stress [MPa]", "stress ", "MPa", 1e-6, 0, True
)
TEMPERATURE = RingField(
    "temperature", "temperature [\u00b0C]", "", "\u00b0C", 1, -273.15, False
)


def read_stage(np, simple, reader, cycles, scale, file_name, ring_field):
    from vtkmodules.util.numpy_support import vtk_to_numpy

    reader.UpdatePipeline(cycles)
    data = simple.servermanager.Fetch(reader)
    while data.IsA("vtkMultiBlockDataSet"):
        data = data.GetBlock(0)
    fields = {}
    for name in ("wear_displacement", "contact_pressure", ring_field.name):
        array = data.GetPointData().GetArray(name)
        if array is None:
            sys.exit(f"plot_bushing: {file_name} has no point field '{name}'")
        fields[name] = vtk_to_numpy(array)
    points = vtk_to_numpy(data.GetPoints().GetData())
    return Stage(np, cycles, points, fields, scale, ring_field)


def set_colours(table, colours, minimum, maximum):
    """Puts a Matplotlib colour map into a table of ParaView."""
    table.AutomaticRescaleRangeMode = "Never"
    table.ColorSpace = "RGB"
    n = 64
    table.RGBPoints = [
        value
        for i in range(n)
        for value in (
            minimum + (maximum - minimum) * i / (n - 1),
            *colours(i / (n - 1))[:3],
        )
    ]
    return table


def rounded_up(value):
    """The next number of the form 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of 10."""
    import math

    if value <= 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    for factor in (1, 1.5, 2, 3, 4, 5, 6, 8, 10):
        if factor * power >= value * (1 - 1e-12):
            return factor * power
    return 10 * power


def draw(arguments):
    pvd = os.path.join(arguments.output_dir, arguments.joint, "bushing.pvd")
    try:
        import numpy as np
        import matplotlib

        matplotlib.use("Agg")
        from matplotlib import pyplot
        from matplotlib.collections import PolyCollection
        from matplotlib.ticker import MaxNLocator
    except ImportError as error:
        sys.exit(f"plot_bushing: {error}: apt-get install python3-matplotlib")
    try:
        from paraview import simple
    except ImportError as error:
        sys.exit(f"plot_bushing: {error}: apt-get install python3-paraview")
    simple._DisableFirstRenderCameraReset()
    ring_field = TEMPERATURE if arguments.temperature else STRESS

    reader = simple.PVDReader(FileName=os.path.abspath(pvd))
    reader.UpdatePipelineInformation()
    times = list(reader.TimestepValues)
    if not times:
        sys.exit(f"plot_bushing: {pvd} lists no stages")
    stages = [
        read_stage(np, simple, reader, times[i], arguments.scale, pvd, ring_field)
        for i in choose_stages(times, arguments.cycles)
    ]

    # The same window in all panels, square, in mm.
    last = stages[-1]
    extent = max(np.abs(stage.shape).max() for stage in stages) * 1.03
    centre = np.zeros(2)
    half = extent / arguments.zoom
    if arguments.zoom > 1:
        deepest = np.argmax(last.depth if last.depth.max() > 0 else last.pressure)
        # The window does not leave the ring behind it.
        centre = np.clip(last.bore[deepest], half - extent, extent - half)
    window = (centre[0] - half, centre[0] + half, centre[1] - half, centre[1] + half)

    least = 0 if ring_field.begins_at_zero else min(stage.least for stage in stages)
    largest = max(stage.largest for stage in stages)
    if ring_field.begins_at_zero:
        largest = rounded_up(largest)
    max_pressure = rounded_up(max(stage.pressure.max() for stage in stages))
    ring_colours = matplotlib.colormaps["inferno" if arguments.temperature else "viridis"]
    pressure_colours = matplotlib.colormaps["YlOrRd"]

    n = len(stages)
    dpi = 200
    width = arguments.width / dpi
    left, right, top, bottom, gap, row_gap = 0.55, 0.75, 0.80, 0.42, 0.10, 0.28  # inches
    panel = (width - left - right - (n - 1) * gap) / n
    if panel < 0.5:
        sys.exit("plot_bushing: the picture is too narrow for so many stages")
    height = top + bottom + 2 * panel + row_gap
    figure = pyplot.figure(figsize=(width, height), dpi=dpi)
    pixels = max(2 * int(panel * dpi), 600)

    warp = simple.WarpByVector(Input=reader)
    warp.Vectors = ["POINTS", "wear_displacement"]
    warp.ScaleFactor = arguments.scale - 1
    view = simple.CreateView("RenderView")
    view.ViewSize = [pixels, pixels]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.CameraParallelProjection = 1
    view.CameraPosition = [1e-3 * centre[0], 1e-3 * centre[1], 1]
    view.CameraFocalPoint = [1e-3 * centre[0], 1e-3 * centre[1], 0]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelScale = 1e-3 * half
    ring = simple.Show(warp, view)
    ring.NonlinearSubdivisionLevel = 3
    ring.Ambient, ring.Diffuse, ring.Specular = 1, 0, 0
    ring_table = simple.GetColorTransferFunction(ring_field.name)

    def render(file_name):
        simple.SaveScreenshot(file_name, view, ImageResolution=[pixels, pixels])
        return pyplot.imread(file_name)

    def add_panel(row, column, image):
        axes = figure.add_axes(
            (
                (left + column * (panel + gap)) / width,
                (bottom + (1 - row) * (panel + row_gap)) / height,
                panel / width,
                panel / height,
            )
        )
        axes.imshow(image, extent=window, interpolation="antialiased")
        closed = np.vstack([stages[column].new_bore, stages[column].new_bore[:1]])
        axes.plot(*closed.T, color="black", linewidth=0.5, linestyle=(0, (6, 3)))
        axes.set_xlim(window[:2])
        axes.set_ylim(window[2:])
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(MaxNLocator(7, steps=[1, 2, 5, 10]))
        axes.tick_params(labelsize=6, length=2, width=0.5, direction="in")
        for spine in axes.spines.values():
            spine.set(linewidth=0.5, color="0.6")
        if row == 0:
            axes.set_xticklabels([])
        else:
            axes.set_xlabel("x [mm]", fontsize=7, labelpad=2)
        if column == 0:
            axes.set_ylabel("y [mm]", fontsize=7, labelpad=2)
        else:
            axes.set_yticklabels([])
        return axes

    def add_note(axes, text):
        axes.annotate(
            text,
            (0.5, 1),
            (0, 3),
            xycoords="axes fraction",
            textcoords="offset points",
            ha="center",
            fontsize=7,
        )

    def add_band(axes, inner, outer, keep, colours):
        """Fills between two closed lines, where keep says so."""
        corners = [inner, np.roll(inner, -1, 0), np.roll(outer, -1, 0), outer]
        axes.add_collection(
            PolyCollection(
                np.stack(corners, axis=1)[keep],
                facecolors=colours,
                edgecolors=colours,
                linewidths=0.2,
            )
        )

    with tempfile.TemporaryDirectory() as directory:
        image_file = os.path.join(directory, "panel.png")
        for column, stage in enumerate(stages):
            view.ViewTime = stage.cycles
            simple.ColorBy(ring, ("POINTS", ring_field.name))
            set_colours(
                ring_table,
                ring_colours,
                ring_field.stored(least),
                ring_field.stored(largest),
            )
            ring.SetScalarBarVisibility(view, False)
            ring.SetRepresentationType("Surface")
            axes = add_panel(0, column, render(image_file))
            axes.set_title(
                f"{stage.cycles:,.0f} cycles".replace(",", "\u2009"), fontsize=9, pad=14
            )
            worn_away = stage.depth + np.roll(stage.depth, -1) > 0
            add_band(axes, stage.new_bore, stage.bore, worn_away, "#d9303a")
            depth = stage.depth.max()
            wear = f"wear {depth:.3g} mm" if depth > 0 else "no wear"
            add_note(
                axes,
                f"{wear}, {ring_field.words}up to {stage.largest:.3g} {ring_field.unit}",
            )

            simple.ColorBy(ring, None)
            ring.SetRepresentationType("Surface With Edges")
            ring.AmbientColor = ring.DiffuseColor = [0.93, 0.94, 0.95]
            ring.EdgeColor = [0.74, 0.77, 0.80]
            axes = add_panel(1, column, render(image_file))
            # Ordinates of the pressure point from the bore to its centre.
            radius = np.hypot(*stage.new_bore.T).min()
            tallest = 0.45 * min(radius, 2 * half)
            inward = -stage.new_bore / np.hypot(*stage.new_bore.T)[:, None]
            tips = stage.bore + inward * (tallest * stage.pressure / max_pressure)[:, None]
            loaded = 0.5 * (stage.pressure + np.roll(stage.pressure, -1))
            keep = loaded > 0
            colours = pressure_colours(loaded[keep] / max_pressure)
            add_band(axes, stage.bore, tips, keep, colours)
            outline = np.vstack([tips, tips[:1]])
            outline[np.append(~(keep | np.roll(keep, 1)), False)] = np.nan
            axes.plot(*outline.T, color="0.25", linewidth=0.5)
            add_note(axes, f"pressure up to {stage.pressure.max():.3g} MPa")

    for row, (colours, minimum, maximum, label) in enumerate(
        (
            (ring_colours, least, largest, ring_field.label),
            (pressure_colours, 0, max_pressure, "contact pressure [MPa]"),
        )
    ):
        bar_axes = figure.add_axes(
            (
                (width - right + 0.12) / width,
                (bottom + (1 - row) * (panel + row_gap) + 0.08 * panel) / height,
                0.13 / width,
                0.84 * panel / height,
            )
        )
        bar = figure.colorbar(
            matplotlib.cm.ScalarMappable(
                matplotlib.colors.Normalize(minimum, maximum), cmap=colours
            ),
            cax=bar_axes,
        )
        bar.set_label(label, fontsize=8)
        bar.ax.tick_params(labelsize=7, length=2, width=0.5)
        bar.outline.set_linewidth(0.5)

    title = f"Wear of the bushing of {arguments.joint.replace('_', ' ')}"
    if arguments.scale != 1:
        title += f" (wear drawn {arguments.scale:g} times as deep)"
    figure.text(
        left / width, 1 - 0.12 / height, title, fontsize=10, va="top", weight="bold"
    )
    figure.text(
        1 - 0.1 / width,
        1 - 0.14 / height,
        "red: worn away   dashed: bore as manufactured",
        fontsize=7,
        va="top",
        ha="right",
    )
    try:
        figure.savefig(arguments.output, dpi=dpi)
    except (OSError, ValueError) as error:
        sys.exit(f"plot_bushing: cannot write {arguments.output}: {error}")
    print(f"Wrote {arguments.output}")


def main():
    arguments = parse_arguments()
    pvd = os.path.join(arguments.output_dir, arguments.joint, "bushing.pvd")
    if not os.path.isfile(pvd):
        sys.exit(
            f"plot_bushing: there is no {pvd}; OUTPUT_DIR is what a run has "
            "written, JOINT the name of a worn joint"
        )
    directory = os.path.dirname(os.path.abspath(arguments.output))
    if not os.path.isdir(directory):
        sys.exit(f"plot_bushing: there is no directory {directory} to write to")
    if not os.environ.get(INSIDE_PVPYTHON):
        restart_in_pvpython()
    draw(arguments)


if __name__ == "__main__":
    main()
