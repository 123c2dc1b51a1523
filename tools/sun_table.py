#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures skin under skies with suns against ground truth: docs/accuracy.md, "Environments and suns".

usage: tools/sun_table.py OUT [options]

Makes skies of 1024 x 512 pixels in OUT: blue above, a ground below, and a sun of so many pixels of a
stated radiance,
or a bright rectangle, which is a strip light or a window.
The reference of each cell is rendered once and kept in OUT, so that a second program is measured with
the same.
"""
import argparse
import json
import math
import pathlib
import statistics
import subprocess
import sys

WIDTH, HEIGHT = 1024, 512
SUN_COLOUR = (1.0, 0.93, 0.82)
MEAN_OF_SKY = 0.35  # of what sky() is without a sun


def direction(x, y):
    """Of the middle of a pixel, as src/environment has it: the picture's middle is behind the head, -Z."""
    azimuth, polar = (x + 0.5 - WIDTH / 2) * 2 * math.pi / WIDTH, (y + 0.5) * math.pi / HEIGHT
    return (math.sin(polar) * math.sin(azimuth), math.cos(polar), -math.sin(polar) * math.cos(azimuth))


def solid_angle(y):
    return 2 * math.pi / WIDTH * math.pi / HEIGHT * math.sin(math.pi * (y + 0.5) / HEIGHT)


def sky(elevation_sine):
    if elevation_sine < 0:
        return (0.16, 0.13, 0.10)
    height = math.sqrt(elevation_sine)
    return (0.75 - 0.60 * height, 0.85 - 0.50 * height, 0.95 - 0.20 * height)


def sun_pixels(elevation_deg, count):
    """Those nearest to a direction in front of the head, which is the seam of the picture."""
    y = round((90 - elevation_deg) / 180 * HEIGHT - 0.5)
    middle = direction(0, y)
    near = [(x % WIDTH, y + j) for j in range(-8, 9) if 0 <= y + j < HEIGHT for x in range(-16, 17)]
    near.sort(key=lambda p: (-round(sum(a * b for a, b in zip(direction(*p), middle)), 9), p))
    return near[:count]


def window_pixels(elevation_deg, size_deg):
    """Those of a rectangle of so many degrees of azimuth and of elevation in front of the head."""
    across, down = (max(1, round(side / 360 * WIDTH)) for side in size_deg)
    y = round((90 - elevation_deg) / 180 * HEIGHT - 0.5)
    return [(x % WIDTH, y + j) for j in range(-(down // 2), down - down // 2) if 0 <= y + j < HEIGHT
            for x in range(-(across // 2), across - across // 2)]


def rgbe(colour):
    largest = max(colour)
    if largest < 1e-32:
        return bytes(4)
    mantissa, exponent = math.frexp(largest)
    scale = mantissa * 256 / largest
    return bytes([int(c * scale) for c in colour] + [exponent + 128])


def write_sky(path, source_pixels, radiance):
    """Returns the irradiance of the source on what faces it, green, its size left aside."""
    pixels = set(source_pixels)
    sun = rgbe([radiance * c for c in SUN_COLOUR])
    rows = []
    for y in range(HEIGHT):
        row = bytearray(rgbe(sky(direction(0, y)[1])) * WIDTH)
        for x, sun_y in pixels:
            if sun_y == y:
                row[4 * x:4 * x + 4] = sun
        rows.append(bytes(row))
    header = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {HEIGHT} +X {WIDTH}\n"
    path.write_bytes(header.encode() + b"".join(rows))
    return sum(solid_angle(y) * radiance * SUN_COLOUR[1] for _, y in pixels)


def output_of(command):
    """Of a program; if it fails, ends with what it said."""
    done = subprocess.run(command, capture_output=True)
    if done.returncode:
        sys.exit(f"error: status {done.returncode} of {' '.join(map(str, command))}\n"
                 + done.stderr.decode(errors="replace"))
    return done.stdout


def numbers(text):
    return [float(n) for n in text.split(",") if n]


def sizes(text):
    return [tuple(float(side) for side in size.split("x")) for size in text.split(",") if size]


class Table:
    def __init__(self, arguments):
        self.arguments = arguments
        self.out = pathlib.Path(arguments.out)
        self.out.mkdir(parents=True, exist_ok=True)

    def scene(self, environment, rotation, exposure):
        a = self.arguments
        return ["--camera", a.camera] * bool(a.camera) + [
            "--environment", environment, "--environment-rotation", str(rotation), "--lights", "0",
             "--size", a.size,
            "--exposure", f"{exposure:.1f}"]

    def measure(self, cell, environment, rotation, exposure):
        """Error over skin of one program in one cell."""
        a = self.arguments
        truth, variance = (self.out / f"{cell}{end}.exr" for end in ("", ".variance"))
        where = self.scene(environment, rotation, exposure)
        if not truth.exists():
            output_of([a.dermis, "reference", a.scene, *where, "--noise", str(a.noise), "--samples",
                       str(a.samples), "--variance", variance, "-o", truth])
        result = output_of([a.dermis, "compare", "--scene", a.scene, *where, "--reference", truth,
                            "--variance", variance, "--techniques", "texture-space",
                            "--map-size", str(a.map_size), "--shadow-size", str(a.shadow_size),
                            "--supersample", str(a.supersample), "--json", "-",
                            *["--tone-map", a.tone_map] * bool(a.tone_map)])
        found = json.loads(result)
        (self.out / f"{cell}.{a.label}.json").write_bytes(result)
        error = found["techniques"][0]["error"]["skin"]
        return {"lights": found["lights"], "noise": found["noise"]["skin"], **error}

    def row(self, cell, environment, rotation, exposure):
        e = self.measure(cell, environment, rotation, exposure)
        print(f"| {cell} | {exposure:.1f} | {e['lights']} | {e['flip']:.4f} | {e['hdr_flip']:.4f} "
              f"| {e['psnr_db']:.1f} "
              f"| {e['rel_mse_unbiased']:.2e} | {e['noise']['flip']:.4f} |", flush=True)
        return e

    def rows(self, name, pixels, radiance):
        """One sky at each rotation. Returns the line of its summary."""
        path = self.out / f"{name}.hdr"
        irradiance = write_sky(path, pixels, radiance)
        # A face that is neither burnt out nor dark: pi facing the light shows white as white.
        exposure = round(-math.log2((irradiance + math.pi * MEAN_OF_SKY) / math.pi), 1)
        rotations = self.arguments.rotations
        errors = [self.row(f"{name}-{rotation:g}", path, rotation, exposure) for rotation in rotations]

        columns = [name]
        for key, digits, worst in (("flip", ".4f", max), ("psnr_db", ".1f", min),
                                   ("rel_mse_unbiased", ".2e", max)):
            values = [e[key] for e in errors]
            columns += [f"{statistics.median(values):{digits}}", f"{worst(values):{digits}}",
                        f"{rotations[values.index(worst(values))]:g}"]
        return "| " + " | ".join(columns) + " |"

    def run(self):
        a = self.arguments
        print("| sky | EV | lights | FLIP | HDR-FLIP | PSNR dB | relMSE less noise | FLIP of the noise |")
        print("|---" * 8 + "|")
        for environment in a.environments:
            self.row(pathlib.Path(environment).stem, environment, 0, 0)
        summaries = []
        for elevation in a.elevations:
            for count in a.pixels:
                pixels = sun_pixels(elevation, int(count))
                summaries.append(self.rows(f"sun-{int(count)}-{elevation:g}", pixels, a.radiance))
            for size in a.windows:
                pixels = window_pixels(elevation, size)
                radiance = a.window_irradiance / (sum(solid_angle(y) for _, y in pixels) * SUN_COLOUR[1])
                summaries.append(self.rows(f"window-{size[0]:g}x{size[1]:g}-{elevation:g}", pixels, radiance))

        if summaries:
            print("\n| source | FLIP, median | largest | at rotation | PSNR dB, median | least | at rotation "
                  "| relMSE less noise, median | largest | at rotation |\n" + "|---" * 10 + "|")
            print("\n".join(summaries))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", help="folder of skies, references and results")
    parser.add_argument("--dermis", default="build/release/dermis", help="the program")
    parser.add_argument("--label", default="now", help="names the results of this program")
    parser.add_argument("--scene", default="assets/heads/lee-perry-smith.gltf")
    parser.add_argument("--camera", default="portrait", help="of the scene; none if empty")
    parser.add_argument("--size", default="96x108")
    parser.add_argument("--noise", type=float, default=3, help="of the reference, per cent")
    parser.add_argument("--samples", type=int, default=1000, help="of the reference, at most")
    parser.add_argument("--map-size", type=int, default=512)
    parser.add_argument("--shadow-size", type=int, default=2048)
    parser.add_argument("--tone-map", default="", help="of FLIP and PSNR; the program's default if empty")
    parser.add_argument("--supersample", type=int, default=4)
    parser.add_argument("--radiance", type=float, default=110000, help="of the sun")
    parser.add_argument("--pixels", type=numbers, default=[1, 4, 16], help="of the sun, a list")
    parser.add_argument("--windows", type=sizes, default=[],
                        help="bright rectangles, a list of degrees of azimuth x elevation")
    parser.add_argument("--window-irradiance", type=float, default=6,
                        help="on what faces one, its size left aside")
    parser.add_argument("--elevations", type=numbers, default=[10, 35, 65], help="degrees, a list")
    parser.add_argument("--rotations", type=numbers, default=[45 * k for k in range(8)],
                        help="degrees, a list; 0: in front")
    parser.add_argument("--environments", nargs="*", default=["studio"],
                        help="further skies, files or 'studio'")
    Table(parser.parse_args()).run()


if __name__ == "__main__":
    main()
