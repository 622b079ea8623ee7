# SPDX-License-Identifier: LGPL-2.1-or-later

"""What the style checks share: finding files and reporting offences."""

import os
import sys


class Offences:
    """Collects offences and prints them as file:line: what is wrong."""

    def __init__(self, root):
        self.root = root
        self.n = 0

    def add(self, path, line, message):
        self.n += 1
        print(f"{os.path.relpath(path, self.root)}:{line}: {message}")

    def exit(self, n_checked, what):
        """Ends the program; to have found nothing to check is an error."""
        if n_checked == 0:
            print(f"Nothing to check: no {what} below {self.root}.")
            sys.exit(1)
        print(f"{n_checked} {what} checked, {self.n} offences.")
        sys.exit(1 if self.n else 0)


def find_files(root, directories, endings):
    """Paths below root/<directory> whose names end in one of endings, sorted."""
    found = []
    for directory in directories:
        for parent, children, names in os.walk(os.path.join(root, directory)):
            children[:] = [c for c in children if not is_generated(parent, c, root)]
            found += [os.path.join(parent, n) for n in names if n.endswith(endings)]
    return sorted(set(found))


def is_generated(parent, name, root):
    """Whether a directory holds what a build or a run has written."""
    if name in (".git", "__pycache__", ".cache"):
        return True
    return os.path.samefile(parent, root) and (
        name.startswith("build") or name == "output"
    )


def read_lines(path):
    with open(path, encoding="utf-8") as file:
        return file.read().splitlines()
