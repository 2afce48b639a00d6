"""The plot of what the simulation costs: one line a kind of cost, and a clear end where a figure is missing."""

import json
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SVG = "{http://www.w3.org/2000/svg}"


def figures(*endings):
    return [{"name": f"sim_{size}_{ending}", "value": value} for ending in endings
            for size, value in {"1k": 0.01, "10k": 0.1, "100k": 1.0, "1m": 10.0}.items()]


class PlotCosts(unittest.TestCase):
    def plot(self, content):
        with tempfile.TemporaryDirectory() as folder:
            source, target = Path(folder) / "figures.json", Path(folder) / "costs.svg"
            source.write_text(json.dumps(content))
            done = subprocess.run([sys.executable, ROOT / "tools/plot_costs.py", source, target], capture_output=True, text=True, check=False)
            return done, ElementTree.fromstring(target.read_text()) if target.exists() else None

    def test_each_cost_is_a_line_that_rises_with_the_number_of_persons(self):
        done, picture = self.plot(figures("day", "jump", "frame_at_peak"))
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = picture.findall(f"{SVG}polyline")
        self.assertEqual(len(lines), 3)
        for line in lines:
            points = [tuple(map(float, point.split(","))) for point in line.get("points").split()]
            self.assertEqual(len(points), 4)
            self.assertEqual(points, sorted(points, key=lambda point: (point[0], -point[1])))
        # Ten times the persons at ten times the cost is a straight line: steps of equal height.
        heights = [points[i][1] - points[i + 1][1] for i in range(3)]
        self.assertAlmostEqual(heights[0], heights[2], delta=0.2)

    def test_a_missing_figure_is_named_and_nothing_is_written(self):
        done, picture = self.plot(figures("day", "jump"))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("has no figure sim_.._frame_at_peak", done.stderr)
        self.assertIsNone(picture)


if __name__ == "__main__":
    unittest.main()
