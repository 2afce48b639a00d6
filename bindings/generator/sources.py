"""Which classes of the engine do the sources use? Those whose headers they include."""

import json
import re
from pathlib import Path

_INCLUDE = re.compile(r'#\s*include\s*[<"]godot_cpp/classes/(\w+)\.hpp[>"]')
# Hand-written or made of several classes.
_NOT_A_CLASS = {"global_constants", "global_constants_binds", "ref", "wrapped"}
_ALWAYS = {"Object", "RefCounted"}


def included_headers(folders):
    """Header name of a class -> "file:line" of its first include."""
    found = {}
    for folder in folders:
        for path in sorted(Path(folder).rglob("*")):
            if path.suffix not in (".h", ".hpp", ".cpp", ".inc"):
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                match = _INCLUDE.search(line)
                if match and match[1] not in _NOT_A_CLASS:
                    found.setdefault(match[1], f"{path}:{number}")
    return found


def classes_of(api, headers):
    """Names of the included classes. An include of an unknown class ends the run with the place."""
    for header, place in headers.items():
        if header not in api.by_header:
            raise SystemExit(f"{place}: this engine has no class with a header '{header}.hpp'.")
    return {api.by_header[header] for header in headers}


def with_ancestors(api, names):
    closed = set()
    for name in set(names) | _ALWAYS:
        closed |= set(api.lineage(name))
    return closed


def profile_names(included):
    """The classes that upstream's build profile must list; it adds the ancestors itself."""
    return set(included) | _ALWAYS


def profile_classes(path):
    return set(json.loads(Path(path).read_text(encoding="utf-8"))["enabled_classes"])


def profile_text(names):
    return json.dumps({"enabled_classes": sorted(names)}, indent=4) + "\n"
