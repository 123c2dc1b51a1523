#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes copies of a scene with maps as large as a file may have: docs/performance.md, "Memory".

usage: tools/large_maps.py OUT [SCENE.gltf] [--side PIXELS]

OUT/NAME.gltf is the scene with one map replaced by a picture of that name. Files the scene needs are linked
to. The pictures have little in them, so that a few MB of file become as many pixels as a header can claim.
"""
import argparse
import json
import math
import pathlib
import struct
import zlib


def png(path, side, bits, channels=1, interlaced=False):
    """A PNG of grey waves; an interlaced one (Adam7) is of one value."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    packer, packed = zlib.compressobj(1), []

    def add(data):
        packed.append(packer.compress(data))

    pixel_bytes = bits * channels // 8
    if interlaced:
        for x, y, dx, dy in ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4),
                             (1, 0, 2, 2), (0, 1, 1, 2)):
            line = b"\0" + b"\x89" * ((side - x + dx - 1) // dx * pixel_bytes)
            for _ in range(y, side, dy):
                add(line)
    else:
        wave = [round(137 + 40 * math.sin(i / 64 * 2 * math.pi)) for i in range(64)]
        lines = []
        for shift in range(64):
            rest = b"\xff" * (bits // 8 * (channels - 1))
            period = b"".join(bytes([wave[(x + shift) % 64]]) * (bits // 8) + rest for x in range(64))
            lines.append(b"\0" + (period * (side // 64 + 1))[:side * pixel_bytes])
        for y in range(side):
            add(lines[y % 64])
    packed.append(packer.flush())

    colour_type = {1: 0, 2: 4, 3: 2, 4: 6}[channels]
    header = struct.pack(">IIBBBBB", side, side, bits, colour_type, 0, 0, 1 if interlaced else 0)
    chunks = chunk(b"IHDR", header) + chunk(b"IDAT", b"".join(packed)) + chunk(b"IEND", b"")
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunks)


def progressive_jpeg(path, side, sampling, value=(20, -10, 14)):
    """A progressive JPEG of one colour. `sampling` of each component: 2, 1, 1 halves the colours (4:2:0)."""
    count, most = len(sampling), max(sampling)

    def segment(marker, data):
        return struct.pack(">BBH", 0xFF, marker, len(data) + 2) + data

    def scan(components, first, last, bits):
        named = b"".join(bytes([c + 1, 0]) for c in components)
        body = bytes([len(components)]) + named + bytes([first, last, 0])
        bits += "1" * (-len(bits) % 8)
        data = int(bits, 2).to_bytes(len(bits) // 8, "big") if bits else b""
        return segment(0xDA, body) + data.replace(b"\xff", b"\xff\0")

    # Code n of 4 bits is symbol n: a category of DC, a run of 2^n to 2^(n+1) - 1 ends of blocks of AC.
    codes = bytes([0, 0, 0, 15] + [0] * 12)
    tables = segment(0xC4, b"\x00" + codes + bytes(range(15)))
    tables += segment(0xC4, b"\x10" + codes + bytes(n << 4 for n in range(15)))

    def dc(difference):
        if difference == 0:
            return "0000"
        n = abs(difference).bit_length()
        return f"{n:04b}" + f"{difference if difference > 0 else difference + (1 << n) - 1:0{n}b}"

    def runs(blocks):
        bits = ""
        while blocks:
            run = min(blocks, (1 << 15) - 1)
            n = run.bit_length() - 1
            bits += f"{n:04b}" + (f"{run - (1 << n):0{n}b}" if n else "")
            blocks -= run
        return bits

    first = "".join(dc(v) + "0000" * (s * s - 1) for v, s in zip(value, sampling))
    units = math.ceil(side / (8 * most)) ** 2
    rest = "0000" * (sum(s * s for s in sampling) * (units - 1))
    file = [b"\xff\xd8", segment(0xDB, b"\0" + bytes([16] * 64)),
            segment(0xC2, struct.pack(">BHHB", 8, side, side, count)
                    + b"".join(bytes([c + 1, s << 4 | s, 0]) for c, s in enumerate(sampling))),
            tables, scan(range(count), 0, 0, first + rest)]
    for c, s in enumerate(sampling):
        blocks = math.ceil(math.ceil(side * s / most) / 8) ** 2
        file.append(scan([c], 1, 63, runs(blocks)))
    path.write_bytes(b"".join(file) + b"\xff\xd9")


COLOUR, DISPLACEMENT = 0, 3  # of the images of the scan's manifest

# name: which map, and what writes it. A progressive picture may have 1 GB of coefficients.
MAPS = {
    "displacement-grey8": (DISPLACEMENT, lambda path, side: png(path, side, 8)),
    "displacement-grey16": (DISPLACEMENT, lambda path, side: png(path, side, 16)),
    "displacement-interlaced": (DISPLACEMENT, lambda path, side: png(path, side, 16, interlaced=True)),
    "colour-grey8": (COLOUR, lambda path, side: png(path, side, 8)),
    "colour-grey-alpha16": (COLOUR, lambda path, side: png(path, side, 16, channels=2)),
    "colour-grey-progressive": (COLOUR, lambda path, side: progressive_jpeg(path, side, (1,), (20,))),
    "colour-progressive": (COLOUR, lambda path, side: progressive_jpeg(path, side, (2, 1, 1))),
    "colour-progressive-full":
        (COLOUR, lambda path, side: progressive_jpeg(path, min(side, 12904), (1, 1, 1))),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("scene", type=pathlib.Path, nargs="?", default="assets/heads/lee-perry-smith.gltf")
    parser.add_argument("--side", type=int, default=16384)
    parser.add_argument("--only", choices=sorted(MAPS), nargs="*", default=list(MAPS))
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)

    scene = json.loads(arguments.scene.read_text())
    for needed in scene["images"] + scene["buffers"]:
        link = arguments.out / needed["uri"]
        link.unlink(missing_ok=True)
        link.symlink_to((arguments.scene.parent / needed["uri"]).resolve())

    for name in arguments.only:
        image, write = MAPS[name]
        path = arguments.out / f"{name}.{'jpg' if 'progressive' in name else 'png'}"
        write(path, arguments.side)
        changed = json.loads(json.dumps(scene))
        changed["images"][image]["uri"] = path.name
        (arguments.out / f"{name}.gltf").write_text(json.dumps(changed))
        print(f"{path}: {path.stat().st_size} bytes", flush=True)


if __name__ == "__main__":
    main()
