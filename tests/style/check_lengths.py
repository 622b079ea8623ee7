# SPDX-License-Identifier: LGPL-2.1-or-later

"""No class above 300 lines, no function above 80.

What is formatted by clang-format (see check_format.py) has its braces where they
can be counted: a definition begins after a line with nothing but a brace and ends
at the brace in the same column. A class counts from its name to its last brace,
a function from its opening brace to the closing one.

Usage: check_lengths.py [--largest] ROOT      (--largest: prints the largest ten)
"""

import re
import sys

from offences import Offences, find_files, read_lines

MAX_CLASS, MAX_FUNCTION = 300, 80

TEMPLATE = re.compile(r"\s*template <.*?>\s*(?=class|struct)")
CLASS = re.compile(r"\s*(?:class|struct)\s+([\w:]+)")
NO_FUNCTION = re.compile(r"\s*(?:namespace|class|struct|union|enum|extern)\b")


def closing_line(lines, opening):
    """Index of the brace that closes the one which is all of a line."""
    indentation = lines[opening][: lines[opening].index("{")]
    ends = (indentation + "}", indentation + "};")
    for number in range(opening + 1, len(lines)):
        if lines[number] in ends or lines[number].startswith(indentation + "} //"):
            return number
    return len(lines) - 1


def head_of(lines, opening):
    """The declaration before an opening brace, one string, and its first line."""
    first = opening
    while first > 0 and lines[first - 1].strip() and not re.search(
        r"[;{}]\s*$|^\s*(?:#|//|\*|/\*|public:|private:|protected:)", lines[first - 1]
    ):
        first -= 1
    return " ".join(line.strip() for line in lines[first:opening]), first


def definitions(path):
    """Yields (kind, name, first line, number of lines) of a file."""
    lines = read_lines(path)
    skip_until = -1
    for opening, line in enumerate(lines):
        if line.strip() != "{" or opening <= skip_until:
            continue
        head, first = head_of(lines, opening)
        head = TEMPLATE.sub("", head)
        end = closing_line(lines, opening)
        name = CLASS.match(head)
        if name and "(" not in head.split(":")[0]:
            yield "class", name.group(1), first + 1, end - first + 1
        elif head and not NO_FUNCTION.match(head) and "(" in head:
            name = re.search(r"([\w:~]+|operator\S+)\s*\(", head)
            yield "function", name.group(1), opening + 1, end - opening + 1
            skip_until = end


def main(arguments):
    root = arguments[-1]
    offences = Offences(root)
    files = find_files(root, ("include", "source"), (".h", ".cc"))
    found = []
    for path in files:
        for kind, name, line, length in definitions(path):
            found.append((kind, length, name, path, line))
            limit = MAX_CLASS if kind == "class" else MAX_FUNCTION
            if length > limit:
                offences.add(
                    path,
                    line,
                    f"{kind} {name} has {length} lines, {limit} are allowed; find "
                    "the two things that it does",
                )
    if "--largest" in arguments:
        for kind in ("class", "function"):
            print(f"Largest of kind {kind}:")
            largest = sorted((f for f in found if f[0] == kind), reverse=True)[:10]
            for _, length, name, path, line in largest:
                print(f"  {length:4} {name} {path}:{line}")
    offences.exit(len(files), "source files")


if __name__ == "__main__":
    main(sys.argv[1:])
