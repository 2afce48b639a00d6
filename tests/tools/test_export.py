"""A game that was exported finds the models, pictures and texts of its rules, though the files themselves are not in it."""

import json
import os
import shutil
import struct
import subprocess
import tempfile
import unittest
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BOX = ("v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\nv 1 1 1\nv 0 1 1\n"
       "f 1 2 3 4\nf 8 7 6 5\nf 4 3 7 8\nf 2 1 5 6\nf 3 2 6 7\nf 1 4 8 5\n")
RULES = """@StartRule
Lot -->
	[ t('0.5, 0, '1) entrance(readTextFile("type.txt"), listSize(fileSearch("*.obj"))) NIL ]
	[ t(1, 0, 1) s(1, 1, 1) i("box.obj") Box. ]
	setupProjection(0, scope.xz, 1, 1) texture("wall.png") projectUV(0) Ground.
"""
SCENE = '[gd_scene load_steps=2 format=3]\n[ext_resource type="Script" path="res://main.gd" id="1"]\n' \
        '[node name="Main" type="Node3D"]\nscript = ExtResource("1")\n'
SCRIPT = """extends Node3D

func _ready() -> void:
	var type := PCGLotType.new()
	type.type = "house"
	type.rules = load("res://rules/lot.cga")
	var city := PCGCity.new()
	city.layout = PCGLayout.new()
	city.layout.fit_lots(4)
	city.lot_types = [type]
	add_child(city)
	city.generate()
	await city.city_generated
	var made: Dictionary = city.get_statistics()
	made["raw"] = FileAccess.file_exists("res://assets/box.obj") or FileAccess.file_exists("res://assets/wall.png")
	made["pictures"] = 0
	for node: Node in city.find_children("Geometry", "MeshInstance3D", true, false):
		made["pictures"] += int(node.mesh.surface_get_material(0).albedo_texture != null)
	print("MADE ", JSON.stringify(made))
	get_tree().quit()
"""
PROJECT = 'config_version=5\n[application]\nconfig/name="exported"\nrun/main_scene="res://main.tscn"\nconfig/features=PackedStringArray("4.6")\n'
PRESET = '[preset.0]\nname="Linux"\nplatform="Linux"\nrunnable=true\nexport_filter="all_resources"\ninclude_filter="*.txt"\n' \
         'exclude_filter=""\nexport_path="game.x86_64"\n[preset.0.options]\nbinary_format/architecture="x86_64"\n'


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def grey_png():
    rows = b"".join(b"\0" + bytes([200] * 8) for _ in range(8))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 8, 8, 8, 0, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


@unittest.skipUnless(os.environ.get("GODOT") and (ROOT / "addons/pcg/bin").is_dir(), "needs an engine in $GODOT and the built addon")
class Export(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.game = Path(folder.name) / "game"
        shutil.copytree(ROOT / "addons/pcg", self.game / "addons/pcg")
        for name, content in (("project.godot", PROJECT), ("export_presets.cfg", PRESET), ("main.tscn", SCENE), ("main.gd", SCRIPT), ("rules/lot.cga", RULES),
                              ("assets/box.obj", BOX), ("assets/type.txt", "school")):
            (self.game / name).parent.mkdir(parents=True, exist_ok=True)
            (self.game / name).write_text(content)
        (self.game / "assets/wall.png").write_bytes(grey_png())

    def godot(self, folder, *arguments):
        told = subprocess.run([os.environ["GODOT"], "--headless", *arguments], cwd=folder, capture_output=True, text=True, check=False, timeout=200)
        return told.stdout + told.stderr

    def made(self, text):
        lines = [line for line in text.splitlines() if line.startswith("MADE ")]
        self.assertEqual(len(lines), 1, text)
        return json.loads(lines[0][5:])

    def test_models_pictures_and_texts_are_found_after_the_export(self):
        self.godot(self.game, "--path", ".", "--import")
        before = self.made(self.godot(self.game, "--path", "."))
        text = self.godot(self.game, "--path", ".", "--export-pack", "Linux", "game.pck")
        self.assertTrue((self.game / "game.pck").is_file(), text)
        alone = self.game.parent / "alone"
        (alone / "addons/pcg").mkdir(parents=True)
        shutil.copytree(self.game / "addons/pcg/bin", alone / "addons/pcg/bin")  # the engine loads libraries from beside the pack
        shutil.copy(self.game / "game.pck", alone)
        after = self.made(self.godot(alone, "--main-pack", "game.pck"))
        self.assertTrue(before["raw"])
        self.assertFalse(after["raw"])
        lots = before["lots"]
        for made in (before, after):
            self.assertEqual(made["instances"], lots)
            self.assertEqual(made["pictures"], lots)
            self.assertEqual(made["entrances"], {"school": lots})
        self.assertEqual(before["faces"], lots * (6 + 1))
        self.assertEqual(after["faces"], lots * (12 + 1))  # triangles


if __name__ == "__main__":
    unittest.main()
