#!/usr/bin/env python3
"""shaders_test.py BRDF FOLDER: what is exported as HLSL, as GLSL ES 3.00 and for BRDF Explorer compiles, of every form and
target: HLSL by glslc, the others by glslangValidator (without SPIR-V). Every form's HLSL, run on the Vulkan device, has the
library's float values: not a bit differs on a software driver."""
import json
import pathlib
import re
import shutil
import subprocess
import sys

brdf, folder = sys.argv[1], pathlib.Path(sys.argv[2])
NO_DRIVER = 3


def run(*words):
    return subprocess.run([str(w) for w in words], text=True, capture_output=True)


def of_explorer(text):
    """The fragment shader that the Explorer makes of the file: sliders as uniforms, version 410."""
    assert text.startswith("analytic\n")
    sliders, shader = re.fullmatch(
        r"analytic\n::begin parameters\n(.*)::end parameters\n::begin shader\n(.*)::end shader\n", text, re.S).groups()
    uniforms = ""
    for line in sliders.splitlines():
        kind, name, *numbers = line.split()
        assert len(numbers) == 3 and all(map(lambda x: float(x) >= 0, numbers)), line
        uniforms += f"uniform {dict(float='float', color='vec3')[kind]} {name};\n"
    return f"#version 410\n{uniforms}{shader}out vec3 colour;\nvoid main() {{ colour = BRDF(vec3(0, 0, 1), vec3(0, 0, 1), " \
           "vec3(0, 0, 1), vec3(1, 0, 0), vec3(0, 1, 0)); }\n"


def differing_on_device(form):
    """Values of a million that differ from the library's, of the form's HLSL on the device; None without a device."""
    path = folder / f"{form}.hlsl"
    run(brdf, "export", "--form", form, "--to", "hlsl", "-o", path)
    proof = run(brdf, "validate", "--shader", path, "--gpu", "--json")
    if proof.returncode == NO_DRIVER:
        return None
    row = json.loads(proof.stdout)["rows"][0]
    assert row["count"] > 1000000, row
    return row["differing" if json.loads(proof.stdout)["software"] else "beyond_tolerance"]


def prove(forms):
    """How many forms' HLSL is not the library, bit for bit."""
    differing = {form: differing_on_device(form) for form in forms}
    if None in differing.values():
        print("no Vulkan driver: HLSL was not run")
        return 0
    wrong = {form: count for form, count in differing.items() if count}
    print(f"{len(forms)} forms in HLSL on the device, {len(wrong)} differ {wrong or ''}")
    return len(wrong)


def main():
    for tool in ("glslc", "glslangValidator"):
        if not shutil.which(tool):
            sys.exit(f"no {tool}: tools/setup interop installs it")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    models = json.loads(run(brdf, "models", "--json").stdout)
    failed = compiled = 0
    for form in [m["form"] for m in models["forms"] + models["targets"]]:
        weight = next(p for m in models["forms"] + models["targets"] if m["form"] == form for p in m["parameters"])
        for to, suffix in (("hlsl", "hlsl"), ("glsl-es", "frag"), ("explorer", "frag")):
            words = [] if to == "explorer" else ["--set", f"{weight['name']}={weight['default']}"]
            made = run(brdf, "export", "--form", form, *words, "--to", to)
            text = made.stdout
            if to == "hlsl":
                text += "[numthreads(1, 1, 1)] void main() {}\n"
            elif to == "explorer":
                text = of_explorer(text)
            path = folder / f"{form}.{to}.{suffix}"
            path.write_text(text)
            check = (run("glslc", "-x", "hlsl", "-fshader-stage=compute", "-fentry-point=main", path, "-o", folder / "spv")
                     if to == "hlsl" else run("glslangValidator", path))
            compiled += 1
            if made.returncode or check.returncode:
                failed += 1
                print(f"{form} to {to}: {made.stderr}{check.stdout}{check.stderr}")
    print(f"{compiled} shaders, {failed} do not compile")
    failed += prove([m["form"] for m in models["forms"]])
    sys.exit(failed > 0 or compiled < 60)


main()
