#!/usr/bin/env python3
# ctest: cli.layouts label=cli @brdf@ @source@
"""layouts_test.py BRDF SOURCE: tests that docs/layout.schema.json and the program accept and refuse the same layouts, and that
describe-table proposes layouts that follow the schema. Exit code 77 without python3-jsonschema."""
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(77)

from documents import changer_of

brdf, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
BAD_FILE = 2
schema = json.loads((source / "docs/layout.schema.json").read_text())
jsonschema.Draft7Validator.check_schema(schema)
follows = jsonschema.Draft7Validator(schema).is_valid

TABLE = ("made by hand\nin;az;out;az2;nm;pol;green;u;turn;g;note\n30;0;20;180;550;s;0,5;2;0;40;dry\n"
         "30;0;20;180;550;p;-1;2;0;40;\n")
# Every key of the document, and the keys of most entries.
FULL = {
    "format": "brdf-layout", "version": 1, "separator": ";", "decimal": ",", "comment": "%", "header": 2, "quantity": "BRF %",
    "mirror_azimuth": 0, "fill": [-1, "n/a"], "aperture": 2.5,
    "columns": [{"name": "in", "is": "theta_i", "unit": "deg", "from": "surface"}, {"position": 2, "is": "phi_i", "unit": "deg"},
                {"name": "out", "is": "theta_o"}, {"name": "az2", "is": "phi_o"}, {"constant": 550, "is": "wavelength", "unit": "nm"},
                {"name": "pol", "is": "polarisation"}, {"name": "green", "is": "value"},
                {"name": "u", "is": "sigma", "of": "fr", "coverage": 2, "relative": "%"},
                {"name": "turn", "is": "rotation", "unit": "rad"}, {"name": "note", "is": "ignored"}],
    "unsure": [{"path": "$.columns[6].is", "reason": "an example"}],
}
LEAST = {"format": "brdf-layout", "version": 1, "quantity": "f_r",
         "columns": [{"name": "in", "is": "theta_i"}, {"name": "out", "is": "theta_o"},
                     {"name": "green", "is": "value", "channel": "g"}]}
changed = changer_of(FULL)

GOOD = {
    "every key": FULL,
    "as little as possible": LEAST,
    "a phase angle": changed(["columns"], [*LEAST["columns"], {"name": "az", "is": "ignored"}, {"name": "g", "is": "phase", "unit": "deg"}],
                             LEAST),
    "a side": LEAST | {"mirror_side": "negative"},
    "a quantity of the entry": changed(["columns", 2, "quantity"], "log10 BRDF", changed(["quantity"], "del", LEAST)),
}
BAD = {
    "a column twice": None,
    "an unknown key": changed(["units"], "deg"),
    "an unknown key of an entry": changed(["columns", 0, "scale"], 2),
    "another format": changed(["format"], "brdf-scene"),
    "another version": changed(["version"], 2),
    "no columns": changed(["columns"], "del"),
    "no values": changed(["columns"], FULL["columns"][:6]),
    "no viewer": changed(["columns", 2], "del"),
    "null": changed(["columns", 2, "is"], None),
    "null in place of a quantity": changed(["quantity"], None),
    "an unknown meaning": changed(["columns", 2, "is"], "theta_v"),
    "an entry without a place": changed(["columns", 0], {"is": "theta_i"}),
    "an entry with two places": changed(["columns", 0, "position"], 1),
    "a constant value": changed(["columns", 6], {"constant": 1, "is": "value"}),
    "a key without effect": changed(["columns", 6, "unit"], "deg"),
    "a wavelength without a unit": changed(["columns", 4, "unit"], "del"),
    "position 0": changed(["columns", 1, "position"], 0),
    "an empty name": changed(["columns", 0, "name"], ""),
    "a coverage of 0": changed(["columns", 7, "coverage"], 0),
    "a relative uncertainty in nm": changed(["columns", 7, "relative"], "nm"),
    "an angle from elsewhere": changed(["columns", 0, "from"], "mirror"),
    "a mirror at 90": changed(["mirror_azimuth"], 90),
    "a side of another name": LEAST | {"mirror_side": "left"},
    "no fill values": changed(["fill"], []),
    "true as a fill value": changed(["fill"], [True]),
    "a wide detector": changed(["aperture"], 91),
    "an unknown separator": changed(["separator"], "space"),
    "an unknown mark": changed(["decimal"], ";"),
    "an empty comment": changed(["comment"], ""),
    "a line before the first": changed(["header"], -1),
    "a doubt without a reason": changed(["unsure", 0], {"path": "$"}),
    "a list": [FULL],
}
del BAD["a column twice"]

with tempfile.TemporaryDirectory() as folder:
    def run(*words):
        return subprocess.run([brdf, *words], cwd=folder, capture_output=True, text=True, check=False)

    pathlib.Path(folder, "table.txt").write_text(TABLE)

    def accepts(layout):
        pathlib.Path(folder, "layout.json").write_text(json.dumps(layout))
        done = run("convert", "table.txt", "out.csv", "--layout", "layout.json", "--keep-fill")
        assert done.returncode in (0, BAD_FILE), done
        assert done.returncode == 0 or "layout.json" in done.stderr, done.stderr
        return done.returncode == 0, done.stderr

    wrong = []
    for name, layout in GOOD.items():
        ok, why = accepts(layout)
        wrong += [f"{name}: refused by {who}: {why}" for who, good in (("the schema", follows(layout)), ("the program", ok)) if not good]
    for name, layout in BAD.items():
        wrong += [f"{name}: accepted by {who}" for who, good in (("the schema", follows(layout)), ("the program", accepts(layout)[0]))
                  if good]
    if wrong:
        sys.exit("\n".join(wrong))

    # Proposals follow the schema as soon as their places are filled.
    rows = "".join(f"{i},{o},{0.1 + 0.5 * (i == o)},{k},21.5\n" for i in (20, 50) for k, o in enumerate(range(-60, 61, 10)))
    pathlib.Path(folder, "plane.csv").write_text("Incident angle (deg),Scatter angle (deg),BRDF (1/sr),point,temperature (C)\n" + rows)
    done = run("describe-table", "plane.csv")
    assert done.returncode == 0, done.stderr
    assert follows(json.loads(done.stdout)), done.stdout
    assert "checked: the proposal reads the same 26 rows of 1 channel as are read without a layout" in " ".join(done.stderr.split())
    pathlib.Path(folder, "plane.json").write_text(done.stdout)
    for words in ((), ("--layout", "plane.json")):
        assert run("convert", "plane.csv", f"plane{len(words)}.csv", *words).returncode == 0
    both = [[line for line in pathlib.Path(folder, f"plane{k}.csv").read_text().splitlines() if not line.startswith("#")] for k in (0, 2)]
    assert both[0] == both[1], both

    # Fill values that the other verbs leave out are proposed, and the row of another value stays.
    run("synth", "--form", "cook_torrance", "--grid", "in_plane", "--theta-i", "20,40,60", "--step", "5", "-o", "whole.csv")
    lines = [line for line in pathlib.Path(folder, "whole.csv").read_text().splitlines() if not line.startswith("#")]
    lines = [line.rpartition(",")[0] + ",-1" if k % 9 == 5 else line for k, line in enumerate(lines)]
    pathlib.Path(folder, "filled.csv").write_text("\n".join(lines) + "\n")
    done = run("describe-table", "filled.csv", "-o", "filled.json")
    assert done.returncode == 0, done.stderr
    assert json.loads(pathlib.Path(folder, "filled.json").read_text()).get("fill") == [-1], done.stderr
    assert f"the same {sum(not line.endswith(',-1') for line in lines) - 1} rows" in " ".join(done.stderr.split()), done.stderr

    # A table that is refused has places that are null, and the exit code 1.
    pathlib.Path(folder, "own.csv").write_text("lamp;eye;reading\n20;30;1,5\n20;40;1,25\n")
    done = run("describe-table", "own.csv", "-o", "own.json")
    assert done.returncode == 1 and "places of the proposal must be completed: null" in " ".join(done.stderr.split()), done.stderr
    proposal = json.loads(pathlib.Path(folder, "own.json").read_text())
    assert [column["is"] for column in proposal["columns"]] == [None] * 3 and not follows(proposal), proposal
    done = run("fit", "own.csv", "--layout", "own.json", "--form", "lambert")
    assert done.returncode == BAD_FILE and "own.json: $.columns[0].is: null must be replaced by" in done.stderr, done.stderr
    done = run("describe-table", source / "docs/layout.schema.json")
    assert done.returncode == BAD_FILE and "is in the format json" in done.stderr, done.stderr

    # A plan holds the layout itself, so that a later change of the file changes nothing.
    for k in (1, 2):
        pathlib.Path(folder, f"lab{k}.csv").write_text("lamp;eye;reading\n" + "".join(f"20;{o};1{k}\n" for o in range(-60, 61, 10)))
    layout = LEAST | {"mirror_side": "positive", "columns": [{"name": "lamp", "is": "theta_i"}, {"name": "eye", "is": "theta_o"},
                                                             {"name": "reading", "is": "value", "quantity": "BRF %"}]}
    del layout["quantity"]
    pathlib.Path(folder, "lab.json").write_text(json.dumps(layout))
    words = ("lab1.csv", "lab2.csv", "--form", "lambert", "--no-pictures", "--layout", "lab.json")
    assert run("plan", "fit", *words, "-o", "job").returncode == 0
    pathlib.Path(folder, "lab.json").write_text("{}")
    assert run("work", "job").returncode == 0
    assert run("collect", "job", "-o", "fitted").returncode == 0
    material = json.loads(pathlib.Path(folder, "fitted/lab1.json").read_text())
    assert abs(material["weights"]["rho"][0] - 0.11) < 1e-6, material
    assert run("plan", "fit", *words, "-o", "job2").returncode == BAD_FILE
