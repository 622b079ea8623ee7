# SPDX-License-Identifier: LGPL-2.1-or-later

"""The contact of compare in CalculiX (calculix-ccx): a full ring and the rigid
surface of a pin, one layer of C3D20R each, in plane strain by no displacement
along the axis, and surface-to-surface penalty contact. The pin is moved to where
it belongs, which spares CalculiX the iteration for the force."""

import os
import resource
import subprocess
import tempfile

import numpy as np

# Of the penalty, over modulus by wall thickness. Stiffer scatters the pressure,
# softer lets the surfaces penetrate.
PENALTY = 5e4

# Nodes of C3D20 in half cells along r, around, and along the axis.
CORNERS = [(0, 0), (2, 0), (2, 2), (0, 2)]
SIDES = [(1, 0), (2, 1), (1, 2), (0, 1)]
CELL = (
    [(*c, 0) for c in CORNERS]
    + [(*c, 2) for c in CORNERS]
    + [(*c, 0) for c in SIDES]
    + [(*c, 2) for c in SIDES]
    + [(*c, 1) for c in CORNERS]
)


class Deck:
    """An input file in N, mm, and s."""

    def __init__(self, cells):
        self.cells, self.nodes, self.elements, self.sections = cells, [], 0, []

    def add_ring(self, name, radii):
        """Cells between the @p radii [m]; returns the numbers of the nodes."""
        radii = 1e3 * np.insert(radii, range(1, len(radii)), (radii[1:] + radii[:-1]) / 2)
        height = np.pi * radii[0] / self.cells
        numbers = {}
        for i in range(2 * self.cells):
            angle = np.pi * i / self.cells
            for j, r in enumerate(radii):
                for k in range(3):
                    if i % 2 + j % 2 + k % 2 < 2:
                        x = r * np.cos(angle), r * np.sin(angle), height * k
                        self.nodes.append("".join(f",{v:.11g}" for v in x))
                        numbers[i, j, k] = len(self.nodes)
        lines = [f"*ELEMENT,TYPE=C3D20R,ELSET={name}"]
        for i in range(self.cells):
            for j in range(0, len(radii) - 1, 2):
                self.elements += 1
                cell = [
                    str(numbers[(2 * i + b) % (2 * self.cells), j + a, k])
                    for a, b, k in CELL
                ]
                lines.append(f"{self.elements}," + ",".join(cell[:10]) + ",")
                lines.append(",".join(cell[10:]))
        self.sections += lines + [f"*SOLID SECTION,ELSET={name},MATERIAL=M"]
        return numbers

    def add_set(self, name, numbers):
        self.sections += [f"*NSET,NSET={name}"] + [str(number) for number in numbers]

    def add_surface(self, name, first, stride, face):
        self.sections.append(f"*SURFACE,NAME={name}")
        self.sections += [f"{first + i * stride},{face}" for i in range(self.cells)]


def write_deck(name, cells, radii, pin, modulus, poisson, centre):
    deck = Deck(cells)
    layers = len(radii) - 1
    bushing = deck.add_ring("BUSHING", radii)
    shaft = deck.add_ring("SHAFT", np.array([0.95 * pin, pin]))
    deck.add_set("BUSHING", bushing.values())
    deck.add_set("SHAFT", shaft.values())
    deck.add_set("RIM", [v for (_, j, _), v in bushing.items() if j == 2 * layers])
    deck.add_set("TOP", [bushing[0, 0, 0]])
    deck.add_surface("BORE", 1, layers, "S6")
    deck.add_surface("PIN", layers * cells + 1, 1, "S4")
    penalty = PENALTY * modulus / (radii[-1] - radii[0])
    lines = ["*NODE"]
    lines += [f"{i + 1}{node}" for i, node in enumerate(deck.nodes)]
    lines += ["*MATERIAL,NAME=M", "*ELASTIC", f"{1e-6 * modulus},{poisson}"]
    lines += deck.sections
    lines += ["*SURFACE INTERACTION,NAME=I"]
    lines += ["*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR", f"{1e-9 * penalty:.6g}"]
    lines += ["*CONTACT PAIR,INTERACTION=I,TYPE=SURFACE TO SURFACE", "BORE,PIN"]
    lines += ["*BOUNDARY", "RIM,1,3", "BUSHING,3,3", "SHAFT,3,3"]
    lines += ["*STEP,INC=100", "*STATIC", "1.,1.", "*BOUNDARY"]
    lines += [f"SHAFT,{i + 1},{i + 1},{1e3 * centre[i]:.11g}" for i in range(2)]
    lines += ["*NODE FILE,NSET=TOP", "U", "*EL FILE,NSET=TOP", "S", "*END STEP"]
    with open(name, "w") as file:
        file.write("\n".join(lines) + "\n")


def peak_of(name):
    """-sigma_xx [MPa] of the only node of the result file."""
    block = ""
    with open(name) as file:
        for line in file:
            if line.startswith(" -4"):
                block = line.split()[1]
            elif line.startswith(" -1") and block == "STRESS":
                return -float(line[13:25])
    raise RuntimeError(f"{name} has no stress")


def measure(radii, cells, pin, modulus, poisson, centre):
    """Processor time of a whole run on one core [s], peak pressure [MPa] at the
    node on the x axis, to which the pin must have moved."""
    with tempfile.TemporaryDirectory() as directory:
        deck = os.path.join(directory, "deck.inp")
        write_deck(deck, cells, radii, pin, modulus, poisson, centre)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(
            ["ccx", "deck"],
            cwd=directory,
            check=True,
            stdout=subprocess.DEVNULL,
            env={**os.environ, "OMP_NUM_THREADS": "1"},
        )
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
        return seconds, peak_of(os.path.join(directory, "deck.frd"))
