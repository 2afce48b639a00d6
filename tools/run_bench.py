#!/usr/bin/env python3
"""Runs the programs in build/bench and collects their figures.

    run_bench.py [NAME..] [--engine GODOT] [--json FILE]
    run_bench.py --instructions [CASE..] [--json FILE]

A program prints one JSON object a figure: name, value, unit, peer (what it is compared with), ratio (value over peer); the last two are null
where there is nothing to compare with. With an engine, the scripts of bench/ are among them. Where valgrind is installed, agenda_bench has a figure in
instructions too: they are the same on every run, whatever else the machine does.
With --instructions only those of derivations are counted, by face and case.
"""

import argparse
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

from deps import ROOT

DERIVE = ROOT / "build/bench/derive_bench"
ALLOCATIONS = ROOT / "build/bench/preload/allocations.so"
FIELDS = ("name", "value", "unit", "peer", "ratio")


def figures_of(program, *command):
    """Returns the figures that one program prints, or raises ValueError with what is wrong. `command` runs what is no program by itself."""
    done = subprocess.run(command or [program], cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise ValueError(f"{program.name} ended with status {done.returncode}\n{done.stdout}{done.stderr}")
    figures = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    for figure in figures:
        missing = [field for field in FIELDS if field not in figure]
        if missing:
            raise ValueError(f"{program.name}: {figure} lacks {', '.join(missing)}")
    if program.name == "agenda_bench" and shutil.which("valgrind"):
        figures.append(agenda_instructions(program))
    return figures


def count(command, *options):
    """Returns the instructions of a program, counted by callgrind, and the last number that it prints."""
    done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *options, *command], cwd=ROOT, capture_output=True,
                          text=True, check=False)
    collected = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or not collected:
        raise ValueError(f"callgrind ended with status {done.returncode}\n{done.stderr}")
    return int(collected[1]), int(done.stdout.split()[-1])


def agenda_instructions(program, persons=20000, peer=7000):
    """What one agenda costs."""
    instructions, made = count([program, str(persons)], "--toggle-collect=pcg::generate_agendas(*")
    value = round(instructions / made)
    return {"name": "agenda.instructions_per_person", "value": value, "unit": "instructions", "peer": peer, "ratio": round(value / peer, 3)}


def derive_instructions(case):
    """What one face of a case costs. The start and the first derivation, which makes memory and reads files, are not counted."""
    (some, few_faces), (more, many_faces) = count([DERIVE, "derive", case, "1"]), count([DERIVE, "derive", case, "3"])
    value = round((more - some) / (many_faces - few_faces))
    return {"name": f"cga_{case}_instructions", "value": value, "unit": "instructions/face", "peer": None, "ratio": None}


def jobs_of(options):
    """What to measure: pairs of a name and a function that returns its figures. None, with a message, where that is not there."""
    programs = {path.name: path for path in sorted((ROOT / "build/bench").glob("*")) if path.is_file()}
    jobs = {name: lambda path=path: figures_of(path) for name, path in programs.items()}
    if options.engine:
        for script in sorted((ROOT / "bench").glob("*_bench.gd")):
            preload = ["env", f"LD_PRELOAD={ALLOCATIONS}"] if ALLOCATIONS.is_file() else []
            command = [*preload, options.engine, "--headless", "--no-header", "--fixed-fps", "60", "--path", ".", "--script", f"bench/{script.name}"]
            jobs[script.stem] = lambda script=script, command=command: figures_of(script, *command)
    if options.instructions and not shutil.which("valgrind"):
        print("bench: valgrind is not installed", file=sys.stderr)
        return None
    if options.instructions:
        cases = subprocess.run([DERIVE, "names"], capture_output=True, text=True, check=True).stdout.split()
        jobs = {case: lambda case=case: [derive_instructions(case)] for case in cases}
    unknown = [name for name in options.names if name not in jobs]
    if unknown or not jobs:
        print(f"bench: there is no {', '.join(unknown) or 'program'}; there are: {', '.join(jobs)}", file=sys.stderr)
        return None
    return [(name, jobs[name]) for name in options.names or jobs]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--engine", metavar="GODOT")
    parser.add_argument("--json", type=Path, metavar="FILE")
    parser.add_argument("--instructions", action="store_true")
    options = parser.parse_args()
    jobs = jobs_of(options)
    if jobs is None:
        return 1
    figures = []
    for _, measure in jobs:
        try:
            found = measure()
        except ValueError as error:
            print(f"bench: {error}", file=sys.stderr)
            return 1
        figures += found
        for figure in found:
            compared = " (peer: {peer}, ratio {ratio})" if figure["peer"] is not None else ""
            print(("{name}: {value} {unit}" + compared).format(**figure), flush=True)
    if options.json:
        partial = options.json.with_name(options.json.name + ".tmp")
        partial.write_text(json.dumps(figures, indent=1) + "\n")
        partial.replace(options.json)
    return 0


if __name__ == "__main__":
    sys.exit(main())
