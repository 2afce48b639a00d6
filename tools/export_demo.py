#!/usr/bin/env python3
"""Exports the demo as a game with Debian's export templates, and plays an hour of each: headless, and on a screen in memory where there is
xvfb-run. What is not as it should be is told, and the exit status is 1.

    export_demo.py --engine GODOT      the games stay in build/export/

The games run on this machine only: Debian's templates want the libraries that came with the engine. For players, use Godot's own templates.
"""

import argparse
import json
import re
import shutil
import sys
import zipfile
from pathlib import Path

from deps import ROOT, read_deps
from engine import engine_directory, engine_version
from engine_fetch import FetchError, fetch_templates
from run_tests import OF_SCREEN_IN_MEMORY, complaints
from run_tests import run as run_program

WORK = ROOT / "build/export"
TIME_LIMIT = 600  # seconds for one run; drawn without a graphics card on a busy machine, the hour takes minutes
KINDS = ("debug", "release")
# The engine's own: Debian's release template says this of every Container in any game's scene when the game ends.
NOT_OURS = re.compile(r"^ERROR: Attempt to disconnect a nonexistent connection from .*'(size_flags|visibility)_changed', callable: ''"
                      "|" + OF_SCREEN_IN_MEMORY.pattern)
PRESET = """[preset.0]
name="Linux"
platform="Linux"
runnable=true
export_filter="all_resources"
include_filter="*.csv"
exclude_filter=""
export_path="demo.x86_64"
[preset.0.options]
binary_format/architecture="x86_64"
custom_template/debug="{debug}"
custom_template/release="{release}"
"""
# Tells what there is of the showcase once its people have lived an hour, then ends the game.
CHECK = """extends Node

const HOUR := 3600.0

func _ready() -> void:
	RenderingServer.render_loop_enabled = false # while the city grows: without a graphics card that takes longer than all the rest
	await get_tree().process_frame
	var city: PCGCity = get_tree().current_scene.city
	var citizens: CitizenManager = get_tree().current_scene.citizens
	city.use_collision = true # it grows, and is not built yet
	await citizens.simulation_started
	for frame: int in 10: # the server of physics takes in what is new
		await get_tree().physics_frame
	var told := {"lots": city.get_statistics()["lots"], "errors": city.get_diagnostics().filter(_is_error), "textures": 0, "ways": 0}
	told["raw_rules"] = FileAccess.file_exists("res://demo/steps/1_one_lot.cga")
	for node: Node in city.find_children("*", "MeshInstance3D", true, false):
		var mesh: Mesh = node.mesh
		for surface: int in mesh.get_surface_count():
			var material := mesh.surface_get_material(surface) as BaseMaterial3D
			told["textures"] += int(material != null and material.albedo_texture != null)
	var doors: Array[Node] = city.find_children("*", "PCGEntrance", true, false)
	var map: RID = get_viewport().find_world_3d().navigation_map
	for frame: int in 600: # and that of navigation, in its own time
		if NavigationServer3D.map_get_path(map, doors[0].global_position, doors[-1].global_position, true).size() > 1:
			break
		await get_tree().physics_frame
	for i: int in 20:
		var from: Vector3 = doors[i].global_position
		told["ways"] += int(NavigationServer3D.map_get_path(map, from, doors[-1 - i].global_position, true).size() > 1)
	var door: Vector3 = doors[0].global_position
	var ray := PhysicsRayQueryParameters3D.create(door + Vector3.UP * 100.0, door + Vector3.DOWN * 5.0)
	told["collision"] = not get_viewport().find_world_3d().direct_space_state.intersect_ray(ray).is_empty()
	citizens.jump_to(citizens.day, 7.5 * HOUR)
	citizens.advance(HOUR)
	RenderingServer.render_loop_enabled = true
	for frame: int in 30:
		await get_tree().process_frame
	var lived: Dictionary = citizens.get_statistics()
	told["persons"] = lived["persons"]
	told["trips"] = lived["trips"]
	told["outside"] = lived["outside"]
	told["agents"] = citizens.get_agent_view().get_agent_count()
	if DisplayServer.get_name() != "headless":
		await RenderingServer.frame_post_draw
		get_viewport().get_texture().get_image().save_png(OS.get_executable_path().get_base_dir().path_join("picture.png"))
	print("EXPORTED ", JSON.stringify(told))
	get_tree().quit()


func _is_error(diagnostic: Dictionary) -> bool:
	return diagnostic["severity"] == "error"
"""


def run(command, folder):
    """Everything that is printed. The game has a home of its own."""
    status, text = run_program(command, {f"XDG_{kind}_HOME": str(WORK / "home") for kind in ("DATA", "CONFIG", "CACHE")}, folder, TIME_LIMIT)
    if status is None:
        return f"{text}\nERROR: still running after {TIME_LIMIT} s\n"
    return text + (f"ERROR: ended with status {status}\n" if status else "")


def make_project(templates):
    shutil.rmtree(WORK, ignore_errors=True)
    project = WORK / "project"
    with zipfile.ZipFile(ROOT / f"out/pcg-{read_deps()['VERSION']}-demo.zip") as archive:
        archive.extractall(project)
    (project / "check.gd").write_text(CHECK)
    settings = project / "project.godot"
    settings.write_text(settings.read_text() + '\n[autoload]\n\nCheck="*res://check.gd"\n')
    (project / "export_presets.cfg").write_text(PRESET.format(**templates))
    (project / ".godot").mkdir()
    (project / ".godot/extension_list.cfg").write_text("res://addons/pcg/pcg.gdextension\n")
    return project


def is_whole(told):
    """What a game needs of everything: its lots, pictures, ground to walk on and to stand on, and people who live."""
    return (told["lots"] >= 300 and not told["errors"] and told["textures"] > 0 and told["ways"] >= 15 and told["collision"]
            and told["persons"] >= 1900 and told["trips"] > 100 and told["outside"] > 0 and told["agents"] > 0)


def judge(label, text):
    """Prints what a run came to; returns whether it is as it should be."""
    line = re.search(r"^EXPORTED (.*)$", text, re.MULTILINE)
    wrong = [line for line in complaints(text) if not NOT_OURS.match(line)]
    told = json.loads(line[1]) if line else {}
    good = bool(told) and is_whole(told) and not wrong
    print(f"export: {label}: {'as it should be' if good else 'NOT as it should be'}; {json.dumps(told) if told else 'it told nothing'}")
    if not good:
        print("\n".join(wrong))
    return good


def export(engine, project, kind):
    target = WORK / kind / "demo.x86_64"
    target.parent.mkdir()
    text = run([engine, "--headless", "--path", ".", f"--export-{kind}", "Linux", target], project)
    if target.is_file() and not complaints(text):
        return target
    print(f"export: the {kind} game could not be made\n{text}")
    return None


def play(game, kind):
    good = judge(f"{kind}, headless", run([game, "--headless"], game.parent))
    if not shutil.which("xvfb-run"):
        print("export: no xvfb-run here, so not played on a screen")
        return good
    screen = ["xvfb-run", "-a", "-s", "-screen 0 960x540x24", game, "--rendering-driver", "opengl3", "--audio-driver", "Dummy",
              "--disable-vsync", "--resolution", "960x540"]
    return judge(f"{kind}, on a screen", run(screen, game.parent)) and good


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--engine", required=True)
    engine = parser.parse_args().engine
    try:
        templates = fetch_templates(engine_directory(), engine_version(engine))
    except FetchError as error:
        print(f"export: {error}", file=sys.stderr)
        return 1
    project = make_project(templates)
    run([engine, "--headless", "--path", ".", "--import"], project)
    games = {kind: export(engine, project, kind) for kind in KINDS}
    return 0 if all([game and play(game, kind) for kind, game in games.items()]) else 1


if __name__ == "__main__":
    sys.exit(main())
