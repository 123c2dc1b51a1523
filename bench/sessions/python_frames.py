# SPDX-License-Identifier: MIT
"""Frames of a session from Python against those from C++, in turns: A B A B.

usage: python_frames.py FRAMES_BENCH OUT.json [FRAMES [SIZE]]

FRAMES_BENCH is build/release/bench/sessions/frames_bench; frames (1000) are those of each side, in blocks of
50. Beside the times of frames, which whatever else runs disturbs, it says what the processors took: the ratio
of that is what Python adds. `--serve SIZE` is the side of Python.
"""

from __future__ import annotations

import json
import math
import statistics
import subprocess
import sys
import time
from typing import Any

BLOCK = 50


def serve(size: int) -> None:
    import dermis

    scene = dermis.Scene(dermis.Asset.load("built-in"))
    session = dermis.Session(outputs="display")
    frame = total = 0
    for line in sys.stdin:
        times = []
        cpu = time.process_time()
        for _ in range(int(line)):
            start = time.perf_counter()
            azimuth_deg = 40 * math.sin(0.1 * frame)
            drawn = session.draw(
                scene,
                size=(size, size),
                map_size=256,
                shadow_size=256,
                exposure=0.0,
                orbit=(azimuth_deg, 0.0),
            )
            total += int(drawn.display[0, 0, 0])
            times.append(1000 * (time.perf_counter() - start))
            frame += 1
        cpu_ms = 1000 * (time.process_time() - cpu)
        print(json.dumps({"ms": times, "cpu_ms": cpu_ms}), flush=True)
    print(f"{frame} frames, sum {total}", file=sys.stderr)


class Side:
    def __init__(self, *command: str) -> None:
        self.process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )

    def draw(self, frames: int) -> tuple[list[float], float]:
        assert self.process.stdin and self.process.stdout
        self.process.stdin.write(f"{frames}\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        return answer["ms"], answer["cpu_ms"]

    def end(self) -> str:
        return self.process.communicate()[1].strip().splitlines()[-1]


def quartiles(values: list[float]) -> list[float]:
    return [round(q, 3) for q in statistics.quantiles(values, n=4)]


def main() -> None:
    bench, output = sys.argv[1:3]
    frames = int(sys.argv[3]) if len(sys.argv) > 3 else 1000
    size = sys.argv[4] if len(sys.argv) > 4 else "64"
    sides = {"c++": Side(bench, size), "python": Side(sys.executable, __file__, "--serve", size)}
    for side in sides.values():
        side.draw(BLOCK)  # warms up
    times: dict[str, list[float]] = {name: [] for name in sides}
    cpu_ms = dict.fromkeys(sides, 0.0)
    turns, cpu_turns = [], []
    for _ in range(max(1, frames // BLOCK)):
        block = {name: side.draw(BLOCK) for name, side in sides.items()}
        for name in sides:
            times[name] += block[name][0]
            cpu_ms[name] += block[name][1]
        turns.append(statistics.median(block["python"][0]) / statistics.median(block["c++"][0]))
        cpu_turns.append(block["python"][1] / block["c++"][1])
    sums = {name: side.end() for name, side in sides.items()}
    record: dict[str, Any] = {
        "what": "ms per frame of a session, from C++ and from Python, in turns of 50 frames",
        "command": "bench/sessions/python_frames.py build/release/bench/sessions/frames_bench OUT.json",
        "frames": len(times["c++"]),
        "size": int(size),
        "quartiles_ms": {name: quartiles(values) for name, values in times.items()},
        "python_over_cpp": {
            "of_medians": round(statistics.median(times["python"]) / statistics.median(times["c++"]), 4),
            "quartiles_of_turns": quartiles(turns),
        },
        "cpu_ms_per_frame": {name: round(ms / len(times[name]), 3) for name, ms in cpu_ms.items()},
        "cpu_python_over_cpp": {
            "of_sums": round(cpu_ms["python"] / cpu_ms["c++"], 4),
            "quartiles_of_turns": quartiles(cpu_turns),
        },
        "same_pixels": sums["c++"] == sums["python"],
    }
    with open(output, "w", encoding="utf-8") as out:
        out.write(json.dumps(record, indent=1) + "\n")
    print(json.dumps(record, indent=1))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--serve"]:
        serve(int(sys.argv[2]))
    elif len(sys.argv) < 3:
        sys.exit(__doc__)
    else:
        main()
