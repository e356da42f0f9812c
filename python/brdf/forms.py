"""The catalogue of forms: names, parameters with ranges and roles, and known violations."""
from __future__ import annotations

import functools
import json
from dataclasses import dataclass
from typing import Any

from . import _brdf
from ._brdf import InputError
from .display import table_html


@dataclass(frozen=True)
class Parameter:
    """One parameter of a form."""

    name: str
    kind: str  #: "weight" (one value per channel) or "shape"
    role: str  #: meaning, independent of the name: "diffuse", "specular", "f0", "width", ...
    min: float
    max: float
    default: float
    usual_max: float  #: upper end of a slider
    unit: str  #: "" if dimensionless
    log_scale: bool
    doc: str


@dataclass(frozen=True)
class Violation:
    """A property that a form is known to violate, with a case that shows the violation."""

    check: str
    statement: str
    witness: str
    theta: float  #: degrees
    value: float


@dataclass(frozen=True)
class Form:
    """A form of the catalogue, with the data of `brdf models --json`."""

    name: str
    family: str
    fittable: bool
    canonical: bool  #: the family's own form
    parameters: tuple[Parameter, ...]
    known_violations: tuple[Violation, ...]

    def parameter(self, name: str) -> Parameter:
        """Returns the parameter of this name. Raises KeyError if the form has no such parameter."""
        for p in self.parameters:
            if p.name == name:
                return p
        raise KeyError(name)

    def _repr_html_(self) -> str:
        rows = [[p.name, p.kind, p.role, f"{p.min:g} to {p.max:g}", f"{p.default:g}", p.unit, p.doc]
                for p in self.parameters]
        head = ["parameter", "kind", "role", "range", "default", "unit", "meaning"]
        return table_html(f"{self.name} (family {self.family})", head, rows)


def _form(entry: dict[str, Any]) -> Form:
    return Form(entry["form"], entry["family"], entry["fittable"], entry["canonical"],
                tuple(Parameter(**p) for p in entry["parameters"]),
                tuple(Violation(**v) for v in entry["known_violations"]))


@functools.lru_cache(maxsize=None)
def _all() -> tuple[Form, ...]:
    return tuple(_form(entry) for entry in json.loads(_brdf.forms_json()))


@functools.lru_cache(maxsize=None)
def _targets() -> tuple[Form, ...]:
    return tuple(_form(entry) for entry in json.loads(_brdf.targets_json()))


def forms(*, fittable: bool | None = None) -> list[Form]:
    """Returns all forms in the order of the catalogue (`brdf models`). fittable: only forms that can, or cannot, be fitted."""
    return [f for f in _all() if fittable is None or f.fittable == fittable]


def form(name: str) -> Form:
    """Returns the form of this name, or the model of another program (`brdf models NAME`). InputError lists known names."""
    for f in _all() + _targets():
        if f.name == name:
            return f
    _brdf.material_of_form(name, [], None)  # refuses it
    raise InputError(f"'{name}' is not the name of a form")
