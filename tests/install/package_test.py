#!/usr/bin/env python3
# ctest: install.package label=slow timeout=3600 needs=install @build@ @python@
"""package_test.py BUILD [PYTHON]: tests that lintian finds no error in the Debian packages, that they install into an empty root and
work from there, and that no file remains when they are removed. PYTHON is the interpreter that the module was built for. Exit code 77
if a tool is missing."""
import json
import os
import pathlib
import shutil
import subprocess
import sys

from installed import run, temporary_folder, values_of

build = pathlib.Path(sys.argv[1])
python = sys.argv[2] if len(sys.argv) > 2 else None
for tool in ("cpack", "lintian", "dpkg-deb", "dpkg-shlibdeps"):
    if not shutil.which(tool):
        print(f"skipped: {tool} is not installed")
        sys.exit(77)


# Fits and evaluates from the folder /, and prints the paths of the program and of the module.
MODULE = """
import json, sys
import brdf
from brdf.programs import executable
samples, directions, said = sys.argv[1:]
found = brdf.fit(samples, "ward")
json.dump(found.to_dict(), open(said, "w"))
for row in found.best.material.eval(*brdf.read_directions(directions)).tolist():
    print(",".join(map(repr, row)))
print(executable(), brdf.__file__)
"""

# Warnings of lintian that stay, with the reason.
EXPLAINED = {"pkg-config-unavailable-for-cross-compilation":
             "the same rules of installation serve every system, and the packages have no folder for each architecture",
             "script-not-executable": "sbatch reads brdf-array.sbatch, and nobody executes it"}


def files_of(root):
    return {str(p.relative_to(root)) for p in root.rglob("*") if not p.is_relative_to(root / "var/lib/dpkg")}


with temporary_folder() as folder:
    folder = pathlib.Path(folder)
    run(["cpack", "-B", folder / "packages"], cwd=build)
    packages = sorted((folder / "packages").glob("*.deb"))
    names = {p.name.split("_")[0] for p in packages}
    has_module = (build / "python/brdf").is_dir()
    assert names == {"brdf", "libbrdf-dev"} | ({"python3-brdf"} if has_module else set()), names
    said = subprocess.run(["lintian", "--allow-root", "--fail-on", "error", *packages], text=True, capture_output=True)
    print(said.stdout)
    assert said.returncode == 0, said.stdout + said.stderr
    warnings = {line.split()[2] for line in said.stdout.splitlines() if line.startswith("W: ")}
    assert warnings <= EXPLAINED.keys(), warnings - EXPLAINED.keys()

    # In an empty root of its own, dpkg unpacks, lists and removes the package; the dependencies are taken from the machine.
    root = folder / "root"
    admin = root / "var/lib/dpkg"
    for name in ("info", "updates", "triggers"):
        (admin / name).mkdir(parents=True)
    (admin / "status").touch()
    before = files_of(root)
    dpkg = ["dpkg", f"--root={root}", "--force-depends", "--force-not-root", "--force-script-chrootless",
            f"--log={folder / 'dpkg.log'}"]
    run([*dpkg, "--install", *packages])
    listed = set()
    for name in names:
        listed |= {line.lstrip("/") for line in run([*dpkg, "--listfiles", name]).splitlines()} - {".", ""}
    present = files_of(root) - before
    assert {p for p in present if (root / p).is_file() and not p.startswith("var")} <= listed, present - listed

    brdf = root / "usr/bin/brdf"
    elsewhere = folder / "elsewhere"
    elsewhere.mkdir()
    run([brdf, "fit", root / "usr/share/brdf/synthetic/ward.csv", "--form", "ward", "-o", "ward.json", "--report",
         "ward.html"], cwd=elsewhere)
    assert (elsewhere / "ward.html").is_file()

    if has_module and python:
        directions, said = elsewhere / "directions.csv", elsewhere / "said.json"
        shutil.copy(root / "usr/share/brdf/directions.csv", directions)
        environment = {**os.environ, "PYTHONPATH": str(root / "usr/lib/python3/dist-packages"),
                       "PYTHONDONTWRITEBYTECODE": "1", "BRDF_PROGRAM": ""}
        printed = run([python, "-P", "-c", MODULE, root / "usr/share/brdf/synthetic/ward.csv", directions, said], cwd="/",
                      env=environment)
        assert f"{root}/usr/bin/brdf {root}/usr/lib/python3/dist-packages/brdf/" in printed, printed
        printed = values_of(printed)
        assert printed == [row[4:] for row in values_of(run([brdf, "eval", "--material", "ward.json", directions],
                                                            cwd=elsewhere))] and printed, printed
        told = json.loads(run([brdf, "fit", root / "usr/share/brdf/synthetic/ward.csv", "--form", "ward", "--json"]))
        assert json.loads(said.read_text())["ranking"] == told["ranking"]

    run([*dpkg, "--purge", *sorted(names)])
    left = {p for p in files_of(root) - before if not p.startswith("var")}
    assert not left, left
