#!/usr/bin/env python3
# ctest: interop.options label=interop timeout=3600 needs=plain @brdf@ @source@ @here@/options
"""options_test.py BRDF SOURCE_DIR FOLDER: tests every target with every option and forty materials. Each call must end with
0, 1 (a loss above --max-loss), or 2 with one line that names the option or the target. The output of --json must follow its schema,
and a refused call must leave no file."""
import json
import pathlib
import re
import shlex
import subprocess
import sys

import jsonschema

brdf, source, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
OPTIONS = [[], ["--naive"], ["--max-loss", "0.01"], ["--include"], ["--kernels", "builtin"], ["--size", "200k"], ["--name", "some_thing"]]
# With refits this takes long, and the refits have tests of their own: every material is copied, a few are refitted.
REFITTED = 4


def run(*words):
    return subprocess.run([brdf, *map(str, words)], text=True, capture_output=True)


def targets():
    """Returns the targets that the program lists."""
    names = re.search(r"--to\s+TEXT:\{([^}]*)\}", run("export", "--help").stdout).group(1)
    return [name.strip() for name in names.replace("\n", " ").split(",")]


def materials():
    made = [["--material", path] for path in sorted((source / "data/materials").glob("*.json"))]
    forms = [m["form"] for m in json.loads(run("models", "--json").stdout)["forms"]]
    return made + [["--form", form] for form in forms] + [words.split() for words in ANISOTROPIC]


# The wider axis of an anisotropic lobe turns the frame, which isotropic targets do not hold.
ANISOTROPIC = ["--form cook_torrance_dielectric --set kd=0 --set ks=1 --set eta=1.5 --set alpha_x=0.01 --set alpha_y=0.3",
               "--form ward --set kd=0.2 --set ks=0.3 --set alpha_x=0.1 --set alpha_y=0.4 --set tangent_phi=30",
               "--form cook_torrance --set kd=0.2 --set ks=0.5 --set alpha_x=0.4 --set alpha_y=0.1"]


def check_commands(told):
    """Runs every command that the export prints."""
    for key in ("same_here", "by_channel_here"):
        commands = told.get(key, [])
        for command in [commands] if isinstance(commands, str) else commands:
            words = shlex.split(command)
            assert words[0] == "brdf", command
            made = subprocess.run([brdf, *words[1:], "-"], text=True, capture_output=True,
                                  input="theta_i,phi_i,theta_o,phi_o\n30,0,40,180\n")
            assert made.returncode == 0, (command, made.stderr)


def check(words, made, output, schema):
    said = made.stderr.strip().splitlines()
    assert made.returncode in (0, 1, 2), (words, made.returncode, made.stderr)
    if made.returncode == 2:
        assert said and said[-1].startswith("brdf: ") and not output.exists(), (words, said)
        if not made.stdout:
            return "refused"
    jsonschema.validate(json.loads(made.stdout), schema)
    told = json.loads(made.stdout)
    if made.returncode == 2:
        assert told["kind"] == "refused", (words, told)
        return "refused"
    assert output.stat().st_size > 0, words
    check_commands(told)
    if "loss" in told:
        loss = told["loss"]
        assert loss["largest_is"] == "at least" and loss["median"] <= loss["largest"] + 1e-12, (words, loss)
        assert (told["kind"] in ("exact", "no_difference")) <= (loss["largest"] < 1e-9), (words, loss)
        if told["kind"] == "refitted":
            for figure in ("rms", "median", "largest"):
                assert loss[figure] <= 1.001 * told["copied"][figure] + 1e-9, (words, figure, loss, told["copied"])
    if made.returncode == 1:
        assert "--max-loss" in words and "--max-loss" in made.stderr, words
    return told["kind"]


def main():
    folder.mkdir(parents=True, exist_ok=True)
    schema = json.loads((source / "docs/export.schema.json").read_text())
    counts = {}
    subjects = materials()
    assert len(subjects) >= 40, len(subjects)
    for target in targets():
        for k, material in enumerate(subjects):
            for options in OPTIONS if k < 3 else OPTIONS[:2]:
                dear = target == "merl" and k > 2
                if dear or (k >= REFITTED and not options):
                    continue
                output = folder / "made"
                output.unlink(missing_ok=True)
                words = ["export", *map(str, material), "--to", target, *options, "-o", output, "--json"]
                kind = check(words, run(*words), output, schema)
                counts[target, kind] = counts.get((target, kind), 0) + 1
    for (target, kind), count in sorted(counts.items()):
        print(f"{target:12} {kind:10} {count}")
    for target in targets():
        assert any(t == target and kind != "refused" for t, kind in counts), target


main()
