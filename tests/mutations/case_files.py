# SPDX-License-Identifier: LGPL-2.1-or-later

"""Parameter files with all that they include, as lines that can be changed."""

import os
import random
import re

from entries import kind_of

SET = re.compile(r"(\s*set\s+)([^=]*?)(\s*=\s*)(.*)", re.DOTALL | re.IGNORECASE)
SUBSECTION = re.compile(r"\s*subsection\s+(.*?)\s*", re.IGNORECASE)
END = re.compile(r"\s*end\s*", re.IGNORECASE)
INCLUDE = re.compile(r"\s*include\s+(.*?)\s*", re.IGNORECASE)


class NotUnderstood(Exception):
    """A file breaks the syntax."""


def read_text(path):
    with open(path, encoding="utf-8", errors="surrogateescape", newline="\n") as file:
        return file.read()


def logical_lines(text):
    """Lines without comments and surplus blanks, those that go on joined."""
    joined = ""
    for line in text.split("\n"):
        line = line.split("#")[0].replace("\t", " ").rstrip(" \f\v\r")
        if line.endswith("\\"):
            joined += line[:-1]
            continue
        yield re.sub(" +", " ", (joined + line).strip(" \f\v\r"))
        joined = ""
    yield re.sub(" +", " ", joined.strip())


def read_assignments(path, depth=0, opened=()):
    """Yields (subsections, name, value, directory) in order, includes followed.

    Raises NotUnderstood where the program must refuse the file.
    """
    if depth > 20 or not os.path.isfile(path):
        raise NotUnderstood(f"{path} cannot be included")
    subsections = list(opened)
    directory = os.path.dirname(path)
    for line in logical_lines(read_text(path)):
        assignment, begin, include = (
            pattern.fullmatch(line) for pattern in (SET, SUBSECTION, INCLUDE)
        )
        if assignment:
            yield (
                tuple(subsections),
                assignment.group(2).strip(),
                assignment.group(4).strip(),
                directory,
            )
        elif begin:
            subsections.append(begin.group(1))
        elif END.fullmatch(line):
            if len(subsections) == len(opened):
                raise NotUnderstood(f"{path}: 'end' without 'subsection'")
            subsections.pop()
        elif include:
            included = os.path.join(directory, include.group(1))
            yield from read_assignments(included, depth + 1, subsections)
        elif line:
            raise NotUnderstood(f"{path}: '{line[:60]}'")
    if len(subsections) != len(opened):
        raise NotUnderstood(f"{path} ends in a subsection")


class Case:
    """The files of one case: lines of parameter files, meshes as they are."""

    def __init__(self, main):
        self.main = main
        self.lines = {}
        self.others = {}

    def copy(self):
        copy = Case(self.main)
        copy.lines = {path: list(lines) for path, lines in self.lines.items()}
        copy.others = dict(self.others)
        return copy

    def entries(self):
        """(file, number of the line, subsections, name, value, kind) of each entry."""
        found = []
        for path, lines in self.lines.items():
            opened = []
            for number, line in enumerate(lines):
                code = line.split("#")[0]
                assignment = SET.fullmatch(code)
                begin = SUBSECTION.fullmatch(code)
                if assignment:
                    name, value = assignment.group(2), assignment.group(4).strip()
                    kind = kind_of(opened, name)
                    found.append((path, number, tuple(opened), name, value, kind))
                elif begin:
                    opened.append(begin.group(1))
                elif END.fullmatch(code) and opened:
                    opened.pop()
        return found

    def blocks(self):
        """(file, first line, last line) of each subsection that is closed."""
        found = []
        for path, lines in self.lines.items():
            begins = []
            for number, line in enumerate(lines):
                code = line.split("#")[0]
                if SUBSECTION.fullmatch(code):
                    begins.append(number)
                elif END.fullmatch(code) and begins:
                    found.append((path, begins.pop(), number))
        return found

    def set_value(self, entry, value):
        path, number = entry[:2]
        code = self.lines[path][number].split("#")[0]
        head = SET.fullmatch(code)
        self.lines[path][number] = "".join(head.group(1, 2, 3)) + value

    def write(self, directory):
        for path, lines in self.lines.items():
            full = os.path.join(directory, path)
            os.makedirs(os.path.dirname(full), exist_ok=True)
            with open(
                full, "w", encoding="utf-8", errors="surrogateescape", newline=""
            ) as file:
                file.write("\n".join(lines) + "\n")
        for path, content in self.others.items():
            with open(os.path.join(directory, path), "wb") as file:
                file.write(content)


def add_files(case, root, path):
    """The file, what it includes and the meshes that it names."""
    case.lines[path] = read_text(os.path.join(root, path)).rstrip("\n").split("\n")
    directory = os.path.dirname(path)
    for line in list(case.lines[path]):
        include = INCLUDE.fullmatch(line.split("#")[0])
        assignment = SET.fullmatch(line.split("#")[0])
        if include:
            included = os.path.normpath(os.path.join(directory, include.group(1)))
            if included not in case.lines:
                add_files(case, root, included)
        elif assignment and assignment.group(2) == "File":
            mesh = os.path.join(directory, assignment.group(4).strip())
            with open(os.path.join(root, mesh), "rb") as file:
                case.others[mesh] = file.read()


def read_case(root, path):
    """The case of a file below root, with paths as they are there."""
    case = Case(path)
    add_files(case, root, path)
    return case


def write_level(values, lines, depth):
    """A tree of subsections as lines."""
    blanks = "  " * depth
    for name, value in values.items():
        if isinstance(value, dict):
            lines.append(f"{blanks}subsection {name}")
            write_level(value, lines, depth + 1)
            lines.append(f"{blanks}end")
        else:
            lines.append(f"{blanks}set {name} = {value}")


def flatten(root, path, settings=()):
    """The same in one file, each entry once; settings: ((path, value), ...) more."""
    case = Case("case.prm")
    tree = {}
    for subsections, name, value, directory in read_assignments(
        os.path.join(root, path)
    ):
        level = tree
        for subsection in subsections:
            level = level.setdefault(subsection, {})
        level[name] = value
        if name == "File":
            with open(os.path.join(directory, value), "rb") as file:
                case.others[value] = file.read()
    bushings = [name.strip() for name in tree.get("Bushings", "").split(",") if name]
    for place, value in settings:
        for bushing in bushings if "BUSHING" in place else [""]:
            level = tree
            *subsections, name = place.replace("BUSHING", bushing).split("/")
            for subsection in subsections:
                level = level.setdefault(subsection, {})
            level[name] = value(level.get(name)) if callable(value) else value
    case.lines["case.prm"] = []
    write_level(tree, case.lines["case.prm"], 0)
    return case


def choose(rng: random.Random, entries, kinds):
    """One of the entries of these kinds (a predicate), None if there is none."""
    fitting = [entry for entry in entries if entry[5] and kinds(entry[5])]
    return rng.choice(fitting) if fitting else None
