#!/usr/bin/env python3
"""Runs the fuzz targets in build/fuzz, each on its corpus in fuzz/corpus and on what earlier runs found.

    run_fuzz.py [NAME..] [--seconds N]

New inputs that reach new code stay in build/fuzz/corpus; an input that breaks a target is kept in build/fuzz and named.
"""

import argparse
import subprocess
import sys
from pathlib import Path

from deps import ROOT

PROGRAMS = ROOT / "build/fuzz"
LONGEST = 4096  # bytes of an input
SLOWEST = 10  # seconds for one input


def run(program, seconds):
    """Returns whether the target lived through all inputs."""
    found = PROGRAMS / "corpus" / program.name
    found.mkdir(parents=True, exist_ok=True)
    print(f"{program.name}: {seconds} s", flush=True)
    log = PROGRAMS / f"{program.name}.log"
    with log.open("wb") as output:
        done = subprocess.run([program, f"-max_total_time={seconds}", f"-max_len={LONGEST}", f"-timeout={SLOWEST}", "-rss_limit_mb=2048",
                               f"-artifact_prefix={PROGRAMS}/{program.name}-", found, ROOT / "fuzz/corpus" / program.name],
                              cwd=ROOT, stdout=output, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        lines = log.read_text(errors="replace").splitlines()
        told = [line for line in lines if "ERROR" in line or "SUMMARY" in line or "runtime error" in line or "Test unit written" in line]
        print("\n".join(told or lines[-20:]), file=sys.stderr)
    return done.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--seconds", type=int, default=60, metavar="N")
    options = parser.parse_args()
    programs = {path.name: path for path in sorted(PROGRAMS.glob("*")) if path.is_file() and not path.suffix and "-" not in path.name}
    unknown = [name for name in options.names if name not in programs]
    if unknown or not programs:
        print(f"run_fuzz: no target {', '.join(unknown)}; there are: {', '.join(programs)}", file=sys.stderr)
        return 2
    broken = [name for name in options.names or programs if not run(programs[name], options.seconds)]
    print(f"{len(broken)} broken" + (": " + ", ".join(broken) if broken else ""))
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
