#!/usr/bin/env python3
"""Plots what the simulation costs against the number of persons, from what the benchmark measured.

    ./dev bench sim_bench --json figures.json && tools/plot_costs.py figures.json docs/images/costs.svg

Both axes are logarithmic. One line for each kind of cost, all in milliseconds; a grey line shows growth in proportion to the number of persons.
"""

import json
import math
import re
import sys
from pathlib import Path

SIZES = {"1k": 1_000, "10k": 10_000, "100k": 100_000, "1m": 1_000_000}
# Ending of a figure's name -> (what it is called, factor to milliseconds, colour).
LINES = {
    "day": ("a day in one go", 1000.0, "#b5432e"),
    "jump": ("a jump in time", 1.0, "#2f6db0"),
    "frame_at_peak": ("a frame of the morning peak at 60x", 1.0, "#3d8c40"),
}
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 720, 420, 70, 230, 24, 52
LOW, HIGH = -4, 5  # powers of ten of a millisecond
FONT = 'font-family="sans-serif" font-size="13"'


def place(persons, milliseconds):
    x = LEFT + (math.log10(persons) - 3) / 3 * (WIDTH - LEFT - RIGHT)
    y = HEIGHT - BOTTOM - (math.log10(milliseconds) - LOW) / (HIGH - LOW) * (HEIGHT - TOP - BOTTOM)
    return round(x, 1), round(y, 1)


def axes():
    for power in range(LOW, HIGH + 1):
        x, y = place(1000, 10.0 ** power)
        name = f"{10 ** power:g} ms" if power < 3 else f"{10 ** (power - 3):g} s"
        yield f'<line x1="{x}" y1="{y}" x2="{WIDTH - RIGHT}" y2="{y}" stroke="#ddd"/>'
        yield f'<text x="{x - 8}" y="{y + 4}" text-anchor="end" {FONT}>{name}</text>'
    for persons in SIZES.values():
        x, y = place(persons, 10.0 ** LOW)
        yield f'<line x1="{x}" y1="{TOP}" x2="{x}" y2="{y}" stroke="#ddd"/>'
        yield f'<text x="{x}" y="{y + 20}" text-anchor="middle" {FONT}>{persons:,}</text>'
    yield f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 10}" text-anchor="middle" {FONT}>persons</text>'
    begin, end = place(1000, 0.1), place(1_000_000, 100.0)
    yield f'<line x1="{begin[0]}" y1="{begin[1]}" x2="{end[0]}" y2="{end[1]}" stroke="#aaa" stroke-dasharray="5 5"/>'
    yield f'<text x="{end[0] + 10}" y="{end[1] + 4}" fill="#888" {FONT}>in proportion to persons</text>'


def curve(points, name, colour):
    places = [place(*point) for point in points]
    yield f'<polyline fill="none" stroke="{colour}" stroke-width="2.5" points="{" ".join(f"{x},{y}" for x, y in places)}"/>'
    yield from (f'<circle cx="{x}" cy="{y}" r="4" fill="{colour}"/>' for x, y in places)
    x, y = places[-1]
    yield f'<text x="{x + 10}" y="{y + 4}" fill="{colour}" {FONT}>{name}</text>'


def points_of(figures, ending, factor):
    found = {}
    for figure in figures:
        match = re.fullmatch(r"sim_(\w+?)_" + ending, figure["name"])
        if match and match[1] in SIZES and figure["value"] > 0:
            found[SIZES[match[1]]] = figure["value"] * factor
    return sorted(found.items())


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    figures = json.loads(Path(sys.argv[1]).read_text())
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>', *axes()]
    for ending, (name, factor, colour) in LINES.items():
        points = points_of(figures, ending, factor)
        if not points:
            sys.exit(f"plot_costs: {sys.argv[1]} has no figure sim_.._{ending}; measure with ./dev bench sim_bench --json FILE")
        parts += curve(points, name, colour)
    Path(sys.argv[2]).write_text("\n".join([*parts, "</svg>"]) + "\n")


if __name__ == "__main__":
    main()
