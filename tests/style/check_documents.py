# SPDX-License-Identifier: LGPL-2.1-or-later

"""What documents refer to exists.

  - relative links of .md files lead to a file, and to a heading if they name one;
  - paths in backticks in .md files that begin with a directory of the project
    (`doc/decisions.md`, `tests/contact/persson_01`) exist; the ending may be left out,
    and CHANGELOG.md, which tells of the past, may name what is gone;
  - so do paths to tests/, doc/ and scripts/ in the comments of .prm, .h and .cc files;
  - README.md has at most 150 lines.

Usage: check_documents.py ROOT
"""

import glob
import os
import re
import sys

from check_sources import project_files
from offences import Offences, read_lines

MAX_README = 150
LINK = re.compile(r"\]\(([^)\s]+)\)")
QUOTED = re.compile(r"`((?:include|source|tests|prm|scripts|doc|benchmarks)/[^`\s]+)[^`]*`")
IN_COMMENT = re.compile(r"(?<![\w/.])((?:tests|doc|scripts)/[\w./=+-]*\w)")
COMMENT = {".prm": re.compile(r"#.*"), ".h": re.compile(r"(?://|\*).*"),
           ".cc": re.compile(r"(?://|\*).*")}

# Paths with a place holder, and those that the worked change of CONTRIBUTING.md makes.
NOT_MEANT = re.compile(r"[<>*{}$]|NN|FILE|FOLDER|/algebraic_friction_")


def exists(root, path):
    path = os.path.join(root, path)
    return os.path.exists(path) or bool(glob.glob(glob.escape(path) + ".*"))


def anchor(heading):
    """The name that GitHub gives to a heading."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def prose_of(lines):
    """The lines with those of code blocks emptied."""
    inside = False
    for line in lines:
        if line.lstrip().startswith("```"):
            inside = not inside
            yield ""
        else:
            yield "" if inside or line.startswith("    ") else line


def check_markdown(root, path, offences):
    lines = read_lines(path)
    name = os.path.relpath(path, root)
    if name == "README.md" and len(lines) > MAX_README:
        offences.add(
            path, MAX_README + 1, f"README.md has {len(lines)} lines, {MAX_README} are "
            "allowed; move the rest to doc/"
        )
    for number, line in enumerate(prose_of(lines), 1):
        for target in LINK.findall(line):
            if not re.match(r"\w+:", target):
                check_link(path, number, target, offences)
        for quoted in QUOTED.findall(line):
            quoted = quoted.rstrip("/.,:;")
            if name != "CHANGELOG.md" and not NOT_MEANT.search(quoted):
                if not exists(root, quoted):
                    offences.add(path, number, f"there is no {quoted}")


def check_link(path, number, target, offences):
    file, _, heading = target.partition("#")
    file = os.path.join(os.path.dirname(path), file) if file else path
    if not os.path.exists(file):
        offences.add(path, number, f"the link to {target} leads nowhere")
    elif heading and file.endswith(".md"):
        headings = [line.lstrip("#").strip() for line in prose_of(read_lines(file))
                    if line.startswith("#")]
        if heading not in map(anchor, headings):
            offences.add(path, number, f"there is no heading #{heading} in {target}")


def check_comments(root, path, comment, offences):
    for number, line in enumerate(read_lines(path), 1):
        text = comment.search(line)
        for mentioned in IN_COMMENT.findall(text.group()) if text else ():
            if not NOT_MEANT.search(mentioned) and not exists(root, mentioned):
                offences.add(path, number, f"there is no {mentioned}")


def main(root):
    offences = Offences(root)
    n_checked = 0
    for path in project_files(root):
        ending = os.path.splitext(path)[1]
        if ending == ".md":
            check_markdown(root, path, offences)
        elif ending in COMMENT:
            check_comments(root, path, COMMENT[ending], offences)
        else:
            continue
        n_checked += 1
    offences.exit(n_checked, "documents and commented files")


if __name__ == "__main__":
    main(sys.argv[1])
