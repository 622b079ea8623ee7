# SPDX-License-Identifier: LGPL-2.1-or-later
"""The output directory of real runs: several at once, links, files that vanish, a
disk that is full. Known: what doc/results.md says.

    check_output_directory.py PROGRAM PRM_DIRECTORY WORK_DIRECTORY
"""

import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys

P = pathlib.Path


def expect(what, value, right):
    """One comparison."""
    if value != right:
        sys.exit(f"{what} is {value!r}, should be {right!r}")


class Runs:
    """How the program is run here."""

    def __init__(self, program, prm):
        self.program, self.prm = P(program).resolve(), P(prm).resolve()

    def begin(self, output, *arguments, case="scotch_yoke.prm", before=None):
        """A run that has begun."""
        return subprocess.Popen(
            [self.program, self.prm / case, "--output", output, *arguments],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            preexec_fn=before)

    def run(self, output, *arguments, **others):
        """Status, stdout and stderr of a whole run."""
        process = self.begin(output, *arguments, **others)
        stdout, stderr = process.communicate()
        return process.returncode, stdout, stderr


def friction(text):
    """Of the crank pin in a parameter file."""
    of_joint = text[text.index("subsection Joint crank_pin"):]
    return float(re.search(r"set Friction coefficient *= ([\d.]+)",
                           of_joint).group(1))


def check_several_at_once(runs):
    """Of runs that begin together, by different names of one directory, one is done
    and the others are refused; what is there is all of that one."""
    P("real").mkdir()
    P("link").symlink_to("real")
    names = ["real", "link", "./real/", str(P("real").resolve()), "real/../link"]
    values = [0.05, 0.1, 0.15, 0.2, 0.25]
    begun = [runs.begin(name, "--set", f"Joint crank_pin/Friction coefficient={mu}",
                        case="quickstart.prm")
             for name, mu in zip(names, values)]
    ended = [process.communicate() + (process.returncode,) for process in begun]
    done = [i for i, (_, _, status) in enumerate(ended) if status == 0]
    expect("at once: number of runs that are done", len(done), 1)
    for i, (_, stderr, status) in enumerate(ended):
        if i in done:
            continue
        expect("at once: status", status, 2)
        expect("at once: message", stderr,
               "Error in the input: Another run is writing to the output directory "
               f"'{names[i]}'. Choose another one with --output.\n")
    expect("at once: friction", friction(P("real/parameters.prm").read_text()),
           values[done[0]])
    expect("at once: directories", sorted(p.name for p in P(".").iterdir()),
           ["link", "real"])
    # Depths on screen, in the log and in the summary are those of one run.
    depth = json.loads(P("real/summary.json").read_text())["joints"]["crank_pin"][
        "bushing"]["max_wear_depth_m"]
    said = re.search(r"maximum depth ([\d.]+) mm", ended[done[0]][0]).group(1)
    if abs(float(said) / (1e3 * depth) - 1) > 1e-3:
        sys.exit(f"at once: {said} mm on the screen, {depth} m in the summary")
    print("at once: one is done, the others are refused")


def check_links(runs):
    """Results go where a link leads, and earlier ones stay on that disk."""
    P("disk/scratch").mkdir(parents=True)
    P("out").symlink_to("disk/scratch")
    P("chain").symlink_to("out")
    for name in ["out", "chain"]:
        status, stdout, _ = runs.run(name)
        expect("link: status", status, 0)
    if "Earlier results moved to 'disk/scratch.1'." not in stdout:
        sys.exit(f"link: said\n{stdout}")
    expect("link: is one", P("out").is_symlink() and P("chain").is_symlink(), True)
    for place in ["disk/scratch", "disk/scratch.1"]:
        expect("link: results", P(place, "summary.json").is_file(), True)
    expect("link: directories", sorted(p.name for p in P(".").iterdir()),
           ["chain", "disk", "out"])
    print("link: results and earlier ones are where it leads")


def check_dangling_links(runs):
    """What does not exist yet is made; what cannot be is refused, and --check says
    the same."""
    P("dangling").symlink_to("disk/new/results")
    expect("dangling: check", runs.run("dangling", "--check")[0], 0)
    expect("dangling: made by --check", P("disk/new").exists(), False)
    expect("dangling: status", runs.run("dangling")[0], 0)
    expect("dangling: results", P("disk/new/results/summary.json").is_file(), True)
    P("nowhere").symlink_to("gone")
    P("circle").symlink_to("circle")
    P("file").write_text("mine\n")
    P("to_file").symlink_to("file")
    for name in ["nowhere/results", "circle", "circle/results", "file/results",
                 "to_file", "x" * 300]:
        checked = runs.run(name, "--check")
        expect(f"{name}: status of --check", checked[0], 2)
        done = runs.run(name)
        expect(f"{name}: status", done[0], 2)
        expect(f"{name}: message", done[2], checked[2])
        if len(checked[2]) > 1000 or "filesystem" in checked[2]:
            sys.exit(checked[2])
    expect("file", P("file").read_text(), "mine\n")
    print("dangling: made, or refused by --check and run alike")


def check_refused(runs):
    """A run that is refused in its set-up leaves nothing, nor takes anything."""
    args = ["--set", "Bushing crank_pin/Mesh/File=no_such.msh"]
    for name in ["new/directory", "kept"]:
        if name == "kept":
            expect("refused: status", runs.run("kept")[0], 0)
            before = sorted(P("kept").rglob("*"))
        expect("refused: status",
               runs.run(name, *args, case="quickstart.prm")[0], 2)
    expect("refused: new directory", P("new").exists(), False)
    expect("refused: files", sorted(P("kept").rglob("*")), before)
    print("refused: nothing written")


def check_vanished(runs):
    """Files or the directory that go while a run is on: never status 0."""
    def remove_history():
        P("vanished/history.csv").unlink()

    def remove_all():
        shutil.rmtree("vanished")

    def replace():
        remove_all()
        P("vanished").mkdir()

    def remove_vtu():
        P("vanished/crank_pin/bushing_0000.vtu").unlink()

    for remove, message in [(remove_history, "'vanished/history.csv' has been removed"),
                            (remove_all, "'vanished' has been removed or replaced"),
                            (replace, "'vanished' has been removed or replaced"),
                            (remove_vtu, "bushing_0000.vtu' has been removed")]:
        shutil.rmtree("vanished", ignore_errors=True)
        process = runs.begin("vanished", "--set", "Wear/Extrapolation=constant",
                             "--set", "Wear/Cycles per step=20",
                             case="quickstart.prm")
        for line in process.stdout:
            if "cycles" in line and "passed" in line:
                break
        remove()
        _, stderr = process.communicate()
        expect(f"{remove.__name__}: status", process.returncode, 1)
        if message not in stderr:
            sys.exit(f"{remove.__name__}: said\n{stderr}")
    print("vanished: status 1 and the name")


def check_full_disk(runs):
    """A file that the disk does not take is named with the cause, nothing is left of
    it, and the summary is whole. A limit of file sizes stands for the disk."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        # Open MPI is to do without files of its own.
        os.environ["PMIX_MCA_gds"] = "hash"
        resource.setrlimit(resource.RLIMIT_FSIZE, (150000, 150000))

    status, _, stderr = runs.run("full", "--set", "Dynamics/Samples per cycle=4000",
                                 before=limit)
    expect("full: status", status, 1)
    if not re.fullmatch(r"The run failed: Cannot write 'full/\w+/\w+\.csv': File too "
                        r"large\.\n", stderr):
        sys.exit(f"full: said\n{stderr}")
    summary = json.loads(P("full/summary.json").read_text())
    expect("full: status", summary["status"], "failed")
    expect("full: halves of files", list(P("full").rglob("*.part")), [])
    print("full: file and cause are named, the summary is whole")


def main(program, prm, work):
    """All of them, each in an empty directory."""
    runs, work = Runs(program, prm), P(work).absolute()
    shutil.rmtree(work, ignore_errors=True)
    for check in [check_several_at_once, check_links, check_dangling_links,
                  check_refused, check_vanished, check_full_disk]:
        directory = work / check.__name__
        directory.mkdir(parents=True)
        os.chdir(directory)
        check(runs)


if __name__ == "__main__":
    main(*sys.argv[1:])
