#!/usr/bin/env python3
"""package_test.py BUILD: the Debian packages have no error for lintian, install into an empty root, work from there, and
leave nothing when they are removed. Exit 77 where a tool is missing."""
import pathlib
import shutil
import subprocess
import sys

from installed import run, temporary_folder

build = pathlib.Path(sys.argv[1])
for tool in ("cpack", "lintian", "dpkg-deb", "dpkg-shlibdeps"):
    if not shutil.which(tool):
        print(f"skipped: {tool} is not installed")
        sys.exit(77)


def files_of(root):
    return {str(p.relative_to(root)) for p in root.rglob("*") if not p.is_relative_to(root / "var/lib/dpkg")}


with temporary_folder() as folder:
    folder = pathlib.Path(folder)
    run(["cpack", "-B", folder / "packages"], cwd=build)
    packages = sorted((folder / "packages").glob("*.deb"))
    names = {p.name.split("_")[0] for p in packages}
    assert {"brdf", "libbrdf-dev"} <= names, names
    said = subprocess.run(["lintian", "--allow-root", "--fail-on", "error", *packages], text=True, capture_output=True)
    print(said.stdout)
    assert said.returncode == 0, said.stdout + said.stderr

    # A root of its own with nothing in it: dpkg unpacks, lists and removes; dependencies are those of the machine.
    root = folder / "root"
    admin = root / "var/lib/dpkg"
    for name in ("info", "updates", "triggers"):
        (admin / name).mkdir(parents=True)
    (admin / "status").touch()
    before = files_of(root)
    dpkg = ["dpkg", f"--root={root}", "--force-depends", "--force-not-root", f"--log={folder / 'dpkg.log'}"]
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

    run([*dpkg, "--purge", *sorted(names)])
    left = {p for p in files_of(root) - before if not p.startswith("var")}
    assert not left, left
