"""The verbs that need the whole program (a renderer, a window, minutes of measuring). They run as a separate process."""
from __future__ import annotations

import functools
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
from collections.abc import Mapping
from typing import Any

from . import _brdf
from .material import Material
from .table import Table, table_or_path

BAD_INPUT, ENVIRONMENT, UNDECIDED = 2, 3, 4


@functools.lru_cache(maxsize=None)
def verbs() -> dict[str, Any]:
    """Returns the content of names.json: the Python name of every verb and option of the program."""
    found: dict[str, Any] = json.loads((pathlib.Path(__file__).parent / "names.json").read_text(encoding="utf-8"))["verbs"]
    return found


def executable() -> str:
    """Returns the program: $BRDF_PROGRAM, the program of the same installation or build, or the one in PATH."""
    above = pathlib.Path(_brdf.__file__).resolve().parents  # BUILD/python/brdf, PREFIX/lib/python3/dist-packages/brdf
    beside = [*(folder / "brdf" for folder in above[2:3]), *(folder / "bin" / "brdf" for folder in above[1:6])]
    for candidate in [os.environ.get("BRDF_PROGRAM"), *beside, shutil.which("brdf")]:
        if candidate and os.path.isfile(candidate) and os.access(candidate, os.X_OK):
            return str(candidate)
    raise _brdf.EnvironmentError("the program brdf was not found: add it to PATH, or set $BRDF_PROGRAM")


def _words(name: str, value: Any) -> list[str]:
    option = "--" + name.replace("_", "-")
    if value is None or value is False:
        return []
    if value is True:
        return [option]
    if isinstance(value, Mapping):
        return [word for key, one in value.items() for word in (option, f"{key}={_joined(one)}")]
    return [option, _joined(value)]


def _joined(value: Any) -> str:
    if isinstance(value, (str, bytes, os.PathLike)):
        return os.fsdecode(value)
    try:
        return ",".join(_joined(v) for v in value)
    except TypeError:
        return str(value)


class _Files:
    """Files for the materials and tables passed to a command, in a folder that exists while the command runs."""

    def __init__(self, folder: pathlib.Path) -> None:
        self._folder, self._count = folder, 0

    def of(self, value: Any) -> Any:
        """Returns a file with the value, or the value itself if it is neither a material nor a table."""
        if isinstance(value, Material):
            path = self._new(f"{value.form}.json")
        elif isinstance(table := table_or_path(value), Table):
            value = table
            path = self._new((pathlib.Path(table.source).stem or "samples") + ".csv")
        else:
            return value
        value.save(path)
        return path

    def _new(self, name: str) -> pathlib.Path:
        self._count += 1
        path = self._folder / str(self._count) / name
        path.parent.mkdir()
        return path


def program(verb: str, *arguments: Any, **options: Any) -> Any:
    """Runs `brdf VERB ARGUMENTS --options` and returns the output: parsed if `json=True`, otherwise text.

    Arguments and options are the same as on the command line. A Material or a Table (or a frame of pandas or xarray) is passed as a temporary file. Options
    have the names of the program with _ for -: `output="a.png"` is --output, True sets a flag, a list is joined by commas,
    {"kd": 0.3} is name=value. Raises InputError and EnvironmentError with the message of the program. A result that fails
    (exit code 1) or is undecided (exit code 4) is returned like any other; the output of json=True contains the failure.
    """
    with tempfile.TemporaryDirectory(prefix="brdf_") as folder:
        files = _Files(pathlib.Path(folder))
        words = [os.fsdecode(files.of(one)) for one in arguments]
        words += [word for name, value in options.items() for word in _words(name, files.of(value))]
        run = subprocess.run([executable(), verb, *words], capture_output=True, encoding="utf-8",
                             errors="surrogateescape", check=False)
    sentence = run.stderr.strip().rpartition("\n")[2].removeprefix("brdf: ")
    if run.returncode == BAD_INPUT:
        raise _brdf.InputError(sentence)
    if run.returncode not in (0, 1, UNDECIDED):
        raise _brdf.EnvironmentError(sentence or f"brdf {verb}: ended with {run.returncode}")
    return json.loads(run.stdout) if options.get("json") else run.stdout


def render(*materials: Any, **options: Any) -> str:
    """`brdf render MATERIALS`: a picture of a scene, with the program's options as keywords (see `program`)."""
    return str(program("render", *materials, **options))


def lobes(*materials: Any, **options: Any) -> str:
    """`brdf lobes MATERIALS`: the lobe of a material as a plot or as a surface in 3D, in the file `output`."""
    return str(program("lobes", *materials, **options))


def maps(kind: str, **options: Any) -> str:
    """`brdf maps KIND`: seeded texture maps in the folder `output`."""
    return str(program("maps", kind, **options))


def parity(**options: Any) -> Any:
    """`brdf parity`: compares the deferred renderer with the ray-traced reference; json=True: returns the rows."""
    return program("parity", **options)


def view(*materials: Any, **options: Any) -> str:
    """`brdf view MATERIALS`: a window; returns when it is closed."""
    return str(program("view", *materials, **options))


def study(*samples: Any, **options: Any) -> Any:
    """`brdf study SAMPLES`: a page per sample and an overview, in the folder `output`; json=True: returns the rows."""
    return program("study", *samples, **options)


def prove(*materials: Any, **options: Any) -> Any:
    """`brdf prove`: properties of forms over their whole domain, and of materials at their parameters; json=True: returns
    the results."""
    return program("prove", *materials, **options)


def _several(verb: str, samples: tuple[Any, ...], repeated: Mapping[str, Any], options: Mapping[str, Any]) -> dict[str, Any]:
    words = [word for name, values in repeated.items() for one in ([values] if isinstance(values, (str, os.PathLike)) else values)
             for word in ("--" + name, one)]
    found: dict[str, Any] = program(verb, *samples, *words, **{**options, "json": True})
    return found


def compare(first: Any, second: Any, budget: Any = (), **options: Any) -> dict[str, Any]:
    """`brdf compare`: whether two tables are of the same surface, within their budgets. Returns the JSON of the verb.

    budget: a file for both tables, or a list with one for each.
    "answer" is "no_difference", "different", "cannot_be_told" (the tables have no budgets) or "undecided".
    """
    return _several("compare", (first, second), {"budget": budget}, options)


def consensus(*samples: Any, at: Any = (), budget: Any = (), **options: Any) -> dict[str, Any]:
    """`brdf consensus`: the consensus of several laboratories' tables of one surface. Returns the JSON of the verb.

    at: directions of values of f, as "0:45" or a list of such words. budget: a file for all tables, or a list with one for
    each. The "consensus" of a quantity is None if it is undecided.
    """
    return _several("consensus", samples, {"at": at, "budget": budget}, options)


def trade(**options: Any) -> Any:
    """`brdf trade`: measures speed against accuracy; json=True: returns the rows."""
    return program("trade", **options)


def recommend(**options: Any) -> Any:
    """`brdf recommend`: the cheapest model that is sufficient for a scene; json=True: returns choice and candidates."""
    return program("recommend", **options)


def convert_parameters(source: Material | Mapping[str, float] | str | os.PathLike[str], to: str = "",
                       **options: Any) -> list[dict[str, Any]]:
    """`brdf convert-parameters`: converts {"phong_exponent": 50} into other widths and roughness, and a width or a material
    into gloss.

    to: one parameter or number, or "" for all. Further options: index, phi. Returns a dictionary for each result, with its
    rule; the value is None if the number is undecided or refused.
    """
    chosen: dict[str, Any] = {"from": source} if isinstance(source, Mapping) else {"material": source}
    if to:
        chosen["to"] = to
    rows: list[dict[str, Any]] = program("convert-parameters", **chosen, **options, json=True)["results"]
    return rows
