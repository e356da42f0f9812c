#!/usr/bin/env python3
# ctest: install.prefix label=install timeout=3600 needs=install @build@ @source@ @python@
"""prefix_test.py BUILD SOURCE [PYTHON]: tests that an installed prefix works after it was moved to another folder: a fit with its
report, by the program and by the module that was built for PYTHON; an installed scene, if this machine can render; man pages,
completion and descriptions."""
import gzip
import os
import pathlib
import shutil
import subprocess
import sys

from installed import moved_prefix, run, temporary_folder

build, source, *python = map(pathlib.Path, sys.argv[1:])
# The written pages contain the Chart.js of the prefix, and the program is found in the same folder.
MODULE = """
import sys
import brdf
brdf.fit(sys.argv[1], "ward").report("module.html")
print(brdf.programs.executable())
"""
with temporary_folder() as folder:
    folder = pathlib.Path(folder)
    prefix = moved_prefix(build, folder)
    elsewhere = folder / "elsewhere"
    elsewhere.mkdir()
    brdf = prefix / "bin/brdf"
    share = prefix / "share"

    def say(*words):
        return run([brdf, *words], cwd=elsewhere)

    # Installed samples are files as any; the report holds the Chart.js of the prefix.
    chart = share / "brdf/chart.min.js"
    marked = chart.read_text() + "\n/* of this prefix */\n"
    chart.chmod(0o644)
    chart.write_text(marked)
    say("fit", share / "brdf/synthetic/ward.csv", "--form", "ward", "-o", "ward.json", "--report", "ward.html")
    assert "/* of this prefix */" in (elsewhere / "ward.html").read_text()
    modules = prefix / "lib/python3/dist-packages"
    if python and modules.is_dir():
        found = run([python[0], "-P", "-c", MODULE, share / "brdf/synthetic/ward.csv"], cwd=elsewhere,
                    env={**os.environ, "PYTHONPATH": str(modules), "BRDF_PROGRAM": ""})
        assert found.strip() == str(brdf), found
        assert "/* of this prefix */" in (elsewhere / "module.html").read_text()
    say("study", share / "brdf/synthetic/lambert.csv", "--form", "lambert", "--no-pictures", "-o", "study")
    assert (elsewhere / "study/index.html").is_file()
    drawn = subprocess.run([brdf, "render", "--scene", "scenes/rusty_metal.json", "--width", "64", "--height", "64",
                            "-o", "scene.png"], cwd=elsewhere, text=True, capture_output=True)
    # Exit code 3: this build or this machine cannot draw, and the scene was found all the same.
    assert drawn.returncode == 0 and (elsewhere / "scene.png").is_file() or drawn.returncode == 3, drawn.stderr

    # The script for job arrays does a unit of planned work.
    (elsewhere / "tables").mkdir()
    for k in range(2):
        shutil.copy(share / "brdf/synthetic/lambert.csv", elsewhere / f"tables/{k}.csv")
    say("plan", "fit", "tables", "--form", "lambert", "--no-pictures", "--unit-size", "1", "-o", "job")
    for k in range(2):
        run(["bash", share / "brdf/slurm/brdf-array.sbatch", "job"], cwd=elsewhere,
            env={**os.environ, "BRDF_PROGRAM": str(brdf), "SLURM_ARRAY_TASK_ID": str(k)})
    say("collect", "job", "-o", "fits")
    assert (elsewhere / "fits/summary.csv").read_text().count("tables/") == 2

    # The checker of proofs is in the same folder, and its help states its purpose.
    say("prove", "--form", "lambert", "--property", "finite", "-o", "certificate.json")
    assert ": 2 proved" in run([prefix / "bin/brdf_check", "--require", "finite", "certificate.json"], cwd=elsewhere)
    assert "brdf_check [--help | --version]" in run([prefix / "bin/brdf_check", "--help"])
    assert "brdf_check" in gzip.decompress((share / "man/man1/brdf_check.1.gz").read_bytes()).decode()

    pages = sorted((share / "man/man1").glob("*.gz"))
    assert len(pages) > 10, pages
    text = gzip.decompress((share / "man/man1/brdf-fit.1.gz").read_bytes()).decode()
    assert "\\-\\-form" in text and "brdf fit samples.csv" in text.replace("\\-", "-")
    if shutil.which("mandoc"):
        for page in pages:
            plain = elsewhere / page.stem
            plain.write_bytes(gzip.decompress(page.read_bytes()))
            run(["mandoc", "-T", "lint", "-W", "warning", plain])
    assert (share / "bash-completion/completions/brdf").is_file()
    if (share / "applications").is_dir():
        for tool, name in (("desktop-file-validate", "applications/org.brdf.view.desktop"),
                           ("appstreamcli", "metainfo/org.brdf.view.metainfo.xml")):
            words = ["validate", "--no-net"] if tool == "appstreamcli" else []
            if shutil.which(tool):
                run([tool, *words, share / name])
