#!/usr/bin/env python3
"""shaders_test.py BRDF FOLDER: what is exported as HLSL, as GLSL ES 3.00 and for BRDF Explorer compiles, of every form and
target: HLSL by glslc, the others by glslangValidator (without SPIR-V)."""
import json
import pathlib
import re
import shutil
import subprocess
import sys

brdf, folder = sys.argv[1], pathlib.Path(sys.argv[2])


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
    sys.exit(failed > 0 or compiled < 60)


main()
