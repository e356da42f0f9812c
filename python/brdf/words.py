"""Python's values as the words of the command line, which the library parses: one parser, the same sentences."""
from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

Path = Union[str, bytes, "os.PathLike[str]"]
Floats = NDArray[np.floating[Any]]
Values = Union[float, Iterable[float], Floats]
Settings = Mapping[str, Values]


def path_of(path: Path) -> bytes:
    """A file's name as the system has it."""
    return os.fsencode(path)


def number(value: float) -> str:
    """The shortest digits that read back to the same double."""
    return repr(float(value))


def setting(name: str, values: Values) -> str:
    """`name=v` or `name=v,v,v`."""
    return f"{name}={','.join(number(v) for v in np.atleast_1d(np.asarray(values, dtype=np.float64)))}"


def settings(values: Settings | None) -> list[str]:
    return [setting(name, value) for name, value in (values or {}).items()]


def ranges(values: Mapping[str, tuple[float, float]] | None) -> list[str]:
    return [f"{name}={number(low)}:{number(high)}" for name, (low, high) in (values or {}).items()]


def list_of(words: str | Iterable[str] | None) -> list[str]:
    """One word or several."""
    if words is None:
        return []
    return [words] if isinstance(words, str) else list(words)
