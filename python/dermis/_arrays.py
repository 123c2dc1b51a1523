# SPDX-License-Identifier: MIT
"""Arrays that come from callers: of any type, stride and byte order that keeps their values, else
refused."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core


def numbers(name: str, value: Any, columns: int, rows: int | None = None) -> NDArray[np.float32]:
    """Returns float32 (N, columns), contiguous. Raises InputError: another shape, not real numbers, a
    value that is not finite or too large for float32."""
    array = _as_array(name, value)
    wanted = f"({'N' if rows is None else rows}, {columns})"
    if array.ndim != 2 or array.shape[1] != columns or (rows is not None and array.shape[0] != rows):
        raise _core.InputError(f"{name} must have the shape {wanted}, got {array.shape}")
    return as_float32(name, array)


def as_float32(name: str, array: NDArray[Any]) -> NDArray[np.float32]:
    if array.dtype.kind not in "fiu":
        raise _core.InputError(f"{name} must be real numbers, got {array.dtype}")
    if not np.isfinite(array).all():
        raise _core.InputError(f"{name} must be finite: {first_place(~np.isfinite(array))} is not")
    with np.errstate(over="ignore"):
        out = np.ascontiguousarray(array, dtype=np.float32)
    if not np.isfinite(out).all():
        raise _core.InputError(f"{name} must fit float32: {first_place(~np.isfinite(out))} does not")
    return out


def whole_numbers(name: str, value: Any) -> NDArray[np.uint32]:
    """Returns uint32 (N,), contiguous: a list of numbers, or triangles (N, 3). Raises InputError: not whole
    numbers, one below 0 or above 2^32 - 1."""
    array = _as_array(name, value)
    if array.ndim == 2 and array.shape[1] == 3:
        array = array.reshape(-1)
    if array.ndim != 1:
        raise _core.InputError(f"{name} must have the shape (N,) or (N, 3), got {array.shape}")
    if array.size == 0:
        return np.zeros(0, np.uint32)
    if array.dtype.kind not in "iu":
        raise _core.InputError(f"{name} must be whole numbers, got {array.dtype}")
    if int(array.min()) < 0 or int(array.max()) >= 1 << 32:
        raise _core.InputError(
            f"{name} must be 0 to 4294967295, got {int(array.min())} to {int(array.max())}"
        )
    return np.ascontiguousarray(array, dtype=np.uint32)


def pixels(name: str, value: Any) -> NDArray[np.uint8]:
    """Returns uint8 (H, W, C), contiguous, C 1 to 4. Raises InputError: another type or shape."""
    array = _as_array(name, value)
    if array.ndim == 2:
        array = array[:, :, np.newaxis]
    if array.ndim != 3 or not 1 <= array.shape[2] <= 4 or array.size == 0:
        raise _core.InputError(f"{name} must have the shape (H, W) or (H, W, 1 to 4), got {array.shape}")
    if array.dtype != np.uint8:
        raise _core.InputError(f"{name} must be uint8, got {array.dtype}")
    return np.ascontiguousarray(array)


def radiance(name: str, value: Any) -> NDArray[np.float32]:
    """Returns float32 (H, W, 3), contiguous, at least 0."""
    array = _as_array(name, value)
    if array.ndim != 3 or array.shape[2] != 3 or array.size == 0:
        raise _core.InputError(f"{name} must have the shape (H, W, 3), got {array.shape}")
    out = as_float32(name, array)
    if out.min() < 0:
        raise _core.InputError(f"{name} must be at least 0: {first_place(out < 0)} is not")
    return out


def picture(name: str, value: Any) -> NDArray[np.uint8] | NDArray[np.float32]:
    """Returns uint8 or float32 (H, W, 3 or 4), contiguous. Raises InputError: another type or shape, a value
    that is not finite."""
    array = _as_array(name, value)
    if array.ndim != 3 or array.shape[2] not in (3, 4) or array.size == 0:
        raise _core.InputError(f"{name} must have the shape (H, W, 3 or 4), got {array.shape}")
    if array.dtype == np.uint8:
        return np.ascontiguousarray(array)
    if array.dtype.kind != "f":
        raise _core.InputError(
            f"{name} must be uint8 (display values) or float (linear light), got {array.dtype}"
        )
    return as_float32(name, array)


def light(name: str, value: Any) -> NDArray[np.float32]:
    """Returns float32 (H, W, 3 or 4), contiguous. Raises InputError as picture() does, and for uint8."""
    found = picture(name, value)
    if found.dtype == np.uint8:
        raise _core.InputError(f"{name} must be linear light, float, got uint8")
    return found.astype(np.float32, copy=False)


def matrix(name: str, value: Any) -> list[float]:
    """Returns a 4x4 matrix column by column."""
    array = _as_array(name, value)
    if array.shape != (4, 4) or array.dtype.kind not in "fiu":
        raise _core.InputError(f"{name} must be real numbers (4, 4), got {array.dtype} {array.shape}")
    if not np.isfinite(array).all():
        raise _core.InputError(f"{name} must be finite: {first_place(~np.isfinite(array))} is not")
    return [float(x) for x in np.asarray(array, np.float64).T.reshape(-1)]


def first_place(wrong: NDArray[np.bool_]) -> str:
    return "[" + ", ".join(str(int(i)) for i in np.argwhere(wrong)[0]) + "]"


def _as_array(name: str, value: Any) -> NDArray[Any]:
    try:
        array: NDArray[Any] = np.asarray(value)
    except ValueError as error:
        raise _core.InputError(f"{name} is no array: {error}") from None
    if array.dtype.kind in "OSUMmV":
        raise _core.InputError(f"{name} must be numbers, got {array.dtype}")
    return array
