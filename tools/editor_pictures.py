#!/usr/bin/env python3
"""Takes pictures of the editor with the addon at work, on a screen in memory (needs xvfb-run).

    editor_pictures.py --engine GODOT [--light] [--scale 100|200] [--size 1280x800] FOLDER
"""

import argparse
import os
import subprocess
import sys
from pathlib import Path

from deps import ROOT
from editor_project import make_project

SCALES = {"100": 2, "200": 6}  # of the editor's setting
SETTINGS = """[gd_resource type="EditorSettings" format=3]

[resource]
interface/editor/display_scale = {scale}
interface/theme/color_preset = "{preset}"
interface/theme/follow_system_theme = false
interface/editor/save_on_focus_loss = false
interface/editor/single_window_mode = true
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--engine", required=True)
    parser.add_argument("--light", action="store_true")
    parser.add_argument("--scale", choices=SCALES, default="100")
    parser.add_argument("--size", default="1280x800")
    parser.add_argument("folder", type=Path)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    project = make_project("picture_project")
    home = ROOT / "build/picture_home"
    settings = home / "godot/editor_settings-4.6.tres"
    settings.parent.mkdir(parents=True, exist_ok=True)
    settings.write_text(SETTINGS.format(scale=SCALES[options.scale], preset="Light" if options.light else "Default"))
    environment = {**os.environ, **{f"XDG_{kind}_HOME": str(home) for kind in ("DATA", "CONFIG", "CACHE")}}
    command = ["xvfb-run", "-a", "-s", f"-screen 0 {options.size}x24", options.engine, "--editor", "--no-header", "--path", project,
               "--rendering-driver", "opengl3", "--resolution", options.size, "--", "--pictures", options.folder.resolve()]
    return subprocess.run([str(part) for part in command], check=False, env=environment).returncode


if __name__ == "__main__":
    sys.exit(main())
