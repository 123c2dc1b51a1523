# SPDX-License-Identifier: MIT
"""Data sets: pictures with labels, drawn from a recipe in shards, by any number of workers in any order.

>>> import dermis.dataset
>>> dermis.dataset.prepare("faces.json", "faces")  # checks all that can be checked before
>>> dermis.dataset.write("faces")                  # draws the shards that are missing
>>> assert dermis.dataset.verify("faces").faults == []

A sample is a function of the recipe and its number. Shards are tars as WebDataset reads them, equal to the
byte however they were drawn, on one class of device.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from . import _core
from ._asset import Path
from ._core import DatasetBenchmark as Benchmark
from ._core import DatasetVerified as Verified
from ._core import TryAgain
from ._progress import Progress, progress_of

__all__ = [
    "Benchmark",
    "Recipe",
    "TryAgain",
    "Verified",
    "Written",
    "bench",
    "coco",
    "dask",
    "datasheet",
    "missing",
    "prepare",
    "sheet",
    "slurm",
    "verify",
    "write",
]

TryAgain.__module__ = "dermis.dataset"


class Recipe:
    """A recipe, read from its file or from a prepared folder. Raises InputError: file, place, what is
    wrong."""

    def __init__(self, path: Path) -> None:
        text = os.fspath(path)
        self._core = _core.dataset_recipe_of(text) if os.path.isdir(text) else _core.dataset_recipe(text)
        self.name = self._core.name
        self.samples = self._core.samples
        self.identities = self._core.identities
        self.shards = self._core.shards
        self.sha256 = self._core.sha256
        """Of its values: not of spaces and order."""

    def parameters(self, sample: int) -> dict[str, Any]:
        """The values of a sample: identity, split, settings, head, pose. Equal on every machine."""
        values: dict[str, Any] = json.loads(self._core.parameters(sample))
        return values

    def samples_of(self, shard: int) -> range:
        first, count = self._core.samples_of(shard)
        return range(first, first + count)

    def file_of(self, shard: int) -> str:
        """Name of its tar: train-000012.tar."""
        return self._core.file_of(shard)

    def __repr__(self) -> str:
        return f"<dermis.dataset.Recipe '{self.name}', {self.samples} samples in {self.shards} shards>"


@dataclass(frozen=True)
class Written:
    """What write() has done: shards and samples drawn; shards that were there; left to other workers."""

    shards: int = 0
    samples: int = 0
    there: int = 0
    elsewhere: int = 0


def prepare(
    recipe: Path,
    folder: Path,
    *,
    one_device: bool = False,
    device: str = "best",
    progress: Progress | bool | None = None,
) -> Recipe:
    """Checks a recipe, draws a sample of each asset, and makes the folder with recipe.lock.json: SHA-256
    of all files, licences, class of the device. `one_device`: workers on another class are refused.
    Raises InputError: a mistake in the recipe, an asset without licence or one that cannot be drawn;
    DeviceError."""
    _core.dataset_prepare(os.fspath(recipe), os.fspath(folder), one_device, device, progress_of(progress))
    return Recipe(folder)


def write(
    folder: Path,
    shards: Iterable[int] | None = None,
    *,
    device: str = "best",
    threads: int = 0,
    progress: Progress | bool | None = None,
) -> Written:
    """Draws shards that are missing; None: all, but those that other workers draw now. `threads` encode
    pictures, 0: one for each core. Raises InputError: the folder is not prepared, a file has changed
    since; TryAgain: the disk is full, the device lost twice, the work was ended. No shard is
    half-written."""
    numbers = [] if shards is None else list(shards)
    if shards is not None and not numbers:
        return Written()
    return Written(
        *_core.dataset_write(os.fspath(folder), numbers, device, threads, progress_of(progress))
    )


def missing(folder: Path) -> list[int]:
    """Numbers of the shards that are not there, rising."""
    return _core.dataset_missing(os.fspath(folder))


def verify(
    folder: Path,
    *,
    redraw: float = 1e-3,
    device: str = "best",
    progress: Progress | bool | None = None,
) -> Verified:
    """Reads all shards: hashes, members, every JSON against the recipe; draws a share of the samples
    again, at least one, equal to the bit on the class of device that drew them. `faults` has a line for
    each fault."""
    return _core.dataset_verify(os.fspath(folder), redraw, device, progress_of(progress))


def slurm(
    folder: Path,
    *,
    program: str = "dermis",
    partition: str = "",
    minutes: int = 60,
    tasks: int = 1000,
    device: str = "best",
) -> str:
    """The text of a job script for sbatch: an array of at most `tasks` workers, each `program dataset
    write`. A task whose worker was killed or could not go on requeues itself, at most three times."""
    return _core.dataset_slurm(os.fspath(folder), program, partition, minutes, tasks, device)


def sheet(folder: Path, *, samples: int = 60) -> str:
    """A page, HTML: at most so many samples with labels over them, histograms of all parameters,
    licences."""
    return _core.dataset_sheet(os.fspath(folder), samples)


def datasheet(folder: Path) -> str:
    """A datasheet (Gebru et al. 2021), Markdown: identities, skin tones, ranges of all parameters, labels,
    licences, devices. "To fill in" marks what only people can answer."""
    return _core.dataset_datasheet(os.fspath(folder))


def coco(folder: Path) -> dict[str, Any]:
    """Boxes of heads, noses and ears as COCO has them, pixels, from the labels `instance` and `region`."""
    boxes: dict[str, Any] = json.loads(_core.dataset_coco(os.fspath(folder)))
    return boxes


def bench(
    recipe: Path,
    *,
    samples: int = 64,
    device: str = "best",
    threads: int = 0,
    progress: Progress | bool | None = None,
) -> Benchmark:
    """Draws samples in turns as write() does and by a bare session, and says where the time goes,
    seconds."""
    return _core.dataset_bench(os.fspath(recipe), samples, device, threads, progress_of(progress))


def dask(
    folder: Path, client: Any, *, device: str = "best", threads: int = 0, retries: int = 3
) -> Written:
    """Draws what is missing on the workers of a dask.distributed.Client, and returns what they did. The
    folder must have one name on all machines. A worker draws a run of shards at a time, so that it opens
    the device and loads heads once for several. What fails is tried again, at most `retries` times; Dask
    itself gives the tasks of a worker that died to others. Raises what a worker raised in the end."""
    left = missing(folder)
    workers = max(1, sum(client.nthreads().values()))
    size = max(1, -(-len(left) // (4 * workers)))
    runs = [left[i : i + size] for i in range(0, len(left), size)]
    futures = client.map(
        write,
        [os.path.abspath(os.fspath(folder))] * len(runs),
        runs,
        device=device,
        threads=threads,
        pure=False,
        retries=retries,
    )
    done: list[Written] = client.gather(futures)
    return Written(
        sum(w.shards for w in done),
        sum(w.samples for w in done),
        sum(w.there for w in done),
        sum(w.elsewhere for w in done),
    )
