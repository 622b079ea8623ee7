# SPDX-License-Identifier: LGPL-2.1-or-later

"""The folders include only what the architecture allows.

Checked are the #include lines of include/tribody/<folder>/ and
source/<folder>/, the DEPENDS of source/<folder>/CMakeLists.txt, that headers do
not include each other in a circle, the include guards, and how many lines a
folder has. Tests and benchmarks may include anything.

Usage: check_includes.py ROOT
"""

import os
import re
import sys

from offences import Offences, find_files, read_lines

# What each folder of include/tribody and source may include beside itself, from
# the bottom up. A part that must call another one declares a small interface or
# takes a function; who uses both supplies it.
ALLOWED = {
    "base": set(),
    "material": {"base"},
    "tables": {"base"},
    "algebra": {"base"},
    "sundials": {"algebra", "base"},
    "surface": {"base"},
    "multibody/elements": {"tables", "algebra", "base"},
    "multibody/joints": {
        "multibody/elements",
        "surface",
        "tables",
        "algebra",
        "material",
        "base",
    },
    "gmsh": {"base"},
    "elasticity": {"gmsh", "surface", "algebra", "material", "base"},
    "thermal": {"surface", "material", "base"},
    "geometry": {"surface", "algebra", "base"},
    "contact": {"surface", "algebra", "base"},
    "wear": {"sundials", "surface", "algebra", "tables", "base"},
    "output": {"surface", "algebra", "base"},
}
ALLOWED["multibody/system"] = ALLOWED["multibody/joints"] | {"multibody/joints"}
ALLOWED["multibody/assembly"] = ALLOWED["multibody/system"] | {"multibody/system"}
ALLOWED["multibody/motion"] = ALLOWED["multibody/system"] | {
    "multibody/system",
    "sundials",
}
ALLOWED["multibody/following"] = ALLOWED["multibody/system"] | {"multibody/system"}
ALLOWED["multibody/play"] = ALLOWED["multibody/system"] | {"multibody/system"}
ALLOWED["multibody/cycle"] = ALLOWED["multibody/motion"] | {
    "multibody/assembly",
    "multibody/motion",
    "multibody/following",
    "multibody/play",
}
BELOW_BUSHING = set(ALLOWED)
ALLOWED["bushing"] = {
    "multibody/joints",
    "multibody/cycle",  # duty cycles, not how they come about
    "elasticity",
    "thermal",
    "geometry",
    "contact",
    "wear",
    "output",
    "surface",
    "algebra",
    "tables",
    "material",
    "base",
}
ALLOWED["stepping"] = {"bushing", "multibody/cycle", "thermal", "wear", "base"}
ALLOWED["case"] = {
    "bushing",
    "stepping",
    "multibody/elements",
    "multibody/joints",
    "multibody/system",
    "multibody/assembly",
    "multibody/motion",
    "multibody/cycle",
    "tables",
    "material",
    "base",
}
ALLOWED["results"] = BELOW_BUSHING | {"bushing", "stepping", "case"}
ALLOWED["run"] = set(ALLOWED)

# Lines of a folder, headers and sources together: what more than a warning says
# has become two things.
MANY_LINES, TOO_MANY_LINES = 2000, 3500

# Headers that the build writes; they belong to the module that includes them.
GENERATED = {"tribody_version.h"}

INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')


def may_include(module):
    return ", ".join([module] + sorted(ALLOWED[module]))


def module_of(root, path):
    """Folder of a file, "main" for source/main.cc, None if it is in none."""
    parts = os.path.relpath(path, root).split(os.sep)
    if parts == ["source", "main.cc"]:
        return "main"
    inside = parts[2:] if parts[:2] == ["include", "tribody"] else parts[1:]
    folder = "/".join(inside[:-1])
    return folder if folder in ALLOWED else None


def included_header(root, path, bracket, name):
    """Path of the project's header that a line includes, None if not ours."""
    if name in GENERATED:
        return None
    if name.startswith("tribody/"):
        return os.path.join(root, "include", name)
    if bracket == '"':
        return os.path.normpath(os.path.join(os.path.dirname(path), name))
    return None


def check_includes(root, path, module, offences):
    """Returns the project's headers that a file includes: (line, path)."""
    found = []
    for number, line in enumerate(read_lines(path), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        header = included_header(root, path, *match.groups())
        if header is None:
            continue
        if not os.path.exists(header):
            offences.add(
                path,
                number,
                f"{match.group(2)} does not exist; "
                "write #include <tribody/FOLDER/FILE.h>",
            )
            continue
        found.append((number, header))
        other = module_of(root, header)
        if other is None:
            offences.add(path, number, f"{match.group(2)} belongs to no folder of the table")
        elif module != "main" and other != module and other not in ALLOWED[module]:
            offences.add(
                path,
                number,
                f"{module} must not include {other}; it may include "
                f"{may_include(module)}. Declare an interface or take a "
                "function, and let who uses both supply it.",
            )
    return found


def check_guard(root, path, module, offences):
    stem = os.path.splitext(os.path.basename(path))[0]
    guard = "_".join(
        ["tribody"]
        + [re.sub(r"[^A-Za-z0-9]", "_", part) for part in (module, stem, "h")]
    )
    directives = [
        (number, line.split())
        for number, line in enumerate(read_lines(path), 1)
        if line.startswith("#")
    ]
    wanted = [(0, ["#ifndef", guard]), (1, ["#define", guard]), (-1, ["#endif"])]
    for index, right in wanted:
        number, line = directives[index] if len(directives) > 2 else (1, [])
        if line[: len(right)] != right:
            offences.add(
                path,
                number,
                "include guard: here should be '" + " ".join(right) + "'",
            )
            return


def check_depends(root, module, offences):
    path = os.path.join(root, "source", module, "CMakeLists.txt")
    if not os.path.exists(path):
        return
    inside = False
    for number, line in enumerate(read_lines(path), 1):
        for word in re.findall(r"[A-Za-z_0-9./]+|[()]", line.split("#")[0]):
            if word == "DEPENDS":
                inside = True
            elif word == ")" or word.isupper():
                inside = False
            elif inside and word not in ALLOWED[module]:
                offences.add(
                    path,
                    number,
                    f"{module} must not depend on {word}; it may depend on "
                    f"{', '.join(sorted(ALLOWED[module])) or 'no module'}",
                )


def check_circles(graph, offences):
    """Depth-first search; reports the line that closes each circle."""
    done, path = set(), []

    def visit(file):
        path.append(file)
        for number, header in graph.get(file, []):
            if header in path:
                circle = path[path.index(header) :] + [header]
                names = " -> ".join(os.path.basename(f) for f in circle)
                offences.add(
                    file, number, f"headers include each other in a circle: {names}"
                )
            elif header not in done:
                visit(header)
        path.pop()
        done.add(file)

    for file in graph:
        if file not in done:
            visit(file)


def check_sizes(root, lines, offences):
    """@param lines of each folder."""
    for folder, n in lines.items():
        if n > TOO_MANY_LINES:
            offences.add(
                os.path.join(root, "source", folder),
                n,
                f"{folder} has {n} lines, {TOO_MANY_LINES} are allowed; find the "
                "two things that it has become",
            )
        elif n > MANY_LINES:
            print(
                f"warning: {folder} has {n} lines; above {TOO_MANY_LINES} it must "
                "be split"
            )


def main(root):
    offences = Offences(root)
    files = find_files(root, ("include", "source"), (".h", ".cc"))
    graph = {}
    lines = dict.fromkeys(ALLOWED, 0)
    for path in files:
        module = module_of(root, path)
        if module is None:
            offences.add(
                path,
                1,
                "is in no folder of the table; it should be in "
                "include/tribody/FOLDER or source/FOLDER with FOLDER one of "
                f"{', '.join(ALLOWED)}",
            )
            continue
        if module != "main":
            lines[module] += len(read_lines(path))
        graph[path] = check_includes(root, path, module, offences)
        if path.endswith(".h"):
            check_guard(root, path, module, offences)
    for module in ALLOWED:
        check_depends(root, module, offences)
    check_circles(graph, offences)
    check_sizes(root, lines, offences)
    offences.exit(len(files), "source files")


if __name__ == "__main__":
    main(sys.argv[1])
