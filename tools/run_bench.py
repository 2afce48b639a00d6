#!/usr/bin/env python3
"""Runs the programs in build/bench and collects their figures.

    run_bench.py [NAME..] [--json FILE]

A program prints one JSON object a figure: name, value, unit, peer (what it is compared with), ratio (value over peer).
"""

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from deps import ROOT

FIELDS = ("name", "value", "unit", "peer", "ratio")


def figures_of(program):
    """Returns the figures that one program prints, or raises ValueError with what is wrong."""
    done = subprocess.run([program], cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise ValueError(f"{program.name} ended with status {done.returncode}\n{done.stdout}{done.stderr}")
    figures = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    for figure in figures:
        missing = [field for field in FIELDS if field not in figure]
        if missing:
            raise ValueError(f"{program.name}: {figure} lacks {', '.join(missing)}")
    return figures


def count_instructions(program, persons=20000, peer=7000):
    """What one agenda costs in instructions, counted by callgrind: the same on every run, whatever else the machine does."""
    if not shutil.which("valgrind"):
        return []
    with tempfile.TemporaryDirectory() as folder:
        counts = Path(folder) / "counts"
        done = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={counts}", "--toggle-collect=pcg::generate_agendas*",
                               program, str(persons)], cwd=ROOT, capture_output=True, text=True, check=False)
        totals = [line.split()[1] for line in counts.read_text().splitlines() if line.startswith(("totals:", "summary:"))] if counts.exists() else []
    if done.returncode != 0 or not totals:
        raise ValueError(f"callgrind ended with status {done.returncode}\n{done.stderr}")
    value = round(int(totals[-1]) / int(done.stdout.split()[-1]))
    return [{"name": "agenda.instructions_per_person", "value": value, "unit": "instructions", "peer": peer, "ratio": round(peer / value, 3)}]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--json", type=Path, metavar="FILE")
    options = parser.parse_args()
    programs = {path.name: path for path in sorted((ROOT / "build/bench").glob("*")) if path.is_file()}
    unknown = [name for name in options.names if name not in programs]
    if unknown or not programs:
        print(f"bench: there is no {', '.join(unknown) or 'program'}; there are: {', '.join(programs)}", file=sys.stderr)
        return 1
    figures = []
    for name in options.names or programs:
        try:
            found = figures_of(programs[name])
            if name == "agenda_bench":
                found += count_instructions(programs[name])
        except ValueError as error:
            print(f"bench: {error}", file=sys.stderr)
            return 1
        figures += found
        for figure in found:
            print("{name}: {value} {unit} (peer: {peer}, ratio {ratio})".format(**figure), flush=True)
    if options.json:
        partial = options.json.with_name(options.json.name + ".tmp")
        partial.write_text(json.dumps(figures, indent=1) + "\n")
        partial.replace(options.json)
    return 0


if __name__ == "__main__":
    sys.exit(main())
