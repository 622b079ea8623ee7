# SPDX-License-Identifier: LGPL-2.1-or-later

"""Every .h and .cc file is formatted as clang-format 14 does with .clang-format.

Usage: check_format.py ROOT
"""

import concurrent.futures
import difflib
import os
import re
import shutil
import subprocess
import sys

from offences import Offences, find_files, read_lines

DIRECTORIES = ("include", "source", "tests", "benchmarks")


def find_clang_format():
    # Other versions format differently; 14 is the one of Debian 12.
    for name in ("clang-format-14", "clang-format"):
        if shutil.which(name):
            version = subprocess.run(
                [name, "--version"], capture_output=True, text=True, check=True
            ).stdout
            if re.search(r"version 14\.", version):
                return name
    return None


def main(root):
    clang_format = find_clang_format()
    if clang_format is None:
        sys.exit(
            "clang-format 14 is missing, so nothing was checked. "
            "scripts/install-dependencies installs it (package clang-format-14)."
        )

    offences = Offences(root)
    files = find_files(root, DIRECTORIES, (".h", ".cc"))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = pool.map(
            lambda path: subprocess.run(
                [clang_format, "--style=file", path], capture_output=True, text=True
            ),
            files,
        )
    for path, result in zip(files, results):
        if result.returncode != 0:
            offences.add(path, 1, f"clang-format failed: {result.stderr.strip()}")
            continue
        is_lines = read_lines(path)
        right_lines = result.stdout.splitlines()
        for tag, i1, i2, j1, j2 in difflib.SequenceMatcher(
            None, is_lines, right_lines, autojunk=False
        ).get_opcodes():
            if tag == "equal":
                continue
            right = "\n".join("    " + line for line in right_lines[j1:j2])
            offences.add(
                path,
                i1 + 1,
                f"lines {i1 + 1} to {i2} should be\n{right}"
                if right
                else f"lines {i1 + 1} to {i2} should not be there",
            )
            break  # the first place will do, the command below mends them all
    if offences.n:
        print(f"To mend a file: {clang_format} -i FILE")
    offences.exit(len(files), "source files")


if __name__ == "__main__":
    main(sys.argv[1])
