# SPDX-License-Identifier: MIT
"""Pictures against pictures, and techniques against ground truth."""

from typing import Any

import numpy as np
import pytest
from conftest import small

import dermis
import dermis.compare
import dermis.reference

random = np.random.default_rng(3)
shown = random.integers(0, 256, (40, 60, 3), np.uint8)
other = np.clip(shown + random.normal(0, 20, shown.shape), 0, 255).astype(np.uint8)
light = random.gamma(1.0, 0.5, (24, 32, 3)).astype(np.float32)


def test_flip_is_that_of_its_authors(scene: dermis.Scene) -> None:
    """NVIDIA's own evaluator, on noise and on pictures of a head."""
    evaluator: Any = pytest.importorskip("flip_evaluator", reason="flip-evaluator is not installed")
    view: dict[str, Any] = {**small, "light": [(60, 10)]}
    head, lambert = (dermis.render(scene, **view, technique=name) for name in ("texture-space", "lambert"))
    for a, b in ((shown, other), (head.display[..., :3], lambert.display[..., :3])):
        theirs, mean, _ = evaluator.evaluate(
            a.astype(np.float32) / 255, b.astype(np.float32) / 255, "LDR", True, False, True
        )
        found = dermis.compare.flip(a, b)
        assert abs(found.mean - mean) < 1e-3
        assert np.abs(found.map - np.asarray(theirs)[..., 0]).max() < 1e-3
        assert found.exposures is None and float(found) == found.mean

    _, mean, _ = evaluator.evaluate(light, light * 1.3, "HDR", False, False, True)
    found = dermis.compare.flip(light, light * 1.3)
    assert abs(found.mean - mean) < 1e-3
    assert found.exposures is not None and found.exposures[2] >= 2


def test_errors_have_closed_forms() -> None:
    one = np.ones((8, 8, 3), np.float32)
    assert dermis.compare.relative_mse(one, 1.5 * one) == pytest.approx(0.25 / 1.01, rel=1e-6)
    assert dermis.compare.relative_mse(one, 1.5 * one, variance=0.04 * one) == pytest.approx(
        0.21 / 1.01, rel=1e-5
    )
    grey = np.full((8, 8, 3), 100, np.uint8)
    assert dermis.compare.psnr_db(grey, grey + 10) == pytest.approx(20 * np.log10(255 / 10))
    assert dermis.compare.psnr_db(grey, grey) == 100
    assert dermis.compare.flip(grey, grey).mean == 0
    with_alpha = np.dstack([one, np.zeros((8, 8), np.float32)])
    assert dermis.compare.relative_mse(with_alpha, one) == 0


def test_a_mask_leaves_pixels_out() -> None:
    test = light.copy()
    test[:, :16] = 0
    right = np.zeros(light.shape[:2], bool)
    right[:, 24:] = True
    assert dermis.compare.relative_mse(light, test, mask=right) == 0
    assert dermis.compare.relative_mse(light, test) > 0.1
    assert dermis.compare.flip(light, test, mask=~right).mean > dermis.compare.flip(light, test).mean


def test_pictures_are_taken_as_they_are(scene: dermis.Scene) -> None:
    a, b = dermis.render(scene, **small), dermis.render(scene, **{**small, "exposure": 0.5})
    assert dermis.compare.flip(a, b).mean == dermis.compare.flip(a.display, b.display).mean > 0
    assert dermis.compare.relative_mse(a, b) == dermis.compare.relative_mse(a.linear, b.linear)
    strided = np.asfortranarray(a.linear.astype(">f8"))
    assert dermis.compare.relative_mse(strided, b) == dermis.compare.relative_mse(a, b)


bad = light.copy()
bad[3, 5, 1] = np.nan


@pytest.mark.parametrize(
    "reference, test, keywords, message",
    [
        (light, light[:-1], {}, r"^test has the shape \(23, 32, 3\), reference \(24, 32, 3\)$"),
        (light[..., 0], light, {}, r"^reference must have the shape \(H, W, 3 or 4\), got \(24, 32\)$"),
        (light, light[..., :2], {}, r"^test must have the shape"),
        (light, bad, {}, r"^test must be finite: \[3, 5, 1\] is not$"),
        (light, np.full(light.shape, np.inf), {}, r"must be finite"),
        (light, light.astype(int), {}, r"^test must be uint8 \(display values\) or float \(linear light\)"),
        (light, light.astype(complex), {}, r"must be uint8"),
        (light, np.full(light.shape, "x"), {}, r"must be numbers"),
        (light, [[1, 2], [3]], {}, r"^test"),
        (shown, light, {}, r"^reference is uint8 and test is float32"),
        (light, light, {"mask": np.ones((24, 31))}, r"^mask must be bool \(H, W\), got float64"),
        (light, light, {"mask": np.ones((24, 31), bool)}, r"^mask: has the shape \(24, 31\), pictures"),
        (light, light, {"mask": np.ones((32, 24), bool)}, r"^mask: has the shape \(32, 24\), pictures"),
        (light, light, {"mask": np.zeros((24, 32), bool)}, r"mask|region"),
    ],
)
def test_what_cannot_be_compared_is_refused(
    reference: Any, test: Any, keywords: dict[str, Any], message: str
) -> None:
    with pytest.raises(dermis.InputError, match=message) as error:
        dermis.compare.flip(reference, test, **keywords)
    assert "\n" not in str(error.value)


def test_each_error_takes_its_kind() -> None:
    with pytest.raises(dermis.InputError, match="must be linear light, float, got uint8"):
        dermis.compare.relative_mse(shown, other)
    with pytest.raises(dermis.InputError, match="must be uint8"):
        dermis.compare.psnr_db(light, light)
    with pytest.raises(dermis.InputError, match="at least 0"):
        dermis.compare.relative_mse(light, light, variance=-light)
    with pytest.raises(dermis.InputError, match="variance"):
        dermis.compare.relative_mse(light, light, variance=light[:4])


def test_regions_are_masks(scene: dermis.Scene) -> None:
    found = dermis.compare.regions(scene, **small)
    assert list(found)[0] == "skin" and {"ears", "nose", "terminator"} <= set(found)
    assert all(mask.shape == (48, 64) and mask.dtype == bool for mask in found.values())
    assert 0 < found["nose"].sum() < found["skin"].sum()


def test_techniques_are_rows(scene: dermis.Scene) -> None:
    view: dict[str, Any] = {**small, "light": [(60, 10)]}
    truth = dermis.reference.render(scene, reference={"samples": 32}, **view)
    table = dermis.compare.techniques(
        scene, ["texture-space", "lambert"], truth=truth, supersample=2, frames=2, **view
    )
    assert table.names == ["texture-space", "lambert"]
    assert table.samples == 32 and table.noise_percent == truth.noise_percent
    skin = table.row("texture-space")
    assert (skin.technique, skin.region) == ("texture-space", "skin")
    assert skin.pixels == table.regions["skin"].sum() > 100 and skin.share == 1 and skin.frame_ms > 0
    assert skin.relative_mse_less_noise is not None and skin.relative_mse_less_noise < skin.relative_mse
    assert {row.region for row in table.rows} <= set(table.regions)
    assert table.noise and table.noise[0].region == "skin"

    # The rows are what the functions say of the pictures.
    for name in table.names:
        found = dermis.compare.flip(table.display(), table.display(name), mask=table.regions["skin"])
        assert found.mean == pytest.approx(table.row(name).flip, rel=1e-6)
        assert np.array_equal(found.map, table.flip_map(name))
        assert table.statistics(name)["technique"] == name
    assert np.array_equal(table.display()[..., :3], truth.display[..., :3])
    assert "<table>" in table._repr_html_()
    with pytest.raises(KeyError, match="did you mean 'lambert'"):
        table.display("lambret")
    with pytest.raises(KeyError, match="texture-space"):
        table.row("oil")


def test_a_truth_is_computed_where_none_is_given(scene: dermis.Scene) -> None:
    heard: list[str] = []
    table = dermis.compare.techniques(
        scene,
        "lambert",
        reference={"samples": 2},
        supersample=1,
        curves=True,
        progress=lambda what, share: heard.append(what),
        **small,
    )
    assert table.samples == 2 and [point.setting for point in table.curves] == ["lambert"]
    assert "frames in turns" in heard and "techniques" in heard


@pytest.mark.parametrize(
    "keywords, message",
    [
        ({"techniques": ["lambret"]}, r"^techniques: .*did you mean 'lambert'"),
        ({"supersample": 17}, r"^supersample must be 1 to 16, got 17"),
        ({"distance": 1e6}, r"shows no skin"),
        ({"reference": {"samples": 0}}, r"samples"),
    ],
)
def test_what_makes_no_table_is_refused(scene: dermis.Scene, keywords: dict[str, Any], message: str) -> None:
    with pytest.raises(dermis.InputError, match=message):
        dermis.compare.techniques(scene, **{"reference": {"samples": 1}, **small, **keywords})


def test_a_truth_of_another_size_is_refused(scene: dermis.Scene) -> None:
    truth = dermis.reference.render(scene, size=(32, 32), exposure=0, reference={"samples": 1})
    with pytest.raises(dermis.InputError, match=r"^truth: is 32 x 32 pixels, size and size say 64 x 48"):
        dermis.compare.techniques(scene, "lambert", truth=truth, **small)
    with pytest.raises(dermis.InputError, match=r"give the number"):
        dermis.compare.techniques(scene, "lambert", truth=truth, **{**small, "exposure": None})


def test_a_progress_function_ends_it(scene: dermis.Scene) -> None:
    with pytest.raises(dermis.Cancelled):
        dermis.compare.techniques(scene, "lambert", progress=lambda what, share: False, **small)
