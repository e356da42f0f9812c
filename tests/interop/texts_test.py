#!/usr/bin/env python3
# ctest: exports.texts label=exports,interop needs=plain @brdf@ @here@/texts
"""texts_test.py BRDF FOLDER: tests that exported text has its stated values wherever it is compiled. Each test is a function with a
sentence as its name."""
import itertools
import json
import math
import os
import pathlib
import re
import shlex
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

from compilers import WARNINGS, Exporter, cpp_compilers, need, run, user_of, wrong_with
from measured import draw_pairs, evaluated, write_directions

brdf, folder = (pathlib.Path(word).resolve() for word in sys.argv[1:3])

# Flags that rearrange arithmetic, and flags that must not.
FLAGS = ["-O2", "-O3", "-O2 -ffast-math", "-Ofast", "-O2 -funsafe-math-optimizations",
         "-O2 -fassociative-math -fno-signed-zeros -fno-trapping-math", "-O2 -ffp-contract=fast -march=native",
         "-O2 -freciprocal-math", "-O3 -march=native -funsafe-math-optimizations", "-O2 -ffinite-math-only"]
UNSAFE = ("-O2 -ffast-math", "-Ofast")  # both compilers have a macro for these
MATERIALS = {"ward": "--form ward --set kd=0.15 --set ks=0.4 --set alpha_x=0.08 --set alpha_y=0.12",
             "cook_torrance_student": "--form cook_torrance_student --set kd=0.1 --set ks=0.5 --set alpha=0.2",
             "phong": "--form phong --set kd=0.1 --set ks=0.5 --set exponent=60"}
PAIRS = 40
CALL = "brdf_material(vec3(0.0, 0.6, 0.8), vec3(0.6, 0.0, 0.8))"
PROGRAM = """#include <cstdio>
#include "NAME.hpp"
int main() {
  const float pairs[][6] = {ROWS};
  for (const float* p : pairs) {
    const NAME::vec3 f = NAME::brdf_material({p[0], p[1], p[2]}, {p[3], p[4], p[5]});
    std::printf("%.9g\\n", double(f.x));
  }
}
"""


def direction(theta, phi):
    t, p = math.radians(theta), math.radians(phi)
    return math.sin(t) * math.cos(p), math.sin(t) * math.sin(p), math.cos(t)


def near_the_mirror(count):
    """Pairs at which a lobe is seen: the viewer some degrees off the mirror direction."""
    return [[a, b, min(a + (c - 40) / 8, 80), b + 180 + (d - 180) / 30] for a, b, c, d in draw_pairs()[:count]]


def cpp_has_the_right_value_or_does_not_compile_under_unsafe_flags(e):
    """Covers -ffast-math and its parts, which silently turned (x + 12582912) - 12582912 into x."""
    pairs = near_the_mirror(PAIRS)
    directions = write_directions(e.folder / "pairs.csv", pairs)
    rows = ", ".join("{" + ", ".join(f"{x:.9g}f" for x in direction(*p[:2]) + direction(*p[2:])) + "}" for p in pairs)
    refused = set()
    every = itertools.product(MATERIALS.items(), ("own", "builtin"))
    for (name, words), kernels in every if "BRDF_THOROUGH" in os.environ else [(next(iter(MATERIALS.items())), "own")]:
        e.write(f"{name}.hpp", e.text(*shlex.split(words), "--to", "cpp", "--kernels", kernels))
        source = e.write("user.cc", PROGRAM.replace("ROWS", rows).replace("NAME", name))
        expected = [row[0] for row in evaluated(brdf, words, directions)]
        for compiler, flags in itertools.product(cpp_compilers(), FLAGS):
            program = e.folder / "user"
            made = run(compiler, "-std=c++17", *WARNINGS, *flags.split(), source, "-o", program)
            if made.returncode:
                assert "brdf: the values are wrong with" in made.stderr, made.stderr
                refused.add((compiler, flags))
                continue
            seen = [float(x) for x in run(program).stdout.split()]
            worst = max(abs(a / b - 1) for a, b in zip(seen, expected))
            assert len(seen) == PAIRS and worst < 1e-4, (name, kernels, compiler, flags, worst)
    for compiler in cpp_compilers():
        assert {flags for c, flags in refused if c == compiler} >= set(UNSAFE)
        assert (compiler, "-O2") not in refused and (compiler, "-O3") not in refused


def cpp_has_the_same_bits_of_every_compiler(e):
    """Requires the same bits of every compiler that does not fuse products and sums."""
    rows = ", ".join("{" + ", ".join(f"{x:.9g}f" for x in direction(*p[:2]) + direction(*p[2:])) + "}" for p in near_the_mirror(PAIRS))
    for name, words in MATERIALS.items():
        e.write(f"{name}.hpp", e.text(*shlex.split(words), "--to", "cpp"))
        source = e.write("user.cc", PROGRAM.replace("ROWS", rows).replace("NAME", name))
        printed = set()
        for compiler, level in itertools.product(cpp_compilers(), ("-O0", "-O3")):
            assert run(compiler, "-std=c++17", level, "-ffp-contract=off", source, "-o", e.folder / "user").returncode == 0
            printed.add(run(e.folder / "user").stdout)
        assert len(printed) == 1, (name, len(printed))


def material(e, name, rho, said_name=None):
    e.write(f"{name}.json", json.dumps({"format": "brdf-material", "version": 1, **({"name": said_name} if said_name else {}),
                                        "form": "lambert", "channels": ["r", "g", "b"], "weights": {"rho": [rho, 0.5, 0.4]},
                                        "shape": {}}))
    return ["--material", f"{name}.json"]


INCLUDED = (("glsl", ["--include"]), ("glsl-es", ["--include"]), ("hlsl", []), ("cpp", []))


def together(e, to, *texts, call=None):
    if to == "cpp":
        for k, text in enumerate(texts):
            e.write(f"part{k}.hpp", text)
        return wrong_with("cpp", "#pragma once\n" + "".join(f'#include "part{k}.hpp"\n' for k in range(len(texts))) + (call or ""), e)
    wrong = wrong_with(to, user_of(to, "".join(texts), **({"call": call} if call else {})), e)
    return wrong.replace("-- ", "--")  # as glslang shows an option in an #error


def two_forms_stand_in_one_shader(e):
    for (to, words), kernels in itertools.product(INCLUDED, ("own", "builtin")):
        texts = [e.text("--form", form, "--to", to, *words, "--kernels", kernels) for form in ("phong", "ward_duer", "phong")]
        wrong = together(e, to, *texts)
        assert not wrong, (to, kernels, wrong)


def two_materials_stand_in_one_shader_by_their_names(e):
    """Names of the files and of the material itself; the same text twice is one."""
    first, second = material(e, "slate", 0.15), material(e, "other", 0.35, "red brick")
    for to, words in INCLUDED:
        texts = [e.text(*m, "--to", to, *words) for m in (first, second, first)]
        calls = ("slate::brdf_material", "red_brick::brdf_material") if to == "cpp" else ("brdf_material_slate", "brdf_material_red_brick")
        if to == "cpp":
            call = "inline slate::vec3 both(slate::vec3 w) { slate::vec3 f = %s(w, w); f += %s(w, w); return f; }\n" % calls
        else:
            call = " + ".join(f"{c}(vec3(0.0, 0.6, 0.8), vec3(0.6, 0.0, 0.8))" for c in calls)
        assert not together(e, to, *texts, call=call), (to, together(e, to, *texts, call=call))


def one_material_is_brdf_material_and_two_are_not(e):
    first, second = material(e, "slate", 0.15), material(e, "brick", 0.35)
    for to, words in INCLUDED[:3]:
        one, two = (e.text(*m, "--to", to, *words) for m in (first, second))
        assert not together(e, to, one, one, call=CALL)
        assert "brdf_material" in together(e, to, one, two, call=CALL), "which of the two?"


def two_materials_of_one_name_are_told_the_way_out(e):
    words_of = [["--form", "ward", "--set", f"ks={ks}"] for ks in (0.2, 0.7)]
    for to, words in INCLUDED:
        one, two = (e.text(*m, "--to", to, *words) for m in words_of)
        assert "export one of them with --name" in together(e, to, one, two)
        named = e.text(*words_of[1], "--to", to, *words, "--name", "bright ward")
        assert not together(e, to, one, named), together(e, to, one, named)


def different_kernels_in_one_shader_are_told(e):
    """Requires a message for GLSL, which cannot have two functions of one name. C++ can, in their namespaces."""
    for to, words in INCLUDED:
        own, builtin = (e.text("--form", form, "--to", to, *words, "--kernels", kernels)
                        for form, kernels in (("ward", "own"), ("phong", "builtin")))
        wrong = together(e, to, own, builtin)
        # Preprocessors print the words of the message with or without spaces between them.
        told = "withthesameversionofbrdf,--toand--kernels" in re.sub(r"\s", "", wrong)
        assert not wrong if to == "cpp" else told, (to, wrong)


NAMES = ["float", "class", "double", "using", "main", "xor", "and", "uint", "vec3", "std", "co_await", "log", "sinf", "gamma",
         "linux", "NAN", "M_PI", "INT_MAX", "size_t", "__gold", "_Gold", "9 carat", "a--b", "in", "out", "half", "sample",
         "texture", "matrix", "précieux", "?", "-"]


def no_name_breaks_the_text(e):
    """C++ has all names in one source, because its compilers take long."""
    headers = []
    for name in NAMES:
        said_name = material(e, "named", 0.3, name)
        for to, words in INCLUDED:
            text = e.text(*said_name, "--to", to, *words)
            if to == "cpp":
                headers.append(text)
            else:
                wrong = together(e, to, text, call=CALL)
                assert not wrong, (name, to, wrong)
    wrong = together(e, "cpp", *headers)
    assert not wrong, wrong


def osl_has_no_reserved_name(e):
    """Requires that names from the specification's list of reserved words are changed, and that other names are kept."""
    for name in ["float", "color", "emit", "surface", "class", "and", "Ci", "P", "ward", "normalize"]:
        assert f"surface material_{name}()" in e.text(*material(e, "named", 0.3, name), "--to", "osl"), name
    assert "surface gold()" in e.text(*material(e, "named", 0.3, "gold"), "--to", "osl")


def mitsuba_has_no_id_of_its_own(e):
    """Identifiers that begin with _ are Mitsuba's."""
    assert 'id="material_gold"' in e.text(*material(e, "named", 0.3, "_gold"), "--to", "mitsuba")


def commands_in_xml_can_be_pasted(e):
    """Includes a name that contains the end of the instruction."""
    odd = e.folder / "a?>--b.json"
    odd.write_text((e.folder / material(e, "plain", 0.2)[1]).read_text())
    directions = write_directions(e.folder / "pairs.csv", draw_pairs()[:5])
    for program, words in itertools.product(("materialx", "mitsuba"), (["--material", odd.name], ["--form", "lambert"])):
        path = e.folder / "m.xml"
        e.text(*words, "--to", program, "-o", path)
        text = path.read_text()
        root = ElementTree.fromstring(text)
        assert root.tag == dict(materialx="materialx", mitsuba="scene")[program]
        same = re.search(r"the same values in brdf: brdf (.*)", text)[1]
        written = re.search(r"Written by brdf \S+: brdf (.*)", text)[1]
        assert run("bash", "-c", f"'{brdf}' {same} '{directions}'", cwd=e.folder).returncode == 0, same
        again = run("bash", "-c", f"'{brdf}' {written}", cwd=e.folder)
        assert again.returncode == 0, (written, again.stderr)


def main():
    need("glslc", "glslangValidator", "g++")
    exporter = Exporter(brdf, folder)
    tests = [cpp_has_the_right_value_or_does_not_compile_under_unsafe_flags, cpp_has_the_same_bits_of_every_compiler,
             two_forms_stand_in_one_shader, two_materials_stand_in_one_shader_by_their_names,
             one_material_is_brdf_material_and_two_are_not, two_materials_of_one_name_are_told_the_way_out,
             different_kernels_in_one_shader_are_told, no_name_breaks_the_text, osl_has_no_reserved_name,
             mitsuba_has_no_id_of_its_own, commands_in_xml_can_be_pasted]
    failed = 0
    for test in tests:
        try:
            test(exporter)
            print(f"{test.__name__}: ok")
        except (AssertionError, subprocess.SubprocessError, TypeError) as error:
            failed += 1
            print(f"{test.__name__}: FAILED\n{str(error)[:1500]}")
    sys.exit(failed > 0)


main()
