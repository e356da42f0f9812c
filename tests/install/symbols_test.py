#!/usr/bin/env python3
# ctest: install.symbols label=slow timeout=3600 needs=install @source@ @here@/shared @brdf@
"""symbols_test.py SOURCE BUILD_FOLDER BRDF: tests that shared libraries export only symbols of namespace brdf and the few that are
listed here, that they carry their version, that every installed header compiles alone, and that a program that uses only the core
needs no other library."""
import pathlib
import re
import sys

from installed import check_consumer, library_folder, moved_prefix, needed, run, temporary_folder

source, build = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
brdf = pathlib.Path(sys.argv[3])
run(["cmake", "-S", source, "-B", build, "-G", "Ninja", "-DBUILD_SHARED_LIBS=ON", "-DBRDF_PROGRAM=OFF",
     "-DBRDF_PYTHON=OFF"])
run(["cmake", "--build", build, "-j2"])

# The names of namespace brdf: functions, variables, types, tables, guards of statics.
OURS = re.compile(r"_Z(N[KOR]*|TIN|TSN|TVN|TTN|GVN|GVZNK?|ZNK?|Thn\d+_N|Tv0_n?\d+_N)4brdf")
# The symbols also carry the version.
FEW = re.compile(r"BRDF_\d+\.\d+$")

with temporary_folder() as folder:
    folder = pathlib.Path(folder)
    prefix = moved_prefix(build, folder, ("libraries", "development"))
    libraries = library_folder(prefix)
    for name in ("brdf", "brdf_io", "brdf_measured", "brdf_fit", "brdf_validate"):
        library = libraries / f"lib{name}.so"
        shown = [line.split()[-1].split("@")[0] for line in run(["nm", "-D", "--defined-only", library]).splitlines()]
        foreign = [s for s in shown if not OURS.match(s) and not FEW.match(s)]
        assert not foreign, f"{library.name} shows {foreign[:20]}"
        assert len(shown) > 5, f"{library.name} shows {len(shown)} symbols"
        header = run(["readelf", "-d", library])
        assert re.search(rf"SONAME.*\[lib{name}\.so\.\d+\.\d+\]", header), header
        print(library.name, len(shown), "symbols")
    core = needed(libraries / "libbrdf.so")
    assert all(n.startswith(("libstdc++", "libm.", "libgcc_s", "libc.", "ld-linux")) for n in core), core

    # Every installed header can be the first that a source includes.
    headers = sorted(str(p.relative_to(prefix / "include")) for p in (prefix / "include").rglob("*.h"))
    assert len(headers) > 60, headers
    for header in headers:
        run(["c++", "-std=c++20", "-fsyntax-only", "-I", prefix / "include", "-x", "c++", "-"], input=f'#include "{header}"\n')

    out = folder / "out"
    run(["cmake", "-S", source / "examples/consumer", "-B", out, f"-DCMAKE_PREFIX_PATH={prefix}"])
    run(["cmake", "--build", out])
    check_consumer(out, brdf, source)
    loaded = run(["ldd", out / "forms"])
    assert not re.search("ceres|glog|OpenEXR|brdf_io", loaded) and "libbrdf.so" in loaded, loaded
