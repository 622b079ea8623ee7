# SPDX-License-Identifier: LGPL-2.1-or-later

"""Runs the program on spoilt parameter files and judges how it ends.

The files of prm/ and tests/app/ are changed once or more often, see mutations.py, each
in a way that follows from --seed and its number. Most are only checked, one in twenty is
made small and run. What must hold is in judge.py; beyond it, a file that is accepted has
no value of another dimension (entries.py and units.py know them independently of the
program), and a run that ends with status 0 no result that is not a number.

Usage: mutate_parameters.py PROGRAM [--count N] [--seed N] [--first N] [--keep DIRECTORY]

  --count N         how many (200)
  --seed N          another N: other mutations
  --first N         the number of the first one; with --count 1 one of them again
  --keep DIRECTORY  where the inputs with faults are kept
"""

import argparse
import collections
import concurrent.futures
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile

import judge
from case_files import NotUnderstood, flatten, read_assignments, read_case
from entries import fault_of_value, kind_of
from mutations import mutate, short

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

#: Of --check, and of a run [s]; it may take so many more to stop when it is asked to.
CHECK_LIMIT, RUN_LIMIT, PATIENCE = 40.0, 20, 15
#: Address space of a run [bytes]: what needs more is refused before.
MEMORY = 4 << 30
#: One in so many is run.
RUN_SHARE = 20

#: What makes a case small enough to be run.
SMALL = (
    ("Cycles", lambda cycles: str(min(3, int(cycles or 0)))),
    ("Dynamics/Samples per cycle", "12"),
    ("Dynamics/Maximum settling cycles", "2"),
    ("Dynamics/Averaged cycles", "2"),
    ("Output/Number of outputs", "2"),
    ("Bushing BUSHING/Mesh/Bore cells", "24"),
    ("Bushing BUSHING/Mesh/Radial cells", "2"),
)

NOT_A_NUMBER = re.compile(r"(?<![\w.])[-+]?(?:nan|inf(?:inity)?)(?![\w.])", re.IGNORECASE)
#: Words of a library that say nothing to who wrote the input; see judge.RAW_TEXTS too.
RAW = re.compile(r"json\.exception|map::at|mu::|bad_\w+|Parser error")


def print_template(program):
    """What --print-parameters prints, without the signs of comments."""
    process = subprocess.run(
        [program, "--print-parameters"], capture_output=True, text=True, check=True
    )
    return process.stdout


def find_words(template):
    """Entry -> the words that it may have, from the manual."""
    words, comment = collections.defaultdict(list), ""
    for line in template.split("\n"):
        line = line.strip()
        if line.startswith("#"):
            comment += " " + line.lstrip("# ")
            continue
        found = re.search(r"One of: (.*?)\.\s*$", comment)
        name = re.match(r"set\s+(.*?)\s*=", line)
        if found and name:
            words[name.group(1)] += found.group(1).split(" | ")
        comment = ""
    return dict(words)


def check_table(template, directory):
    """Ends the program unless the table here has all entries, with right defaults."""
    path = os.path.join(directory, "template.prm")
    with open(path, "w", encoding="utf-8") as file:
        file.write(template)
    for subsections, name, value, _ in read_assignments(path):
        place = "/".join([*subsections, name])
        kind = kind_of(subsections, name)
        if kind is None:
            sys.exit(f"entries.py does not know the entry '{place}'")
        fault = value and fault_of_value(kind, value)
        if fault:
            sys.exit(f"entries.py is wrong about '{place}': {fault}")


def faults_of_values(path):
    """Of a file that was accepted: values of a wrong dimension."""
    try:
        for subsections, name, value, _ in read_assignments(path):
            place = "/".join([*subsections, name])
            kind = kind_of(subsections, name)
            if kind is None:
                return [f"accepts: an entry '{short(place)}' that nobody knows"]
            fault = value and fault_of_value(kind, value)
            if fault:
                return [f"accepts: {place}: {short(fault)}"]
    except NotUnderstood as error:
        return [f"accepts: {short(str(error))}"]
    return []


def find_null(value, path=""):
    """Path of the first null, which is how JSON writes what is not a number."""
    if value is None:
        return path
    members = value.items() if isinstance(value, dict) else ()
    if isinstance(value, list):
        members = enumerate(value)
    for key, member in members:
        found = find_null(member, f"{path}/{key}")
        if found:
            return found
    return ""


def faults_of_results(outcome, directory):
    """What a run that ended with status 0 has printed and written."""
    faults = []
    printed = NOT_A_NUMBER.search(outcome.stdout.decode(errors="replace"))
    if printed:
        faults.append(f"not a number: {printed.group()} is printed")
    for name in outcome.changed:
        path = os.path.join(directory, name)
        if not name.endswith((".csv", ".json")) or not os.path.isfile(path):
            continue
        with open(path, encoding="utf-8", errors="replace") as file:
            text = file.read()
        if name.endswith(".json"):
            null = find_null(json.loads(text))
            if null:
                faults.append(f"not a number: {null} in {name}")
        elif any(
            NOT_A_NUMBER.search(line)
            for line in text.split("\n")
            if not line.startswith("#")
        ):
            faults.append(f"not a number: in {name}")
    return faults[:2]


def run_case(program, case, directory, slow):
    """A run that is asked to stop when it takes long. Returns (outcome, faults)."""
    limit = RUN_LIMIT * slow
    arguments = (f"--kill-after={PATIENCE * slow}", str(limit), program, case)
    outcome = judge.run(
        shutil.which("timeout"),
        "--signal=TERM",
        directory,
        (*arguments, "--output", "results"),
        time_limit=limit + PATIENCE * slow + 10.0,
        memory_limit=memory_limit(slow),
    )
    # Of timeout(1): 124 if the program ended when it was asked to, 137 if it did not.
    statuses = (0, 1, 2, 124)
    faults = judge.faults_of(outcome, statuses)
    if outcome.status != 2:
        faults = [fault for fault in faults if not fault.startswith("has written")]
    if outcome.status == 124:
        faults = [fault for fault in faults if not fault.startswith("says nothing")]
    if outcome.status == 0:
        faults += faults_of_results(outcome, directory)
    return outcome, faults


def make_case(seeds, words, seed, number):
    """Returns (case, whether it is run, what was done to it)."""
    rng = random.Random(f"{seed}/{number}")
    path = rng.choice(seeds)
    is_run = number % RUN_SHARE == 7
    if is_run or rng.random() < 0.7:
        case = flatten(ROOT, path, SMALL if is_run else ())
    else:
        case = read_case(ROOT, path)
    done = ("run " if is_run else "") + f"{path}: " + mutate(rng, case, words)
    return case, is_run, done


def memory_limit(slow):
    """Sanitizers, which make a program slow, need terabytes of address space."""
    return MEMORY if slow == 1 else 0


def try_one(program, seeds, words, top, seed, number, slow):
    """One mutation. Returns (what was done, outcome, faults, its directory)."""
    case, is_run, done = make_case(seeds, words, seed, number)
    directory = os.path.join(top, f"{seed}_{number:05d}")
    os.makedirs(directory)
    case.write(directory)
    if is_run:
        outcome, faults = run_case(program, case.main, directory, slow)
    else:
        outcome = judge.run(
            program,
            case.main,
            directory,
            time_limit=CHECK_LIMIT * slow,
            memory_limit=memory_limit(slow),
        )
        # The first cycle, which is measured, may fail.
        faults = judge.faults_of(outcome, (0, 1, 2))
    raw = RAW.search((outcome.stdout + outcome.stderr).decode(errors="replace"))
    if raw:
        faults.append(f"has the raw text '{raw.group()}'")
    if outcome.status == 0:
        faults += faults_of_values(os.path.join(directory, case.main))
    return done, outcome, faults, directory


def keep(outcome, done, faults, directory):
    """What is needed to look into it."""
    for name, content in (("stdout", outcome.stdout), ("stderr", outcome.stderr)):
        with open(os.path.join(directory, name), "wb") as file:
            file.write(content)
    with open(
        os.path.join(directory, "faults"), "w", encoding="utf-8", errors="replace"
    ) as file:
        file.write("\n".join([done, *faults, ""]))


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--keep", metavar="DIRECTORY")
    parser.add_argument(
        "--slow",
        type=int,
        default=1,
        help="times as much time, and no limit of the memory: for sanitizers",
    )
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    # Beside a run without mpirun Open MPI starts a daemon, which takes a third of the
    # time of a run as short as these. It is for programs that start others; without it
    # runs must not share directories for messages, which they do not need either.
    for name, value in (
        ("ess_singleton_isolated", "1"),
        ("orte_create_session_dirs", "0"),
        ("btl", "self"),
    ):
        os.environ["OMPI_MCA_" + name] = value
    program = os.path.abspath(options.program)
    top = options.keep or tempfile.mkdtemp(prefix="mutations_")
    os.makedirs(top, exist_ok=True)
    template = print_template(program)
    check_table(template, top)
    words = find_words(template)
    seeds = [
        os.path.join(folder, name)
        for folder in ("prm", "tests/app")
        for name in sorted(os.listdir(os.path.join(ROOT, folder)))
        if name.endswith(".prm")
    ]

    statuses, kinds = collections.Counter(), collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        futures = [
            pool.submit(
                try_one,
                program,
                seeds,
                words,
                top,
                options.seed,
                number,
                options.slow,
            )
            for number in range(options.first, options.first + options.count)
        ]
        for number, future in enumerate(futures, options.first):
            try:
                done, outcome, faults, directory = future.result()
            except Exception:
                print(f"{options.seed}/{number}: cannot be judged:", flush=True)
                raise
            statuses[outcome.status] += 1
            for fault in faults:
                kinds[re.sub(r"[\d.]+|\bin .*|: .*", "", fault)] += 1
                print(f"{options.seed}/{number}: {fault}\n    {short(done)}", flush=True)
            if faults and options.keep:
                keep(outcome, done, faults, directory)
            else:
                shutil.rmtree(directory)
    if not options.keep:
        shutil.rmtree(top)

    for kind, n in kinds.most_common():
        print(f"{n:6} {kind}")
    shown = ", ".join(f"status {status}: {n}" for status, n in statuses.most_common())
    print(f"{options.count} mutations ({shown}), {sum(kinds.values())} faults.")
    return 1 if kinds else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
