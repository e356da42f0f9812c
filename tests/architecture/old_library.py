#!/usr/bin/env python3
# ctest: architecture.the_page_has_what_its_standard_library_lacks label=architecture @source@
"""Checks that the page's build has every algorithm of ranges that its sources call.

    old_library.py ROOT

Debian's emscripten has a standard library without these algorithms; browser/old_standard_library.h defines the ones that the page calls.
That build takes too long for every change, so this check reads the names.
"""
import pathlib
import re
import sys

import rooms

HEADER = "browser/old_standard_library.h"
ELSEWHERE = ("io/files/digest/", "io/formats/exrOpenEXR_", "validate/joint/", "validate/outside/")  # not compiled for the page
CALL = re.compile(r"\bstd::ranges::(\w+)\(")
DEFINED = re.compile(r"^BRDF_OF_[A-Z]+\((\w+)|^(?:constexpr )?\w+ (\w+)\(", re.M)


def missing(defined, texts):
    """Returns (file, algorithm) for each call of an algorithm that is not defined."""
    return sorted({(name, called) for name, text in texts.items() for called in CALL.findall(text) if called not in defined})


def main(root):
    root = pathlib.Path(root)
    defined = {name for pair in DEFINED.findall((root / HEADER).read_text()) for name in pair if name}
    page = {room.name for room in rooms.read(root) if room.kind in ("installed", "page", "browser")}
    names = [n for n in rooms.files(root, "*.cpp", "*.h")
             if n.split("/")[0] in page and not n.startswith(ELSEWHERE) and n != HEADER]
    assert missing({"sort"}, {"a.cpp": "std::ranges::sort(x); std::ranges::rotate(x);"}) == [("a.cpp", "rotate")]
    found = missing(defined, {name: (root / name).read_text() for name in names})
    for name, called in found:
        print(f"{name}: std::ranges::{called} is not in {HEADER}: define it there, or call std::{called}")
    print(f"{len(names)} sources of the page, {len(defined)} algorithms: {len(found)} calls of others")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
