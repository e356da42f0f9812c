"""Checks of forms over their whole parameter domain, of materials, of measured tables, and of samplers."""
from __future__ import annotations

import json
import os
import pathlib
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any, Union

from . import _brdf
from ._brdf import InputError
from .callables import Evaluated, Functions, Sampled
from .display import table_html
from .entries import Entries
from .forms import forms
from .frames import Frame, Layout, kind_of, layout_word
from .material import Material
from .table import Table, table_or_path
from .words import Path, finite, list_of, path_of, seed_of, whole

Subject = Union[Material, Table, Path, Frame]
Progress = Callable[[int, int], Any]
PNG = b"\x89PNG\r\n\x1a\n"


@dataclass(frozen=True)
class Finding(Entries):
    """The finding of one check of one subject, with the keys of its JSON."""

    subject: str
    check: str
    verdict: str  #: pass, known_violation, fail, not_applicable or undecided
    _content: dict[str, Any] = field(repr=False)


class Judgement(Entries):
    """The result of `validate` and of `judge`; `to_dict()` returns the object that `brdf validate --json` prints."""

    def __init__(self, judged: _brdf.Judged, required: list[str]) -> None:
        self._judged, self._required = judged, required
        self._content = json.loads(judged.json)
        self.findings = [Finding(f["subject"], f["check"], f["verdict"], f) for f in self._content["findings"]]

    @property
    def passed(self) -> bool:
        """Whether no check failed and all required checks passed, for which `brdf validate` returns the exit code 0."""
        return self._judged.holds(self._required)

    @property
    def failed(self) -> list[Finding]:
        return [f for f in self.findings if f.verdict == "fail"]

    def report(self, path: Path, picture: Iterable[Path] = ()) -> None:
        """Writes .html or .md (`-o`). The PNG files `picture` are embedded in the HTML."""
        name = path_of(path)
        pictures = [(path_of(p), _png(p)) for p in picture]
        if name.endswith(b".md") and not pictures:
            return _brdf.write_text(name, self._judged.markdown)
        if not name.endswith(b".html"):
            needs = "needs -o with a name that ends in .html"
            raise InputError(f"--picture {os.fsdecode(pictures[0][0])}: {needs}" if pictures else
                             f"-o {os.fsdecode(name)}: must end in .html or .md")
        return _brdf.write_text(name, self._judged.html(pictures))

    def __repr__(self) -> str:
        return f"<brdf.Judgement: {self._judged.summary}>"

    def _repr_html_(self) -> str:
        rows = [[f.subject, f.check, f.verdict, str(f._content.get("statement", ""))] for f in self.findings]
        return table_html(self._judged.summary, ["subject", "check", "verdict", "finding"], rows)


def _png(path: Path) -> bytes:
    name = os.fsdecode(path)
    try:
        content = pathlib.Path(name).read_bytes()
    except OSError as error:
        raise InputError(f"{name}: cannot be read: {error.strerror}") from None
    if not content.startswith(PNG):
        raise InputError(f"--picture {name}: is not a PNG file")
    return content


def validate(subjects: Subject | list[Subject] | tuple[Subject, ...] = (), *,
             form: str | Iterable[str] | None = None, all: bool = False, effort: str = "quick",
             require: str | Iterable[str] | None = None, max_theta: float = 89.5, keep_fill: bool = False,
             seed: int = 1, quantity: str = "", mirror_side: str = "auto", layout: Layout | None = None,
             progress: Progress | None = None) -> Judgement:
    """Judges materials, tables and files of either, and forms over their whole domain: `brdf validate`.

    effort: quick or full. require: checks that must pass for `passed`. max_theta: degrees, above 0 and at most 90, the
    largest angle of the energy check; rows of tables beyond this angle are judged separately. keep_fill: also judge rows of fill
    values. quantity, mirror_side, layout: facts that files of samples do not state, as in `read`. progress: called with the number
    of finished checks and the number of all checks. If the callback returns False, `brdf.Stopped` is raised.
    """
    given: list[Subject] = list(subjects) if isinstance(subjects, (list, tuple)) else [subjects]
    required = list_of(require)
    _brdf.check_required(required)
    names = [f.name for f in forms()] if all else []
    names += list_of(form)
    if not given and not names:
        raise InputError("nothing to validate: give materials, samples, --form, --all or --shader")
    items: list[Any] = []
    for k, subject in enumerate(given):
        if isinstance(subject, Material):
            items.append((subject.form if len(given) == 1 else f"{subject.form} ({k + 1})", subject._optics))
        else:
            options = (quantity, mirror_side, layout) if kind_of(subject) == "DataFrame" else ("", "auto", None)
            table = table_or_path(subject, *options)
            items.append(table._samples if isinstance(table, Table) else path_of(table))
    return Judgement(_brdf.validate(names, items, effort, finite("--max-theta", max_theta), keep_fill, seed_of(seed),
                                     quantity, mirror_side, layout_word(layout), progress), required)


MOST_RANDOMS = 32  # numbers that a sample takes


def judge(*, eval: Evaluated | None = None, sample: Sampled | None = None, pdf: Evaluated | None = None,
          returns: str = "f", value: str | None = None, density_of: str = "solid_angle", randoms: int = 2,
          name: str = "functions", effort: str = "quick", require: str | Iterable[str] | None = None,
          seed: int = 1) -> Judgement:
    """Judges a BRDF, its sampler and the density of the sampler together, given as functions of numpy arrays.

    The nine checks are those that `brdf validate --shader` adds for a sampler, except that the functions are evaluated in
    double precision only. Directions are unit vectors (n, 3) in the local frame, normal +z; every row of wo is the same
    viewing direction. Each call returns one result for each row, and a result must depend on its own row alone.

    eval(wi, wo): the values, (n,) or (n, channels) with up to 3 channels. returns: their quantity, f or f*cos_i.
    sample(u, wo): u has shape (n, randoms) with numbers from 0 to 1, and the ends 0 and 1 are tried. The function returns wi,
    or (wi, pdf), or (wi, pdf, value), or a dictionary with wi and any of pdf, value and valid. A sample is lost if its
    pdf is 0, or if valid is False. value: the quantity of the returned value, f, f*cos_i or f*cos_i/pdf; without this
    option the judge takes f*cos_i/pdf if the values equal it, otherwise the quantity of eval. pdf(wi, wo): the densities,
    (n,). density_of: the measure of both densities, solid_angle, projected or half (the solid angle of the half vector).

    A function may be left out, except that sample or pdf must be given; the checks that need the function are then undecided.
    name: of the subject in the findings. effort: 6 viewing directions (quick) or 24 (full). require: those of the nine
    checks that must pass for `passed`. Raises InputError if a function raises an exception, or if its results have a wrong
    shape or are no numbers.
    """
    required = list_of(require)
    known = _brdf.sampler_checks()
    for check in required:
        if check not in known:
            raise InputError(f"require {check}: must be one of {', '.join(known)}")
    if sample is None and pdf is None:
        raise InputError("nothing to judge: give sample, pdf or both")
    functions = Functions(eval, sample, pdf, whole("randoms", randoms, 1, MOST_RANDOMS))
    return Judgement(_brdf.judge(name, None if eval is None else functions.eval,
                                 None if sample is None else functions.sample, None if pdf is None else functions.pdf,
                                 functions.channels, randoms, functions.gives_pdf, functions.gives_value, returns,
                                 value or "", density_of, effort, seed_of(seed)), required)
