# SPDX-License-Identifier: MIT
"""Threads, processes, signals and callbacks."""

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from typing import Any

import numpy as np
import pytest
from conftest import small

import dermis
import dermis.reference


def test_two_threads_with_two_renderers(head: dermis.Asset) -> None:
    wanted = dermis.render(head, **small).display.copy()
    found: list[Any] = [None, None]

    def draw(i: int) -> None:
        with dermis.Renderer() as renderer:
            for _ in range(3):
                found[i] = renderer.render(head, **small).display

    threads = [threading.Thread(target=draw, args=(i,)) for i in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert np.array_equal(found[0], wanted) and np.array_equal(found[1], wanted)


def test_one_renderer_in_two_threads_is_refused(head: dermis.Asset) -> None:
    renderer = dermis.Renderer()
    begun, errors = threading.Event(), []

    def draw() -> None:
        begun.set()
        renderer.render(head, size=(512, 512), exposure=0, frames=20)

    thread = threading.Thread(target=draw)
    thread.start()
    begun.wait()
    time.sleep(0.2)
    try:
        renderer.render(head, **small)
    except RuntimeError as error:
        errors.append(str(error))
    thread.join()
    assert len(errors) == 1 and "works in another thread" in errors[0]
    assert renderer.render(head, **small).width == 64, "and then it works again"


def test_the_interpreter_runs_while_a_picture_is_drawn(head: dermis.Asset, renderer: dermis.Renderer) -> None:
    ticks, done = [0], threading.Event()

    def count() -> None:
        while not done.wait(0.005):
            ticks[0] += 1

    thread = threading.Thread(target=count)
    thread.start()
    start = time.perf_counter()
    renderer.render(head, size=(256, 256), exposure=0, frames=5)
    seconds = time.perf_counter() - start
    done.set()
    thread.join()
    assert ticks[0] > 0.3 * seconds / 0.006


forked = """
import os, sys
import dermis
scene = dermis.Scene.load("built-in")
renderer = dermis.Renderer()
session = renderer.session("depth")
settings = dict(size=(16, 16), map_size=64, shadow_size=64, exposure=0)
frame = session.draw(scene, **settings)
array = frame.depth
calls = [lambda: renderer.render(scene, **settings), lambda: session.draw(scene, **settings),
         lambda: dermis.Renderer(), lambda: dermis.devices(), lambda: dermis.Scene.load("built-in"),
         lambda: renderer.close(), lambda: dermis.Profile.preset("skin1"), lambda: frame.statistics]
pid = {fork}
if pid == 0:
    for number, call in enumerate(calls):
        try:
            call()
            os._exit(100 + number)
        except RuntimeError as error:
            if "spawn" not in str(error):
                os._exit(50 + number)
    array[0, 0] = 1
    del frame, array, session, renderer, scene  # destroys nothing that the parent has
    sys.exit(7)
_, status = os.waitpid(pid, 0)
assert os.waitstatus_to_exitcode(status) == 7, os.waitstatus_to_exitcode(status)
assert session.draw(scene, **settings).depth.shape == (16, 16)
print("right")
"""


@pytest.mark.parametrize("fork", ["os.fork()", "__import__('ctypes').CDLL(None).fork()"])
def test_a_process_that_was_forked_is_refused(fork: str) -> None:
    """Also by a fork that Python does not know of."""
    result = subprocess.run(
        [sys.executable, "-c", forked.replace("{fork}", fork)], capture_output=True, text=True, timeout=120
    )
    assert result.returncode == 0 and result.stdout.strip() == "right", result.stderr


def mean_in_worker(azimuth_deg: float) -> float:
    return float(dermis.render("built-in", **small, orbit=(azimuth_deg, 0)).linear.mean())


def test_spawned_workers_draw() -> None:
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        means = pool.map(mean_in_worker, [0.0, 30.0])
    assert means == [mean_in_worker(0.0), mean_in_worker(30.0)]


def interrupted(call: Any, after_s: float) -> float:
    """Sends SIGINT; returns how long the call takes to raise KeyboardInterrupt."""
    sent = [0.0]

    def interrupt() -> None:
        sent[0] = time.perf_counter()
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(after_s, interrupt)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        call()
    return time.perf_counter() - sent[0]


def test_ctrl_c_ends_a_reference_within_a_second(scene: dermis.Scene) -> None:
    assert (
        interrupted(
            lambda: dermis.reference.render(scene, size=(256, 256), exposure=0, reference={"samples": 10**6}),
            1.5,
        )
        < 1
    )


def test_ctrl_c_ends_a_picture_within_a_second(scene: dermis.Scene) -> None:
    renderer = dermis.Renderer()
    renderer.render(scene, **small)
    assert interrupted(lambda: renderer.render(scene, size=(512, 512), exposure=0, frames=20), 1) < 1
    # What was left behind is waited for.
    assert renderer.render(scene, **small).width == 64


def test_ctrl_c_ends_a_profile_within_a_second() -> None:
    assert interrupted(lambda: dermis.Profile.preset("skin1", model="monte-carlo", photons=10**9), 0.5) < 1


def test_progress_is_told_and_may_end_the_work(scene: dermis.Scene) -> None:
    heard: list[tuple[str, float]] = []
    settings: dict[str, Any] = {"size": (32, 32), "exposure": 0.0}
    dermis.reference.render(
        scene, reference={"samples": 2}, progress=lambda *work: heard.append(work), **settings
    )
    assert heard and all(isinstance(what, str) and 0 <= share <= 1 for what, share in heard)

    samples: list[int] = []

    def stop(progress: dermis.reference.SampleProgress) -> bool:
        samples.append(progress.samples)
        return progress.samples < 3

    truth = dermis.reference.render(scene, reference={"samples": 100}, after_sample=stop, **settings)
    assert not truth.complete and truth.samples < 20 and samples[:3] == [1, 2, 3]
    assert truth.linear.shape == truth.variance.shape == (32, 32, 4)
    with pytest.raises(dermis.Cancelled):
        dermis.Profile.preset("skin1", model="monte-carlo", progress=lambda what, share: False)


def test_an_exception_of_a_callback_reaches_the_caller(scene: dermis.Scene) -> None:
    class Mine(Exception):
        pass

    def fail(*_: Any) -> None:
        raise Mine("of the callback")

    with pytest.raises(Mine, match="of the callback"):
        dermis.Profile.preset("skin1", model="monte-carlo", progress=fail)
    with pytest.raises(Mine, match="of the callback"):
        dermis.reference.render(scene, size=(16, 16), exposure=0, reference={"samples": 4}, after_sample=fail)
    assert dermis.Profile.preset("skin1").name


def test_lines_go_to_the_logger(caplog: pytest.LogCaptureFixture) -> None:
    mesh = dermis.Mesh(positions=[[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0]])
    with caplog.at_level("WARNING", logger="dermis"):
        dermis.Asset.from_arrays([mesh], [dermis.Material(name="skin", skin=True)])
    assert any(record.name == "dermis" for record in caplog.records), "skin without coordinates"


class Azimuths:
    """Pictures of a data set, by index."""

    def __len__(self) -> int:
        return 4

    def __getitem__(self, index: int) -> Any:
        return dermis.render("built-in", **small, orbit=(10.0 * index, 0)).linear


def test_a_data_loader_with_spawned_workers() -> None:
    data: Any = pytest.importorskip("torch.utils.data", reason="torch is not installed")
    loader = data.DataLoader(Azimuths(), batch_size=2, num_workers=2, multiprocessing_context="spawn")
    batches = [batch.numpy() for batch in loader]
    assert [batch.shape for batch in batches] == [(2, 48, 64, 4), (2, 48, 64, 4)]
    assert np.array_equal(batches[1][1], Azimuths()[3])
