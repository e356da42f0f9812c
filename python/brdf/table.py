"""Tables of samples: read from any format, made from arrays, converted to numpy and pandas."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import _brdf
from ._brdf import InputError
from .arrays import Array, check_vectors, numbers, together
from .display import plot_slices, table_html
from .entries import made
from .frames import ANGLES, PREFIX, Labelled, Layout, kind_of, layout_word, needed, with_columns
from .words import Path, list_of, path_of

if TYPE_CHECKING:
    import pandas
    import xarray

IN_PLANE = 0.5  # degrees by which a direction may be out of the plane


def _names(count: int) -> list[str]:
    """Returns the default names of channels, the same as for a material."""
    return {1: ["fr"], 3: ["r", "g", "b"]}.get(count, [f"c{k}" for k in range(count)])


def _columns(values: ArrayLike, shape: tuple[int, ...], what: str) -> Array:
    """Returns values of shape `shape` or `shape + (channels,)` as (pairs, channels)."""
    array = numbers(what, values)
    if array.shape == shape:
        return array.reshape(-1, 1)
    if array.ndim == len(shape) + 1 and array.shape[:-1] == shape:
        return array.reshape(-1, array.shape[-1])
    raise InputError(f"{what}: shape {array.shape}: must be {shape}, or this shape followed by the number of channels")


class Table:
    """Measured or computed values of f_r in 1/sr, one row per pair of directions.

    wi, wo: (..., 3), which broadcast: directions of any length above 0, to the light and to the viewer. values: f_r in 1/sr
    with the shape of the pairs, or this shape followed by the number of channels. sigma: standard deviations of the same
    shape; all NaN in a channel without known deviations. channels: names (default "fr", or "r", "g", "b"). metadata:
    comments for the head of a CSV. Raises InputError if a rule of tables is broken (docs/formats.md).

    Rows store polar angles in degrees, as files do; `from_degrees` makes a table from such angles without rounding.
    """

    _samples: _brdf.Samples

    def __init__(self, wi: ArrayLike, wo: ArrayLike, values: ArrayLike, *, sigma: ArrayLike | None = None,
                 channels: Sequence[str] | None = None, metadata: Mapping[str, str] | None = None) -> None:
        light, viewer = numbers("wi", wi), numbers("wo", wo)
        for name, array in (("wi", light), ("wo", viewer)):
            check_vectors(name, array)
            if not np.all(np.isfinite(array)) or not np.all(np.any(array != 0, axis=-1)):
                raise InputError(f"{name}: every direction must be finite and longer than 0")
        light, viewer = together(("wi", "wo"), (light, viewer))
        angles = [*_brdf.angles_of(light.reshape(-1, 3)), *_brdf.angles_of(viewer.reshape(-1, 3))]
        self._samples = _made(angles, light.shape[:-1], values, sigma, channels, metadata)

    @classmethod
    def from_degrees(cls, theta_i: ArrayLike, phi_i: ArrayLike, theta_o: ArrayLike, phi_o: ArrayLike,
                     values: ArrayLike, *, sigma: ArrayLike | None = None, channels: Sequence[str] | None = None,
                     metadata: Mapping[str, str] | None = None) -> Table:
        """Returns a table for polar angles and azimuths in degrees, which broadcast."""
        angles = together(ANGLES, [numbers(name, a) for name, a in zip(ANGLES, (theta_i, phi_i, theta_o, phi_o))])
        return cls._of(_made([a.reshape(-1) for a in angles], angles[0].shape, values, sigma, channels, metadata))

    @classmethod
    def from_pandas(cls, frame: pandas.DataFrame, *, metadata: Mapping[str, str] | None = None, quantity: str = "",
                    mirror_side: str = "auto", layout: Layout | None = None) -> Table:
        """Returns a table from a frame with the columns of a CSV: theta_i, phi_i, theta_o, phi_o, channels, sigma_CHANNEL.

        Named levels of the index count as columns. A frame with a column of wavelengths, and a frame read with quantity,
        mirror_side or layout (as in `read`), is read like a file with these columns. Without these options the values of
        a frame are f_r.
        """
        frame = with_columns(frame)
        if quantity or mirror_side != "auto" or layout is not None or "wavelength" in frame.columns:
            if metadata:
                raise InputError("metadata: cannot be given for a frame that is read like a file")
            stated = quantity if quantity or layout is not None else "f_r"
            return cls.from_csv(frame.to_csv(index=False), "frame", quantity=stated, mirror_side=mirror_side, layout=layout)
        columns = {str(name): frame[name] for name in frame.columns}
        if len(columns) != len(frame.columns):
            raise InputError("frame: two columns have the same name")
        for name in ANGLES:
            if name not in columns:
                raise InputError(f"frame: column '{name}' is missing")
        names = [n for n in columns if n not in ANGLES and not n.startswith(PREFIX)]
        if not names:
            raise InputError("frame: no column of values")
        for name in columns:
            if name.startswith(PREFIX) and name.removeprefix(PREFIX) not in names:
                raise InputError(f"frame: column '{name}' has no column of values")

        def column(name: str) -> Array:
            return numbers(f"frame: column '{name}'", columns[name]) if name in columns else np.full(len(frame), np.nan)

        theta_i, phi_i, theta_o, phi_o = (column(a) for a in ANGLES)
        return cls.from_degrees(theta_i, phi_i, theta_o, phi_o, np.stack([column(n) for n in names], axis=-1),
                                sigma=np.stack([column(PREFIX + n) for n in names], axis=-1), channels=names,
                                metadata=metadata)

    @classmethod
    def from_xarray(cls, data: xarray.DataArray | xarray.Dataset, *, metadata: Mapping[str, str] | None = None) -> Table:
        """Returns a table from a DataArray, or from a Dataset whose variables are channels and sigma_CHANNEL.

        theta_i, phi_i, theta_o and phi_o are coordinates: dimensions, single numbers, or numbers along other dimensions. A
        dimension `wavelength` gives a channel for each wavelength. The attribute `units` may be deg or rad for angles, nm,
        um or m for wavelengths, 1/sr for values; without it, angles are in degrees and wavelengths in nm. Directions in
        which all channels are NaN are left out.
        """
        read = Labelled(data)
        theta_i, phi_i, theta_o, phi_o = read.angles
        return cls.from_degrees(theta_i, phi_i, theta_o, phi_o, read.values, sigma=read.sigma, channels=read.channels,
                                metadata=metadata)

    @classmethod
    def from_csv(cls, text: str, name: str = "text", *, quantity: str = "", mirror_side: str = "auto",
                 layout: Layout | None = None) -> Table:
        """Returns the table of a file with this content. The options are the same as in `read`."""
        return cls._of(_brdf.read_text(text, name, quantity, mirror_side, layout_word(layout)))

    @classmethod
    def _of(cls, samples: _brdf.Samples) -> Table:
        return made(cls, _samples=samples)

    @property
    def theta_i(self) -> Array:
        """(rows,) angle of incidence in degrees. This and the next three are read-only views of the table's memory."""
        return self._samples.theta_i

    @property
    def phi_i(self) -> Array:
        """(rows,) azimuth of the incident direction in degrees."""
        return self._samples.phi_i

    @property
    def theta_o(self) -> Array:
        """(rows,) viewing angle in degrees."""
        return self._samples.theta_o

    @property
    def phi_o(self) -> Array:
        """(rows,) azimuth of the viewing direction in degrees."""
        return self._samples.phi_o

    @property
    def wi(self) -> Array:
        """(rows, 3) unit vectors to the light."""
        return self._samples.wi

    @property
    def wo(self) -> Array:
        """(rows, 3) unit vectors to the viewer."""
        return self._samples.wo

    @property
    def values(self) -> Array:
        """(rows, channels) f_r in 1/sr as a copy; `table["r"]` is a view."""
        return self._samples.values

    @property
    def sigma(self) -> Array | None:
        """(rows, channels) standard deviations in 1/sr, NaN in a channel without them; None if no channel has them."""
        known = any(self._samples.has_sigma(c) for c in range(len(self.channels)))
        return self._samples.sigma if known else None

    def __getitem__(self, channel: str) -> Array:
        """(rows,) f_r of one channel in 1/sr, a read-only view of the table's memory."""
        if channel not in self.channels:
            raise KeyError(channel)
        return self._samples.column(self.channels.index(channel))

    def __iter__(self) -> Iterator[str]:
        """Iterates over the names of the channels, as a data frame does over its columns; `"r" in table`."""
        return iter(self.channels)

    def __len__(self) -> int:
        return self._samples.rows

    @property
    def channels(self) -> list[str]:
        return self._samples.channels

    @property
    def metadata(self) -> list[tuple[str, str]]:
        """The comments above the header, in order. Free text has the key ""."""
        return self._samples.metadata

    @property
    def source(self) -> str:
        """The file from which the table was read; "" for a table made otherwise."""
        return self._samples.source

    @property
    def format(self) -> str:
        """The format that was read (csv, merl, rgl, astm_e1392, zemax, alta, exr, fred, cornell, openmaterial, bird, early_bird, speos,
        klems, aspecular), material, or arrays."""
        return self._samples.format

    @property
    def warnings(self) -> list[str]:
        """Rows that the reader left out and repairs that it made, one sentence each."""
        return self._samples.warnings

    def save(self, path: Path) -> list[str]:
        """Writes .csv, .binary (MERL) or .exr. Returns the losses, one phrase each."""
        return self._samples.write(path_of(path))

    def to_csv(self) -> str:
        """Returns the text of the CSV, which reads back to exactly the same table, except that rows that repeat a direction
        with the same values (azimuths of 0 and 360 degrees, any azimuth along the normal) are read once."""
        return self._samples.csv()

    def to_pandas(self) -> pandas.DataFrame:
        """Returns a frame with the columns of the CSV."""
        columns = {name: getattr(self, name) for name in ANGLES}
        columns.update({c: self[c] for c in self.channels})
        sigma = self._samples.sigma
        columns.update({PREFIX + c: sigma[:, k] for k, c in enumerate(self.channels) if self._samples.has_sigma(k)})
        frame: pandas.DataFrame = needed("pandas").DataFrame(columns)
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """Returns a Dataset along the dimension `row`: the channels and sigma_CHANNEL, with the angles as coordinates."""
        sigma = self._samples.sigma
        variables = {c: ("row", self[c], {"units": "1/sr"}) for c in self.channels}
        variables.update({PREFIX + c: ("row", sigma[:, k], {"units": "1/sr"}) for k, c in enumerate(self.channels)
                          if self._samples.has_sigma(k)})
        angles = {a: ("row", getattr(self, a), {"units": "deg"}) for a in ANGLES}
        made: xarray.Dataset = needed("xarray").Dataset(variables, coords=angles)
        return made

    def in_plane(self, theta_i: float) -> tuple[Array, Array]:
        """Returns the rows in the plane of incidence at incidence theta_i, to half a degree.

        The result is the viewing angle in degrees, positive on the mirror side, and the values (rows, channels).
        """
        turned = (self.phi_o - self.phi_i) % 360
        across = np.minimum(turned, 360 - turned)  # 180: on the mirror's side
        ahead, back = across > 180 - IN_PLANE, across < IN_PLANE
        chosen = (np.abs(self.theta_i - theta_i) <= IN_PLANE) & (ahead | back | (self.theta_o == 0))
        where = np.where(back, -self.theta_o, self.theta_o)[chosen]
        order = np.argsort(where, kind="stable")
        return where[order], self.values[chosen][order]

    def plot(self, theta_i: Iterable[float] = (0, 30, 60), axes: Any = None) -> Any:
        """Plots slices of the plane of incidence with matplotlib. Returns the axes."""
        return plot_slices(None, self, list(theta_i), axes)

    def __repr__(self) -> str:
        return f"<brdf.Table of {len(self)} rows, channels {', '.join(self.channels)}: {self.source or self.format}>"

    def _repr_html_(self) -> str:
        def span(a: Array) -> str:
            return f"{a.min():g} to {a.max():g}" if len(a) else "-"

        rows = [["rows", str(len(self))], ["channels", ", ".join(self.channels)], ["format", self.format],
                *([name + ", degrees", span(getattr(self, name))] for name in ANGLES),
                *([c + ", 1/sr", span(self[c])] for c in self.channels[:8]), *(["", w] for w in self.warnings)]
        return table_html(self.source or "samples", ["", ""], rows)

    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]:
        return _remade, ([np.array(getattr(self, a)) for a in ANGLES], self.values, self.sigma, self.channels,
                         self.metadata)


def _made(angles: Sequence[Array], shape: tuple[int, ...], values: ArrayLike, sigma: ArrayLike | None,
          channels: Sequence[str] | None, metadata: Mapping[str, str] | None) -> _brdf.Samples:
    f = _columns(values, shape, "values")
    names = _names(f.shape[1]) if channels is None else list_of(channels)
    if len(names) != f.shape[1]:
        raise InputError(f"channels: {len(names)} names for {f.shape[1]} channels")
    deviations: list[Array | None] = []
    if sigma is not None:
        s = _columns(sigma, shape, "sigma")
        if s.shape != f.shape:
            raise InputError(f"sigma: {s.shape[1]} channels for {f.shape[1]} channels of values")
        deviations = [None if np.all(np.isnan(s[:, c])) else s[:, c] for c in range(s.shape[1])]
    return _brdf.from_arrays(list(angles), [f[:, c] for c in range(f.shape[1])], deviations, names,
                             [(str(key), str(value)) for key, value in (metadata or {}).items()])


def _remade(angles: list[Array], values: Array, sigma: Array | None, channels: list[str],
            metadata: list[tuple[str, str]]) -> Table:
    columns = [None if sigma is None or np.all(np.isnan(sigma[:, c])) else sigma[:, c] for c in range(len(channels))]
    return Table._of(_brdf.from_arrays(angles, [values[:, c] for c in range(len(channels))], columns, channels,
                                       metadata))


def read_directions(path: Path) -> tuple[Array, Array]:
    """Returns the directions of a CSV of angles, the input of `brdf eval`: (rows, 3) unit vectors wi to the light and wo to
    the viewer. InputError names file, line and column."""
    pairs = _brdf.read_directions(path_of(path))
    return pairs.wi, pairs.wo


def read(path: Path, *, quantity: str = "", mirror_side: str = "auto", layout: Layout | None = None,
         matrix: str = "") -> Table:
    """Reads samples in any format that the program reads (docs/formats.md). The format is detected from the content.
    InputError names file, line and column.

    quantity: the quantity of the values if the file does not state it: "BRF", "BRF %", "f_r*cos_o", ... (docs/formats.md);
    the values are converted to f_r. mirror_side: the sign of the viewing angle on the mirror side in a table of two signed
    angles, "positive" or "negative" (default "auto": the side of the largest values). layout: the description of a
    laboratory's table, a file or a dictionary (`brdf describe-table` proposes one). matrix: words of the name of the matrix
    to read from Klems XML, such as "back visible" (default: reflection at the front, visible). `warnings` reports the
    decisions.
    """
    return Table._of(_brdf.read(path_of(path), quantity, mirror_side, layout_word(layout), matrix))


def table_or_path(source: Any, quantity: str = "", mirror_side: str = "auto", layout: Layout | None = None) -> Table | Path:
    """Returns the table of a Table, a DataFrame, a DataArray or a Dataset, and any other object, such as a path, unchanged."""
    kind = kind_of(source)
    if kind == "DataFrame":
        return Table.from_pandas(source, quantity=quantity, mirror_side=mirror_side, layout=layout)
    if not kind and not isinstance(source, Table):
        path: Path = source
        return path
    if quantity or mirror_side != "auto" or layout is not None:
        raise InputError("quantity, mirror_side, layout: apply to files, but " +
                         (f"a {kind} states its columns" if kind else "this table is already read"))
    return source if isinstance(source, Table) else Table.from_xarray(source)
