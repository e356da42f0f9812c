"""The verbs that need the whole program (a renderer, a window, minutes of measuring): run beside the interpreter."""
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
from .table import Table

BAD_INPUT, ENVIRONMENT = 2, 3


@functools.lru_cache(maxsize=None)
def verbs() -> dict[str, Any]:
    """names.json: what every verb and option of the program is called here."""
    found: dict[str, Any] = json.loads((pathlib.Path(__file__).parent / "names.json").read_text(encoding="utf-8"))["verbs"]
    return found


def executable() -> str:
    """The program: $BRDF_PROGRAM, that of the same installation or build, or the one in PATH."""
    above = pathlib.Path(_brdf.__file__).resolve().parents  # BUILD/python/brdf, PREFIX/lib/python3/dist-packages/brdf
    beside = [*(folder / "brdf" for folder in above[2:3]), *(folder / "bin" / "brdf" for folder in above[1:6])]
    for candidate in [os.environ.get("BRDF_PROGRAM"), *beside, shutil.which("brdf")]:
        if candidate and os.path.isfile(candidate) and os.access(candidate, os.X_OK):
            return str(candidate)
    raise _brdf.EnvironmentError("the program brdf was not found: it belongs in PATH or in $BRDF_PROGRAM")


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
    """Files of the materials and tables that a command is given, in a folder that lasts as long as it runs."""

    def __init__(self, folder: pathlib.Path) -> None:
        self._folder, self._count = folder, 0

    def of(self, value: Any) -> Any:
        """Its file; what is no material and no table as it is."""
        if isinstance(value, Material):
            path = self._new(f"{value.form}.json")
        elif isinstance(value, Table):
            path = self._new((pathlib.Path(value.source).stem or "samples") + ".csv")
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
    """Runs `brdf VERB ARGUMENTS --options` and returns what it prints: parsed where `json=True`, else text.

    Arguments and options are as on the command line, or a Material or a Table: the program reads a file of it.
    Options have the program's names with _ for -: `output="a.png"` is --output, True a flag, a list is joined by
    commas, {"kd": 0.3} is name=value. InputError and EnvironmentError with the program's sentence. A result that fails
    (exit code 1) is returned as any other; with json=True it says so itself.
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
    if run.returncode not in (0, 1):
        raise _brdf.EnvironmentError(sentence or f"brdf {verb}: ended with {run.returncode}")
    return json.loads(run.stdout) if options.get("json") else run.stdout


def render(*materials: Any, **options: Any) -> str:
    """`brdf render MATERIALS`: a picture of a scene, with the program's options as keywords (see `program`)."""
    return str(program("render", *materials, **options))


def lobes(*materials: Any, **options: Any) -> str:
    """`brdf lobes MATERIALS`: the lobe of a material as a plot or a body, in the file `output`."""
    return str(program("lobes", *materials, **options))


def maps(kind: str, **options: Any) -> str:
    """`brdf maps KIND`: seeded texture maps in the folder `output`."""
    return str(program("maps", kind, **options))


def parity(**options: Any) -> Any:
    """`brdf parity`: the deferred renderer against the ray-traced reference; json=True: its rows."""
    return program("parity", **options)


def view(*materials: Any, **options: Any) -> str:
    """`brdf view MATERIALS`: a window; returns when it is closed."""
    return str(program("view", *materials, **options))


def study(*samples: Any, **options: Any) -> Any:
    """`brdf study SAMPLES`: one sample's page, many samples' overview, in the folder `output`; json=True: its rows."""
    return program("study", *samples, **options)


def prove(*materials: Any, **options: Any) -> Any:
    """`brdf prove`: properties of forms over their whole domain, of materials at their parameters; json=True: its results."""
    return program("prove", *materials, **options)


def trade(**options: Any) -> Any:
    """`brdf trade`: speed against accuracy, measured; json=True: its rows."""
    return program("trade", **options)


def recommend(**options: Any) -> Any:
    """`brdf recommend`: the cheapest model that a scene needs; json=True: what is chosen and the candidates."""
    return program("recommend", **options)
