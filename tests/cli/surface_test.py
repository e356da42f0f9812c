#!/usr/bin/env python3
# ctest: cli.surface label=cli @brdf@ @source@
"""surface_test.py BRDF SOURCE: tests that every verb and option is documented in each place: in a group and an example of --help,
in the man page, in the completion of both shells with its permitted values, in a schema if the verb has --json, and with a name
in Python (python/brdf/names.json, if the module is built). The test fails for each missing place."""
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

brdf, source = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
missing = []


def run(*words, **options):
    return subprocess.run([str(w) for w in words], text=True, capture_output=True, check=True, **options).stdout


def expect(holds, what):
    if not holds:
        missing.append(what)


verbs = json.loads(run(brdf, "describe", "json"))["verbs"]
# `brdf --help` lists the same verbs as `brdf describe`.
listed = re.findall(r"^  (\w[\w-]*) +\S", run(brdf, "--help").split("\nBegin here:")[1], re.M)
assert sorted(listed) == sorted(v["name"] for v in verbs), (listed, [v["name"] for v in verbs])

# An option that verbs share, in words too, has its example with any of them.
sharers = {}
for v in verbs:
    for o in v["options"]:
        sharers.setdefault((tuple(o["names"]), o["description"]), []).append(v["name"])
commands = {v["name"]: " ".join(re.findall(rf"brdf {v['name']} (.*)", v["footer"])) for v in verbs}

with tempfile.TemporaryDirectory() as folder:
    run(brdf, "describe", "man", "-o", folder)
    pages = {p.name: p.read_text().replace("\\-", "-") for p in pathlib.Path(folder).iterdir()}
    scripts = {shell: pathlib.Path(folder) / f"{shell}.complete" for shell in ("bash", "zsh", "fish")}
    for shell, path in scripts.items():
        path.write_text(run(brdf, "describe", shell))
        if shutil.which(shell):
            run(shell, "-n", path)  # it parses

    def complete(*words):
        """Returns the words that bash offers after these words."""
        script = (f"source {scripts['bash']}; COMP_WORDS=({' '.join(repr(w) for w in words)}); "
                  f"COMP_CWORD={len(words) - 1}; _brdf; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
        return run("bash", "--norc", "-c", script, cwd=folder).split()

    assert complete("brdf", "fit", "--fo") == ["--form"]
    assert complete("brdf", "val") == ["validate"]
    listed = json.loads(run(brdf, "models", "--json"))
    listed = listed["forms"] + listed["targets"]
    forms = [f["form"] for f in listed]
    expect(set(complete("brdf", "eval", "--form", "")) == set(forms), "completion of forms")
    expect({"all", "auto", *forms} <= set(complete("brdf", "fit", "s.csv", "--form", "")), "completion of models of a fit")
    parameters = {p["name"] + "=" for f in listed for p in f["parameters"]}
    expect(set(complete("brdf", "synth", "--set", "")) == parameters, "completion of parameters")
    for file in ("samples.csv", "material.json", "notes.pdf", "sky.hdr"):
        (pathlib.Path(folder) / file).touch()
    assert complete("brdf", "fit", "") == ["samples.csv"]
    assert complete("brdf", "eval", "--material", "") == ["material.json"]
    expect({"adaptive", "pole"} <= set(complete("brdf", "albedo", "--rule", "")), "completion of an option's words")
    if any(o["names"] == ["--environment"] for v in verbs for o in v["options"]):
        expect({"studio", "sky.hdr"} == set(complete("brdf", "render", "--environment", "s")) - {"sky"},
               "completion of words and files")

    zsh, fish = scripts["zsh"].read_text(), scripts["fish"].read_text()
    if shutil.which("fish"):
        def offered_by_fish(line):
            said = run("fish", "--no-config", "-c", f"source {scripts['fish']}; complete -C {shlex.quote(line)}", cwd=folder)
            return [row.split("\t")[0] for row in said.splitlines()]

        expect(offered_by_fish("brdf val") == ["validate"], "fish: verbs")
        expect(offered_by_fish("brdf fit --fo") == ["--form"], "fish: options")
        expect(set(offered_by_fish("brdf eval --form ")) == set(forms), "fish: forms")
        expect("samples.csv" in offered_by_fish("brdf fit sam"), "fish: files")
    expect(f"brdf-{verbs[0]['name']} (1)" in pages["brdf.1"], "brdf.1")
    for verb in verbs:
        name = verb["name"]
        help_text = run(brdf, name, "--help")
        expect("\nOptions:\n" not in help_text, f"{name}: options without a group in --help")
        expect(re.search(rf"Examples?:.*brdf {name}", verb["footer"], re.S), f"{name}: example in --help")
        page = pages.get(f"brdf-{name}.1", "")
        expect(page, f"{name}: man page")
        part = re.search(rf"^  {name}\)\n(.*?);;$", zsh, re.S | re.M)
        expect(part, f"{name}: zsh completion")
        offered = complete("brdf", name, "-")
        for option in verb["options"]:
            first = option["names"][-1]
            what = f"{name} {first}"
            expect(all(n in help_text for n in option["names"]), f"{what}: --help")
            expect(all(n in page for n in option["names"]), f"{what}: man page")
            expect(option["description"] or first in ("-h", "--help"), f"{what}: description")
            expect(option["takes"] != "unnamed", f"{what}: what it takes (cli/surface/option_table.cpp)")
            if option["positional"]:
                continue
            under = re.search(rf"^{re.escape(option['group'])}:\n((?: .*\n)+)", help_text, re.M)
            expect(under and re.search(rf"(?<![\w-]){first}(?![\w-])", under[1]), f"{what}: under its heading in --help")
            expect(f"\n.SS {option['group']}\n" in page, f"{what}: heading in the man page")
            for n in option["names"]:
                expect(n in offered, f"{what}: bash completion")
                expect(part and n in part[1], f"{what}: zsh completion")
                kind = "-l" if n.startswith("--") else "-s"
                expect(re.search(rf"__fish_seen_subcommand_from {name}'.* {kind} {n.lstrip('-')}(?![\w-])", fish), f"{what}: fish")
            # An older spelling of a positional argument needs no example.
            if first != "--help" and not re.fullmatch("[Tt]he same as [A-Z]+", option["description"]):
                shared = sharers[tuple(option["names"]), option["description"]]
                used = " ".join(commands[verb_of] for verb_of in shared)
                expect(any(re.search(rf"(?<![\w-]){n}(?![\w-])", used) for n in option["names"]), f"{what}: example")
        if any("--json" in o["names"] for o in verb["options"]):
            expect((source / f"docs/schemas/{name}.schema.json").is_file()
                   or (source / f"docs/{name}.schema.json").is_file(), f"{name} --json: schema")

    # If the module is built: the Python name of each verb and option, or a mark that the verb takes all options by their names.
    table = source / "python/brdf/names.json"
    if table.is_file():
        names = json.loads(table.read_text())["verbs"]
        for verb in verbs:
            known = names.get(verb["name"], {})
            expect(known.get("python"), f"{verb['name']}: Python name")
            for option in verb["options"]:
                name = option["names"][-1]
                if name != "--help" and known.get("options") != "keywords":
                    expect(known.get("options", {}).get(name), f"{verb['name']} {name}: Python name")

if missing:
    sys.exit("\n".join([f"{len(missing)} missing:", *missing]))
