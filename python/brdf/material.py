"""Materials: reflectances with parameters, evaluated on arrays."""
from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _brdf
from ._brdf import InputError
from .arrays import Array, check_vectors, common_shape, given, numbers, together
from .display import SIDE, plot_slices, table_html
from .entries import made
from .words import Floats, Path, Values, finite, list_of, path_of, setting, whole

if TYPE_CHECKING:
    from .judging import Judgement
    from .table import Table


@dataclass(frozen=True)
class Albedo:
    """Directional albedos: arrays with the shape of the angles, followed by the number of channels.

    value; error_bound (absolute, of the integral); low and high (95 % interval of the fit, NaN for a material
    without a fit); converged; evaluations; rule, the integration rule that was used.
    """

    value: Array
    error_bound: Array
    low: Array
    high: Array
    converged: NDArray[np.bool_]
    evaluations: NDArray[np.int64]
    rule: NDArray[np.str_]


def directions(theta: ArrayLike, phi: ArrayLike = 0.0) -> Array:
    """Returns unit vectors (..., 3) for polar angles and azimuths in degrees, which broadcast. Normal +z, tangent +x.

    The result is bit-identical on every machine. Sines and cosines are accurate to 1.5 ulp for |angle| up to 1e6 degrees.
    """
    t, p = together(("theta", "phi"), (numbers("theta", theta), numbers("phi", phi)))
    return _brdf.unit_vectors(t.reshape(-1), p.reshape(-1)).reshape(t.shape + (3,))


def _usable(array: Floats) -> Floats:
    """Returns the array with native byte order and aligned addresses, as C++ requires. A suitable array is not copied."""
    if array.flags.aligned and array.dtype.isnative:
        return array
    return np.array(array, dtype=array.dtype.newbyteorder("="))


def _pairs(wi: ArrayLike, wo: ArrayLike) -> tuple[Floats, Floats]:
    """Returns both directions, broadcast, in one type: float32 if both are float32, otherwise float64."""
    light, viewer = given("wi", wi), given("wo", wo)
    single = light.dtype == np.float32 and viewer.dtype == np.float32
    kind = np.float32 if single else np.float64
    check_vectors("wi", light)
    check_vectors("wo", viewer)
    light, viewer = (_usable(a.astype(kind, copy=False)) for a in (light, viewer))
    shape = common_shape(("wi", "wo"), (light, viewer))
    return np.broadcast_to(light, shape), np.broadcast_to(viewer, shape)


class Material:
    """A form, or a sum of forms, with parameters for each channel.

    Materials are made by `brdf.material`, `brdf.load`, a fit, or as the sum of two materials. A material is immutable:
    `replace` returns another material.
    """

    _optics: _brdf.Optics

    def __init__(self) -> None:
        raise TypeError("materials are made by brdf.material(form, ...), brdf.load(path) or a fit")

    @classmethod
    def _of(cls, optics: _brdf.Optics) -> Material:
        return made(cls, _optics=optics)

    @classmethod
    def from_dict(cls, content: dict[str, Any], name: str = "material") -> Material:
        """Returns the material of a JSON object with the content of a file (docs/formats.md). Messages begin with `name`."""
        return cls._of(_brdf.material_of_json(json.dumps(content), name))

    def to_dict(self) -> dict[str, Any]:
        """Returns the content of the JSON file."""
        content: dict[str, Any] = json.loads(self._optics.json)
        return content

    def save(self, path: Path) -> None:
        """Writes the JSON file atomically."""
        self._optics.save(path_of(path))

    @property
    def channels(self) -> list[str]:
        return self._optics.channels

    @property
    def anisotropic(self) -> bool:
        """Whether the reflectance depends on the rotation of the sample: some term has two different widths."""
        return self._optics.anisotropic

    @property
    def form(self) -> str:
        """The name of the form; for a sum, the names joined by +."""
        return "+".join(self._optics.forms)

    @property
    def fit(self) -> dict[str, Any] | None:
        """Provenance and statistics of the fit that made the material; None if the material is not from a fit."""
        block: dict[str, Any] | None = self.to_dict().get("fit")
        return block

    @property
    def parameters(self) -> dict[str, float | list[float]]:
        """Parameters by name: one value, or one per channel. tangent_phi is in degrees and listed if not 0. In a sum the
        names are terms[0].kd and so on, as in a fit."""
        content = self.to_dict()
        terms = content.get("terms")
        found: dict[str, float | list[float]] = {}
        for k, term in enumerate([content] if terms is None else terms):
            before = "" if terms is None else f"terms[{k}]."
            for block in ("weights", "shape"):
                for name, value in term.get(block, {}).items():
                    one = isinstance(value, list) and len(value) == 1
                    found[before + name] = value[0] if one else value
            if term.get("tangent_phi"):
                found[before + "tangent_phi"] = term["tangent_phi"]
        return found

    def replace(self, *, channels: Sequence[str] | None = None, **set: Values) -> Material:
        """Returns a material with these parameters (`--set`): one value, or one per channel. `alpha` sets both widths,
        `tangent_phi` is in degrees. `channels` renames the channels. The statistics of a fit are removed by a change."""
        optics = self._optics.with_settings([setting(name, v) for name, v in set.items()])
        return Material._of(optics if channels is None else optics.with_channels(list_of(channels)))

    def __add__(self, other: Material) -> Material:
        """Returns the sum of the reflectances. Both materials must have the same channels."""
        if not isinstance(other, Material):
            return NotImplemented
        return Material._of(self._optics.plus(other._optics))

    def _evaluated(self, wi: ArrayLike, wo: ArrayLike, out: Floats | None, cosine: bool) -> Floats:
        light, viewer = _pairs(wi, wo)
        shape = light.shape[:-1] + (len(self.channels),)
        if out is None:
            result: Floats = np.empty(shape, dtype=light.dtype)
        else:
            if not isinstance(out, np.ndarray) or out.shape != shape or out.dtype != light.dtype:
                raise InputError(f"out: must be an array of shape {shape} and type {light.dtype}")
            if not out.flags.writeable or not out.flags.aligned:
                raise InputError("out: must be writeable and aligned")
            result = out
            if np.may_share_memory(out, light) or np.may_share_memory(out, viewer):
                light, viewer = light.copy(), viewer.copy()
        self._optics.evaluate(light, viewer, result, cosine)
        return result

    def eval(self, wi: ArrayLike, wo: ArrayLike, out: Floats | None = None) -> Floats:
        """Returns f_r in 1/sr, without cosine: (..., channels) for wi (..., 3) and wo (..., 3), which broadcast.

        Directions are unit vectors (squared length within 1e-4, otherwise InputError). Values are 0 below the horizon and
        finite everywhere. The result is float32 if both inputs are float32 (with the stated accuracy of the form in
        float), otherwise float64 and bit-identical to `brdf eval`. Arrays of float64 or float32 are not copied, for any
        strides. `out`, if given, receives the result and is returned.
        """
        return self._evaluated(wi, wo, out, False)

    def eval_cos(self, wi: ArrayLike, wo: ArrayLike, out: Floats | None = None) -> Floats:
        """Returns f_r cos_i in 1/sr (`brdf eval --cos`); otherwise the same as eval."""
        return self._evaluated(wi, wo, out, True)

    def eval_degrees(self, theta_i: ArrayLike, phi_i: ArrayLike, theta_o: ArrayLike, phi_o: ArrayLike, *,
                     cos: bool = False) -> Array:
        """Returns f_r in 1/sr (cos: times cos_i) for angles in degrees, which broadcast: (..., channels)."""
        f = self._evaluated(directions(theta_i, phi_i), directions(theta_o, phi_o), None, cos)
        return f.astype(np.float64, copy=False)

    def sample(self, wo: ArrayLike, u: ArrayLike) -> Array:
        """Returns random directions wi (..., 3), distributed approximately as f_r cos_i for wo (..., 3), from numbers
        u (..., 3) in [0, 1); wo and u broadcast. A direction may be below the horizon, where the value is 0. For a sum a
        term is chosen at random."""
        return self._rows(_brdf.sample, "wo", numbers("wo", wo), "u", numbers("u", u))

    def pdf(self, wi: ArrayLike, wo: ArrayLike) -> Array:
        """Returns the density of `sample` at wi (..., 3) for wo (..., 3), in 1/sr: (...)."""
        return self._rows(_brdf.pdf, "wi", numbers("wi", wi), "wo", numbers("wo", wo))

    def _rows(self, call: Callable[[_brdf.Optics, Array, Array], Array], name: str, a: Array, other: str,
              b: Array) -> Array:
        check_vectors(name, a)
        check_vectors(other, b)
        a, b = together((name, other), (a, b))
        found = call(self._optics, a.reshape(-1, 3), b.reshape(-1, 3))
        return found.reshape(a.shape[:-1] + found.shape[1:])

    def albedo(self, theta: ArrayLike, phi: float = 0.0, *, fixed: str = "i", tolerance: float = 1e-6,
               rule: str = "automatic") -> Albedo:
        """Returns the directional albedo with one direction fixed at theta (any shape) and phi, in degrees (`brdf albedo`).

        fixed: "i", the incident direction, or "o", the viewing direction. tolerance: requested relative error, 1e-14 to 1.
        rule: automatic, pole, slope or adaptive. Arrays have the shape of theta, followed by the channels. The result has
        the error bound of each integral and, for a fitted material, the 95 % interval of the fit.
        """
        angles = numbers("theta", theta)
        rows = self._optics.albedo([finite("--theta", t) for t in angles.reshape(-1).tolist()], finite("--phi", phi), fixed,
                                   finite("--tolerance", tolerance), rule)
        columns = list(zip(*rows)) if rows else [()] * 7
        shape = angles.shape + (len(self.channels),)

        def column(k: int, kind: Any = np.float64) -> NDArray[Any]:
            return np.array(columns[k], dtype=kind).reshape(shape)

        return Albedo(value=column(0), error_bound=column(1), evaluations=column(2, np.int64),
                      converged=column(3, np.bool_), rule=column(4, np.str_), low=column(5), high=column(6))

    def validate(self, **options: Any) -> Judgement:
        """Returns the checks of `brdf.validate` for this material."""
        from .judging import validate

        return validate(self, **options)

    def export(self, to: str, output: Path | None = None, *, include: bool = False, name: str = "") -> str:
        """Returns the shader source for "glsl" or "glsl-es" (`brdf export`), and writes it to `output` if given."""
        from .making import export

        return export(self, to, output, include=include, name=name)

    def plot(self, theta_i: Iterable[float] = (0, 30, 60), table: Table | None = None, axes: Any = None) -> Any:
        """Plots slices of the plane of incidence with matplotlib, with the values of a table as points. Returns the axes."""
        return plot_slices(self, table, list(theta_i), axes)

    def picture(self, side: int = SIDE) -> bytes:
        """Returns a PNG of `side` by `side` pixels: a sphere in the studio. Raises InputError if channels are not colours."""
        if self._optics.obstacle:
            raise InputError(self._optics.obstacle)
        return self._optics.sphere(whole("side", side, 8, 4096))

    def __repr__(self) -> str:
        values = ", ".join(f"{name}={_short(value)}" for name, value in self.parameters.items())
        return f"<brdf.Material {self.form}: {values}>"

    def _repr_png_(self) -> bytes | None:
        return None if self._optics.obstacle else self.picture()

    def _repr_html_(self) -> str:
        rows = [[name, _short(value)] for name, value in self.parameters.items()]
        return table_html(self.form, ["parameter", ", ".join(self.channels)], rows, self._repr_png_())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Material) and self._optics.json == other._optics.json

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]:
        return _remade, (self._optics.json,)


def _short(value: float | list[float]) -> str:
    return ", ".join(f"{v:.6g}" for v in (value if isinstance(value, list) else [value]))


def _remade(text: str) -> Material:
    return Material._of(_brdf.material_of_json(text, "material"))


def material(form: str, *, channels: Sequence[str] | None = None, **set: Values) -> Material:
    """Returns a form with these parameters, others at their defaults: `brdf.material("ward", kd=[.3, .2, .1], alpha=.1)`.

    The number of channels is the length of the longest list (three are r, g, b; one is fr), or of `channels`. Raises
    InputError for an unknown form or parameter, a value out of range (`brdf.form(name)` has the ranges), or a wrong count.
    """
    words = [setting(name, v) for name, v in set.items()]
    return Material._of(_brdf.material_of_form(form, words, None if channels is None else list_of(channels)))


def load(path: Path) -> Material:
    """Reads a material's JSON file. InputError names file, JSON path, value and rule."""
    return Material._of(_brdf.load(path_of(path)))
