# SPDX-License-Identifier: LGPL-2.1-or-later

"""Small rules that a search can check.

  - MPI_COMM_WORLD in source/main.cc only: a communicator is an argument;
  - source/main.cc has at most 60 lines;
  - no notes on unfinished work and no control characters in include/ and source/;
  - lines of .prm files have at most 100 characters;
  - no absolute paths to somebody's own directories, in any file.

Usage: check_sources.py ROOT
"""

import os
import re
import subprocess
import sys

from offences import Offences, find_files, read_lines

# In two parts, so that this file passes its own check.
UNFINISHED = re.compile(r"\b(TO" + r"DO|FIX" + r"ME|XX" + r"X|HA" + r"CK)\b")
CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f]")
OWN_PATH = re.compile(r"(?<![\w.\-/})\]])/(?:home|Users|root|work|mnt|media)/[\w.]+")
COMMENT_OR_STRING = re.compile(
    r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL
)


def code_lines(lines):
    """The lines of a C++ file without comments and strings."""
    text = COMMENT_OR_STRING.sub(
        lambda match: "\n" * match.group().count("\n"), "\n".join(lines)
    )
    return text.split("\n")


def check_cpp(root, path, offences):
    lines = read_lines(path)
    is_main = os.path.relpath(path, root) == os.path.join("source", "main.cc")
    if is_main and len(lines) > 60:
        offences.add(
            path, 61, f"main.cc has {len(lines)} lines, 60 are allowed; move the "
            "rest into a module"
        )
    for number, line in enumerate(code_lines(lines), 1):
        if not is_main and re.search(r"\bMPI_COMM_WORLD\b", line):
            offences.add(
                path, number, "MPI_COMM_WORLD: take the communicator as an argument"
            )
    for number, line in enumerate(lines, 1):
        match = UNFINISHED.search(line)
        if match:
            offences.add(
                path, number, f"{match.group()}: finish it, or write it into an issue"
            )


def check_characters(path, offences):
    for number, line in enumerate(read_lines(path), 1):
        match = CONTROL.search(line)
        if match:
            offences.add(
                path,
                number,
                f"a control character, {match.group()!r}; was it to be '\\a', '\\v' or so?",
            )


def check_prm(path, offences):
    for number, line in enumerate(read_lines(path), 1):
        if len(line) > 100:
            offences.add(
                path,
                number,
                f"{len(line)} characters, 100 are allowed; break the line with "
                "'\\' or move the comment to a line of its own",
            )


def check_paths(path, offences):
    try:
        lines = read_lines(path)
    except UnicodeDecodeError:
        return  # a picture
    for number, line in enumerate(lines, 1):
        match = OWN_PATH.search(line)
        if match:
            offences.add(
                path,
                number,
                f"{match.group()}...: exists on one machine only; write a path "
                "relative to the project",
            )


def project_files(root):
    """All files of the project: those of git, or all when this is no clone."""
    git = ["git", "-C", root]
    try:
        top = subprocess.run(
            git + ["rev-parse", "--show-toplevel"], capture_output=True, text=True
        )
        if top.returncode == 0 and os.path.samefile(top.stdout.strip(), root):
            names = subprocess.run(
                git + ["ls-files", "-z", "-c", "-o", "--exclude-standard"],
                capture_output=True,
                text=True,
                check=True,
            ).stdout.split("\0")
            paths = sorted(os.path.join(root, name) for name in names if name)
            return [path for path in paths if os.path.isfile(path)]
    except (OSError, subprocess.CalledProcessError):
        pass
    return find_files(root, (".",), ("",))


def main(root):
    offences = Offences(root)
    for path in find_files(root, ("include", "source"), (".h", ".cc")):
        check_cpp(root, path, offences)
        check_characters(path, offences)
    files = project_files(root)
    for path in files:
        if path.endswith(".prm"):
            check_prm(path, offences)
        check_paths(path, offences)
    offences.exit(len(files), "files")


if __name__ == "__main__":
    main(sys.argv[1])
