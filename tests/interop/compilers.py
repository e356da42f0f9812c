"""The compilers of exported texts. Each function takes a text and returns the errors of the compiler; "" if there are no errors."""
import pathlib
import re
import shutil
import subprocess
import sys

# The flags that users compile with.
WARNINGS = ["-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Wsign-conversion", "-Wdouble-promotion", "-pedantic", "-Werror"]
LANGUAGES = ("glsl", "glsl-es", "hlsl", "cpp", "explorer")


def run(*words, **options):
    return subprocess.run([str(w) for w in words], text=True, capture_output=True, **options)


def found(*names):
    return [name for name in names if shutil.which(name)]


def cpp_compilers():
    """Returns g++ and clang in every installed version."""
    return found("g++", "clang++", "clang++-16")


def need(*tools):
    for tool in tools:
        if not shutil.which(tool):
            sys.exit(f"no {tool}: tools/setup interop installs it")


class Exporter:
    """`brdf export`, its texts and the files for the compilers."""

    def __init__(self, brdf, folder):
        self.brdf, self.folder = brdf, pathlib.Path(folder)
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def text(self, *words):
        made = run(self.brdf, "export", *words, cwd=self.folder)
        assert made.returncode == 0, (words, made.stderr)
        return made.stdout

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return self.folder / name


def said(*results):
    return "".join(r.stdout + r.stderr for r in results if r.returncode)


def of_explorer(text):
    """Returns the fragment shader that the Explorer makes of the file: sliders as uniforms, version 410."""
    assert "analytic\n" in text
    sliders, shader = re.fullmatch(
        r"analytic\n::begin parameters\n(.*)::end parameters\n::begin shader\n(.*)::end shader\n", text, re.S).groups()
    uniforms = ""
    for line in sliders.splitlines():
        kind, name, *numbers = line.split()
        assert len(numbers) == 3 and all(float(x) >= 0 for x in numbers), line
        uniforms += f"uniform {dict(float='float', color='vec3')[kind]} {name};\n"
    return f"#version 410\n{uniforms}{shader}out vec3 colour;\nvoid main() {{ colour = BRDF(vec3(0, 0, 1), vec3(0, 0, 1), " \
           "vec3(0, 0, 1), vec3(1, 0, 0), vec3(0, 1, 0)); }\n"


def user_of(to, functions, call="vec3(0.0, 0.0, 0.0)"):
    """Returns a shader or source that includes the functions and calls them."""
    if to == "glsl":
        return f"#version 450\n{functions}layout(location = 0) out vec4 o;\nvoid main() {{ o = vec4({call}, 1.0); }}\n"
    if to == "glsl-es":
        return "#version 300 es\nprecision highp float;\nprecision highp int;\n" \
               f"{functions}out vec4 o;\nvoid main() {{ o = vec4({call}, 1.0); }}\n"
    if to == "hlsl":
        return f"{functions}float4 main() : SV_Target {{ return float4({call.replace('vec3', 'float3')}, 1.0); }}\n"
    return functions


def wrong_with(to, text, exporter, name="text"):
    """Returns the errors that all installed compilers of the language report for a whole shader or source."""
    e = exporter
    results = []
    if to == "cpp":
        header = e.write(f"{name}.hpp", text)
        source = e.write(f"{name}.cc", f'#include "{header.name}"\n#include "{header.name}"\n')
        for compiler in cpp_compilers():
            results.append(run(compiler, "-std=c++17", *WARNINGS, "-fsyntax-only", source))
        return said(*results)
    if to == "hlsl":
        source = e.write(f"{name}.hlsl", text)
        results.append(run("glslc", "-x", "hlsl", "-fshader-stage=fragment", "-fentry-point=main", source, "-o",
                           e.folder / "hlsl.spv"))
        results.append(run("glslangValidator", "-D", "-V", "-S", "frag", "-e", "main", source, "-o", e.folder / "h.spv"))
        return said(*results)
    source, module = e.write(f"{name}.{to}.frag", text), e.folder / f"{to}.spv"
    if to == "glsl":
        results.append(run("glslc", "-Werror", source, "-o", module))
        if found("spirv-cross") and results[-1].returncode == 0:
            for words in (["--es", "--version", "310"], ["--hlsl", "--shader-model", "50"], ["--msl"]):
                results.append(run("spirv-cross", *words, module))
    results.append(run("glslangValidator", *(["-V", "-o", module] if to == "glsl" else []), source))
    return said(*results)
