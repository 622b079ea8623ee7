# SPDX-License-Identifier: LGPL-2.1-or-later

"""The style checks find what they are there to find.

A small correct project must pass; then one offence at a time is made in it,
and the check must fail and name the file and line of that offence.

Usage: self_test.py
"""

import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))

HEADER = """\
#ifndef tribody_{module}_{name}_h
#define tribody_{module}_{name}_h

{include}namespace Tribody
{{
  struct {name}
  {{
    double value;
  }};
}} // namespace Tribody

#endif
"""


def header(module, name, include=""):
    return HEADER.format(
        module=module, name=name, include=include and f"#include <{include}>\n\n"
    )


CORRECT = {
    "include/tribody/base/a.h": header("base", "a"),
    "include/tribody/base/b.h": header("base", "b", "tribody/base/a.h"),
    "include/tribody/contact/c.h": header("contact", "c", "tribody/base/a.h"),
    "include/tribody/wear/w.h": header("wear", "w"),
    "source/wear/w.cc": "#include <tribody/wear/w.h>\n",
    "source/wear/CMakeLists.txt": "tribody_module(wear SOURCES w.cc DEPENDS base)\n",
    "source/main.cc": "// MPI_COMM_WORLD\nint communicator = MPI_COMM_WORLD;\n",
    "prm/a.prm": "set A = 1\n",
    "README.md": "See include/tribody/home/a and https://b.org/home/c.\n"
                 "Run `prm/a.prm`, [read](doc/a.md#the-law) `include/tribody/base/a`.\n",
    "doc/a.md": "# The law\n\n    `doc/in_a_block.md`\n",
}

# check, file, its new content, line at which the offence must be reported
OWN = "/" + "home/somebody/data"
NOTE = "// TO" + "DO: later\n"
OFFENCES = [
    ("format", "source/wear/w.cc", "#include <tribody/wear/w.h>\n\nint  i;\n", 3),
    ("format", "tests/wear/t.cc", "int main(){}\n", 1),
    ("includes", "source/wear/w.cc", "#include <tribody/contact/c.h>\n", 1),
    ("includes", "source/wear/w.cc", '#include "../contact/c.h"\n', 1),
    ("includes", "source/wear/w.cc", "\n#include <tribody/wear/none.h>\n", 2),
    ("includes", "include/tribody/base/a.h", header("base", "a", "tribody/wear/w.h"), 4),
    ("includes", "include/tribody/base/a.h", header("wear", "a"), 1),
    ("includes", "include/tribody/base/a.h", "#pragma once\n", 1),
    ("includes", "include/tribody/base/b.h", header("base", "b").replace(
        "#define tribody_base_b_h", "#define tribody_base_c_h"), 2),
    ("includes", "source/wear/CMakeLists.txt",
     "tribody_module(wear SOURCES w.cc\n DEPENDS base contact)\n", 2),
    ("includes", "source/stray/s.cc", "int i;\n", 1),
    ("sources", "source/wear/w.cc", "int i;\nint c = MPI_COMM_WORLD;\n", 2),
    ("sources", "source/wear/w.cc", "int i;\n" + NOTE, 2),
    ("sources", "source/main.cc", "\n" * 61, 61),
    ("sources", "source/wear/w.cc", "int i;\n// \alpha\n", 2),
    ("sources", "prm/a.prm", "set A = 1\nset B = " + "1" * 100 + "\n", 2),
    ("sources", "prm/a.prm", f"set File = {OWN}\n", 1),
    ("documents", "README.md", "\n" * 151, 151),
    ("documents", "README.md", "See\n[this](doc/none.md).\n", 2),
    ("documents", "README.md", "See [this](doc/a.md#no-law).\n", 1),
    ("documents", "doc/a.md", "See `prm/none.prm --check`.\n", 1),
    ("documents", "prm/a.prm", "set A = 1 # tests/wear/none_01.cc compares\n", 1),
    ("documents", "source/wear/w.cc", "int i;\n// See doc/none.md.\n", 2),
    ("lengths", "source/wear/w.cc", "\nint\nf()\n{\n" + "  f();\n" * 79 + "}\n", 4),
    ("lengths", "include/tribody/wear/w.h", "\nclass W\n{\n" + "  int i;\n" * 298 + "};\n",
     2),
]

# Lines of source/wear that are one too many with those of its header, and where
# that is reported.
LONG = "int i;\n" * (3501 - header("wear", "w").count("\n"))
LONG_FOLDER = ("includes", "source/wear/w.cc", LONG, "source/wear:3501:")

# Two files that include each other are allowed by every other rule. It is
# reported where the circle closes, which may be either header.
CIRCLE = ("includes", "include/tribody/base/a.h",
          header("base", "a", "tribody/base/b.h"), ".h:4: headers include")

# What is as long as it may be.
LONGEST = {
    "lengths": ("source/wear/w.cc", "\nint\nf()\n{\n" + "  f();\n" * 78 + "}\n"),
    "includes": ("source/wear/w.cc", LONG[len("int i;\n"):]),
}


def write(root, name, content):
    path = os.path.join(root, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(content)


def run(check, root):
    return subprocess.run(
        [sys.executable, "-B", os.path.join(HERE, f"check_{check}.py"), root],
        capture_output=True,
        text=True,
    )


def project(root):
    shutil.copy(os.path.join(HERE, "..", "..", ".clang-format"), root)
    for name, content in CORRECT.items():
        write(root, name, content)


def main():
    failures = 0
    for check in ("documents", "format", "includes", "lengths", "sources"):
        with tempfile.TemporaryDirectory() as root:
            project(root)
            if check in LONGEST:
                write(root, *LONGEST[check])
            result = run(check, root)
            if result.returncode != 0:
                failures += 1
                print(f"{check}: a correct project fails:\n{result.stdout}{result.stderr}")

    offences = [(check, name, content, f"{name}:{line}:")
                for check, name, content, line in OFFENCES] + [LONG_FOLDER, CIRCLE]
    for check, name, content, place in offences:
        with tempfile.TemporaryDirectory() as root:
            project(root)
            write(root, name, content)
            result = run(check, root)
            if result.returncode != 1 or place not in result.stdout:
                failures += 1
                print(f"{check}: missed the offence at {place} its output:\n"
                      f"{result.stdout}{result.stderr}")

    print(f"{len(offences)} offences tried, {failures} failures.")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
