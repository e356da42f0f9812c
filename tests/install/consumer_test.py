#!/usr/bin/env python3
# ctest: install.find_package label=install timeout=3600 needs=install find_package @build@ @source@
# ctest: install.pkg_config label=slow timeout=3600 needs=install pkg_config @build@ @source@
# ctest: install.fetch label=slow timeout=3600 needs=install fetch @build@ @source@
"""consumer_test.py find_package|pkg_config|fetch BUILD SOURCE: tests that examples/consumer, built in this way, prints the same
values as the program, and that the core of libbrdf needs only the standard library."""
import os
import pathlib
import shutil
import sys

from installed import check_consumer, library_folder, moved_prefix, needed, run, temporary_folder

way, build, source = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
with temporary_folder() as folder:
    folder = pathlib.Path(folder)
    consumer, out = folder / "consumer", folder / "out"
    shutil.copytree(source / "examples/consumer", consumer)
    brdf = build / "brdf"
    if way == "fetch":
        run(["cmake", "-S", consumer, "-B", out, "-G", "Ninja", f"-DBRDF_SOURCE={source}"])
        run(["cmake", "--build", out, "-j2"])
    else:
        prefix = moved_prefix(build, folder, ("development",))
        if way == "find_package":
            run(["cmake", "-S", consumer, "-B", out, f"-DCMAKE_PREFIX_PATH={prefix}"])
            run(["cmake", "--build", out])
        else:
            out = consumer
            run(["make", "-C", consumer],
                env={**os.environ, "PKG_CONFIG_PATH": str(library_folder(prefix) / "pkgconfig")})
    check_consumer(out, brdf, source)
    foreign = [name for name in needed(out / "forms")
               if not name.startswith(("libstdc++", "libm.", "libgcc_s", "libc.", "ld-linux"))]
    assert not foreign, foreign
