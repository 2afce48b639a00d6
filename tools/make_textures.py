#!/usr/bin/env python3
"""Makes the pictures of rules/cga/assets: light and grey, so that a surface keeps its colour, and seamless at all sides.

    tools/make_textures.py [FOLDER]

The same pictures come out each time. Nothing but Python's own library is needed.
"""

import math
import struct
import sys
import zlib
from pathlib import Path

SIZE = 256  # pixels; one tile of the surface


def dice(*numbers):
    """A number from 0 to 1 that depends on nothing else."""
    return zlib.crc32(struct.pack(f"<{len(numbers)}i", *numbers)) / 2**32


def noise(x, y, cells, seed):
    """Smooth noise from 0 to 1 that repeats after SIZE pixels; `cells` of it lie in one tile."""
    u, v = x * cells / SIZE, y * cells / SIZE
    i, j = int(u), int(v)
    fade = lambda t: t * t * (3 - 2 * t)
    a, b = fade(u - i), fade(v - j)
    at = lambda p, q: dice(p % cells, q % cells, seed)
    return (at(i, j) * (1 - a) + at(i + 1, j) * a) * (1 - b) + (at(i, j + 1) * (1 - a) + at(i + 1, j + 1) * a) * b


def grain(x, y, seed, cells=16, layers=4):
    total = weight = 0.0
    for layer in range(layers):
        total += noise(x, y, min(cells << layer, SIZE), seed + layer) * 0.6**layer
        weight += 0.6**layer
    return total / weight


def brick(x, y):
    """Running bond, 5 bricks wide (1.2 m) and 16 courses high (1.2 m)."""
    height, width = SIZE / 16, SIZE / 5
    row = int(y / height)
    along = (x + (width / 2 if row % 2 else 0)) % SIZE
    column = int(along / width)
    edge = min(along % width, width - along % width, 1.4 * (y % height), 1.4 * (height - y % height))
    if edge < 1.6:
        return 0.90 + 0.08 * grain(x, y, 1)
    return 0.70 + 0.20 * dice(row, column, 2) + 0.10 * grain(x, y, 3, 32, 3) - (0.08 if edge < 2.6 else 0.0)


def tiles(x, y):
    """Rounded roof tiles, 6 side by side (1.5 m), 5 rows (1.75 m); y runs down the roof."""
    width, height = SIZE / 6, SIZE / 5
    row = int(y / height)
    along = (x + (width / 2 if row % 2 else 0)) % SIZE
    column = int(along / width)
    across = (along % width) / width
    down = (y % height) / height
    light = 0.80 + 0.10 * dice(row, column, 4) + 0.06 * grain(x, y, 5)
    light *= 0.80 + 0.20 * math.sin(math.pi * across) ** 0.6
    return light * (0.66 if down > 0.93 - 0.05 * math.sin(math.pi * across) else 0.88 + 0.12 * down)


def grass(x, y):
    return 0.70 + 0.16 * grain(x, y, 6, 4, 3) + 0.16 * grain(x, y, 7, 64, 3)


def slabs(x, y):
    """Four by four paving stones (0.6 m each in 2.4 m)."""
    size = SIZE / 4
    edge = min(x % size, size - x % size, y % size, size - y % size)
    light = 0.82 + 0.10 * dice(int(x / size), int(y / size), 8) + 0.08 * grain(x, y, 9, 32, 3)
    return 0.66 if edge < 1.3 else light


def png(pixel):
    rows = bytearray()
    for y in range(SIZE):
        rows.append(0)
        rows.extend(min(255, max(0, round(51 * pixel(x + 0.5, y + 0.5)) * 5)) for x in range(SIZE))  # few shades pack well

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 0, 0, 0, 0)  # grey
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b"")


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[1] / "rules/cga/assets")
    folder.mkdir(parents=True, exist_ok=True)
    for pixel in (brick, tiles, grass, slabs):
        (folder / f"{pixel.__name__}.png").write_bytes(png(pixel))


if __name__ == "__main__":
    main()
