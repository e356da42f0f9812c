#!/usr/bin/env python3
# ctest: cli.schemas label=cli @brdf@ @source@
"""schemas_test.py BRDF SOURCE: tests that the output of verbs with --json follows docs/VERB.schema.json, and that the schemas
refuse wrong output. validate and study have their own tests. Exit code 77 without python3-jsonschema."""
import copy
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

brdf, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
synthetic = source / "data/synthetic"
NO_DRIVER = 3


def check(verb, document):
    schema = json.loads((source / f"docs/{verb}.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    errors = [error for error in jsonschema.Draft7Validator(schema).iter_errors(document)]
    if errors:
        worst = jsonschema.exceptions.best_match(errors)
        sys.exit(f"{verb} at {list(worst.absolute_path)}: {worst.message[:300]}")
    spoiled = copy.deepcopy(document)
    spoiled["unknown"] = 1
    try:
        jsonschema.validate(spoiled, schema)
    except jsonschema.ValidationError:
        return
    sys.exit(f"docs/{verb}.schema.json accepts anything")


with tempfile.TemporaryDirectory() as folder:

    def said(*words):
        done = subprocess.run([brdf, *map(str, words)], cwd=folder, capture_output=True, text=True)
        assert done.stdout or done.returncode == NO_DRIVER, f"{words}: {done.returncode} {done.stderr}"
        return json.loads(done.stdout) if done.stdout else None

    check("models", said("models", "--json"))
    check("doctor", said("doctor", "--json"))
    bare = {"PATH": "/nowhere", "VK_DRIVER_FILES": "/nowhere", "VK_ICD_FILENAMES": "/nowhere", "HOME": str(folder)}
    parts = {p["name"]: p for p in json.loads(subprocess.run([brdf, "doctor", "--json"], env=bare, capture_output=True).stdout)["parts"]}
    for name in ("Vulkan driver", "display", "Blender", "GNU parallel", "Slurm"):
        assert not parts[name]["found"] and parts[name]["remedy"], f"doctor finds {name} in an empty environment"
    check("fit", said("fit", synthetic / "ward.csv", "--form", "ward", "-o", "m.json", "--json"))
    check("fit", said("fit", synthetic / "ward.csv", "--form", "ward", "--bootstrap", "3", "--json"))
    check("fit", said("fit", synthetic / "ward_anisotropic.csv", "--form", "ward+lambert", "--anisotropic", "--fix",
                      "kd=0.1", "--metric", "log", "--free-scale", "--json"))
    check("fit", said("fit", synthetic / "phong_sparse.csv", synthetic / "README.md", "--form", "auto", "-o", "many", "--no-pictures",
                      "--json"))
    subprocess.run([brdf, "synth", "--form", "ward", "--texels", "3x2", "--lights", "40", "-o", "stack"], cwd=folder, check=True)
    check("fit", said("fit", "stack", "--form", "ward", "-o", "maps", "--json"))
    subprocess.run([brdf, "plan", "fit", "stack", "--form", "ward", "-o", "job"], cwd=folder, check=True)
    check("plan", json.loads((pathlib.Path(folder) / "job/plan.json").read_text()))
    check("collect", said("collect", "job", "--json"))
    for name, seed in (("one.csv", 1), ("two.csv", 2)):
        subprocess.run([brdf, "synth", "--form", "ward", "--noise", "0.01", "--seed", str(seed), "-o", name], cwd=folder, check=True)
    for name, kd in (("exact.csv", "0.2"), ("other.csv", "0.3")):
        subprocess.run([brdf, "synth", "--form", "ward", "--set", "kd=" + kd, "-o", name], cwd=folder, check=True)
    for tables in (("one.csv", "two.csv"), ("exact.csv", "other.csv")):  # without noise: undecided
        check("consensus", said("consensus", *tables, "--form", "ward", "--json"))
        check("compare", said("compare", *tables, "--form", "ward", "--json"))
    check("albedo", said("albedo", "--form", "ward", "--theta", "0,60", "--json"))
    check("albedo", said("albedo", "--material", "m.json", "--theta", "60", "--json"))
    start = (synthetic / "ward.csv").read_text().splitlines()
    rows = [line for line in start if not line.startswith("#")]
    (pathlib.Path(folder) / "start.csv").write_text("\n".join([rows[0], *rows[1::40]]) + "\n")
    check("next", said("next", "start.csv", "--reach", synthetic / "ward.csv", "--form", "ward", "--rows", "4", "--noise", "0.01", "--json"))
    check("next", said("next", "start.csv", "--reach", synthetic / "ward.csv", "--form", "ward", "--form", "phong", "--noise", "0.01", "--json"))
    for words in (("--from", "ggx_alpha=0.3"), ("--from", "glass_index=1.5"), ("m.json", "--to", "gloss"), ("m.json", "--to", "haze")):
        check("convert-parameters", said("convert-parameters", *words, "--json"))
    for words in (("--form", "ward", "--to", "materialx"), ("--form", "lambert", "--to", "gltf"), ("--form", "ward", "--to", "glsl"),
                  ("--form", "ward", "--to", "rgl", "--size", "200K"), ("--form", "ward", "--to", "merl"),
                  ("--form", "ward", "--to", "dfg", "--table-layout", "three"), ("--form", "cook_torrance", "--to", "albedo"), ("--form", "lambert", "--to", "ltc"),
                  ("--form", "ward_duer", "--to", "gltf")):
        check("export", said("export", *words, "-o", "exported", "--json"))
    check("prove", said("prove", "--form", "ward", "--form", "oren_nayar_full", "--seconds", "0.2", "-o", "c.json", "--json"))
    check("prove", said("prove", "--check", "c.json", "--json"))
    check("prove", said("prove", "m.json", "--seconds", "5", "--json"))
    check("trade", json.loads((source / "data/ledger.json").read_text()))
    ledger = source / "data/ledger.json"
    check("trade", said("trade", "--compare", ledger, ledger, "--json"))
    size = ("--width", 32, "--height", 32, "-o", "p.png", "--json")
    pictures = [said("render", "m.json", *size), said("render", "m.json", "--turntable", 2, "--width", 32, "--height", 32,
                                                      "-o", "p.webp", "--json"), said("render", "m.json", "--compare", "embree", "--probe", "16,16", *size)]
    for picture in pictures:
        if picture:
            check("render", picture)
    check("check-shader", said("check-shader", source / "data/shaders", "--seconds", 5, "--json"))
    if rows := said("parity", "--form", "lambert", "--json"):
        check("parity", rows)
    scene = json.loads((source / "data/scenes/recommend_close_up.json").read_text())
    scene["camera"] |= {"width": 32, "height": 32}
    (pathlib.Path(folder) / "scene.json").write_text(json.dumps(scene))
    recommended = said("recommend", "--scene", "scene.json", "--reference",
                       source / "data/materials/glossy_grey_paper.json", "--ledger", ledger, "--tolerance", "0.2", "--json")
    if recommended:
        check("recommend", recommended)
print("outputs follow their schemas")
