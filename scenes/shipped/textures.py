#!/usr/bin/env python3
"""Writes the pictures of the shipped scenes again, the same bytes: interior/*.png and glass/sky.hdr."""

import math
import pathlib
import struct
import zlib

here = pathlib.Path(__file__).parent


def noise(*key):
    """A number in [0, 1) that depends on the key alone."""
    return zlib.crc32(repr(key).encode()) / 2**32


def smooth_noise(x, y, period, seed):
    """Value noise, periodic in both directions."""
    i, j = math.floor(x), math.floor(y)
    s, t = x - i, y - j
    s, t = s * s * (3 - 2 * s), t * t * (3 - 2 * t)
    corner = lambda a, b: noise(seed, (i + a) % period[0], (j + b) % period[1])
    return (corner(0, 0) * (1 - s) + corner(1, 0) * s) * (1 - t) + (corner(0, 1) * (1 - s) + corner(1, 1) * s) * t


def write_png(name, width, height, texel):
    """texel(x, y) gives bytes: one for grey, three for red, green and blue."""
    rows = [[texel(x, y) for x in range(width)] for y in range(height)]
    data = b"".join(b"\0" + b"".join(bytes(t) for t in row) for row in rows)
    chunk = lambda kind, body: struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    header = struct.pack(">IIBBBBB", width, height, 8, 2 if len(rows[0][0]) == 3 else 0, 0, 0, 0)
    body = chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(data, 9)) + chunk(b"IEND", b"")
    (here / name).write_bytes(b"\x89PNG\r\n\x1a\n" + body)


def shade(colour, factor):
    return [max(0, min(255, round(c * factor))) for c in colour]


def plank(x, y):
    """Boards of 16 texels along x, each with its own tone and grain, and a dark joint between them."""
    board = y // 16
    tone = 0.8 + 0.3 * noise("board", board)
    grain = smooth_noise(x / 16, y / 2, (8, 64), "grain") * 0.25 + smooth_noise(x / 4, y, (32, 128), "fine") * 0.12
    joint = y % 16 == 0 or (x + 37 * board) % 128 == 0
    return shade((176, 122, 74), (0.45 if joint else tone - grain))


def table(x, y):
    rings = math.sin(2 * math.pi * (x / 16 + 1.5 * smooth_noise(x / 16, y / 32, (4, 2), "ring")))
    return shade((110, 58, 32), 0.85 + 0.15 * rings + 0.2 * (noise("table", x, y) - 0.5))


def painting(x, y):
    """Hills under an evening sky, in a pale margin."""
    if x < 3 or y < 3 or x >= 61 or y >= 45:
        return [225, 215, 195]
    if math.hypot(x - 44, y - 15) < 5:
        return [250, 225, 120]
    for depth, colour in ((0, (40, 70, 60)), (1, (70, 105, 90)), (2, (115, 125, 150))):
        if y > 36 - 7 * depth - 5 * math.sin(x / (6 + 4 * depth) + 2 * depth):
            return list(colour)
    return shade((235, 150, 110), 0.6 + 0.012 * y)


def lace(x, y):
    """Opacity: threads crossing at an angle, with a flower in the middle."""
    thread = (x + y) % 8 < 2 or (x - y) % 8 < 2
    angle = math.atan2(y - 31.5, x - 31.5)
    flower = math.hypot(x - 31.5, y - 31.5) < 14 + 6 * math.cos(5 * angle)
    return [255 if flower else 190 if thread else 40]


def rgbe(colour):
    """[Ward 1991]: mantissas of 8 bits with the exponent of the largest channel."""
    exponent = math.frexp(max(colour))[1]
    return bytes(int(c * 2.0 ** (8 - exponent)) for c in colour) + bytes([exponent + 128])


def sky(column, row):
    """Of 64 by 32. RGBE holds every value exactly; from 42 degrees above the horizon to 8 below each half is constant."""
    if (column, row) == (40, 6):
        return (320.0, 272.0, 208.0)
    if row < 8:
        return (0.25, 0.4375, 0.875)
    if row < 18:
        return (0.75, 0.875, 1.0) if 16 <= column < 48 else (0.25, 0.3125, 0.5)
    return (0.125, 0.109375, 0.09375)


def write_sky():
    pixels = b"".join(rgbe(sky(column, row)) for row in range(32) for column in range(64))
    (here / "glass/sky.hdr").write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n" + pixels)


write_png("interior/planks.png", 128, 128, plank)
write_png("interior/table.png", 64, 64, table)
write_png("interior/painting.png", 64, 48, painting)
write_png("interior/lace.png", 64, 64, lace)
write_sky()
