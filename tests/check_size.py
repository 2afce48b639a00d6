#!/usr/bin/env python3
"""Reports functions over 40 lines and files over 400, in C++, Python and GDScript.

A longer one explains itself with a comment that begins `Long because`: in or just above the function, or among the
first 20 lines of the file.
"""

import ast
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FUNCTION_LIMIT = 40  # lines, from the name to the closing brace
FILE_LIMIT = 400
FOLDERS = ["src", "addons", "bench", "bindings", "demo", "tests", "tools"]
EXCUSE = re.compile(r"(//|#)\s*Long because")


def blank(match):
    return re.sub(r"[^\n]", " ", match[0])


def cpp_code(text):
    """The text with comments, strings, characters and preprocessor lines blanked, line breaks kept."""
    text = re.sub(r'R"(\w*)\(.*?\)\1"', blank, text, flags=re.DOTALL)
    text = re.sub(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|(?<!\w)'(?:\\.|[^'\\\n])*'", blank, text, flags=re.DOTALL)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", blank, text, flags=re.MULTILINE)


def opens(header):
    """What a brace after `header` opens: "function", "scope" (a namespace or type) or "expression"."""
    header = re.sub(r"\b(alignas|requires)\s*\([^)]*\)", "", header).strip()
    if header.endswith(("=", ",", "return", "(")):
        return "expression"
    if re.search(r"\b(namespace|struct|class|union|enum|extern)\b[^()]*$", header) or "(" not in header:
        return "scope" if not header or re.search(r"\b(namespace|struct|class|union|enum|extern)\b", header) else "expression"
    if re.search(r"\)\s*(noexcept\s*)?:[^:].*[\w>]$", header, re.DOTALL):
        return "expression"  # a member that a constructor sets: `: _name{..}`
    return "function"


def cpp_functions(text):
    """Yields (first line, last line) of every function body that does not lie within another."""
    code, stack, header, start, line, depth = cpp_code(text), [], "", 1, 1, 0
    for character in code:
        inside = "function" in (kind for kind, _ in stack)
        if character == "\n":
            line += 1
        if character in "()" and not inside:
            depth += 1 if character == "(" else -1
        if character == "{":
            kind = "expression" if inside or depth > 0 else opens(header)
            stack.append((kind, start))
            header = header if kind == "expression" else ""
        elif character == "}":
            kind, first = stack.pop() if stack else ("scope", line)
            if kind == "function":
                yield first, line
            header = header + "{}" if kind == "expression" else ""
        elif character == ";" and not inside and depth == 0:
            header = ""
        elif not inside and not any(kind == "expression" for kind, _ in stack):
            if not header.strip():
                start = line
            header += character


def python_functions(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.lineno, node.end_lineno


def gdscript_functions(text):
    first, last = 0, 0
    for number, line in enumerate(text.splitlines() + ["end"], 1):
        if re.match(r"\S", line) and not line.startswith(("#", ")")):
            if first:
                yield first, last
            first = number if re.match(r"(static\s+)?func\b", line) else 0
        if line.strip():
            last = number


LANGUAGES = {".h": cpp_functions, ".hpp": cpp_functions, ".cpp": cpp_functions, ".py": python_functions,
             ".gd": gdscript_functions}


def check_file(path):
    text = path.read_text()
    lines = text.splitlines()
    name = path.relative_to(ROOT).as_posix()
    if len(lines) > FILE_LIMIT and not EXCUSE.search("\n".join(lines[:20])):
        yield f"{name}:1: {len(lines)} lines; {FILE_LIMIT} at most"
    for first, last in LANGUAGES[path.suffix](text):
        if last - first + 1 > FUNCTION_LIMIT and not EXCUSE.search("\n".join(lines[max(0, first - 4):last])):
            yield f"{name}:{first}: a function of {last - first + 1} lines; {FUNCTION_LIMIT} at most"


def main():
    files = sorted(p for f in FOLDERS for p in (ROOT / f).rglob("*") if p.suffix in LANGUAGES and p.is_file())
    problems = [problem for path in files for problem in check_file(path)]
    print("\n".join(problems) if problems else f"size: {len(files)} files keep to the limits")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
