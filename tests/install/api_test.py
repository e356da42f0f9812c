#!/usr/bin/env python3
# ctest: install.api label=slow timeout=3600 needs=install @build@ @source@
"""api_test.py BUILD SOURCE: Doxygen makes a page of every public header, without a warning. Exit 77 without Doxygen."""
import pathlib
import shutil
import sys

from installed import run

build, source = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
if not shutil.which("doxygen"):
    print("skipped: doxygen is not installed")
    sys.exit(77)
shutil.rmtree(build / "api", ignore_errors=True)
run(["doxygen", build / "Doxyfile"])
headers = [p.name for root in (source / "libbrdf/brdf", build / "public/brdf") for p in root.rglob("*.h")]
pages = {p.name for p in (build / "api/html").glob("*_8h.html")}
# A name that occurs twice has its folder in its page's name.
missing = [h for h in headers if not any(p.endswith(h.replace("_", "__").replace(".h", "_8h.html")) for p in pages)]
assert not missing and len(pages) == len(headers), (missing, len(pages), len(headers))
