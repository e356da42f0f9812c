#!/usr/bin/env python3
# ctest: architecture.only_forms_know_their_names label=architecture @source@ @brdf@
"""Checks that only the forms' headers know forms and parameters by name.

    names.py ROOT BRDF

Outside the forms and parameter sets of libbrdf no source may contain the name of a form or a parameter as a string, use the name
of a form as an identifier, compare the name of a form or a parameter, or index a parameter table with a constant. The names come
from `BRDF models --json`. Exempt places are counted and printed; an unused exemption is a fault.
"""
import collections
import json
import os
import re
import subprocess
import sys

import rooms

FORMS = ("libbrdf/brdf/forms/", "libbrdf/brdf/targets/", "libbrdf/brdf/any_form.h", "libbrdf/brdf/parameter.h")
EXEMPT = {
    "trade/questions/": "the trade's questions",
    "bench/": "measured examples",
    "libbrdf/src/reflectance.cpp": "finding by name",
    "libbrdf/brdf/reflectance_of.h": "finding by name",
    "interop/write_": "other programs' parameters",
    "maps/textures/": "other programs' parameters",
    "interop/width_parameters.cpp": "whose widths are converted",
    "interop/gloss_numbers.cpp": "whose widths are converted",
    "io/columns/units.cpp": "names of letters",
    "io/material/familiar_names.cpp": "other programs' names for ours",
    "shader/front/roles.cpp": "what arguments of shaders are called",
    "shader/entry.cpp": "names of shaders' functions",
    "shader/companions.cpp": "names of shaders' functions",
    "shader/joint.cpp": "names of shaders' arguments",
    "shader/binding.cpp": "names of shaders' arguments",
    "shader/results.cpp": "names of shaders' results",
}
# Words that are also the name of a parameter or a form, and have another meaning in these places.
HOMONYMS = {
    ("io/formats/rgl.cpp", "sigma"): "a field of RGL's files",
    ("io/formats/rgl_writer.cpp", "sigma"): "a field of RGL's files",
    ("fit/model/options.h", "sigma"): "a weighting",
    ("cli/verbs/albedo.cpp", "albedo"): "the verb",
    ("cli/program/written_table.h", "albedo"): "the integral",
    ("browser/session.cpp", "albedo"): "the integral",
    ("interop/lookup_table.cpp", "albedo"): "the integral",
    ("interop/lookup_table.cpp", "roughness"): "an axis",
    ("interop/lookup_table.cpp", "alpha"): "an axis",
    ("interop/cosine_transform.cpp", "roughness"): "an axis",
    ("io/columns/value_names.cpp", "sigma"): "standard deviations",
    ("io/columns/layout.h", "sigma"): "standard deviations",
    ("io/columns/scale_comments.cpp", "sigma"): "standard deviations",
    ("io/columns/quantity_words.cpp", "rho"): "a letter",
    ("io/columns/quantity_words.cpp", "n"): "a letter",
    ("python/samples.cpp", "sigma"): "standard deviations",
    ("python/materials.cpp", "albedo"): "the method",
    ("validate/", "albedo"): "a check",
    ("render/", "albedo"): "a texture map",
    ("render/", "roughness"): "a texture map",
    ("render/", "metallic"): "a texture map",
    ("cli/steps/stack_scene.cpp", "albedo"): "a texture map",
    ("cli/steps/stack_scene.cpp", "roughness"): "a texture map",
    ("render/scene/scene.h", "phong"): "a shading",
    ("micro/theory_reflectance.cpp", "retro"): "a direction",
    ("io/columns/angle_names.cpp", "gamma"): "a column of a table",
    ("io/columns/metadata_names.cpp", "n"): "a column of a table",
    ("io/columns/angle_names.cpp", "alpha"): "a column of a table",
    ("io/formats/optical_constants.cpp", "n"): "a column of a table",
    ("io/formats/optical_constants.cpp", "k"): "a column of a table",
    ("shader/glsl.cpp", "n"): "a letter",
    ("render/viewer/commands.cpp", "n"): "a key",
    ("render/viewer/commands.cpp", "k"): "a key",
    ("micro/", "lambert"): "a facet's reflection",
    ("micro/", "oren_nayar"): "the angles of grooves",
}


def names_of(brdf):
    models = json.loads(subprocess.run([brdf, "models", "--json"], check=True, capture_output=True, text=True).stdout)
    forms = models["forms"]
    parameters = {p["name"] for f in forms for p in f["parameters"]}
    parameters |= {name[:-2] for name in parameters if name.endswith("_x") and name[:-1] + "y" in parameters}
    return {f["form"] for f in forms}, parameters


TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\((?:.*?)\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\])\'', re.S)
INDEXED = re.compile(r"(?:\binfo(?:\([^()]*\))?|\btable)(?:\.|->)(?:shape|weights)\[\d+\]|\b(?:shape|weights)\[\d+\]\[\d+\]")
WHOSE = r"(?:\binfo(?:\([^()]*\))?|\b(?:form|parameter|table|p|f)|\(\))(?:\.|->)"
COMPARED = re.compile(rf"{WHOSE}name\s*[!=]=|[!=]=\s*{WHOSE}name\b|\bfamily\s*[!=]=|[!=]=\s*(?:\w+\.)?family\b")


def split(text):
    """Returns the code without comments and strings (same lines), and the strings with their line."""
    strings = []

    def replace(match):
        token = match.group(0)
        line = text.count("\n", 0, match.start()) + 1
        if token.startswith(('"', "R")):
            strings.append((line, token.strip('R"')))
        return re.sub(r"[^\n]", " ", token) if not token.startswith("'") else "' '"

    return TOKEN.sub(replace, text), strings


def is_example(string):
    """Returns whether the string is a command for people: a part of a help text, or a sentence with a command to type."""
    return re.search(r"\bbrdf \w|--\w", string) is not None


def faults_of(text, forms, parameters):
    code, strings = split(text)
    for line, string in strings:
        if string in forms or string in parameters:
            yield line, string, f'names "{string}"'
    for match in re.finditer(r"\b[a-z]\w*\b", code):
        if match.group(0) in forms and not code[:match.start()].rstrip().endswith(("include", ".", "->")):
            yield code.count("\n", 0, match.start()) + 1, match.group(0), f"uses the form {match.group(0)}"
    for pattern, what in ((COMPARED, "compares a name"), (INDEXED, "indexes a table with a constant")):
        for match in pattern.finditer(code):
            yield code.count("\n", 0, match.start()) + 1, "", f"{what}: {' '.join(match.group(0).split())}"


def main():
    root, brdf = sys.argv[1], sys.argv[2]
    known = [room.name for room in rooms.read(root)]
    forms, parameters = names_of(brdf)
    exempt, faults, used = collections.Counter(), [], set()
    checked = 0
    for folder, folders, files in os.walk(root):
        folders[:] = [f for f in folders if not f.startswith(".") and (folder != root or f in known)]
        for name in files:
            path = os.path.relpath(os.path.join(folder, name), root)
            if not name.endswith((".h", ".cpp")) or path.startswith(FORMS) or path.split("/")[0] not in known:
                continue
            checked += 1
            text = open(os.path.join(root, path), encoding="utf-8").read()
            exempt["examples in texts"] += sum(is_example(s) for _, s in split(text)[1])
            for line, word, what in faults_of(text, forms, parameters):
                place = next((p for p in EXEMPT if path.startswith(p)), None)
                own = next(((p, w) for p, w in HOMONYMS if path.startswith(p) and w == word), None)
                if place or own:
                    exempt[EXEMPT[place] if place else HOMONYMS[own]] += 1
                    used.add(place or own)
                else:
                    faults.append(f"{path}:{line}: {what}")
    faults += [f"{key}: exempt, but nothing there needs it" for key in [*EXEMPT, *HOMONYMS] if key not in used]
    print("\n".join(faults) or "only the forms know their names")
    print(f"{checked} files; {len(forms)} forms, {len(parameters)} parameters; exempt: "
          + ", ".join(f"{count} {why}" for why, count in sorted(exempt.items())))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
