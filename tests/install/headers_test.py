#!/usr/bin/env python3
# ctest: install.headers label=install timeout=3600 needs=install @build@
# ctest: install.headers_alone label=slow timeout=3600 needs=install @build@ --alone
"""headers_test.py BUILD [--alone]: tests that every installed header compiles with -Wall -Wextra as errors, with g++ and clang++ if
they are installed. One source includes all headers; with --alone, each header is the first of its own source. Under flags that
rearrange arithmetic, libbrdf must either refuse to compile or give the right values."""
import concurrent.futures
import math
import os
import pathlib
import shutil
import subprocess
import sys

from installed import moved_prefix, run, temporary_folder

build, alone = pathlib.Path(sys.argv[1]), "--alone" in sys.argv[2:]
COMPILERS = [name for name in ("g++", "clang++", "clang++-16") if shutil.which(name)]
WARNINGS = ["-Wall", "-Wextra", "-Werror"]
# As users of CMake have the headers of others: warnings in them are not theirs.
SYSTEM = [f"-isystem{path}" for path in ("/usr/include/OpenEXR", "/usr/include/Imath")]
FLAGS = ["-O2", "-O3", "-O2 -ffast-math", "-Ofast", "-O2 -funsafe-math-optimizations",
         "-O2 -fassociative-math -fno-signed-zeros -fno-trapping-math", "-O2 -ffp-contract=fast"]
# e^-x at x = 1/8, 2/8, ...: the kernel rounds with (x + magic) - magic.
PROGRAM = """#include <cstdio>
#include "brdf/kernels.h"
int main() {
  for (int k = 1; k < 200; ++k) std::printf("%.9g\\n", double(brdf::kernels::exp(-float(k) / 8)));
}
"""


def compile_headers(compiler, include, headers):
    """Returns the messages of the compiler about a source that includes these headers."""
    source = "".join(f'#include "{header}"\n' for header in headers)
    done = subprocess.run([compiler, "-std=c++20", *WARNINGS, "-fsyntax-only", "-I", include, *SYSTEM, "-x", "c++", "-"],
                          input=source, text=True, capture_output=True)
    return f"{compiler} {headers if len(headers) == 1 else 'all headers'}: {done.stderr}" if done.returncode else ""


def check_arithmetic(compiler, include, folder):
    """Requires that the source is refused with the reason, or gives values that are right to rounding."""
    source = folder / "user.cc"
    source.write_text(PROGRAM)
    compiled = 0
    for flags in FLAGS:
        made = subprocess.run([compiler, "-std=c++20", *WARNINGS, *flags.split(), "-I", include, source, "-o", folder / "user"],
                              text=True, capture_output=True)
        if made.returncode:
            assert "libbrdf relies on IEEE arithmetic" in made.stderr and flags not in ("-O2", "-O3"), made.stderr
            continue
        compiled += 1
        seen = [float(x) for x in run([folder / "user"]).split()]
        worst = max(abs(y * math.exp((k + 1) / 8) - 1) for k, y in enumerate(seen))
        assert len(seen) == 199 and worst < 2.5e-7, (compiler, flags, worst)
    assert compiled >= 3, compiler


with temporary_folder() as folder:
    folder = pathlib.Path(folder)
    include = moved_prefix(build, folder, ("libraries", "development")) / "include"
    headers = sorted(str(p.relative_to(include)) for p in include.rglob("*.h"))
    assert len(headers) > 60 and COMPILERS, headers
    sources = [[header] for header in headers] if alone else [headers]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        said = pool.map(lambda what: compile_headers(what[0], include, what[1]), [(c, s) for c in COMPILERS for s in sources])
        wrong = [text for text in said if text]
    for compiler in COMPILERS:
        check_arithmetic(compiler, include, folder)
    print(f"{len(headers)} headers by {', '.join(COMPILERS)}, {len(wrong)} with warnings")
    if wrong:
        sys.exit("\n".join(wrong))
