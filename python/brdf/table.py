"""Tables of samples: read from any format, made of arrays, handed on to numpy and pandas."""
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
from .words import Path, list_of, path_of

if TYPE_CHECKING:
    import pandas

ANGLES = ("theta_i", "phi_i", "theta_o", "phi_o")
PREFIX = "sigma_"
IN_PLANE = 0.5  # degrees by which a direction may be out of the plane


def _names(count: int) -> list[str]:
    """The channels' names where none are given: as of a form's material."""
    return {1: ["fr"], 3: ["r", "g", "b"]}.get(count, [f"c{k}" for k in range(count)])


def _columns(values: ArrayLike, shape: tuple[int, ...], what: str) -> Array:
    """Values of shape `shape` or `shape + (channels,)` as (pairs, channels)."""
    array = numbers(what, values)
    if array.shape == shape:
        return array.reshape(-1, 1)
    if array.ndim == len(shape) + 1 and array.shape[:-1] == shape:
        return array.reshape(-1, array.shape[-1])
    raise InputError(f"{what}: shape {array.shape}: must be {shape}, or that and the number of channels")


class Table:
    """Measured or computed values of f_r in 1/sr, one row per pair of directions.

    wi, wo: (..., 3), broadcast against each other: directions of any length above 0, to the light and to the viewer.
    values: the pairs' shape, or that and the number of channels: f_r in 1/sr. sigma: the same, standard deviations;
    NaN throughout a channel where they are not known. channels: names (default "fr", or "r", "g", "b").
    metadata: comments for the head of a CSV. InputError where a rule of tables is broken (docs/formats.md).

    Rows keep polar angles in degrees, as files do; `from_degrees` makes a table of those without rounding.
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
        """The same of polar angles and azimuths in degrees, which are broadcast against each other."""
        angles = together(ANGLES, [numbers(name, a) for name, a in zip(ANGLES, (theta_i, phi_i, theta_o, phi_o))])
        return cls._of(_made([a.reshape(-1) for a in angles], angles[0].shape, values, sigma, channels, metadata))

    @classmethod
    def from_pandas(cls, frame: pandas.DataFrame, *, metadata: Mapping[str, str] | None = None) -> Table:
        """A frame with the columns of a CSV: theta_i, phi_i, theta_o, phi_o, channels, and sigma_CHANNEL."""
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
    def from_csv(cls, text: str, name: str = "text", *, quantity: str = "", mirror_side: str = "auto") -> Table:
        """The table that a file of this content would be; options as of `read`."""
        return cls._of(_brdf.read_text(text, name, quantity, mirror_side))

    @classmethod
    def _of(cls, samples: _brdf.Samples) -> Table:
        return made(cls, _samples=samples)

    @property
    def theta_i(self) -> Array:
        """(rows,) polar angle of the light in degrees; a read-only view of the table's own memory, as the next three."""
        return self._samples.theta_i

    @property
    def phi_i(self) -> Array:
        """(rows,) azimuth of the light in degrees."""
        return self._samples.phi_i

    @property
    def theta_o(self) -> Array:
        """(rows,) polar angle of the viewer in degrees."""
        return self._samples.theta_o

    @property
    def phi_o(self) -> Array:
        """(rows,) azimuth of the viewer in degrees."""
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
        """(rows, channels) f_r in 1/sr, a copy; `table["r"]` is a view."""
        return self._samples.values

    @property
    def sigma(self) -> Array | None:
        """(rows, channels) standard deviations in 1/sr, NaN in channels without; None where no channel has any."""
        known = any(self._samples.has_sigma(c) for c in range(len(self.channels)))
        return self._samples.sigma if known else None

    def __getitem__(self, channel: str) -> Array:
        """(rows,) f_r of one channel in 1/sr: a read-only view of the table's own memory."""
        if channel not in self.channels:
            raise KeyError(channel)
        return self._samples.column(self.channels.index(channel))

    def __iter__(self) -> Iterator[str]:
        """The channels' names, as a data frame has its columns'; `"r" in table`."""
        return iter(self.channels)

    def __len__(self) -> int:
        return self._samples.rows

    @property
    def channels(self) -> list[str]:
        return self._samples.channels

    @property
    def metadata(self) -> list[tuple[str, str]]:
        """The comments above the header, in order; free text has the key ""."""
        return self._samples.metadata

    @property
    def source(self) -> str:
        """The file that it was read from; "" of one that was made."""
        return self._samples.source

    @property
    def format(self) -> str:
        """csv, merl, rgl, astm_e1392, zemax, alta, exr, material, or arrays."""
        return self._samples.format

    @property
    def warnings(self) -> list[str]:
        """What the reader left out or repaired, a sentence each."""
        return self._samples.warnings

    def save(self, path: Path) -> list[str]:
        """Writes .csv, .binary (MERL) or .exr. Returns what is lost, a phrase each."""
        return self._samples.write(path_of(path))

    def to_csv(self) -> str:
        """The text of its CSV, which reads back to exactly the same table; of rows that repeat a direction with the same values
        (azimuths of 0 and 360 degrees, any azimuth along the normal) one is read."""
        return self._samples.csv()

    def to_pandas(self) -> pandas.DataFrame:
        """A frame with the columns of its CSV."""
        import pandas

        columns = {name: getattr(self, name) for name in ANGLES}
        columns.update({c: self[c] for c in self.channels})
        sigma = self._samples.sigma
        columns.update({PREFIX + c: sigma[:, k] for k, c in enumerate(self.channels) if self._samples.has_sigma(k)})
        return pandas.DataFrame(columns)

    def in_plane(self, theta_i: float) -> tuple[Array, Array]:
        """The rows in the plane of incidence with the light at theta_i, to half a degree.

        Returns the viewer's polar angle in degrees, positive towards the mirror direction, and (rows, channels) values.
        """
        turned = (self.phi_o - self.phi_i) % 360
        across = np.minimum(turned, 360 - turned)  # 180: on the mirror's side
        ahead, back = across > 180 - IN_PLANE, across < IN_PLANE
        chosen = (np.abs(self.theta_i - theta_i) <= IN_PLANE) & (ahead | back | (self.theta_o == 0))
        where = np.where(back, -self.theta_o, self.theta_o)[chosen]
        order = np.argsort(where, kind="stable")
        return where[order], self.values[chosen][order]

    def plot(self, theta_i: Iterable[float] = (0, 30, 60), axes: Any = None) -> Any:
        """Slices of the plane of incidence by matplotlib; returns its axes."""
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
    """The directions of a CSV of angles, as `brdf eval` takes it: (rows, 3) unit vectors wi to the light and wo to the
    viewer. InputError names file, line and column."""
    pairs = _brdf.read_directions(path_of(path))
    return pairs.wi, pairs.wo


def read(path: Path, *, quantity: str = "", mirror_side: str = "auto") -> Table:
    """Reads samples in any format that the program reads, told by their content: CSV, MERL .binary, RGL or lens-design
    .bsdf, ASTM E1392. InputError names file, line and column.

    quantity: the quantity of the values if the file does not state it: "BRF", "BRF %", "f_r*cos_o", ... (docs/formats.md);
    they become f_r. mirror_side: of a table of two signed angles, the sign of the viewer's angle on the mirror side,
    "positive" or "negative" (default "auto": the side of the largest values). `warnings` says what was decided.
    """
    return Table._of(_brdf.read(path_of(path), quantity, mirror_side))
