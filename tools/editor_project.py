#!/usr/bin/env python3
"""Makes a project below build/ anew: a project with a copy of the addon and its rules, as somebody has who installed it, and a second plugin that
runs tests/editor. Tests may change its files; the checkout stays as it is."""

import shutil

from deps import ROOT

SETTINGS = """config_version=5

[application]

config/name="PCG editor tests"
config/features=PackedStringArray("4.6")

[debug]

gdscript/warnings/exclude_addons=false
gdscript/warnings/untyped_declaration=2

[editor_plugins]

enabled=PackedStringArray("res://addons/pcg/plugin.cfg", "res://tests/editor/plugin.cfg")
"""
COPIED = ("rules", "tests/editor", "tests/godot/suite.gd", "tests/godot/runner.gd", "tests/godot/city_for_tests.gd")


def make_project(name="editor_project"):
    """Returns its path. The built library is linked, not copied."""
    project = ROOT / "build" / name
    shutil.rmtree(project, ignore_errors=True)
    shutil.copytree(ROOT / "addons/pcg", project / "addons/pcg", ignore=shutil.ignore_patterns("bin"))
    (project / "addons/pcg/bin").symlink_to(ROOT / "addons/pcg/bin")
    for copied in COPIED:
        (project / copied).parent.mkdir(parents=True, exist_ok=True)
        (shutil.copytree if (ROOT / copied).is_dir() else shutil.copy)(ROOT / copied, project / copied)
    (project / "project.godot").write_text(SETTINGS)
    (project / ".godot").mkdir()
    (project / ".godot/extension_list.cfg").write_text("res://addons/pcg/pcg.gdextension\n")
    return project


if __name__ == "__main__":
    print(make_project())
