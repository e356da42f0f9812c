"""Reflectance models (BRDFs): fitting to measurements, checking and evaluation.

The library of the program `brdf` for numpy arrays. Results are bit-identical to the results of the program.

    import brdf

    table = brdf.read("samples.csv")              # any format that `brdf fit` reads
    result = brdf.fit(table, form="all")          # the options of `brdf fit` as keywords
    material = result.best.material
    f = material.eval(wi, wo)                     # (..., 3) and (..., 3) broadcast; (..., channels) in 1/sr

Conventions. `wi` points to the light, `wo` to the viewer, both away from the surface; unit vectors in the local frame,
normal +z, tangent +x. Angles are in degrees. f_r is in 1/sr and without cosine, unless a function is documented otherwise.
`alpha` is the width of the slope distribution.

Errors are `brdf.InputError` (a ValueError), with the message that the program prints.
"""
from ._brdf import EnvironmentError, InputError, Stopped
from ._brdf import version as __version__
from .fitting import Candidate, Fit, Interval, NextDirections, fit, fit_files, next_directions
from .forms import Form, Parameter, Violation, form, forms
from .judging import Finding, Judgement, judge, validate
from .making import convert, export, synth
from .material import Albedo, Material, directions, load, material
from .programs import compare, consensus, convert_parameters, lobes, maps, parity, program, prove, recommend, render, study, trade, view
from .table import Table, read, read_directions

__all__ = [
    "Albedo", "Candidate", "EnvironmentError", "Finding", "Fit", "Form", "InputError", "Interval", "Judgement",
    "Material", "NextDirections", "Parameter", "Stopped", "Table", "Violation", "__version__", "compare", "consensus", "convert", "convert_parameters", "directions",
    "export", "fit", "fit_files", "form", "forms", "judge", "load", "lobes", "maps", "material", "next_directions", "parity", "program", "prove", "read",
    "read_directions", "recommend", "render", "study", "synth", "trade", "validate", "view",
]
