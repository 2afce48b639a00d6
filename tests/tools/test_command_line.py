"""pcg tells what is wrong with its command line, writes nothing over its inputs, and leaves nothing behind."""

import json
import resource
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PCG = ROOT / "bin/pcg"

HOUSE = """attr height = 3
attr sign = "x"
Lot --> report("z", geometry.area) report("a", height) print(sign) extrude(height)
style Tall
attr height = 30
"""
TWO_LOTS = "v 0 0 0\nv 10 0 0\nv 10 0 -10\nv 0 0 -10\nv 20 0 0\nv 30 0 0\nv 30 0 -10\nv 20 0 -10\no north\nf 1 2 3 4\ng south lot\nf 5 6 7 8\n"
BOW_TIE = "v 0 0 0\nv 10 0 0\nv 0 0 -10\nv 10 0 -10\no tie\nf 1 2 3 4\n"


@unittest.skipUnless(PCG.exists(), "bin/pcg is not built")
class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name, text in (("house.cga", HOUSE), ("two.obj", TWO_LOTS), ("tie.obj", BOW_TIE), ("broken.cga", "Lot --> extrude(\nB -->")):
            (self.folder / name).write_text(text)

    def pcg(self, *arguments, **options):
        return subprocess.run([PCG, *arguments], cwd=self.folder, capture_output=True, text=True, check=False, timeout=60, **options)

    def refused(self, *arguments):
        before = {path.name: path.read_bytes() for path in self.folder.iterdir()}
        told = self.pcg(*arguments)
        self.assertEqual(told.returncode, 2, told.stderr)
        self.assertEqual(before, {path.name: path.read_bytes() for path in self.folder.iterdir()})
        return told.stderr

    def test_no_output_is_written_over_an_input_or_another_output(self):
        self.assertIn("--json would overwrite the rule file", self.refused("derive", "house.cga", "--json", "house.cga"))
        self.assertIn("--out would overwrite --shape", self.refused("derive", "house.cga", "--shape", "two.obj", "--out", "./two.obj"))
        self.assertIn("--json would overwrite --out", self.refused("derive", "house.cga", "--out", "m.glb", "--json", "../" + self.folder.name + "/m.glb"))
        (self.folder / "link.obj").symlink_to("two.obj")
        self.assertIn("--out would overwrite --shape", self.refused("derive", "house.cga", "--shape", "two.obj", "--out", "link.obj"))
        people = ("--city", "city.json", "--households", "h.csv", "--persons", "5")
        self.assertIn("--out would overwrite --city", self.refused("agenda", "day.pcg", *people, "--out", "city.json"))
        self.assertIn("--lived would overwrite --trace", self.refused("simulate", "day.pcg", *people, "--trace", "t.csv", "--lived", "t.csv"))

    def test_empty_values_are_mistakes(self):
        self.assertIn("--out must not be empty", self.refused("derive", "house.cga", "--out", ""))
        self.assertIn("--json must not be empty", self.refused("derive", "house.cga", "--json="))

    def test_numbers_that_are_none_are_told(self):
        self.assertIn("nan", self.refused("derive", "house.cga", "--attr", "height=nan"))
        self.assertIn("inf", self.refused("derive", "house.cga", "--attr", "height=inf"))
        self.assertIn("--persons", self.refused("agenda", "d.pcg", "--city", "c", "--households", "h", "--persons", "100000001"))

    def test_an_unknown_attribute_is_a_warning(self):
        told = self.pcg("derive", "house.cga", "--attr", "nothing=1")
        self.assertEqual(told.returncode, 0)
        self.assertIn("'nothing' is no attribute of the rules", told.stderr)

    def test_groups_of_a_footprint_are_shapes_of_their_own(self):
        told = self.pcg("derive", "house.cga", "--shape", "two.obj", "--style", "Tall", "--attr", "sign=5", "--threads", "2", "--out", "m.obj", "--json", "r.json")
        self.assertEqual(told.returncode, 0, told.stderr)
        report = json.loads((self.folder / "r.json").read_text())
        self.assertEqual([shape["name"] for shape in report["initial_shapes"]], ["north", "south lot"])
        self.assertEqual(report["faces"], 12)
        self.assertEqual(report["bbox"], [[0, 0, -10], [30, 30, 0]])
        self.assertEqual(list(report["reports"]), ["z", "a"])  # in the order of their first use
        self.assertEqual(report["reports"]["a"], {"n": 2, "sum": 60, "min": 30, "max": 30, "avg": 30})
        self.assertEqual(report["prints"], ["5", "5"])  # a text, though it looks like a number
        names = [line for line in (self.folder / "m.obj").read_text().splitlines() if line.startswith("o ")]
        self.assertEqual(names, ["o north", "o south lot"])

    def test_one_thread_and_several_give_the_same_model(self):
        for threads in ("1", "4"):
            self.pcg("derive", "house.cga", "--shape", "two.obj", "--threads", threads, "--out", f"{threads}.glb")
        self.assertEqual((self.folder / "1.glb").read_bytes(), (self.folder / "4.glb").read_bytes())

    def test_vertices_that_the_faces_of_a_shape_share_count_once(self):
        (self.folder / "three.obj").write_text("v 0 0 0\nv 6 0 0\nv 0 0 -6\nf 1 2 3\n")
        (self.folder / "cap.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
        corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n"
        (self.folder / "joined.obj").write_text(corners + "f 1/1 3/2 4/3\n")
        (self.folder / "apart.obj").write_text(corners + "v 2 0 0\nv 3 0 0\nv 3 1 0\nf 5/1 6/2 7/3\n")
        changed = "".join(f'\n{rule} --> s(1, 1, 0) i("{file}.obj") scaleUV(0, 2, 2)' for rule, file in (("A", "joined"), ("B", "apart")))
        # A prism; its faces one by one; cut into one prism of four sides and one of three; three models of 4 vertices each; changed models, two of
        # two triangles with 4 vertices and two of two with 6.
        for body, faces, vertices in (("X.", 5, 6), ("comp(f) { all : X. }", 5, 18), ("split(x) { 3 : X. | ~1 : X. }", 11, 14),
                                      ("split(y) { 1 : s(1, 1, 1) i(\"cap.obj\") X. }*", 9, 12), ("split(y) { { 0.75 : A | 0.75 : B }* }" + changed, 8, 20)):
            (self.folder / "v.cga").write_text(f"Lot --> extrude(3) {body}\n")
            told = self.pcg("derive", "v.cga", "--shape", "three.obj", "--json", "v.json")
            self.assertEqual(told.returncode, 0, told.stderr)
            report = json.loads((self.folder / "v.json").read_text())
            self.assertEqual((report["faces"], report["vertices"]), (faces, vertices), body)

    def test_inserted_models_count_like_all_other_faces(self):
        (self.folder / "tile.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 0 -1\nv 0 0 -1\nf 1 2 3 4\n")  # 1 m2
        (self.folder / "tiles.cga").write_text('Lot --> split(x) { 2 : s(\'1, 0, \'1) i("tile.obj") X. }* ')  # five of 2 x 10 m
        told = self.pcg("derive", "tiles.cga", "--lot", "10x10", "--out", "m.obj", "--json", "r.json")
        self.assertEqual(told.returncode, 0, told.stderr)
        report = json.loads((self.folder / "r.json").read_text())
        for figures in (report, report["initial_shapes"][0]):
            self.assertEqual((figures["faces"], figures["vertices"]), (5, 20))
            self.assertAlmostEqual(figures["area"], 100.0, 4)
            self.assertEqual(figures["bbox"], [[0, 0, -10], [10, 0, 0]])
        self.assertEqual((self.folder / "m.obj").read_text().count("\nf "), 10)

    def test_a_bow_tie_is_told_with_file_shape_and_reason(self):
        told = self.pcg("derive", "house.cga", "--shape", "tie.obj")
        self.assertEqual(told.returncode, 1)
        self.assertIn('tie.obj: error: shape "tie": ', told.stderr)
        self.assertIn("crosses itself", told.stderr)

    def test_a_file_that_grows_too_large_is_told_and_leaves_nothing(self):
        before = sorted(path.name for path in self.folder.iterdir())
        told = self.pcg("derive", "house.cga", "--out", "m.glb", preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (512, 512)))
        self.assertEqual(told.returncode, 1)
        self.assertIn("cannot write", told.stderr)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), before)

    def test_check_tells_every_mistake_and_exits_with_one(self):
        (self.folder / "two.cga").write_text("A --> ]\nB --> t(1,2,)\nC --> extrude(1) )\n")
        told = self.pcg("check", "two.cga", "house.cga", "--json")
        self.assertEqual(told.returncode, 1)
        lines = {diagnostic["line"] for diagnostic in json.loads(told.stdout)["diagnostics"]}
        self.assertTrue({1, 2, 3} <= lines, lines)
        self.assertEqual(self.pcg("check", "house.cga").returncode, 0)

    def write_town(self, capacity=4):
        (self.folder / "day.pcg").write_text('@StartRule\nHousehold --> members { true: stayInside(0h, 24h, home) goToBuilding(8h, 9h, findBuilding("shop")) }\n')
        (self.folder / "table.csv").write_text('descriptor,count\nOne adult woman with two minor children,5\n"Two adults, no minors",3\n')
        entrances = [{"id": i, "entrances": [{"type": "house", "position": [i, 0, 0], "capacity": capacity}]} for i in range(10)]
        shop = {"id": 77, "entrances": [{"type": "shop", "position": [500, 0, 0]}]}
        (self.folder / "city.json").write_text(json.dumps({"buildings": entrances + [shop]}))
        return ("agenda", "day.pcg", "--city", "city.json", "--households", "table.csv", "--persons")

    def test_agendas_are_a_table_and_people_that_were_saved_come_back(self):
        agenda = self.write_town()
        told = self.pcg(*agenda, "20", "--seed", "3", "--out", "agendas.csv", "--save-population", "people.csv", "--day", "sat")
        self.assertEqual(told.returncode, 0, told.stderr)
        rows = [line.split(",") for line in (self.folder / "agendas.csv").read_text().splitlines()]
        self.assertEqual(rows[0], ["household", "person", "age", "gender", "day", "start", "end", "kind", "target", "detail"])
        self.assertEqual({row[4] for row in rows[1:]}, {"sat"})
        self.assertIn(["28800", "32400", "goToBuilding", "77"], [row[5:9] for row in rows])
        told = self.pcg("agenda", "day.pcg", "--city", "city.json", "--population", "people.csv", "--seed", "3", "--out", "again.csv", "--day", "sat")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertEqual((self.folder / "again.csv").read_text(), (self.folder / "agendas.csv").read_text())

    def test_more_people_than_homes_are_counted(self):
        told = self.pcg(*self.write_town(), "100000000", "--out", "agendas.csv")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertIn("100000000 persons, but the homes of the city take 40", told.stderr)

    def test_a_city_without_homes_is_a_warning_and_a_table_of_nobody(self):
        agenda = self.write_town()
        (self.folder / "city.json").write_text(json.dumps({"buildings": [{"id": 7, "entrances": [{"type": "shop", "position": [0, 0, 0]}]}]}))
        told = self.pcg(*agenda, "12", "--out", "agendas.csv")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertIn("city.json: warning: 12 persons, but the homes of the city take 0", told.stderr)
        self.assertEqual(len((self.folder / "agendas.csv").read_text().splitlines()), 1)

    def write_family(self):
        (self.folder / "city.json").write_text(json.dumps({"buildings": [
            {"id": 10, "entrances": [{"type": "house", "position": [0, 0, 0], "capacity": 2}]},
            {"id": 12, "entrances": [{"type": "house", "position": [9, 0, 0]}]},
            {"id": 7, "entrances": [{"type": "school", "position": [90, 0, 0]}]}]}))
        (self.folder / "people.csv").write_text("household,person,home,age,gender,speed,first_name,family_name\n50,100,10,40,w,1.2,,Nagy\n"
                                                "50,101,10,12,m,1.1,,\n50,102,10,9,m,1.1,,\n77,205,12,70,w,1,,\n")
        return ("day.pcg", "--city", "city.json", "--population", "people.csv")

    def test_rules_and_messages_know_the_ids_of_the_files(self):
        family = self.write_family()
        (self.folder / "day.pcg").write_text(
            "@StartRule\nHousehold -->\n\tcase household.id == 77: Lonely\n\telse: members { person.id == 101: goToBuilding(8h, 9h, 7) }\n"
            "Lonely --> case home == 12: members { true: goToBuilding(8h, 9h, 2) stayInside(1 / (count() - 1), 1h, home) }\n")
        told = self.pcg("agenda", *family, "--out", "agendas.csv", "--save-population", "again.csv", "--day", "mon")
        self.assertEqual(told.returncode, 1, told.stderr)
        self.assertIn("household 77: division by zero", told.stderr)
        self.assertIn("household 77: 'goToBuilding' is given 2, which is no building of the city", told.stderr)
        self.assertIn("people.csv: warning: 3 persons live in building 10, which takes 2", told.stderr)
        rows = (self.folder / "agendas.csv").read_text().splitlines()[1:]
        self.assertEqual(rows, ["50,101,12,m,mon,28800,32400,goToBuilding,7,"])
        again = (self.folder / "again.csv").read_text().splitlines()
        self.assertEqual(again[1].split(",")[:3] + again[1].split(",")[7:8], ["50", "100", "10", "Nagy"])

    def test_attributes_are_set_for_agendas_and_for_the_rules_of_the_day(self):
        family = self.write_family()
        (self.folder / "day.pcg").write_text(
            "attr start = 8h\nattr pause = 1h\nconst fixed = 1\n@StartRule\nHousehold --> members { age > 60: goToBuilding(start, start + 1h, 7) "
            "delayedRule(12h, 20h, Stroll) }\nStroll --> wait(pause) goToBuilding(7)\n")
        told = self.pcg("agenda", *family, "--attr", "start=10h30m", "--day", "mon")
        self.assertIn(",37800,41400,goToBuilding,7,", told.stdout)
        told = self.pcg("simulate", *family, "--attr", "pause=2h", "--trace", "trace.csv")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertIn("50400.000,205,set-out,building:7", (self.folder / "trace.csv").read_text())
        for setting, message in (("strat=9h", "did you mean 'start'?"), ("fixed=2", "'fixed' is const in the rules"), ("start=true", "'start' is a number in the rules, not true or false")):
            for command in ("agenda", "simulate"):
                told = self.pcg(command, *family, "--attr", setting)
                self.assertEqual(told.returncode, 1)
                self.assertIn(message, told.stderr)

    def test_interrupt_cancels_and_writes_nothing(self):
        agenda = self.write_town(capacity=1000000)
        before = {path.name for path in self.folder.iterdir()}
        with subprocess.Popen([PCG, *agenda, "9000000", "--out", "agendas.csv"], cwd=self.folder, stderr=subprocess.PIPE, text=True) as process:
            time.sleep(0.5)
            process.send_signal(signal.SIGINT)
            told = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 1, told)
        self.assertIn("cancelled", told)
        self.assertEqual(before, {path.name for path in self.folder.iterdir()})


if __name__ == "__main__":
    unittest.main()
