#!/usr/bin/env python3
# ctest: prove.compilers label=slow timeout=3600 @source@ @build@
"""compilers_test.py SOURCE BUILD: tests that g++ and clang, with -O0 and -O3, find the same boxes and the same
bounds of every form, bit for bit. BUILD has the generated headers and the parts of the catalogue. Exit code 77 without clang."""
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

source, build = (pathlib.Path(p).resolve() for p in sys.argv[1:])
generated, shards = build / "libbrdf/generated", sorted((build / "prove").glob("shard_*.cpp"))
gcc = shutil.which("g++")
clang = next(filter(None, map(shutil.which, ("clang++-16", "clang++"))), None)
if not gcc or not clang:
    print("skipped: g++ and clang++ are needed")
    sys.exit(77)

FILES = [*sorted((source / "prove/scalar").glob("*.cpp")), *sorted((source / "prove/energy").glob("*.cpp")), source / "prove/check/claim.cpp", source / "prove/search.cpp", source / "tests/prove/compilers/driver.cpp", *shards]


def built(compiler, level, folder):
    flags = ["-std=c++20", level, "-ffp-contract=off", f"-I{source}", f"-I{source}/libbrdf", f"-I{generated}"]
    flags += ["-fno-tree-slp-vectorize"] if compiler == gcc else []

    def compiled(number):
        out = folder / f"{number}.o"
        subprocess.run([compiler, *flags, "-c", FILES[number], "-o", out], check=True)
        return out

    with concurrent.futures.ThreadPoolExecutor(min(4, os.cpu_count() or 1)) as pool:
        objects = list(pool.map(compiled, range(len(FILES))))
    subprocess.run([compiler, *objects, "-o", folder / "driver"], check=True)
    return subprocess.run([folder / "driver"], check=True, capture_output=True).stdout


said = {}
for compiler in (gcc, clang):
    for level in ("-O0", "-O3"):
        with tempfile.TemporaryDirectory() as folder:
            said[f"{pathlib.Path(compiler).name} {level}"] = built(compiler, level, pathlib.Path(folder))
(first, text), *others = said.items()
assert text.count(b"\n") > 2000, text[:400]
for name, other in others:
    if other != text:
        pairs = zip(text.splitlines(), other.splitlines())
        here, there = next((pair for pair in pairs if pair[0] != pair[1]), ("the end", "the end"))
        sys.exit(f"{name} differs from {first}: {there} where that has {here}")
print(f"{len(text.splitlines())} lines are the same from {', '.join(said)}")
