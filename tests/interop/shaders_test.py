#!/usr/bin/env python3
# ctest: interop.shaders label=interop timeout=3600 needs=plain @brdf@ @here@/shaders
# ctest: exports.few_shaders label=exports needs=plain @brdf@ @here@/few_shaders --few
"""shaders_test.py BRDF FOLDER [--few]: every form and target, and a shader, compile in every language, with both kinds of kernels, whole and
to be included, as a form and as a material: GLSL by glslc, glslangValidator and spirv-cross, GLSL ES 3.00 and BRDF Explorer's by
glslangValidator, HLSL by glslc and glslangValidator, C++ by g++ and clang++ with warnings as errors. Every form's HLSL, run on the
Vulkan device, has the library's float values: not a bit differs on a software driver. No name that C++ has for itself gets into
a text. --few: of three forms, with the compilers that are here, and nothing is run."""
import itertools
import json
import pathlib
import re
import sys

from compilers import LANGUAGES, Exporter, cpp_compilers, need, of_explorer, run, user_of, wrong_with

brdf, folder = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
few = "--few" in sys.argv[3:]
NO_DRIVER = 3
FEW = ("lambert", "ward", "cook_torrance_beckmann")


def differing_on_device(exporter, form):
    """Returns how many of a million values of the form's HLSL on the device differ from the library; None without a device."""
    path = exporter.write(f"{form}.device.hlsl", exporter.text("--form", form, "--to", "hlsl"))
    proof = run(brdf, "validate", "--shader", path, "--gpu", "--json")
    if proof.returncode == NO_DRIVER:
        return None
    row = json.loads(proof.stdout)["rows"][0]
    assert row["count"] > 1000000, row
    return row["differing" if json.loads(proof.stdout)["software"] else "beyond_tolerance"]


def prove(exporter, forms):
    """Returns the number of forms with HLSL that differs from the library in any bit."""
    differing = {form: differing_on_device(exporter, form) for form in forms}
    if None in differing.values():
        print("no Vulkan driver: HLSL was not run")
        return 0
    wrong = {form: count for form, count in differing.items() if count}
    print(f"{len(forms)} forms in HLSL on the device, {len(wrong)} differ {wrong or ''}")
    return len(wrong)


def shader(exporter, to, include, as_material, words):
    """Returns the whole shader or source of an export."""
    text = exporter.text("--to", to, *words, *(["--include"] if include else []))
    if to == "explorer":
        return of_explorer(text)
    call = {"call": "brdf_material(vec3(0.0, 0.6, 0.8), vec3(0.6, 0.0, 0.8))"} if as_material else {}
    return text if to == "glsl-es" and not include or to == "glsl" and not include else user_of(to, text, **call)


def subjects(models):
    """Returns the options of every subject, with a setting that makes a material of it. The last is a shader whose operations and
    parameters the languages spell differently."""
    for model in models:
        weight = next(iter(model["parameters"]))
        yield ["--form", model["form"]], f"{weight['name']}={weight['default']}"
    yield ["--shader", pathlib.Path(__file__).resolve().parent / "languages" / "kinds.glsl"], "rough=0.5"


def compile_all(exporter, models):
    """Compiles the exports of every language with all kernels, with --include, and of forms and materials. Returns the number of texts,
    and the number of texts that do not compile."""
    compiled = failed = 0
    for subject, setting in subjects(models):
        for to, kernels, as_material in itertools.product(LANGUAGES, ("own", "builtin"), (False, True)):
            for include in ((False, True) if to.startswith("glsl") else (False,)):
                words = [*subject, "--kernels", kernels, *(["--set", setting] if as_material else [])]
                wrong = wrong_with(to, shader(exporter, to, include, as_material, words), exporter)
                compiled += 1
                if wrong:
                    failed += 1
                    print(f"{' '.join(map(str, words))} --to {to}{' --include' if include else ''}: {wrong}")
    return compiled, failed


HEADERS = "#include <cmath>\n#include <cstdint>\n#include <cstring>\n"


def names_taken():
    """Returns the words of C++ and of the included headers that the compilers refuse as the name of a namespace."""
    taken = set()
    for compiler in cpp_compilers():
        for standard in ("c++17", "gnu++20"):
            text = run(compiler, f"-std={standard}", "-E", "-P", "-x", "c++", "-", input=HEADERS).stdout
            macros = run(compiler, f"-std={standard}", "-dM", "-E", "-x", "c++", "-", input=HEADERS).stdout
            words = sorted({w for w in re.findall(r"\w+", text + macros) if re.fullmatch(r"[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*", w)})
            limit = "-fmax-errors=0" if "g++" == compiler else "-ferror-limit=0"
            while True:
                # Each line has one word, so that the line of an error identifies the word. Such words are removed until no error remains.
                source = HEADERS + "".join(f"namespace {w} {{ struct own {{ int a; }}; }}\n" for w in words)
                checked = run(compiler, f"-std={standard}", limit, "-w", "-fsyntax-only", "-x", "c++", "-", input=source)
                lines = {int(n) - 4 for n in re.findall(r"^<stdin>:(\d+):\d+: error", checked.stderr, re.M)}
                hit = {words[n] for n in lines if 0 <= n < len(words)}
                if not hit:
                    assert checked.returncode == 0, checked.stderr
                    break
                taken |= hit
                words = [w for w in words if w not in hit]
    return sorted(taken)


def is_taken(word):
    """Compiles the word alone, because a compiler may report the error of one word at the line of another."""
    source = HEADERS + f"namespace {word} {{ struct own {{ int a; }}; }}\n"
    return any(run(c, f"-std={s}", "-w", "-fsyntax-only", "-x", "c++", "-", input=source).returncode
               for c in cpp_compilers() for s in ("c++17", "gnu++20"))


def names_are_free(exporter):
    """Requires that a material with such a name gets another namespace."""
    taken = names_taken()
    wrong = [word for word in taken
             if f"namespace material_{word} {{" not in exporter.text("--form", "lambert", "--to", "cpp", "--name", word)]
    wrong = [word for word in wrong if is_taken(word)]
    print(f"{len(taken)} names that C++ has, {len(wrong)} are written {wrong or ''}")
    assert len(taken) > 800
    return len(wrong)


def main():
    need("glslc", "glslangValidator", "g++", *([] if few else ["spirv-cross"]))
    exporter = Exporter(brdf, folder)
    catalogue = json.loads(run(brdf, "models", "--json").stdout)
    models = [m for m in catalogue["forms"] + catalogue["targets"] if not few or m["form"] in FEW]
    compiled, failed = compile_all(exporter, models)
    print(f"{compiled} texts by {', '.join(['glslc', *cpp_compilers()])} and what else is here, {failed} do not compile")
    assert compiled == 28 * (len(models) + 1) and len(models) >= (3 if few else 30)
    if not few:
        failed += names_are_free(exporter)
        failed += prove(exporter, [m["form"] for m in catalogue["forms"]])
    sys.exit(failed > 0)


main()
