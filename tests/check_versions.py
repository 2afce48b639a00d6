#!/usr/bin/env python3
"""Checks that the version in deps.env is the one in the files that cannot read it."""

import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools"))
from deps import read_deps  # noqa: E402


def main():
    version = read_deps()["VERSION"]
    plugin = re.search(r'^version="(.*)"$', (ROOT / "addons/pcg/plugin.cfg").read_text(), re.MULTILINE)
    found = {
        "addons/pcg/plugin.cfg": plugin[1] if plugin else "none",
        "vcpkg.json": json.loads((ROOT / "vcpkg.json").read_text())["version"],
    }
    wrong = [f"{name}:1: version {value}; deps.env says {version}" for name, value in found.items() if value != version]
    print("\n".join(wrong) if wrong else f"versions: {version} everywhere")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
