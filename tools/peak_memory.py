#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws glTF files, small, and prints what each process took at most, MB.
docs/performance.md, "Memory".

usage: tools/peak_memory.py FILE|FOLDER... [--dermis PROGRAM] [-- OPTIONS of dermis render]

Files that are refused are counted. Fails if one ends otherwise.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

SMALL = ["--size", "96x108", "--map-size", "256", "--shadow-size", "512"]


def peak(program, file, options, picture):
    """Exit status, and the largest resident set in MB."""
    child = subprocess.Popen([program, "render", file, *SMALL, *options, "-o", picture],
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    return child.returncode, usage.ru_maxrss * 1024 / 1e6


def main():
    arguments, options = sys.argv[1:], []
    if "--" in arguments:
        at = arguments.index("--")
        arguments, options = arguments[:at], arguments[at + 1:]
    program = "build/release/dermis"
    if "--dermis" in arguments:
        at = arguments.index("--dermis")
        program = arguments[at + 1]
        del arguments[at:at + 2]
    if not arguments:
        sys.exit(__doc__)

    files = []
    for given in map(pathlib.Path, arguments):
        inside = sorted(p for p in given.rglob("*") if p.suffix in (".gltf", ".glb"))
        files += inside if given.is_dir() else [given]

    drawn, refused, failed = [], 0, []
    with tempfile.TemporaryDirectory() as folder:
        for file in files:
            status, peak_mb = peak(program, file, options, f"{folder}/picture.png")
            if status == 0:
                drawn.append((peak_mb, file))
                print(f"{peak_mb:7.0f} {file}", flush=True)
            elif status in (1, 2):
                refused += 1
            else:
                failed.append((status, file))

    print(f"{len(drawn)} files were drawn, {refused} refused" +
          (f"; the largest: {max(drawn)[0]:.0f} MB, {max(drawn)[1]}" if drawn else ""))
    for status, file in failed:
        print(f"error: {file}: exit status {status}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
