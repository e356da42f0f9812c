"""Fits of forms to samples: parameters with confidence intervals."""
from __future__ import annotations

import functools
import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Tuple, Union

import numpy as np

from . import _brdf
from ._brdf import InputError
from .arrays import Array
from .display import table_html
from .entries import Entries
from .frames import Frame, Layout, layout_word
from .material import Material
from .table import Table, read, table_or_path
from .words import Path, Settings, finite, list_of, path_of, ranges, seed_of, settings, whole

Progress = Callable[[str], Any]
Source = Union[Table, Path, Frame]
Extent = Tuple[Union[float, None], Union[float, None]]  # lowest and highest


@dataclass(frozen=True)
class Interval:
    """The estimate of one parameter: the value (None if the samples cannot identify it) and 95 % intervals."""

    value: float | None
    status: str  #: free, fixed, at_bound or unidentified
    low: float | None  #: from the measurement noise, assuming that the model is correct; None: this end is open
    high: float | None
    standard_error: float | None
    with_lack_of_fit: Extent  #: includes the lack of fit of the model
    left_out: Extent  #: range of the value over fits without one fold of the samples
    other_metrics: Extent  #: range of the value over fits with the other metrics

    @classmethod
    def _of(cls, entry: Mapping[str, Any]) -> Interval:
        def extent(name: str) -> Extent:
            found = entry.get(name) or {}
            return found.get("low"), found.get("high")

        return cls(entry["value"], entry["status"], entry.get("low"), entry.get("high"), entry.get("standard_error"),
                   extent("with_lack_of_fit"), extent("left_out"), extent("other_metrics"))


class Candidate(Entries):
    """The fit of one form: an entry of `ranking` of `brdf fit --json` with the same keys. `to_dict()` returns the entry."""

    def __init__(self, fitted: _brdf.Fitted, place: int, entry: dict[str, Any]) -> None:
        self._fitted, self._place, self._content = fitted, place, entry

    @property
    def form(self) -> str:
        """"ward", or "oren_nayar+ward"."""
        form: str = self._content["form"]
        return form

    @property
    def verdict(self) -> str:
        """converged, at_bound, determined, not_identifiable, misfit, breaks_energy, diverged or interrupted."""
        verdict: str = self._content["verdict"]
        return verdict

    @property
    def state(self) -> str:
        """The judgement of the fit: good, unknown (lack of fit cannot be judged), warn or bad."""
        state: str = self._content["state"]
        return state

    @property
    def sentence(self) -> str:
        """The judgement as a sentence, the same as in the program's output and pages."""
        sentence: str = self._content["sentence"]
        return sentence

    @property
    def usable(self) -> bool:
        """Whether the material is usable, for which `brdf fit` returns the exit code 0."""
        return self._fitted.usable(self._place)

    @property
    def findings(self) -> list[str]:
        """Findings as sentences; the reason of the verdict comes first."""
        findings: list[str] = self._content["findings"]
        return findings

    @property
    def median_relative_error(self) -> float | None:
        error: float | None = self._content["median_relative_error"]
        return error

    @functools.cached_property
    def material(self) -> Material:
        """The fitted material, with the block `fit` that `-o` writes."""
        return Material._of(self._fitted.material(self._place))

    @functools.cached_property
    def intervals(self) -> dict[str, Interval | dict[str, Interval]]:
        """Intervals by parameter, and by channel for a parameter with a value per channel. tangent_phi is in degrees."""
        return {name: Interval._of(entry) if "status" in entry
                else {channel: Interval._of(one) for channel, one in entry.items()}
                for name, entry in self._content["intervals"].items()}

    def __repr__(self) -> str:
        return f"<brdf.Candidate {self.form}: {self.verdict}>"

    def _repr_html_(self) -> str:
        return f"{self.material._repr_html_()}<p>{self.sentence}</p>"


class Fit(Entries):
    """The result of `brdf fit`; the first entry of `ranking` is the best. The keys are the same as in `brdf fit --json`:
    "samples", "metric", "steps", ...; `to_dict()` returns the whole object."""

    def __init__(self, fitted: _brdf.Fitted) -> None:
        self._fitted = fitted

    @functools.cached_property
    def _content(self) -> dict[str, Any]:  # type: ignore[override]  # parsed on first access
        content: dict[str, Any] = json.loads(self._fitted.json)
        return content

    @functools.cached_property
    def ranking(self) -> list[Candidate]:
        return [Candidate(self._fitted, k, entry) for k, entry in enumerate(self._content["ranking"])]

    @property
    def best(self) -> Candidate:
        return self.ranking[0]

    @property
    def recommended(self) -> Candidate:
        """The simplest usable candidate that is not worse than the best; the best candidate if there is no simpler one."""
        return self.ranking[self._fitted.recommended]

    @property
    def verdict(self) -> str:
        """The verdict of the best candidate."""
        return self.best.verdict

    @property
    def interrupted(self) -> bool:
        """Whether the progress callback stopped the fit. The result is then the best fit so far."""
        return self._fitted.interrupted

    def report(self, path: Path) -> None:
        """Writes the HTML report of `brdf fit --report`."""
        _brdf.write_text(path_of(path), self._fitted.html())

    def __str__(self) -> str:
        """Returns the text that `brdf fit` prints."""
        return self._fitted.text

    def __repr__(self) -> str:
        return f"<brdf.Fit of {len(self.ranking)} forms, best {self.best.form}: {self.verdict}>"

    def _repr_html_(self) -> str:
        def share(x: float | None) -> str:
            return "-" if x is None else f"{100 * x:.2g} %"

        rows = [[c.form, c.verdict, share(c.median_relative_error), c.findings[0] if c.findings else ""]
                for c in self.ranking]
        title = self.best.sentence
        return table_html(title, ["form", "verdict", "median error (fitted)", "finding"], rows, self.best.material._repr_png_())


def _choice(form: str, metric: str, weights: str, robust: str | None, fix: Settings | None, start: Settings | None,
            bounds: Mapping[str, tuple[float, float]] | None, tie: str | Iterable[str] | None, physical: bool,
            anisotropic: bool, per_channel: bool, free_scale: bool, keep_fill: bool, polarisation: str, repeats: str,
            quantity: str, mirror_side: str, layout: Layout | None, max_theta: float, aperture: float | None, budget: Path | None,
            starts: int, seed: int, shape: str | None) -> _brdf.FitChoice:
    return _brdf.FitChoice(form, metric, weights, robust or "", settings(fix), settings(start), ranges(bounds),
                           list_of(tie), physical, anisotropic, per_channel, free_scale, keep_fill, polarisation,
                           repeats, quantity, mirror_side, layout_word(layout),
                           finite("--max-theta", max_theta), None if aperture is None else finite("--aperture", aperture),
                           b"" if budget is None else path_of(budget), whole("--starts", starts, 0, 100_000), seed_of(seed), shape or "")


def fit(samples: Source, form: str = "all", *, metric: str = "auto", weights: str = "auto", robust: str | None = None,
        fix: Settings | None = None, start: Settings | None = None,
        bounds: Mapping[str, tuple[float, float]] | None = None, tie: str | Iterable[str] | None = None,
        physical: bool = False, anisotropic: bool = False, per_channel: bool = False, free_scale: bool = False,
        keep_fill: bool = False, polarisation: str = "keep", repeats: str = "keep", quantity: str = "",
        mirror_side: str = "auto", layout: Layout | None = None, max_theta: float = 80.0, aperture: float | None = None,
        budget: Path | None = None, starts: int = 0, seed: int = 1, shape: str | None = None, progress: Progress | None = None) -> Fit:
    """Fits forms to samples: `brdf fit`, with its options as keywords.

    samples: a Table, a file, or a frame of pandas or xarray. form: all, every, a form, a sum as in "oren_nayar+ward", or auto. metric: auto, log,
    cosine_l2, cube_root, log_relative. weights: auto, uniform, sigma, solid_angle. robust: "huber" or "cauchy", with
    ":SCALE". fix, start: {"kd": 0.3} or {"kd": [.3, .2, .1]}, one value per channel, or for f0 (n, k)
    a file with refractive indices, "gold.yml". bounds: {"alpha": (low, high)}.
    tie: names of parameters with one value for all channels. shape: the shape over the channels,
    "shared", "free" (as per_channel) or "smooth:DEGREE", a polynomial in 1/wavelength. polarisation, repeats: treatment
    of polarised channels and of repeated directions, as in `convert`. keep_fill: also fit rows of fill values.
    quantity, mirror_side, layout: facts that a file does not state, as in `read`. max_theta, aperture: degrees; aperture
    None: the width that the file states, otherwise 0. budget: a file with the uncertainty budget of the instrument, which
    enters every interval; None: the one that the samples' file names. starts: number of
    random starts in addition to the grid, generated from `seed`.

    progress: called with a sentence before each form is fitted. If the callback returns False, the best result so far is
    returned and `interrupted` is True. Other Python threads can run during the fit; Ctrl-C raises KeyboardInterrupt.
    Raises InputError if the options are not valid for the samples.
    """
    choice = _choice(form, metric, weights, robust, fix, start, bounds, tie, physical, anisotropic, per_channel,
                     free_scale, keep_fill, polarisation, repeats, quantity, mirror_side, layout, max_theta,
                     aperture, budget, starts, seed, shape)
    found = table_or_path(samples, quantity, mirror_side, layout)
    table = found if isinstance(found, Table) else read(found, quantity=quantity, mirror_side=mirror_side, layout=layout)
    return Fit(_brdf.fit(table._samples, choice, progress))


def fit_files(samples: Sequence[Path], output: Path, form: str = "all", *, jobs: int = 1, metric: str = "auto",
              weights: str = "auto", robust: str | None = None, fix: Settings | None = None,
              start: Settings | None = None, bounds: Mapping[str, tuple[float, float]] | None = None,
              tie: str | Iterable[str] | None = None, physical: bool = False, anisotropic: bool = False,
              per_channel: bool = False, free_scale: bool = False, keep_fill: bool = False,
              polarisation: str = "keep", repeats: str = "keep",
              quantity: str = "", mirror_side: str = "auto", layout: Layout | None = None, max_theta: float = 80.0,
              aperture: float | None = None, budget: Path | None = None,
              starts: int = 0, seed: int = 1, shape: str | None = None, progress: Progress | None = None) -> list[dict[str, Any]]:
    """Fits many files into the folder `output`, `jobs` at a time: `brdf fit FILES -o FOLDER`, without pictures.

    Results of an earlier run of a file with the same options are kept. Returns the entries of `--json`: "file", "material",
    "kept" and "best", or "file" and "error". Options are the same as in `fit`.
    """
    if not samples:
        raise InputError("no samples: give at least one file")
    choice = _choice(form, metric, weights, robust, fix, start, bounds, tie, physical, anisotropic, per_channel,
                     free_scale, keep_fill, polarisation, repeats, quantity, mirror_side, layout, max_theta,
                     aperture, budget, starts, seed, shape)
    rows: list[dict[str, Any]] = json.loads(
        _brdf.fit_files([path_of(p) for p in samples], path_of(output), whole("--jobs", jobs, 1, 256), choice, progress))["files"]
    return rows


class NextDirections(Entries):
    """The result of `brdf next`. The keys are the same as in `brdf next --json`: "rows", "standard_errors", "errors", ...;
    `to_dict()` returns the whole object."""

    def __init__(self, content: dict[str, Any], text: str) -> None:
        self._content, self._text = content, text

    @property
    def directions(self) -> Array:
        """(rows, 4) theta_i, phi_i, theta_o and phi_o in degrees, in the order of the choice."""
        angles = ("theta_i", "phi_i", "theta_o", "phi_o")
        return np.array([[row[angle] for angle in angles] for row in self._content["rows"]]).reshape(-1, len(angles))

    def __str__(self) -> str:
        """Returns the text that `brdf next` prints."""
        return self._text

    def __repr__(self) -> str:
        return f"<brdf.NextDirections: {len(self._content['rows'])} rows for {self._content['form']}>"


def next_directions(samples: Source, reach: Table | Path, form: str | Sequence[str] = "all", *, rows: int = 16,
                    aim: str = "auto", noise: float | None = None, model_error: float | None = None,
                    metric: str = "auto", weights: str = "auto", robust: str | None = None,
                    fix: Settings | None = None, start: Settings | None = None,
                    bounds: Mapping[str, tuple[float, float]] | None = None, tie: str | Iterable[str] | None = None,
                    physical: bool = False, anisotropic: bool = False, per_channel: bool = False,
                    free_scale: bool = False, keep_fill: bool = False, polarisation: str = "keep",
                    repeats: str = "keep", quantity: str = "", mirror_side: str = "auto",
                    layout: Layout | None = None, max_theta: float = 80.0, aperture: float | None = None,
                    starts: int = 0, seed: int = 1, shape: str | None = None,
                    progress: Progress | None = None) -> NextDirections:
    """Chooses the directions to measure next: `brdf next`, with its options as keywords.

    samples: the rows measured so far, as in `fit`. reach: the directions that the instrument can take, a Table or a CSV of
    angles; values in it are not used. form: as in `fit`, or a list of forms to distinguish. rows: number of rows to choose.
    aim: "prediction", "forms" or "auto". noise, model_error: relative standard deviations of a reading and of the form
    (None: from the samples and the residuals). The other options are as in `fit`; rows at random are drawn with `seed`.
    Raises InputError if the samples are too few for the form, or if nothing can be chosen.
    """
    forms = form if isinstance(form, str) else ",".join(form)
    choice = _choice(forms, metric, weights, robust, fix, start, bounds, tie, physical, anisotropic, per_channel,
                     free_scale, keep_fill, polarisation, repeats, quantity, mirror_side, layout, max_theta,
                     aperture, None, starts, seed, shape)
    found = table_or_path(samples, quantity, mirror_side, layout)
    table = found if isinstance(found, Table) else read(found, quantity=quantity, mirror_side=mirror_side, layout=layout)
    to_reach = reach._samples if isinstance(reach, Table) else _brdf.read_directions(path_of(reach))
    stated = None if noise is None else finite("--noise", noise)
    error = None if model_error is None else finite("--model-error", model_error)
    content, text = _brdf.next_directions(table._samples, to_reach, choice, whole("--rows", rows, 1, 1000), aim, stated,
                                          error, progress)
    return NextDirections(json.loads(content), text)
