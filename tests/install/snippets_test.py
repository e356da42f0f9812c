#!/usr/bin/env python3
# ctest: install.snippets label=install timeout=900 cost=40 needs=install @build@ @brdf@
"""snippets_test.py BUILD BRDF [PREFIX]: the examples in the comments of the public headers compile and run.

An example is the code after a line `// Example:` in a comment, indented by four columns more than the
comment. A line `// #include "..."` in the code includes another header; the standard headers of HEAD are
always included. The examples are compiled with an installed prefix (PREFIX, or a prefix made of BUILD) and
run in a folder with the files that they name.

An entry point is a header of cmake/public_headers.txt, or of libbrdf/brdf itself, that declares a function
with its body in a library: outside a class and a namespace `detail`, no template, not inline. Every entry
point must have an example.
"""
import os
import pathlib
import re
import subprocess
import sys

from installed import library_folder, moved_prefix, run, temporary_folder

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEAD = ["cmath", "cstdio", "fstream", "iostream", "memory", "string", "vector"]
FLAGS = ["-std=c++20", "-O0", "-Wall", "-Wextra", "-Werror",
         "-Wno-unused-variable", "-Wno-unused-but-set-variable"]


def public_headers():
    """Returns the headers that may be entry points, as {name for others: path}."""
    listed = [line for line in (ROOT / "cmake/public_headers.txt").read_text().splitlines()
              if line and not line.startswith("#")]
    headers = {f"brdf/{name}": ROOT / name for name in listed}
    return headers | {f"brdf/{path.name}": path for path in sorted((ROOT / "libbrdf/brdf").glob("*.h"))}


def declares_functions(text):
    """Returns whether the text of a header declares a function with its body in a library."""
    text = re.sub(r"//.*|= \{\}", "", text)
    text = re.sub(r"^namespace detail \{.*?^\}", "", text, flags=re.M | re.S)
    text = re.sub(r"^template\b.*\n(?:  .*\n)*(?=\S)", "template ", text, flags=re.M)
    return bool(re.search(r"^(?!inline|template|constexpr|using|static|typedef|friend|struct|class|namespace)"
                          r"[\w:][^;{}()]*\b\w+\([^;{}]*\);", text, re.M))


def examples_of(text):
    """Returns [(line of the first line of code, lines of code)] of a header."""
    found, lines = [], text.split("\n")
    for k, line in enumerate(lines):
        if re.fullmatch(r" *// Example:", line):
            code = []
            for after in lines[k + 1:]:
                match = re.fullmatch(r" *//     (.*)", after)
                if not match:
                    break
                code.append(match[1])
            found.append((k + 2, code))
    return found


def source_of(examples):
    """Returns a program that runs the example with the number in its argument. An example is (header, path, line, code)."""
    includes = [f"#include <{name}>" for name in HEAD]
    functions = []
    for number, (header, path, line, code) in enumerate(examples):
        includes.append(f'#include "{header}"')
        includes += [text.removeprefix("// ") for text in code if text.startswith("// #include")]
        body = [re.sub(r"^// #include.*", "", text) for text in code]
        functions += [f"void example_{number}() {{", f'#line {line} "{path}"', *body, "}"]
    calls = [f"  if (number == {number}) example_{number}();" for number in range(len(examples))]
    head = ["int main(int, char** argv) {", "  const int number = std::stoi(argv[1]);"]
    return "\n".join([*includes, *functions, *head, *calls, "}\n"])


def compiled(source, folder, flags):
    """Returns the errors of the compiler, and the program if there are libraries among the flags."""
    (folder / "examples.cpp").write_text(source)
    links = any(flag.startswith("-l") for flag in flags)
    how = ["-o", folder / "examples"] if links else ["-fsyntax-only"]
    command = [os.environ.get("CXX", "g++"), *FLAGS, folder / "examples.cpp", *how, *flags]
    done = subprocess.run(command, text=True, capture_output=True, check=False)
    return done.stderr if done.returncode else ""


def check_that_faults_are_found(folder, flags):
    assert declares_functions("namespace brdf {\n// Adds.\nint add(int a,\n        int b = {});\n}\n")
    for text in ("struct A {\n  int f();\n};\n", "template <class T>\nT f();\n",
                 "inline int f() { return 1; }\n", "// int f();\n", "namespace detail {\nint f();\n}\n"):
        assert not declares_functions(text), text
    for code, good in (("const brdf::Angle a = brdf::degrees(3);", True),
                       ("const brdf::Angle a = 3;", False)):
        wrong = compiled(source_of([("brdf/angle.h", "angle.h", 7, [code])]), folder, flags)
        assert ("angle.h:7:" in wrong) != good, wrong


def make_files(brdf, folder):
    """Writes the files that the examples name."""
    data = ROOT / "data"
    for name, source in (("paint.csv", "synthetic/cook_torrance_metal.csv"),
                         ("matt.csv", "synthetic/lambert.csv"), ("copper.json", "materials/copper.json")):
        (folder / name).write_bytes((data / source).read_bytes())
    run([brdf, "convert", "paint.csv", "paint.binary"], cwd=folder)
    run([brdf, "export", "--material", "copper.json", "--to", "rgl", "-o", "copper.bsdf"], cwd=folder)
    (folder / "in_plane.csv").write_text("theta_i,phi_i,theta_o,phi_o,f\n" + "".join(
        f"30,0,{abs(angle)},{180 if angle > 0 else 0},{0.1 + 0.01 * angle}\n" for angle in range(0, 80, 5)))


def main():
    build, brdf = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    examples, missing = [], []
    for header, path in public_headers().items():
        text = path.read_text()
        found = examples_of(text)
        examples += [(header, path.relative_to(ROOT), line, code) for line, code in found]
        if declares_functions(text) and not found:
            missing.append(header)
        lengths = {line: sum(not text.startswith("// #") for text in code) for line, code in found}
        wrong = [line for line, length in lengths.items() if not 1 <= length <= 8]
        assert not wrong, f"{header}, line {wrong[0]}: an example has one to eight lines"
    if missing:
        sys.exit("an entry point has no example in its comments (// Example:): " + ", ".join(missing))
    with temporary_folder() as folder:
        folder = pathlib.Path(folder)
        given = sys.argv[3:]
        parts = ("libraries", "development")
        prefix = pathlib.Path(given[0]) if given else moved_prefix(build, folder, parts)
        environment = {**os.environ, "PKG_CONFIG_PATH": str(library_folder(prefix) / "pkgconfig")}
        packages = ["brdf-fit", "brdf-validate"]
        flags = run(["pkg-config", "--cflags", *packages], env=environment).split()
        check_that_faults_are_found(folder, flags)
        flags += run(["pkg-config", "--libs", *packages], env=environment).split()
        wrong = compiled(source_of(examples), folder, flags)
        if wrong:
            sys.exit(wrong)
        work = folder / "work"
        work.mkdir()
        make_files(brdf, work)
        for number, (header, path, line, _) in enumerate(examples):
            done = subprocess.run([folder / "examples", str(number)], cwd=work, text=True,
                                  capture_output=True, check=False)
            if done.returncode:
                sys.exit(f"{path}:{line}: the example of {header} ends with {done.returncode}\n{done.stderr}")
    print(f"{len(examples)} examples compile and run")


main()
