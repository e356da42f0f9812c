#!/usr/bin/env python3
# ctest: cli.older_files label=cli @brdf@ @source@/tests/cli/older_files
"""older_files_test.py BRDF FILES: tests that files of version 0.1 are read. FILES holds files as programs of that version wrote them: the
first ones that carried the number, and the last ones. Each test is a function with a sentence as its name."""
import hashlib
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

brdf, files = (pathlib.Path(word).resolve() for word in sys.argv[1:3])


def run(*words, cwd=files, code=0):
    done = subprocess.run([brdf, *map(str, words)], cwd=cwd, capture_output=True, text=True, check=False)
    assert done.returncode == code, (words, done.returncode, done.stderr)
    return done.stdout


def content(name):
    return json.loads((files / name).read_text())


def materials_are_read_with_their_values(_):
    for name in ("first_material.json", "fitted_material.json"):
        material = content(name)
        shown = json.loads(run("albedo", name, "--theta", "0,60", "--json"))
        set_ = [f"{key}={','.join(map(str, value))}" for key, value in material["weights"].items()]
        set_ += [f"{key}={value}" for key, value in material["shape"].items()]
        words = [word for setting in set_ for word in ("--set", setting)]
        named = json.loads(run("albedo", "--form", material["form"], *words, "--theta", "0,60", "--json"))
        values = [[row["value"] for row in one["results"]] for one in (shown, named)]
        assert values[0] == values[1] and values[0], name


def ledgers_are_compared_with_themselves(_):
    for name in ("first_ledger.json", "ledger.json"):
        assert content(name)["claims"], name
        assert "agree in cost ratio" in run("trade", "--compare", name, name), name


def certificates_are_verified(_):
    for name in ("first_certificate.json", "certificate.json"):
        results = content(name)["results"]
        assert f"{len(results)} results" in (said := run("prove", "--check", name)) and f" {len(results)} proved" in said, said


def a_plan_is_worked_and_no_unit_of_the_older_version_is_collected(folder):
    plan = content("plan.json")
    assert plan["brdf_version"] == "0.1.0"
    key = plan.pop("key")

    def key_of(members):
        return hashlib.sha256(json.dumps(members, separators=(",", ":")).encode()).hexdigest()
    assert key_of(plan) == key
    plan["directory"] = str(folder)
    (folder / "job/units/000").mkdir(parents=True)
    (folder / "job/plan.json").write_text(json.dumps({**plan, "key": key_of(plan)}))
    (folder / "tables").mkdir()
    for name in ("a.csv", "b.csv"):
        shutil.copy(files / name, folder / "tables")
    # An empty unit as the older version would have named it.
    (folder / "job/units/000/00000.unit").write_text(f"brdf-unit 1 {key_of(plan)} 0 {hashlib.sha256(b'').hexdigest()}\n")
    assert run("collect", "job", "--missing", cwd=folder, code=1).strip() == "0-1"
    run("work", "job", cwd=folder)
    run("collect", "job", "-o", "collected", cwd=folder)
    run("fit", "tables", "--form", "phong", "--no-pictures", "-o", "at_once", cwd=folder)
    at_once = list((folder / "at_once").rglob("*.json"))
    assert len(at_once) >= 2, at_once
    for made in at_once:
        assert made.read_bytes() == (folder / "collected" / made.relative_to(folder / "at_once")).read_bytes(), made


for test in (materials_are_read_with_their_values, ledgers_are_compared_with_themselves, certificates_are_verified,
             a_plan_is_worked_and_no_unit_of_the_older_version_is_collected):
    with tempfile.TemporaryDirectory(prefix="brdf_older_") as place:
        test(pathlib.Path(place))
    print(test.__name__.replace("_", " "))
