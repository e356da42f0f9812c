"""What is made of materials and tables: samples of a virtual instrument, shaders, other formats."""
from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, Union

from . import _brdf
from ._brdf import InputError
from .material import Material, material
from .table import Table
from .words import Path, finite, path_of, seed_of

Progress = Callable[[int, int], Any]


def synth(material: Material, *, grid: str = "hemisphere", theta_i: Iterable[float] = (), step: float = 0.0,
          azimuths: Iterable[float] | None = None, blind_zone: float = 0.0, aperture: float = 0.0,
          source_aperture: float = 0.0, noise: float = 0.0, noise_floor: float = 0.0, saturation: float = 0.0,
          clip_negatives: bool = False, sigma_columns: bool = False, seed: int = 1,
          progress: Progress | None = None) -> Table:
    """Measures a known material with a virtual goniophotometer: `brdf synth`.

    grid: in_plane, hemisphere, merl or a CSV of directions, joined by +. Angles in degrees: theta_i the incidences, step
    the detector's, azimuths by which the sample is turned (default 0, of an anisotropic material 0, 45, 90), blind_zone,
    aperture and source_aperture full widths. noise: s of the factor exp(s z - s^2/2); noise_floor, saturation: 1/sr. The
    same arguments give the same table on every machine. The table's metadata records the truth and every setting.
    """
    return Table._of(_brdf.synth(
        material._optics, grid, [finite("--theta-i", t) for t in theta_i], finite("--step", step),
        None if azimuths is None else [finite("--azimuths", a) for a in azimuths], finite("--blind-zone", blind_zone),
        finite("--aperture", aperture), finite("--source-aperture", source_aperture), finite("--noise", noise),
        finite("--noise-floor", noise_floor), finite("--saturation", saturation), clip_negatives, sigma_columns,
        seed_of(seed), progress))


def convert(source: Path | Table | Material, output: Path, *, keep_fill: bool = False, polarisation: str = "keep",
            repeats: str = "keep", quantity: str = "", mirror_side: str = "auto") -> list[str]:
    """Writes samples in another format: .csv, .binary (MERL), .exr, .astm or .zemax (`brdf convert`); of a material its
    values at the MERL cells. Returns what is lost, a phrase each.

    keep_fill: write rows of fill values, too: numbers that stand for directions that were not measured.
    polarisation: what is made of channels whose names say one (fr_s, 465nm p): keep, average, s, p, ss, sp, ps, pp.
    repeats: keep a row for each, or average directions that were measured more than once. quantity, mirror_side: what a
    file does not state, as of `read`.
    """
    if isinstance(source, (Table, Material)) and (quantity or mirror_side != "auto"):
        raise InputError("quantity, mirror_side: are for files; this was read before")
    name = path_of(output)
    _brdf.check_table_format(name)
    if isinstance(source, Material):
        source = synth(source, grid="merl", azimuths=(0,))
    samples = source._samples if isinstance(source, Table) else _brdf.table_of_file(path_of(source), quantity,
                                                                                            mirror_side)
    if not keep_fill:
        samples = samples.measured()
    return samples.arranged(polarisation, repeats).write(name)


def export(source: Union[Material, str], to: str, output: Path | None = None, *, include: bool = False,
           name: str = "") -> str:
    """Shader source of a material or of a form by its name, to "glsl" (4.50, Vulkan) or "glsl-es" (3.00, WebGL 2):
    `brdf export`.

    Of a material a function brdf_material(wi, wo) is added. include: functions only, for an #include; several go into one
    shader, where each material's function is brdf_material_NAME, by `name`, the material's name or its form's, and
    brdf_material is it too while there is one. Written to `output` where given. InputError where a form has no GLSL.
    """
    if not isinstance(source, (Material, str)):
        raise InputError(f"{source!r}: a shader is made of a material, or of a form by its name")
    whole = source if isinstance(source, Material) else material(source)
    text = whole._optics.glsl(to, isinstance(source, Material), include, name)
    if output is not None:
        _brdf.write_text(path_of(output), text)
    return text
