"""Output from materials and tables: samples of a virtual instrument, shaders, other formats."""
from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, Union

from . import _brdf
from ._brdf import InputError
from .frames import Frame, Layout, layout_word
from .material import Material, material
from .table import Table, table_or_path
from .words import Path, finite, path_of, seed_of

Progress = Callable[[int, int], Any]


def synth(material: Material, *, grid: str = "hemisphere", theta_i: Iterable[float] = (), step: float = 0.0,
          azimuths: Iterable[float] | None = None, blind_zone: float = 0.0, aperture: float = 0.0,
          source_aperture: float = 0.0, noise: float = 0.0, noise_floor: float = 0.0, saturation: float = 0.0,
          clip_negatives: bool = False, sigma_columns: bool = False, seed: int = 1,
          progress: Progress | None = None) -> Table:
    """Measures a known material with a virtual goniophotometer: `brdf synth`.

    grid: in_plane, hemisphere, merl or a CSV of directions, joined by +. Angles are in degrees: theta_i are the angles of
    incidence, step is the step of the detector, azimuths are the rotations of the sample (default 0; for an anisotropic
    material 0, 45, 90), and blind_zone, aperture and source_aperture are full widths. noise: s of the factor
    exp(s z - s^2/2); noise_floor, saturation: 1/sr. The same arguments give the same table on every machine. The metadata
    of the table record the ground truth and every setting.
    """
    return Table._of(_brdf.synth(
        material._optics, grid, [finite("--theta-i", t) for t in theta_i], finite("--step", step),
        None if azimuths is None else [finite("--azimuths", a) for a in azimuths], finite("--blind-zone", blind_zone),
        finite("--aperture", aperture), finite("--source-aperture", source_aperture), finite("--noise", noise),
        finite("--noise-floor", noise_floor), finite("--saturation", saturation), clip_negatives, sigma_columns,
        seed_of(seed), progress))


def convert(source: Path | Table | Material | Frame, output: Path, *, keep_fill: bool = False, polarisation: str = "keep",
            repeats: str = "keep", quantity: str = "", mirror_side: str = "auto", layout: Layout | None = None,
            matrix: str = "") -> list[str]:
    """Writes samples in another format: .csv, .binary (MERL), .exr, .astm, .zemax, .xompt, .brdf (BiRD) or
    .xml (Klems matrices): `brdf convert`. For a material, the values at the MERL cells are written, for .xml the means
    over the patches. Returns the losses, one phrase each.

    keep_fill: also write rows of fill values, which mark directions that were not measured.
    polarisation: treatment of channels with a polarisation in their names (fr_s, 465nm p): keep, average, s, p, ss, sp,
    ps, pp. repeats: keep one row for each repeat measurement, or average. quantity, mirror_side, layout, matrix: as in
    `read`.
    """
    if isinstance(source, Material) and (quantity or mirror_side != "auto" or layout is not None or matrix):
        raise InputError("quantity, mirror_side, layout, matrix: apply to files, but this source is already read")
    name = path_of(output)
    _brdf.check_table_format(name)
    if isinstance(source, Material):
        source = Table._of(_brdf.table_of_material(source._optics, name))
    table = table_or_path(source, quantity, mirror_side, layout)
    if matrix and isinstance(table, Table):
        raise InputError("matrix: applies to files of Klems XML, but this source is already read")
    samples = table._samples if isinstance(table, Table) else _brdf.table_of_file(path_of(table), quantity, mirror_side,
                                                                                  layout_word(layout), matrix, name)
    if not keep_fill:
        samples = samples.measured()
    return samples.arranged(polarisation, repeats).write(name)


def export(source: Union[Material, str], to: str, output: Path | None = None, *, include: bool = False,
           name: str = "") -> str:
    """Shader source of a material or of a form by its name, to "glsl" (4.50, Vulkan) or "glsl-es" (3.00, WebGL 2):
    `brdf export`.

    For a material, a function brdf_material(wi, wo) is added. include: write functions only, for an #include. Several such
    texts can be used in one shader: the function of each material is brdf_material_NAME, with `name`, the name of the
    material or the name of its form; with a single material, brdf_material is an alias. The text is also written to
    `output` if given. Raises InputError if a form has no GLSL.
    """
    if not isinstance(source, (Material, str)):
        raise InputError(f"{source!r}: a shader is made from a material, or from the name of a form")
    whole = source if isinstance(source, Material) else material(source)
    text = whole._optics.glsl(to, isinstance(source, Material), include, name)
    if output is not None:
        _brdf.write_text(path_of(output), text)
    return text
