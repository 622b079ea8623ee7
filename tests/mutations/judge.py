# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run of the program on a mutated input must not do, whatever the input.

A script that mutates inputs of some kind needs three things from here:

    outcome = run(program, case, directory)   # one run, observed
    faults = faults_of(outcome)               # list of sentences, [] if it is well
    status = main(description, make_case)     # many, with the usual command line

`make_case(seed, directory)` writes the mutated input number `seed` and all that it
includes into the empty `directory` and returns (file name of the parameter file,
one line that says what was changed). The same seed must give the same files: use
`random.Random(seed)`. `main()` reads the command line

    mutate_x.py PROGRAM [--count N] [--first SEED] [--keep DIRECTORY] ...

runs `PROGRAM case.prm --check` in each directory, prints the faults and a last line
with the counts, keeps the directories of those with faults (all else is removed),
and returns the exit status for `sys.exit`: 0 if there are no faults.

A run is well if it ends by itself within the time, with status 0 (accepted), 1 (it
would fail in its first cycle) or 2 (refused), has written no file, and if what it
says is short (1 kB at most when it refuses), printable, of the program's own words,
and not empty when it refuses.
"""

import argparse
import collections
import concurrent.futures
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

# status: of the exit, negative if a signal ended it, None if the time did; stdout,
# stderr: bytes; seconds: that it took; changed: files made, removed or changed.
Outcome = collections.namedtuple("Outcome",
                                 "status stdout stderr seconds changed")

# Words of libraries and languages, which tell a user nothing.
RAW_TEXTS = [b"An error occurred in line", b"The violated condition was",
             b"Additional information", b"Stacktrace", b"terminate called",
             b"what():", b"std::", b"dealii::", b"boost::", b"basic_string",
             b"bad_alloc", b"bad lexical cast", b"filesystem error", b"vector::_M",
             b"stod", b"stoi", b"stoul", b"AddressSanitizer", b"LeakSanitizer",
             b"runtime error:", b"MPI_ABORT", b"Assertion", b"bad optional access",
             b"bad_variant", b"udunits:", b"ut_parse"]

MAX_MESSAGE = 1024


def snapshot(directory):
    """What is in a directory: {relative path: (size, time of change)}."""
    found = {}
    for path in pathlib.Path(directory).rglob("*"):
        stat = path.lstat()
        found[str(path.relative_to(directory))] = (
            None if path.is_dir() else (stat.st_size, stat.st_mtime_ns))
    return found


def run(program, case, directory, arguments=("--check",), time_limit=20.,
        memory_limit=0):
    """One run in a directory. memory_limit: of the address space [bytes], 0: none
    (the address sanitizer needs terabytes of it)."""
    def limit():
        if memory_limit > 0:
            resource.setrlimit(resource.RLIMIT_AS, (memory_limit, memory_limit))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    before = snapshot(directory)
    start = time.monotonic()
    # A process group of its own, so that nothing outlives a run that hangs.
    process = subprocess.Popen([os.path.abspath(program), case, *arguments],
                               cwd=directory, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               preexec_fn=limit, start_new_session=True)
    try:
        stdout, stderr = process.communicate(timeout=time_limit)
        status = process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        stdout, stderr = process.communicate()
        status = None
    seconds = time.monotonic() - start
    after = snapshot(directory)
    changed = sorted(name for name in before.keys() | after.keys()
                     if before.get(name, ()) != after.get(name, ()))
    return Outcome(status, stdout, stderr, seconds, changed)


def faults_of_text(name, text):
    """Of what was printed to one stream."""
    faults = [f"{name} has the raw text '{raw.decode()}'"
              for raw in RAW_TEXTS if raw in text]
    try:
        printed = text.decode()
    except UnicodeDecodeError:
        return faults + [f"{name} is not UTF-8"]
    odd = sorted({c for c in printed
                  if c not in "\n\t" and (ord(c) < 32 or 127 <= ord(c) < 160)})
    if odd:
        faults.append(f"{name} has control characters {odd}")
    return faults


def faults_of(outcome, statuses=(0, 2)):
    """Sentences about what is wrong with a run; none if it is well. statuses: the
    exit status that it may have."""
    faults = []
    if outcome.status is None:
        faults.append(f"hangs: not done after {outcome.seconds:.0f} s")
    elif outcome.status < 0:
        faults.append(f"ended by {signal.Signals(-outcome.status).name}")
    elif outcome.status not in statuses:
        faults.append(f"exit status {outcome.status}")
    if outcome.changed:
        faults.append("has written " + ", ".join(outcome.changed[:5]))
    if outcome.status not in (None, 0):
        if not outcome.stderr.strip():
            faults.append("says nothing")
        if len(outcome.stderr) > MAX_MESSAGE:
            faults.append(f"a message of {len(outcome.stderr)} bytes")
    if any(len(line) > MAX_MESSAGE for line in outcome.stdout.split(b"\n")):
        faults.append("a printed line above 1 kB")
    return (faults + faults_of_text("stdout", outcome.stdout) +
            faults_of_text("stderr", outcome.stderr))


def try_seed(seed, make_case, options, top):
    """One mutation. Returns (seed, description, outcome, faults)."""
    directory = pathlib.Path(top) / f"{seed:04d}"
    directory.mkdir()
    case, description = make_case(seed, directory)
    outcome = run(options.program, case, directory,
                  time_limit=options.time_limit,
                  memory_limit=int(options.memory * 2**30))
    # The first cycle, which --check measures, may fail.
    faults = faults_of(outcome, (0, 1, 2))
    if faults:
        (directory / "stdout").write_bytes(outcome.stdout)
        (directory / "stderr").write_bytes(outcome.stderr)
    elif not options.keep_all:
        shutil.rmtree(directory)
    return seed, description, outcome, faults


def parse(description, arguments):
    """The command line that all scripts of this kind have."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=20,
                        help="number of mutations")
    parser.add_argument("--first", type=int, default=0, help="first seed")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--time-limit", type=float, default=20.,
                        help="of each run [s]")
    parser.add_argument("--memory", type=float, default=0.,
                        help="limit of each run's address space [GiB], 0: none")
    parser.add_argument("--keep", metavar="DIRECTORY",
                        help="where inputs with faults are kept, "
                             "else a temporary directory")
    parser.add_argument("--keep-all", action="store_true",
                        help="keep the inputs without faults too")
    parser.add_argument("--verbose", action="store_true",
                        help="print each mutation with its message")
    return parser.parse_args(arguments)


def main(description, make_case, arguments=None):
    """Run many mutations; see the top of this file. Returns the exit status."""
    options = parse(description, arguments)
    top = options.keep or tempfile.mkdtemp(prefix="mutations_")
    os.makedirs(top, exist_ok=True)
    counts = collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        futures = [pool.submit(try_seed, seed, make_case, options, top)
                   for seed in range(options.first,
                                     options.first + options.count)]
        for future in futures:
            seed, change, outcome, faults = future.result()
            counts["faulty" if faults else
                   "accepted" if outcome.status == 0 else "refused"] += 1
            if options.verbose and not faults:
                said = outcome.stderr.decode().strip().replace("\n", " | ")
                print(f"{seed}: {change}: {said or 'accepted'}")
            for fault in faults:
                print(f"{seed}: {change}: {fault}")
    print(f"{options.count} mutations: {counts['accepted']} accepted, "
          f"{counts['refused']} refused, {counts['faulty']} with faults" +
          (f", kept in '{top}'" if counts["faulty"] else ""))
    if not counts["faulty"] and not options.keep and not options.keep_all:
        shutil.rmtree(top)
    return 1 if counts["faulty"] else 0


if __name__ == "__main__":
    sys.exit(__doc__)
