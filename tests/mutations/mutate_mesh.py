#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run the program on mutated mesh files; what it must not do is in judge.py.

    mutate_mesh.py PROGRAM [--count N] [--first SEED] ...

The mesh is that of tests/app/mesh_file.prm in format 2, or the same ring in format
4.1, each with and without refinements. A mutation changes bytes, lines, tokens,
node numbers or coordinates, one to three times.
"""

import math
import pathlib
import random
import sys

import judge

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

CASE = """include {quickstart}
set Cycles = 1
subsection Bushing crank_pin
  set Outer support                = elastic foundation
  set Foundation normal stiffness  = 1e14 N/m^3
  subsection Mesh
    set File                = ring.msh
    set File length unit    = 1 mm
    set File refinements    = {refinements}
    set Sector refinements  = {sector}
    set Refined sector      = 60 deg, 300 deg
  end
end
"""

# What a token may become.
ODD = ["0", "-1", "1", "2", "3", "15", "99999", "4294967295", "4294967296",
       "9223372036854775807", "-9223372036854775808", "1e308", "-1e308", "1e-320",
       "nan", "inf", "-inf", "1e999", "0x10", "1,5", "", "$Nodes", "$EndNodes",
       "$Elements", "$", "%s%n", "\x1b[31m", "\u00b5", "'", "1 2", "\x00"]


def ring_in_format_4():
    """The ring of tests/app/ring.msh, 24 by 2 cells, as Gmsh 4 writes it."""
    radii = [9.535, 12.705, 15.875]
    around = 24
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$Entities", "0 2 1 0",
             "1 -9.535 -9.535 0 9.535 9.535 0 1 1 0",
             "2 -15.875 -15.875 0 15.875 15.875 0 1 2 0",
             "1 -15.875 -15.875 0 15.875 15.875 0 1 3 2 1 2", "$EndEntities",
             "$Nodes", f"3 {3 * around} 1 {3 * around}"]
    for k, (dimension, entity) in enumerate([(1, 1), (2, 1), (1, 2)]):
        lines.append(f"{dimension} {entity} 0 {around}")
        lines += [str(k * around + i + 1) for i in range(around)]
        for i in range(around):
            angle = 2 * math.pi * i / around
            lines.append(f"{radii[k] * math.cos(angle):.12g} "
                         f"{radii[k] * math.sin(angle):.12g} 0")
    lines += ["$EndNodes", "$Elements", f"3 {4 * around} 1 {4 * around}"]
    element = 0

    def node(k, i):
        return k * around + i % around + 1

    for entity, k in [(1, 0), (2, 2)]:
        lines.append(f"1 {entity} 1 {around}")
        for i in range(around):
            element += 1
            lines.append(f"{element} {node(k, i)} {node(k, i + 1)}")
    lines.append(f"2 1 3 {2 * around}")
    for k in range(2):
        for i in range(around):
            element += 1
            lines.append(f"{element} {node(k, i)} {node(k + 1, i)} "
                         f"{node(k + 1, i + 1)} {node(k, i + 1)}")
    return "\n".join(lines + ["$EndElements", ""])


def sections(lines):
    """Numbers of the lines of nodes and of elements, without counts."""
    nodes = range(lines.index("$Nodes") + 2, lines.index("$EndNodes"))
    elements = range(lines.index("$Elements") + 2, lines.index("$EndElements"))
    return nodes, elements


def change_bytes(random_, text, _lines):
    """Some bytes anywhere become others, go, or come."""
    data = bytearray(text.encode())
    for _ in range(random_.choice([1, 1, 3, 20])):
        at = random_.randrange(len(data))
        kind = random_.randrange(3)
        if kind == 0:
            data[at] = random_.randrange(256)
        elif kind == 1:
            del data[at]
        else:
            data.insert(at, random_.randrange(256))
    return data.decode("latin-1"), "bytes"


def cut(random_, text, _lines):
    """The file ends early."""
    return text[: random_.randrange(len(text))], "cut"


def change_lines(random_, _text, lines):
    """A line goes, comes twice, or swaps with another."""
    lines = list(lines)
    a, b = random_.randrange(len(lines)), random_.randrange(len(lines))
    kind = random_.choice(["removed", "twice", "swapped"])
    if kind == "removed":
        del lines[a]
    elif kind == "twice":
        lines.insert(b, lines[a])
    else:
        lines[a], lines[b] = lines[b], lines[a]
    return "\n".join(lines), f"line {a + 1} {kind}"


def change_token(random_, _text, lines):
    """A token anywhere becomes something odd."""
    lines = list(lines)
    at = random_.randrange(len(lines))
    words = lines[at].split(" ")
    which = random_.randrange(len(words))
    words[which] = random_.choice(ODD)
    lines[at] = " ".join(words)
    return "\n".join(lines), f"line {at + 1}: token {which + 1} is {words[which]!r}"


def change_node_number(random_, _text, lines):
    """An element gets another node, or two of them swap."""
    lines = list(lines)
    at = random_.choice(sections(lines)[1])
    words = lines[at].split(" ")
    a, b = random_.randrange(len(words)), random_.randrange(len(words))
    if random_.random() < 0.5:
        words[-1 - a % 4 % len(words)] = str(random_.randint(0, 75))
    else:
        words[a], words[b] = words[b], words[a]
    lines[at] = " ".join(words)
    return "\n".join(lines), f"line {at + 1}: '{lines[at]}'"


def change_coordinates(random_, _text, lines):
    """A node moves: a little, far, onto an axis, onto another node."""
    lines = list(lines)
    places = [n for n in sections(lines)[0] if len(lines[n].split(" ")) >= 3]
    at, other = random_.choice(places), random_.choice(places)
    words, others = lines[at].split(" "), lines[other].split(" ")
    kind = random_.choice(["scaled", "shifted", "zero", "moved", "odd"])
    axis = random_.choice([-3, -2, -2, -3, -1])
    try:
        value = float(words[axis])
    except ValueError:
        value = 0.
    if kind == "scaled":
        words[axis] = repr(value * random_.choice([-1, 0.5, 2, 1.001, 1e6, 1e-9]))
    elif kind == "shifted":
        words[axis] = repr(value + random_.choice([1e-12, 1e-6, 1e-3, 0.5, -5, 40]))
    elif kind == "zero":
        words[axis] = "0"
    elif kind == "moved":
        words[-3:] = others[-3:]
    else:
        words[axis] = random_.choice(ODD)
    lines[at] = " ".join(words)
    return "\n".join(lines), f"line {at + 1} {kind}"


def change_elements(random_, _text, lines):
    """An element goes, comes twice, or becomes one of another type."""
    lines = list(lines)
    elements = sections(lines)[1]
    at = random_.choice(elements)
    kind = random_.choice(["removed", "twice", "type"])
    count = lines.index("$Elements") + 1
    words = lines[count].split(" ")
    if kind == "type":
        parts = lines[at].split(" ")
        parts[1 % len(parts)] = str(random_.randint(0, 20))
        lines[at] = " ".join(parts)
    elif kind == "removed":
        del lines[at]
        words[0] = str(int(words[0]) - 1)
    else:
        lines.insert(at, lines[random_.choice(elements)])
        words[0] = str(int(words[0]) + 1)
    # In format 4 the counts are elsewhere, and no longer right.
    if len(words) == 1:
        lines[count] = words[0]
    return "\n".join(lines), f"element of line {at + 1} {kind}"


def nothing(_random, text, _lines):
    """The mesh as it is, which must be accepted."""
    return text, "nothing"


KINDS = [change_bytes, cut, change_lines, change_token, change_token,
         change_node_number, change_node_number, change_coordinates,
         change_coordinates, change_coordinates, change_elements]


def make_case(seed, directory):
    """See judge.py."""
    random_ = random.Random(seed)
    text = (ring_in_format_4() if seed % 3 == 2 else
            (ROOT / "tests" / "app" / "ring.msh").read_text())
    said = []
    kinds = [random_.choice(KINDS) for _ in range(random_.choice([1, 1, 1, 2, 3]))]
    # The first three show that the meshes are good ones.
    for kind in kinds if seed >= 3 else [nothing]:
        try:
            text, what = kind(random_, text, text.split("\n"))
        except (ValueError, IndexError):
            # What is left of the file has no such place.
            continue
        said.append(what)
    (directory / "ring.msh").write_bytes(text.encode("latin-1", "replace"))
    (directory / "case.prm").write_text(CASE.format(
        quickstart=ROOT / "prm" / "quickstart.prm",
        refinements=random_.choice([0, 1]), sector=random_.choice([0, 1])))
    return "case.prm", "; ".join(said)


if __name__ == "__main__":
    sys.exit(judge.main(__doc__.split("\n", maxsplit=1)[0], make_case))
