#!/usr/bin/env python3
"""Takes pictures of the editor with the addon at work, on a screen in memory (needs xvfb-run).

    editor_pictures.py --engine GODOT [--light] [--scale 100|200] [--size 1280x800] FOLDER
"""

import argparse
import os
import subprocess
import sys
from pathlib import Path

from editor_project import SCALES, make_project, on_screen


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--engine", required=True)
    parser.add_argument("--light", action="store_true")
    parser.add_argument("--scale", choices=SCALES, default="100")
    parser.add_argument("--size", default="1280x800")
    parser.add_argument("folder", type=Path)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    command, home = on_screen(options.engine, make_project("picture_project"), options.size, options.scale, options.light)
    command += ["--", "--pictures", options.folder.resolve()]
    return subprocess.run([str(part) for part in command], check=False, env={**os.environ, **home}).returncode


if __name__ == "__main__":
    sys.exit(main())
