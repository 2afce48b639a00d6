#!/usr/bin/env python3
"""Checks which folder includes which, against the table in docs/architecture.md, and what else the core must not use.

The compiler already keeps the engine out of the core; this keeps the rooms of the core apart.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def read_table(document):
    """Room (a folder below src/) -> the set of rooms that it may include, from the table "Rooms" of docs/architecture.md."""
    rows = re.findall(r"^\| `src/([\w/]+)` \|[^|]*\|([^|]*)\|$", document.read_text(), re.MULTILINE)
    every = {room for room, _ in rows if room.startswith("core/")}
    table = {}
    for room, text in rows:
        words = re.findall(r"[\w-]+", re.split(r"[.;]", text)[0])
        table[room] = every if "core" in words else {f"core/{word}" for word in words} & every
    return table


MAY_INCLUDE = read_table(ROOT / "docs/architecture.md")

# Third-party headers by their beginning -> the folders that may name them.
LIBRARIES = {
    "godot_cpp/": ["godot"],
    "gdextension_interface": ["godot"],
    "doctest/": [],
    "nlohmann/": ["core/io", "cli"],
    "tiny_gltf": ["core/io"],
    "stb_image": ["core/io"],
}

# Headers and words that would let results depend on the machine or reach outside, -> where they are allowed.
NOT_IN_CORE = {
    r"#include <(fstream|iostream|filesystem)>": ("input and output belong in core/io", ["core/io"]),
    r"\bstd::(uniform_\w+|normal_distribution|mt19937\w*|rand|random_device)\b|#include <random>": (
        "results would differ between machines; use core/base/random.h", []),
    r"\b(throw|try|catch)\b\s*[({\w]": ("the core is built without exceptions; return a Result", []),
}


def room_of(path):
    """The key of MAY_INCLUDE for a path below src, such as core/lang/parser.h, or "" where there is none."""
    parts = path.split("/")
    return next((room for room in ("/".join(parts[:2]), parts[0]) if room in MAY_INCLUDE), "")


def check_include(room, name, quoted):
    """Returns what is wrong with including `name` from `room`, or an empty string."""
    for beginning, rooms in LIBRARIES.items():
        if name.startswith(beginning):
            return "" if room in rooms else f"<{name}> is only for {', '.join(rooms) or 'tests'}"
    if not quoted:
        return ""
    target = room_of(name)
    if not target:
        return f'"{name}" is not named from src/, as "core/base/result.h" is'
    if target == room or target in MAY_INCLUDE[room]:
        return ""
    return f'{room} must not include "{name}"'


def without_comments_and_strings(text):
    pattern = r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\''
    return re.sub(pattern, lambda m: m[0] if m[0][0] == '"' and "/" in m[0] else "\n" * m[0].count("\n"), text,
                  flags=re.DOTALL)


def check_file(path):
    """Yields "file:line: what is wrong" for one source file below src/."""
    name = path.relative_to(ROOT / "src").as_posix()
    room = room_of(name)
    if not room:
        yield f"src/{name}:1: this folder is not in the table of docs/architecture.md"
        return
    for number, line in enumerate(without_comments_and_strings(path.read_text()).splitlines(), 1):
        include = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        problem = check_include(room, include[2], include[1] == '"') if include else ""
        if problem:
            yield f"src/{name}:{number}: {problem}"
        for pattern, (reason, allowed) in NOT_IN_CORE.items():
            if room.startswith("core/") and room not in allowed and re.search(pattern, line):
                yield f"src/{name}:{number}: {reason}"


def main():
    files = sorted(p for p in (ROOT / "src").rglob("*") if p.suffix in (".h", ".cpp"))
    problems = [problem for path in files for problem in check_file(path)]
    print("\n".join(problems) if problems else f"layers: {len(files)} files keep to the table")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
