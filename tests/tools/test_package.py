"""The two zips: what they hold, that the same files give the same bytes, and that a new user gets a living day from it."""

import contextlib
import io
import os
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import package  # noqa: E402
from run_tests import complaints  # noqa: E402

FILES = ("README.md", "LICENSE.md", "CHANGELOG.md", "CONTRIBUTING.md", "project.godot", "docs/.gdignore", "docs/language-cga.md",
         "docs/architecture.md", "docs/images/park.png", "docs/getting-started.md", "docs/images/editor_city.png", "rules/cga/park.cga", "rules/cga/park.cga.uid", "rules/cga/assets/grass.png",
         "rules/cga/assets/grass.png.import", "rules/agenda/weekday.pcg",
         "rules/data/table.csv", "rules/data/table.csv.import", "rules/paper/building.cga", "addons/pcg/plugin.cfg", "addons/pcg/bin/libpcg.x.so")
PACKED = ("CHANGELOG.md", "LICENSE.md", "README.md", "bin/libpcg.x.so", "docs/.gdignore", "docs/getting-started.md",
          "docs/images/editor_city.png", "docs/language-cga.md", "plugin.cfg", "rules/agenda/weekday.pcg", "rules/cga/assets/grass.png", "rules/cga/assets/grass.png.import", "rules/cga/park.cga", "rules/data/table.csv",
          "rules/data/table.csv.import", "rules/paper/building.cga")

HERE_ONLY = ("CONTRIBUTING.md", "docs/architecture.md", "docs/images/park.png")


def write_quietly(target, entries):
    with contextlib.redirect_stdout(io.StringIO()):
        package.write_package(target, entries)


class Package(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.saved = package.ROOT, package.ADDON
        package.ROOT, package.ADDON = self.root, self.root / "addons/pcg"
        self.addCleanup(self.restore)
        for name in FILES:
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(name)

    def restore(self):
        package.ROOT, package.ADDON = self.saved

    def write(self, name, entries):
        write_quietly(self.root / "out" / name, entries)

    def test_it_holds_the_addon_with_its_rules_and_texts_and_nothing_else(self):
        self.write("a.zip", package.addon_entries())
        with zipfile.ZipFile(self.root / "out/a.zip") as archive:
            self.assertEqual(archive.namelist(), ["addons/pcg/" + name for name in PACKED])

    def test_the_demo_is_a_project_with_everything_where_it_is_here(self):
        for name in ("demo/showcase.tscn", "demo/showcase.gd.uid", "tests/godot/run.gd", "src/core/a.cpp"):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(name)
        self.write("demo.zip", package.demo_entries())
        with zipfile.ZipFile(self.root / "out/demo.zip") as archive:
            self.assertEqual(archive.namelist(), sorted((*(name for name in FILES if name not in HERE_ONLY), "demo/showcase.tscn", "demo/showcase.gd.uid")))

    def test_the_time_of_the_files_does_not_change_a_byte(self):
        self.write("a.zip", package.addon_entries())
        os.utime(self.root / "addons/pcg/plugin.cfg", (1, 1))
        self.write("b.zip", package.addon_entries())
        self.assertEqual((self.root / "out/a.zip").read_bytes(), (self.root / "out/b.zip").read_bytes())

    def test_pictures_keep_how_they_are_imported_but_not_who_they_are(self):
        (self.root / "rules/cga/assets/grass.png.import").write_text('[remap]\nuid="uid://a"\n[params]\nmipmaps/generate=true\n')
        self.assertEqual(dict(package.addon_entries())["addons/pcg/rules/cga/assets/grass.png.import"], b"[remap]\n[params]\nmipmaps/generate=true\n")

    def test_what_is_said_of_the_repository_stays_there(self):
        (self.root / "README.md").write_text("a\n\n<!-- repository -->\nb\n\nc\n<!-- /repository -->\n\n- d\n<!-- repository -->\n- e\n"
                                             "<!-- /repository -->\n\nf\n")
        self.assertEqual(dict(package.addon_entries())["addons/pcg/README.md"], b"a\n\n\n- d\n\nf\n")


class Texts(unittest.TestCase):
    def test_no_link_of_the_packed_texts_is_dead(self):
        packed = dict(package.addon_entries())
        texts = [name for name in packed if name.endswith(".md")]
        self.assertIn("addons/pcg/README.md", texts)
        for name in texts:
            for target in re.findall(r"\]\(([^)#\s]+)", packed[name].decode()):
                if not re.match(r"\w+:", target):
                    with self.subTest(text=name, link=target):
                        self.assertIn(os.path.normpath(os.path.join(os.path.dirname(name), target)), packed)


# The scene of the README's steps 3 and 4, as the editor would save it. Time runs fast, so that the day is over soon.
SCENE = """[gd_scene format=3]

[ext_resource type="Script" path="res://town.gd" id="1"]
[ext_resource type="Script" path="res://watch.gd" id="2"]
{rules}
[ext_resource type="PCGRuleSet" path="res://addons/pcg/rules/agenda/weekday.pcg" id="agenda"]

[sub_resource type="PCGLayout" id="layout"]

{types}
[sub_resource type="PCGHouseholdTable" id="households"]
file = "res://addons/pcg/rules/data/households_us_acs2023.csv"

[node name="Town" type="Node3D"]
script = ExtResource("1")

[node name="PCGCity" type="PCGCity" parent="."]
layout = SubResource("layout")
lot_types = Array[PCGLotType]([{list}])

[node name="CitizenManager" type="CitizenManager" parent="." node_paths=PackedStringArray("city")]
city = NodePath("../PCGCity")
rules = ExtResource("agenda")
household_table = SubResource("households")
person_count = 100
time_scale = 3600.0
check_promises = true

[node name="Watch" type="Node" parent="."]
script = ExtResource("2")
"""
RULES = '[ext_resource type="PCGRuleSet" path="res://addons/pcg/rules/cga/{0}.cga" id="{0}"]'
TYPE = """[sub_resource type="PCGLotType" id="type_{0}"]
type = "{0}"
rules = ExtResource("{0}")
"""
WATCH = """extends Node
## Ends the game after the first whole day.

func _ready() -> void:
	var citizens: CitizenManager = $"../CitizenManager"
	citizens.day_started.connect(func(day: int) -> void:
		print("day ", day, ": ", citizens.get_statistics()["trips"], " trips, ", citizens.get_broken_promises())
		if day == 2:
			get_tree().quit())
"""
# Opens a page of the editor's help, as F1 does, and prints it.
HELP_PLUGIN = """@tool
extends EditorPlugin

func _enter_tree() -> void:
	_show.call_deferred()


func _show() -> void:
	var editor: ScriptEditor = EditorInterface.get_script_editor()
	for frame: int in 600:
		await get_tree().process_frame
		editor.goto_help("class_name:PCGCity")
		for page: Node in editor.find_children("*", "EditorHelp", true, false):
			for text: RichTextLabel in page.find_children("*", "RichTextLabel", true, false):
				if text.get_parsed_text().contains("PCGCity"):
					print("HELP: ", text.get_parsed_text().replace("\\n", " "))
					get_tree().quit()
					return
	get_tree().quit(1)
"""


@unittest.skipUnless(os.environ.get("GODOT") and (ROOT / "addons/pcg/bin").is_dir(), "needs an engine in $GODOT and the built addon")
class NewUser(unittest.TestCase):
    """An empty project with the zip in it, and the README to the letter."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Path(folder.name) / "game"
        self.project.mkdir()
        write_quietly(Path(folder.name) / "pcg.zip", package.addon_entries())
        with zipfile.ZipFile(Path(folder.name) / "pcg.zip") as archive:
            archive.extractall(self.project)
        (self.project / "project.godot").write_text('config_version=5\n\n[application]\n\nconfig/name="A game"\n\n'
                                                    '[editor_plugins]\n\nenabled=PackedStringArray("res://addons/pcg/plugin.cfg")\n')

    def run_engine(self, *arguments):
        """Everything that the engine prints; it must not complain of anything."""
        home = str(self.project.parent / "home")
        environment = {**os.environ, "XDG_DATA_HOME": home, "XDG_CONFIG_HOME": home, "XDG_CACHE_HOME": home}
        done = subprocess.run([os.environ["GODOT"], "--headless", "--path", str(self.project), *arguments], capture_output=True, text=True,
                              env=environment, check=False, timeout=300, stdin=subprocess.DEVNULL)
        printed = done.stdout + done.stderr
        self.assertEqual(done.returncode, 0, printed)
        self.assertEqual(complaints(printed), [], printed)
        return printed

    def open_once(self):
        """Long enough for the editor to note the help of the classes: closed earlier, it crashes (godotengine/godot#111048)."""
        self.run_engine("--editor", "--frame-delay", "100", "--quit-after", "60")

    def write_game(self):
        readme = (self.project / "addons/pcg/README.md").read_text()
        (self.project / "town.gd").write_text(re.search(r"```gdscript\n(.*?)```", readme, re.DOTALL)[1])
        (self.project / "watch.gd").write_text(WATCH)
        names = re.search(r"3\. Add a \*\*PCGCity\*\*.*?(?=\n4\.)", readme, re.DOTALL)[0]
        types = [name for name in re.findall(r"`(\w+)`", names)]
        self.assertEqual(types, ["house", "workplace", "school", "shop", "park"])
        (self.project / "town.tscn").write_text(SCENE.format(
            rules="\n".join(RULES.format(name) for name in types), types="\n".join(TYPE.format(name) for name in types),
            list=", ".join(f'SubResource("type_{name}")' for name in types)))
        project = self.project / "project.godot"
        project.write_text(project.read_text().replace("[application]\n\n", '[application]\n\nrun/main_scene="res://town.tscn"\n'))

    def test_the_five_steps_of_the_readme_give_a_living_day(self):
        self.open_once()
        self.write_game()
        printed = self.run_engine("--fixed-fps", "60")
        self.assertRegex(printed, r"\d\d:\d\d \w+ .* leaves building \d+")
        day = re.search(r"day 2: (\d+) trips, (\{.*\})", printed)
        self.assertTrue(day, printed)
        self.assertGreater(int(day[1]), 100)
        self.assertFalse(re.search(r": [1-9]", day[2]), day[2])

    def test_the_help_of_the_editor_knows_the_classes(self):
        plugin = self.project / "addons/help"
        plugin.mkdir()
        (plugin / "plugin.cfg").write_text('[plugin]\nname="Help"\ndescription=""\nauthor=""\nversion="1"\nscript="plugin.gd"\n')
        (plugin / "plugin.gd").write_text(HELP_PLUGIN)
        self.open_once()
        project = self.project / "project.godot"
        project.write_text(project.read_text().replace('plugin.cfg")', 'plugin.cfg", "res://addons/help/plugin.cfg")'))
        printed = self.run_engine("--editor")
        self.assertRegex(printed, r"HELP: .*Grows a city from a layout and rules\..*Emitted once at the end of every generation")


if __name__ == "__main__":
    unittest.main()
