"""Tables from pandas and xarray, and back. Neither package is imported before it is needed."""
from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from ._brdf import InputError
from .arrays import Array, numbers
from .words import Path

if TYPE_CHECKING:
    import pandas
    import xarray

    Frame = Union[pandas.DataFrame, xarray.DataArray, xarray.Dataset]
else:
    Frame = Any

ANGLES = ("theta_i", "phi_i", "theta_o", "phi_o")
PREFIX = "sigma_"
Layout = Union[Path, Mapping[str, Any]]
IN_NM = {"nm": 1.0, "um": 1e3, "µm": 1e3, "μm": 1e3, "micrometer": 1e3, "nanometer": 1.0, "m": 1e9}
IN_DEGREES = {"deg": False, "degree": False, "degrees": False, "°": False, "rad": True, "radian": True, "radians": True}
PER_STERADIAN = ("1/sr", "sr-1", "sr^-1", "sr**-1", "1 / steradian", "1 / sr")


def needed(package: str) -> Any:
    """Imports pandas or xarray. Raises ImportError with the name of Debian's package."""
    try:
        return __import__(package)
    except ImportError as error:
        raise ImportError(f"this needs {package}, which is not installed (Debian: python3-{package})") from error


def kind_of(source: object) -> str:
    """Returns "DataFrame", "DataArray" or "Dataset" for objects of pandas and xarray, otherwise "". Imports neither."""
    for base in type(source).__mro__:
        package = base.__module__.partition(".")[0]
        if (package, base.__name__) in (("pandas", "DataFrame"), ("xarray", "DataArray"), ("xarray", "Dataset")):
            return base.__name__
    return ""


def layout_word(layout: Layout | None) -> bytes:
    """Returns a layout for the extension: the name of a file, or the JSON itself."""
    if layout is None:
        return b""
    if isinstance(layout, Mapping):
        return json.dumps(layout).encode()
    return os.fsencode(layout)


def with_columns(frame: pandas.DataFrame) -> pandas.DataFrame:
    """Returns the frame with the named levels of its index as columns."""
    named = [name for name in frame.index.names if name is not None]
    return frame.reset_index(level=named) if named else frame


class Labelled:
    """The angles, values and deviations of a DataArray or a Dataset, one row for each combination of its dimensions."""

    def __init__(self, data: xarray.DataArray | xarray.Dataset) -> None:
        xarray = needed("xarray")
        self.kind = kind_of(data)
        if self.kind == "DataArray":
            name = "fr" if data.name is None else str(data.name)
            data = xarray.Dataset({name: data})
        self.data = data
        names = [str(name) for name in data.data_vars]
        self.values_of = [n for n in names if not n.startswith(PREFIX)]
        if not self.values_of:
            raise InputError(f"{self.kind}: no variable of values")
        for name in names:
            if name.startswith(PREFIX) and name.removeprefix(PREFIX) not in self.values_of:
                raise InputError(f"{self.kind}: variable '{name}' has no variable of values")
            self._check_unit(name)
        self._read()

    def _check_unit(self, name: str) -> None:
        attributes = self.data[name].attrs
        unit = str(attributes.get("units", "1/sr")).strip()
        if unit not in PER_STERADIAN:
            raise InputError(f"{self.kind}: variable '{name}': units {unit!r}: must be 1/sr (f_r); convert the values")
        quantity = str(attributes.get("quantity", "f_r")).strip()
        if quantity != "f_r":
            raise InputError(f"{self.kind}: variable '{name}': quantity {quantity!r}: must be f_r; convert the values")

    def _read(self) -> None:
        data = self.data
        has_bands = "wavelength" in data.coords or "wavelength" in data.dims
        if has_bands and len(self.values_of) > 1:
            raise InputError(f"{self.kind}: a wavelength needs one variable of values, not {len(self.values_of)}")
        for name in (*ANGLES, *(["wavelength"] if has_bands else [])):
            if name not in data.coords:
                raise InputError(f"{self.kind}: coordinate '{name}' is missing" +
                                 (f": assign it, for example assign_coords({name}=0)" if name in ANGLES else ""))
        bands = "wavelength" if has_bands and data["wavelength"].ndim == 1 else None
        if has_bands and data["wavelength"].ndim == 1 and data["wavelength"].dims != ("wavelength",):
            raise InputError(f"{self.kind}: coordinate 'wavelength' must be a dimension or a single number")
        dims = [d for d in data.dims if d != bands]
        sizes = [data.sizes[d] for d in dims]
        self.angles: list[Array] = [self._angle(name, dims, sizes) for name in ANGLES]
        self.channels = self._channels(bands)
        columns = [self._columns(name, dims, sizes, bands) for name in self.values_of]
        self.values: Array = np.concatenate(columns, axis=1)
        self.sigma: Array = np.concatenate([
            self._columns(PREFIX + name, dims, sizes, bands) if PREFIX + name in data.data_vars else np.full_like(column, np.nan)
            for name, column in zip(self.values_of, columns)], axis=1)
        self._leave_out()

    def _angle(self, name: str, dims: list[Any], sizes: list[int]) -> Array:
        coordinate = self.data[name]
        unit = str(coordinate.attrs.get("units", "deg")).strip()
        if unit not in IN_DEGREES:
            raise InputError(f"{self.kind}: coordinate '{name}': units {unit!r}: must be deg or rad")
        if not set(coordinate.dims) <= set(dims):
            raise InputError(f"{self.kind}: coordinate '{name}' must not depend on the wavelength")
        array = self._spread(coordinate, dims, sizes, f"{self.kind}: coordinate '{name}'")
        return np.degrees(array) if IN_DEGREES[unit] else array

    @staticmethod
    def _spread(variable: Any, dims: list[Any], sizes: list[int], what: str) -> Array:
        """Returns the variable as one number for each combination of the dimensions."""
        missing = [d for d in dims if d not in variable.dims]
        whole = variable.expand_dims({d: size for d, size in zip(dims, sizes) if d in missing}).transpose(*dims)
        return numbers(what, whole.values).reshape(-1)

    def _channels(self, bands: str | None) -> list[str]:
        data = self.data
        if "wavelength" not in data.coords:
            return self.values_of
        unit = str(data["wavelength"].attrs.get("units", "nm")).strip()
        if unit not in IN_NM:
            raise InputError(f"{self.kind}: coordinate 'wavelength': units {unit!r}: must be nm, um or m")
        found = numbers(f"{self.kind}: coordinate 'wavelength'", np.atleast_1d(numbers("wavelength", data["wavelength"].to_numpy())))
        return [f"{float(f'{IN_NM[unit] * w:.9g}'):.10g}nm" for w in found]

    def _columns(self, name: str, dims: list[Any], sizes: list[int], bands: str | None) -> Array:
        variable = self.data[name]
        what = f"{self.kind}: variable '{name}'"
        if bands is None or bands not in variable.dims:
            column = self._spread(variable, dims, sizes, what)[:, None]
            return np.repeat(column, len(self.channels) if bands else 1, axis=1)
        return np.stack([self._spread(variable.isel({bands: k}), dims, sizes, what)
                         for k in range(variable.sizes[bands])], axis=1)

    def _leave_out(self) -> None:
        """Leaves out the directions without any value. A grid holds NaN where nothing was measured."""
        gaps = np.isnan(self.values)
        empty = gaps.all(axis=1)
        partly = gaps.any(axis=1) & ~empty
        if partly.any():
            k = int(np.argmax(partly))
            at = ", ".join(f"{name} {angle[k]:g}" for name, angle in zip(ANGLES, self.angles))
            raise InputError(f"{self.kind}: NaN in some channels but not in all at {at} ({int(partly.sum())} such directions): "
                             "drop these directions or channels")
        keep = ~empty
        self.angles = [angle[keep] for angle in self.angles]
        self.values, self.sigma = self.values[keep], self.sigma[keep]
