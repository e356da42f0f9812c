#!/usr/bin/env python3
# ctest: platforms.aarch64 label=platforms timeout=3600 needs=plain @source@ @build@ @here@/aarch64 aarch64-linux-gnu-g++ --link=-static --run qemu-aarch64-static
# ctest: platforms.clang label=platforms timeout=3600 needs=plain @source@ @build@ @here@/clang clang++-16
# ctest: platforms.wasm label=wasm timeout=900 needs=plain @source@ @build@ @here@/wasm em++ --wasm @source@/build/wasm --run node
"""Tests that libbrdf has the same bits on another platform: f_r in double and in float, their derivatives, and directional albedos, of
every form and target.

    platforms_test.py SOURCE BUILD FOLDER COMPILER [--compile FLAG]... [--link FLAG]... [--wasm BUILD] [--run PROGRAM]

Compiles libbrdf and bits.cpp with the other compiler (--wasm: links the libbrdf.a of a build for WebAssembly) and compares the output with that
of BUILD. Exit code 77 if the compiler, the program that runs the result, or the other build is missing.
"""
import argparse
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
for name in ("source", "build", "folder"):
    parser.add_argument(name, type=lambda word: pathlib.Path(word).resolve())
parser.add_argument("compiler")
parser.add_argument("--compile", action="append", default=[])
parser.add_argument("--link", action="append", default=[])
parser.add_argument("--wasm", type=lambda word: pathlib.Path(word).resolve())
parser.add_argument("--run")
o = parser.parse_args()
for program in (o.compiler, o.run):
    if program and not shutil.which(program):
        print(f"skipped: {program} is not installed")
        sys.exit(77)
if o.wasm and not (o.wasm / "libbrdf/libbrdf.a").exists():
    print(f"skipped: {o.wasm} has no libbrdf: cmake --preset wasm && cmake --build --preset wasm")
    sys.exit(77)

generated = o.build / "libbrdf/generated"
PROGRAM = o.source / "tests/libbrdf/platforms/bits.cpp"
WORDS = ["-std=c++20", "-O1", "-ffp-contract=off", "-DBRDF_FEW_CLONES", f"-I{o.build}/libbrdf/include", f"-I{generated}", f"-I{o.source}"]


def run(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    assert done.returncode == 0, (words, done.stderr[-2000:])
    return done.stdout


def compiled(compiler, flags, sources, folder):
    """Returns the object files of the sources, compiled two at a time."""
    folder.mkdir(parents=True, exist_ok=True)

    def one(source):
        made = folder / (source.name + ".o")
        run(compiler, *WORDS, *flags, "-c", source, "-o", made)
        return made
    with concurrent.futures.ThreadPoolExecutor(min(2, os.cpu_count() or 1)) as pool:
        return list(pool.map(one, sources))


def rows(text):
    """Returns the hashes and the bits of the albedos by form."""
    return {line.split()[0]: line.split()[1:] for line in text.splitlines()}


def here():
    objects = compiled("c++", [], [PROGRAM], o.folder / "here")
    program = o.folder / "here/bits"
    run("c++", *objects, o.build / "libbrdf/libbrdf.a", "-o", program)
    return run(program)


def elsewhere():
    flags, link = o.compile, o.link
    if o.wasm:
        sources, objects = [PROGRAM], [o.wasm / "libbrdf/libbrdf.a"]
        flags = [*flags, "-fwasm-exceptions", "-msimd128", f"-isystem{o.source}/build/wasm-packages/include", "-include",
                 o.source / "browser/old_standard_library.h"]
        link = [*link, "-fwasm-exceptions", "-sALLOW_MEMORY_GROWTH=1", "-sSINGLE_FILE=1"]
    else:
        sources = [PROGRAM, *sorted((o.source / "libbrdf/src").rglob("*.cpp")), *sorted(generated.glob("*.cpp"))]
        objects = []
    objects = compiled(o.compiler, flags, sources, o.folder / "elsewhere") + objects
    program = o.folder / ("elsewhere/bits.js" if o.wasm else "elsewhere/bits")
    run(o.compiler, *link, *objects, "-o", program)
    return run(*([o.run] if o.run else []), program)


ours, theirs = rows(here()), rows(elsewhere())
assert ours.keys() == theirs.keys() and len(ours) > 40, (len(ours), len(theirs))
different = [name for name in ours if ours[name] != theirs[name]]
assert not different, f"other bits: {', '.join(different)}"
assert all(len(bits) > 7 for bits in ours.values())  # f_r in double and float, derivatives, and albedos
print(f"{len(ours)} forms and targets: the same bits of f_r in double and float, of the derivatives and of the albedos")
