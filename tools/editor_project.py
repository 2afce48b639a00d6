#!/usr/bin/env python3
"""Makes a project below build/ anew: a project with a copy of the addon and its rules, as somebody has who installed it, and a second plugin that
runs tests/editor. Tests may change its files; the checkout stays as it is. And opens it on a screen in memory, where xvfb-run is."""

import os
import shutil
import subprocess

from deps import ROOT
from engine import engine_version

SETTINGS = """config_version=5

[application]

config/name="PCG editor tests"
config/features=PackedStringArray("4.6")

[debug]

gdscript/warnings/exclude_addons=false
gdscript/warnings/untyped_declaration=2

[editor_plugins]

enabled=PackedStringArray({plugins})
"""
ADDON = "res://addons/pcg/plugin.cfg"
TESTS = "res://tests/editor/plugin.cfg"
EDITOR_SETTINGS = """[gd_resource type="EditorSettings" format=3]

[resource]
interface/editor/display_scale = {scale}
interface/theme/color_preset = "{preset}"
interface/theme/follow_system_theme = false
interface/editor/save_on_focus_loss = false
interface/editor/single_window_mode = true
"""
SCALES = {"100": 2, "200": 6}  # of the editor's setting
COPIED = ("rules", "tests/editor", "tests/godot/suite.gd", "tests/godot/runner.gd", "tests/godot/city_for_tests.gd")


def make_project(name="editor_project", plugins=(ADDON, TESTS)):
    """Returns its path. The built library is linked, not copied. `plugins` are switched on in it."""
    project = ROOT / "build" / name
    shutil.rmtree(project, ignore_errors=True)
    shutil.copytree(ROOT / "addons/pcg", project / "addons/pcg", ignore=shutil.ignore_patterns("bin"))
    (project / "addons/pcg/bin").symlink_to(ROOT / "addons/pcg/bin")
    for copied in COPIED:
        (project / copied).parent.mkdir(parents=True, exist_ok=True)
        (shutil.copytree if (ROOT / copied).is_dir() else shutil.copy)(ROOT / copied, project / copied)
    (project / "project.godot").write_text(SETTINGS.format(plugins=", ".join(f'"{plugin}"' for plugin in plugins)))
    (project / ".godot").mkdir()
    (project / ".godot/extension_list.cfg").write_text("res://addons/pcg/pcg.gdextension\n")
    return project


def know_script_help(engine, project):
    """On a screen the engine gathers the help of scripts when a project is opened first, on two threads of which one joins the other perhaps before that
    one is known: now and then, more often on a busy machine, the editor aborts with `std::system_error` (godotengine/godot#123273)."""
    command = [engine, "--headless", "--no-header", "--path", project, "--script", ROOT / "tools/empty_script_help.gd"]
    subprocess.run([str(part) for part in command], check=False, capture_output=True, stdin=subprocess.DEVNULL)


def know_engine_help(engine, project, home):
    """In a home where the engine has never been, it writes down its own help first, and for as long as it runs then the pages of extensions are empty."""
    if not list(home.glob("godot/cache/editor_doc_cache-*")):
        command = [engine, "--headless", "--editor", "--no-header", "--path", project, "--quit-after", "300"]
        folders = {name: str(home) for name in ("XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME")}
        subprocess.run([str(part) for part in command], check=False, capture_output=True, stdin=subprocess.DEVNULL, env=os.environ | folders)


def on_screen(engine, project, size="1280x800", scale="100", is_light=False):
    """Returns the command that opens a project in the editor on a screen in memory, and its environment: a home of its own with these settings."""
    home = project.with_name(project.name + "_home")
    settings = home / f"godot/editor_settings-{'.'.join(engine_version(engine).split('.')[:2])}.tres"
    settings.parent.mkdir(parents=True, exist_ok=True)
    settings.write_text(EDITOR_SETTINGS.format(scale=SCALES[scale], preset="Light" if is_light else "Default"))
    know_script_help(engine, project)
    know_engine_help(engine, project, home)
    command = ["xvfb-run", "-a", "-s", f"-screen 0 {size}x24", engine, "--editor", "--no-header", "--path", project,
               "--rendering-driver", "opengl3", "--audio-driver", "Dummy", "--resolution", size]
    return command, {f"XDG_{kind}_HOME": str(home) for kind in ("DATA", "CONFIG", "CACHE")}


if __name__ == "__main__":
    print(make_project())
