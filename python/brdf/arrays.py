"""Checks and broadcasting of array arguments. Functions raise InputError with the name of the argument."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._brdf import InputError

Array = NDArray[np.float64]
NUMBERS = "fiub"  # numpy's kinds of real numbers


def given(name: str, values: ArrayLike) -> NDArray[Any]:
    """Returns an array of real numbers of any type. An array is not copied."""
    try:
        array = np.asarray(values)
        if array.dtype.kind == "O":
            array = array.astype(np.float64)
    except (TypeError, ValueError):
        raise InputError(f"{name}: must be an array of numbers") from None
    if array.dtype.kind not in NUMBERS:
        raise InputError(f"{name}: {array.dtype}: must be numbers")
    return array


def numbers(name: str, values: ArrayLike) -> Array:
    """Returns the values as an array of float64."""
    return given(name, values).astype(np.float64, copy=False)


def check_vectors(name: str, array: NDArray[Any]) -> None:
    if array.ndim == 0 or array.shape[-1] != 3:
        raise InputError(f"{name}: shape {array.shape}: must end in 3")


def common_shape(names: Sequence[str], arrays: Sequence[NDArray[Any]]) -> tuple[int, ...]:
    """Returns the shape to which the arrays broadcast by numpy's rules."""
    try:
        return np.broadcast_shapes(*(a.shape for a in arrays))
    except ValueError:
        shapes = [str(a.shape) for a in arrays]
        raise InputError(f"{_listed(names)}: shapes {_listed(shapes)} do not broadcast") from None


def together(names: Sequence[str], arrays: Sequence[Array]) -> list[Array]:
    """Returns all arrays, broadcast to their common shape."""
    shape = common_shape(names, arrays)
    return [np.broadcast_to(a, shape) for a in arrays]


def _listed(words: Sequence[str]) -> str:
    return " and ".join([", ".join(words[:-1]), words[-1]])
