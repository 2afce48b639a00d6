#!/usr/bin/env python3
"""Finds the Godot that this project runs, and fetches it where there is none.

    engine.py path     prints the executable (fetches it first if need be; progress goes to stderr)
    engine.py dump     the same, and writes the engine's API description to build/api/ when the engine has changed

Order: $GODOT; godot4 or godot on PATH, if new enough; Debian's own package, unpacked into $PCG_ENGINE_DIR (default
.engine/), which touches nothing of the system.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from deps import ROOT, read_deps  # noqa: E402
from engine_fetch import FetchError, fetch  # noqa: E402

MINIMUM = read_deps()["ENGINE_MINIMUM"]


def engine_version(executable):
    """Returns what `godot --version` says, or "" if it cannot be run."""
    try:
        out = subprocess.run([executable, "--version"], capture_output=True, text=True, timeout=60, check=False).stdout
    except (OSError, subprocess.TimeoutExpired):
        return ""
    versions = [line.strip() for line in out.splitlines() if re.match(r"\d+\.\d+", line.strip())]
    return versions[-1] if versions else ""


def is_new_enough(version):
    numbers = [int(n) for n in re.findall(r"\d+", version)[:2]]
    return numbers >= [int(n) for n in MINIMUM.split(".")]


def from_environment():
    """Returns $GODOT, or None where it is not set; what is set and does not work is an error, not a reason to go on."""
    named = os.environ.get("GODOT")
    if not named:
        return None
    executable = shutil.which(named)
    version = engine_version(executable) if executable else ""
    if not version:
        raise FetchError(f"GODOT={named} does not run. Set it to a Godot {MINIMUM} or newer, or unset it.")
    if not is_new_enough(version):
        raise FetchError(f"GODOT={named} is {version}; {MINIMUM} or newer is needed. Set it to another one, or unset it.")
    return os.path.abspath(executable)


def from_path():
    for name in ("godot4", "godot"):
        executable = shutil.which(name)
        if executable and is_new_enough(engine_version(executable)):
            return executable
    return None


def engine_directory():
    return Path(os.environ.get("PCG_ENGINE_DIR") or ROOT / ".engine").absolute()


def find_engine():
    named = from_environment()
    if named:
        return named
    return from_path() or str(fetch(engine_directory()))


def dump_api(executable, directory=ROOT / "build" / "api"):
    """Writes extension_api.json and gdextension_interface.{h,json} where the engine differs from the last dump."""
    stamp = directory / "engine.txt"
    identity = f"{engine_version(executable)} {executable}\n"
    wanted = ["extension_api.json", "gdextension_interface.h"]
    if stamp.is_file() and stamp.read_text() == identity and all((directory / w).is_file() for w in wanted):
        return
    work = directory.with_name("api.tmp")
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    command = [executable, "--headless", "--dump-extension-api-with-docs", "--dump-gdextension-interface"]
    for extra in (["--dump-gdextension-interface-json"], []):
        done = subprocess.run(command + extra, cwd=work, capture_output=True, text=True, timeout=300, check=False)
        if all((work / w).is_file() for w in wanted):
            break
    else:
        raise FetchError(f"{executable} did not write its API description:\n{done.stdout}{done.stderr}")
    (work / "engine.txt").write_text(identity)
    shutil.rmtree(directory, ignore_errors=True)
    work.rename(directory)


def main(arguments):
    if arguments not in (["path"], ["dump"]):
        print(__doc__, file=sys.stderr)
        return 2
    try:
        executable = find_engine()
        if arguments == ["dump"]:
            dump_api(executable)
    except FetchError as error:
        print(f"engine: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("engine: stopped; nothing half-made was left", file=sys.stderr)
        return 130
    print(executable)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
