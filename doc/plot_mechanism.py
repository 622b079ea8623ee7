#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws a mechanism at some moments of its recorded cycle.

    doc/plot_mechanism.py OUTPUT_DIR -o picture.png

reads OUTPUT_DIR/mechanism.pvd and writes one PNG: the mechanism at --frames
equal times of the cycle, side by side, coloured by body, with the joint forces
as arrows (of the first body, with the pin, on the second). --force is the
length of an arrow in metres per newton; --no-springs leaves springs out.

ParaView draws the pictures, Matplotlib puts them side by side:
    apt-get install paraview python3-paraview python3-matplotlib xvfb
Run it as
    xvfb-run -a pvpython --force-offscreen-rendering doc/plot_mechanism.py ...
"""

import argparse
import os
import tempfile

# Numbers of the parts in the field `part`, see mechanism/legend.txt.
SPRING = 4


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("output_dir", metavar="OUTPUT_DIR")
    parser.add_argument("-o", "--output", default="mechanism.png", metavar="PICTURE")
    parser.add_argument("--frames", type=int, default=4, metavar="N")
    parser.add_argument("--force", type=float, default=0.0, metavar="M/N")
    parser.add_argument("--no-springs", action="store_true")
    return parser.parse_args()


def union(a, b):
    return [
        min(a[i], b[i]) if i % 2 == 0 else max(a[i], b[i]) for i in range(len(a))
    ]


def render(arguments, directory):
    """Writes the frames; returns their files and times."""
    from paraview import simple

    source = simple.PVDReader(
        FileName=os.path.join(arguments.output_dir, "mechanism.pvd")
    )
    shown = source
    if arguments.no_springs:
        shown = simple.Threshold(Input=source, Scalars=["POINTS", "part"])
        shown.ThresholdMethod = "Between"
        shown.LowerThreshold = SPRING - 0.5
        shown.UpperThreshold = SPRING + 0.5
        shown.Invert = 1
    times = list(source.TimestepValues)
    stride = max(1, len(times) // arguments.frames)
    times = times[::stride][: arguments.frames]

    view = simple.CreateRenderView()
    view.ViewSize = [900, 500]
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    bounds, force = None, 0.0
    for time in times:
        shown.UpdatePipeline(time)
        information = shown.GetDataInformation()
        bounds = union(bounds or information.GetBounds(), information.GetBounds())
        force = max(force, shown.PointData["force"].GetRange(-1)[1])
    width = bounds[1] - bounds[0]

    lines = simple.Show(shown, view)
    simple.ColorBy(lines, ("POINTS", "body"))
    lines.LineWidth = 6
    simple.GetColorTransferFunction("body").ApplyPreset("Viridis (matplotlib)", True)
    lines.SetScalarBarVisibility(view, False)
    arrows = simple.Glyph(Input=shown, GlyphType="Arrow")
    arrows.OrientationArray = ["POINTS", "force"]
    arrows.ScaleArray = ["POINTS", "force"]
    arrows.ScaleFactor = arguments.force or 0.15 * width / max(force, 1e-300)
    arrows.GlyphMode = "All Points"
    arrow_display = simple.Show(arrows, view)
    simple.ColorBy(arrow_display, None)
    arrow_display.DiffuseColor = [0.8, 0.1, 0.1]

    files = []
    for number, time in enumerate(times):
        view.ViewTime = time
        centre = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2]
        view.CameraFocalPoint = centre + [0]
        view.CameraPosition = centre + [width]
        view.CameraParallelScale = max(
            0.62 * (bounds[3] - bounds[2]), 0.38 * width
        )
        files.append(os.path.join(directory, f"frame_{number}.png"))
        simple.SaveScreenshot(files[-1], view)
    return files, [time - times[0] for time in times]


def main():
    arguments = parse_arguments()
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    with tempfile.TemporaryDirectory() as directory:
        files, times = render(arguments, directory)
        columns = 2 if len(files) > 1 else 1
        rows = (len(files) + columns - 1) // columns
        figure, axes = plt.subplots(
            rows, columns, figsize=(4.5 * columns, 2.6 * rows), squeeze=False
        )
        for ax in axes.flat:
            ax.axis("off")
        for ax, name, time in zip(axes.flat, files, times):
            ax.imshow(plt.imread(name))
            ax.set_title(f"{time:.3g} s", fontsize=9)
        figure.tight_layout(pad=0.3)
        figure.savefig(arguments.output, dpi=110)


if __name__ == "__main__":
    main()
