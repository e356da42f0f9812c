"""Conversion of Python values to words of the command line, so that one parser gives the same messages for both."""
from __future__ import annotations

import math
import operator
import os
from collections.abc import Iterable, Mapping
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from ._brdf import InputError

Path = Union[str, bytes, "os.PathLike[str]"]
Floats = NDArray[np.floating[Any]]
Values = Union[float, Iterable[float], Floats]
Settings = Mapping[str, Union[Values, str]]

SEEDS = 2**64 - 1  # the largest


def path_of(path: Path) -> bytes:
    """Returns the name of a file in the encoding of the system."""
    return os.fsencode(path)


def number(value: float) -> str:
    """Returns the shortest digits that read back to the same double."""
    return repr(float(value))


def finite(option: str, value: float) -> float:
    """Returns the number of an option."""
    try:
        found = float(value)
    except (TypeError, ValueError):
        found = math.nan
    if not math.isfinite(found):
        raise InputError(f"{option}: '{value}' must be a finite number")
    return found


def whole(option: str, value: int, low: int, high: int) -> int:
    """Returns the whole number of an option, within its range."""
    found = _index(value)
    if found is None or not low <= found <= high:
        raise InputError(f"{option}: {value}: must be a whole number from {low} to {high}")
    return found


def seed_of(value: int) -> int:
    found = _index(value)
    if found is None or not 0 <= found <= SEEDS:
        raise InputError(f"--seed: '{value}' must be a whole number from 0 to {SEEDS}")
    return found


def _index(value: int) -> int | None:
    try:
        return operator.index(value)
    except TypeError:
        return None


def setting(name: str, values: Values) -> str:
    """Returns `name=v` or `name=v,v,v`."""
    try:
        given = np.atleast_1d(np.asarray(values, dtype=np.float64))
    except (TypeError, ValueError):
        given = np.empty((0, 0))
    if given.ndim != 1:
        raise InputError(f"{name}: {values!r}: must be a number, or one number per channel")
    return f"{name}={','.join(number(v) for v in given)}"


def settings(values: Settings | None) -> list[str]:
    return [f"{name}={value}" if isinstance(value, str) else setting(name, value)
            for name, value in (values or {}).items()]


def ranges(values: Mapping[str, tuple[float, float]] | None) -> list[str]:
    return [f"{name}={number(low)}:{number(high)}" for name, (low, high) in (values or {}).items()]


def list_of(words: str | Iterable[str] | None) -> list[str]:
    """Returns a list of one word or several words."""
    if words is None:
        return []
    return [words] if isinstance(words, str) else list(words)
