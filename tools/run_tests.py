#!/usr/bin/env python3
"""Runs every suite of the project on what has been built, and closes with one line: `N passed, N failed`.

    run_tests.py --engine GODOT [--suffix .address-undefined] [--only SUITE] [WORD]

WORD keeps the tests whose name holds it. A suite that does not reach its own end counts as one failure.
"""

import argparse
import contextlib
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
from dataclasses import dataclass
from pathlib import Path

from deps import ROOT
from editor_project import TESTS, make_project, on_screen

TIME_LIMIT = 900  # seconds for one suite; a hang is a failure, not a wait

# What the engine says when something is wrong, at the beginning of a line.
ENGINE_COMPLAINT = re.compile(r"^\s*((USER |SCRIPT )?(ERROR|WARNING):|Parse Error|.*(ObjectDB instances? (was|were )?leaked|"
                              r"Leaked instance|RID allocations? of type|still in use at exit|Orphan StringName))")
OF_SCREEN_IN_MEMORY = re.compile(r"^WARNING: Could not set V-Sync mode")


@dataclass
class Outcome:
    passed: int = 0
    failed: int = 0
    text: str = ""  # shown only if something failed


def run(command, environment=None, folder=ROOT, limit=TIME_LIMIT):
    """Returns (exit status, everything printed); the status is None where the limit, in seconds, ended the program. What the program began ends with it:
    a screen in memory, and what is shown there."""
    child = subprocess.Popen([str(part) for part in command], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, start_new_session=True,
                             stderr=subprocess.STDOUT, text=True, errors="replace", env={**os.environ, **(environment or {})})
    expired = []
    timer = threading.Timer(limit, lambda: (expired.append(True), end_all(child)))
    timer.start()
    try:
        text = child.communicate()[0]
    except BaseException:
        end_all(child)
        raise
    finally:
        timer.cancel()
    return (None if expired else child.returncode), text


def end_all(child):
    """Ends a program that began a session, and all that it began."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(child.pid, signal.SIGKILL)


def ending(status):
    if status is None:
        return f"stopped after {TIME_LIMIT} s without an end"
    return f"ended with status {status}" if status >= 0 else f"was killed by signal {-status}"


def run_check(script, *arguments):
    status, text = run([sys.executable, script, *arguments])
    return Outcome(1, 0) if status == 0 else Outcome(0, max(1, len(re.findall(r":\d+: ", text))), text)


def run_unittest(folder, options):
    command = [sys.executable, "-m", "unittest", "discover", "-s", folder]
    status, text = run(command + (["-k", options.word] if options.word else []), {"GODOT": options.engine})
    ran = re.search(r"^Ran (\d+) tests? in", text, re.MULTILINE)
    if not ran or status is None:
        return Outcome(0, 1, f"{text}\n{folder} {ending(status)}")
    bad = sum(int(n) for n in re.findall(r"(?:failures|errors|unexpected successes)=(\d+)", text))
    skipped = sum(int(n) for n in re.findall(r"skipped=(\d+)", text))
    return Outcome(int(ran[1]) - bad - skipped, bad, text)


def run_bindings(options):
    """The bindings' own tests build their own little extension, whose objects ccache remembers where it is installed."""
    compiler = os.environ.get("CXX", "g++")
    remembered = compiler if "ccache" in compiler or not shutil.which("ccache") else f"ccache {compiler}"
    status, text = run(["bindings/tests/run.sh", options.engine], {"CXX": remembered})
    closing = re.search(r"^(\d+) passed, (\d+) failed$", text.strip().splitlines()[-1] if text.strip() else "")
    if not closing or (status != 0 and closing[2] == "0"):
        return Outcome(0, 1, f"{text}\nbindings/tests/run.sh {ending(status)} and without a closing line")
    return Outcome(int(closing[1]), int(closing[2]), text)


def run_doctest(program, options):
    status, text = run([program, "--no-colors"] + ([f"-tc=*{options.word}*"] if options.word else []))
    summary = re.search(r"test cases:\s*\d+ \|\s*(\d+) passed \|\s*(\d+) failed", text)
    if not summary:
        return Outcome(0, 1, f"{text}\n{program} {ending(status)} and printed no summary")
    passed, failed = int(summary[1]), int(summary[2])
    if status != 0 and failed == 0:  # a sanitizer's complaint at exit
        failed = 1
        text += f"\n{program} {ending(status)}"
    return Outcome(passed, failed, text)


def complaints(text):
    """The engine's complaints that no test announced, and the announcements that nothing followed."""
    lines = text.splitlines()
    expected = {line.split(": ", 1)[1] for line in lines if line.startswith("EXPECTED MESSAGE: ")}
    found = [line for line in lines if ENGINE_COMPLAINT.match(line)]
    unexpected = [line for line in found if not any(e in line for e in expected)]
    missing = [f"expected, and not seen: {e}" for e in sorted(expected) if not any(e in line for line in found)]
    return unexpected + missing


def run_import_check():
    """The engine's own words when it last imported the project."""
    log = ROOT / "build/import.log"
    wrong = complaints(log.read_text(errors="replace")) if log.is_file() else ["build/import.log: the project was not imported"]
    return Outcome(0 if wrong else 1, len(wrong), "\n".join(wrong))


def run_godot(options):
    return run_in_engine(options, "godot", [options.engine, "--headless", "--no-header", "--path", ".", "--script", "tests/godot/run.gd"])


def run_editor(options):
    return run_in_engine(options, "editor", [options.engine, "--headless", "--editor", "--no-header", "--path", make_project()])


def run_screen(options):
    """The editor as a user has it, on a screen in memory; nothing where there is none."""
    if not shutil.which("xvfb-run"):
        print("screen: no xvfb-run here, so nobody clicked in the editor; ./dev setup installs it", file=sys.stderr)
        return Outcome()
    command, home = on_screen(options.engine, make_project("screen_project", plugins=(TESTS,)))
    return run_in_engine(options, "screen", command, home)


def run_in_engine(options, name, command, environment=None):
    status, text = run(command + (["--", options.word] if options.word else []), environment)
    marker = re.search(rf"^{name} suite ended: (\d+) passed, (\d+) failed$", text, re.MULTILINE)
    if not marker:
        return Outcome(0, 1, f"{text}\nthe {name} suite {ending(status)} before its end marker")
    passed, failed = int(marker[1]), int(marker[2])
    wrong = [line for line in complaints(text) if not OF_SCREEN_IN_MEMORY.match(line)]
    if status != 0 and failed == 0:
        wrong.append(f"the engine {ending(status)} after the end marker")
    return Outcome(passed, failed + len(wrong), text + "\n" + "\n".join(wrong))


def suites(options):
    """(name, function), roughly the quick ones first; those that cannot be narrowed down to a word run only without one."""
    core = ROOT / f"build/tests/pcg_tests{options.suffix}"
    if not options.word:
        for check in ("layers", "size", "versions"):
            yield check, lambda check=check: run_check(ROOT / f"tests/check_{check}.py")
        yield "docs", lambda: run_check(ROOT / "tools/generate_docs.py", "--check", "--engine", options.engine)
    yield "core", lambda: run_doctest(core, options)
    yield "tools", lambda: run_unittest("tests/tools", options)
    if not options.word:
        yield "bindings", lambda: run_bindings(options)
        yield "import", run_import_check
    yield "godot", lambda: run_godot(options)
    yield "editor", lambda: run_editor(options)
    yield "screen", lambda: run_screen(options)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--engine", default="")
    parser.add_argument("--suffix", default="")
    parser.add_argument("--only", default="")
    parser.add_argument("word", nargs="?", default="")
    options = parser.parse_args()
    total = Outcome()
    for name, suite in suites(options):
        if options.only and name != options.only:
            continue
        started = time.monotonic()
        print(f"{name} ..", file=sys.stderr, flush=True)
        outcome = suite()
        if outcome.failed:
            print(outcome.text)
        print(f"{name}: {outcome.passed} passed, {outcome.failed} failed, {time.monotonic() - started:.1f} s", flush=True)
        total.passed += outcome.passed
        total.failed += outcome.failed
    print(f"{total.passed} passed, {total.failed} failed")
    return 0 if total.failed == 0 and total.passed > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
