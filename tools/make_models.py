#!/usr/bin/env python3
"""Makes the models that streets put up many times, rules/cga/assets/*.glb, from the rules that ship: a mesh each, shown as instances.

    scons cli && python3 tools/make_models.py
"""
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RULES = """import grounds : "{rules}/grounds.cga"
import furniture : "{rules}/furniture.cga"
attr lod = 1
Tree --> grounds.Broadleaf(6)
Lamp --> furniture.Lamp
Bin --> furniture.Bin
Red --> furniture.CarOf("#8d2f2a")
Blue --> furniture.CarOf("#2f4a6b")
White --> furniture.CarOf("#c9c9c6")
"""
# Rule, level of detail, seed.
MODELS = {"street_tree_1": ("Tree", 1, 2), "street_tree_2": ("Tree", 1, 5), "street_tree_3": ("Tree", 1, 11), "street_lamp": ("Lamp", 2, 1),
          "street_bin": ("Bin", 1, 1), "car_red": ("Red", 2, 1), "car_blue": ("Blue", 2, 1), "car_white": ("White", 2, 1)}


def main():
    with tempfile.TemporaryDirectory() as folder:
        rules = Path(folder) / "models.cga"
        rules.write_text(RULES.format(rules=ROOT / "rules/cga"))
        for name, (rule, lod, seed) in MODELS.items():
            subprocess.run([ROOT / "bin/pcg", "derive", rules, "--start", rule, "--attr", f"lod={lod}", "--seed", str(seed),
                            "--lot", "8x8", "--out", ROOT / f"rules/cga/assets/{name}.glb"], check=True)


if __name__ == "__main__":
    main()
