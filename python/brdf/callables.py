"""Functions of the caller that `judge` calls with arrays: checks of their results."""
from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._brdf import InputError
from .arrays import Array, numbers
from .material import directions
from .table import _columns, _names

Evaluated = Callable[[Array, Array], ArrayLike]  # of wi and wo
Sampled = Callable[[Array, Array], Any]  # of u and wo
Drawn = tuple[Array, "Array | None", "Array | None", "Array | None"]
PARTS = ("wi", "pdf", "value", "valid")  # of a sample
MOST_CHANNELS = 3
TRIED = 16  # rows of the trial calls


def _called(name: str, function: Callable[[Array, Array], Any], first: Array, second: Array) -> Any:
    """Calls the function. Warnings of numpy are silenced, because the checks report values that are not finite."""
    if not callable(function):
        raise InputError(f"{name}: {function!r}: must be a function of arrays")
    try:
        with np.errstate(all="ignore"):
            result = function(first, second)
    except Exception as error:
        raise InputError(f"{name}: the function raised {type(error).__name__}: {error}") from error
    if result is None:
        raise InputError(f"{name}: the function returned None: it must return an array")
    return result


def _one_each(name: str, values: ArrayLike, count: int) -> Array:
    """Returns one number for each of `count` rows."""
    array = numbers(name, values)
    if array.shape != (count,):
        raise InputError(f"{name}: shape {array.shape}: must be ({count},), one number for each row")
    return array


class Functions:
    """The functions in the form that the extension expects. They are tried with a few rows."""

    def __init__(self, eval: Evaluated | None, sample: Sampled | None, pdf: Evaluated | None, randoms: int) -> None:
        self._eval, self._sample, self._pdf, self._randoms = eval, sample, pdf, randoms
        self._channels = 0  # not known yet
        self._given: list[bool] | None = None  # which parts a sample has
        random = np.random.default_rng(1)
        wo = np.repeat(directions(40, 30)[None], TRIED, axis=0)
        wi = directions(random.uniform(1, 89, TRIED), random.uniform(0, 360, TRIED))
        u = random.random((TRIED, randoms))
        if eval is not None:
            self._try("eval", lambda rows: [self.eval(wi[rows], wo[rows])])
        if sample is not None:
            self._try("sample", lambda rows: self.sample(u[rows], wo[rows]))
        if pdf is not None:
            self._try("pdf", lambda rows: [self.pdf(wi[rows], wo[rows])])

    @property
    def channels(self) -> list[str]:
        return _names(max(self._channels, 1))

    @property
    def gives_pdf(self) -> bool:
        return self._given is not None and self._given[PARTS.index("pdf")]

    @property
    def gives_value(self) -> bool:
        return self._given is not None and self._given[PARTS.index("value")]

    def eval(self, wi: Array, wo: Array) -> Array:
        """Returns (rows, channels)."""
        assert self._eval is not None
        return self._of_channels("eval", _called("eval", self._eval, wi, wo), len(wi))

    def pdf(self, wi: Array, wo: Array) -> Array:
        """Returns (rows,)."""
        assert self._pdf is not None
        return _one_each("pdf", _called("pdf", self._pdf, wi, wo), len(wi))

    def sample(self, u: Array, wo: Array) -> Drawn:
        """Returns the parts of a sample: (rows, 3), (rows,), (rows, channels), (rows,); all but the first may be None."""
        assert self._sample is not None
        parts = self._parts(_called("sample", self._sample, u, wo))
        given = [part is not None for part in parts]
        if self._given is not None and given != self._given:
            raise InputError("sample: the function must return the same parts in every call")
        self._given = given
        count = len(u)
        wi = numbers("sample: wi", parts[0])
        if wi.shape != (count, 3):
            raise InputError(f"sample: wi: shape {wi.shape}: must be ({count}, 3), one direction for each row")
        pdf, valid = (None if p is None else _one_each(f"sample: {name}", p, count)
                      for name, p in (("pdf", parts[1]), ("valid", parts[3])))
        return wi, pdf, None if parts[2] is None else self._of_channels("sample: value", parts[2], count), valid

    @staticmethod
    def _parts(result: Any) -> list[Any]:
        """Returns the four parts of what a sampler returned."""
        if isinstance(result, Mapping):
            unknown = [str(name) for name in result if name not in PARTS]
            if unknown or result.get("wi") is None:
                wrong = f"the key {unknown[0]} is unknown" if unknown else "the key wi is missing"
                raise InputError(f"sample: {wrong}: a dictionary must have the keys wi and, if available, pdf, value, valid")
            return [result.get(name) for name in PARTS]
        parts = list(result) if isinstance(result, tuple) else [result]
        if not 1 <= len(parts) <= 3 or parts[0] is None:
            raise InputError(f"sample: a tuple of {len(parts)}: must be wi, (wi, pdf), (wi, pdf, value) or a dictionary")
        return parts + [None] * (len(PARTS) - len(parts))

    def _of_channels(self, name: str, values: ArrayLike, count: int) -> Array:
        """Returns (rows, channels), with the same channels in every call."""
        array = _columns(values, (count,), name)
        found = array.shape[1]
        if not 1 <= found <= MOST_CHANNELS:
            raise InputError(f"{name}: {found} channels: must be 1 to {MOST_CHANNELS}; judge further channels in a call of their own")
        if self._channels not in (0, found):
            raise InputError(f"{name}: {found} channels: must be {self._channels}, as in the other results")
        self._channels = found
        return array

    @staticmethod
    def _try(name: str, call: Callable[[NDArray[np.intp]], Any]) -> None:
        """Requires the same results for the same rows in another order."""
        forward, backward = np.arange(TRIED), np.arange(TRIED)[::-1]
        for a, b in zip(call(forward), call(backward)):
            if a is not None and not np.allclose(a[::-1], b, rtol=1e-6, atol=1e-12, equal_nan=True):
                raise InputError(f"{name}: the results differ if the same rows are given in another order: every result must "
                                 "follow from its own row, without a random generator inside")
