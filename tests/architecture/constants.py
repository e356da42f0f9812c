#!/usr/bin/env python3
# ctest: architecture.no_constant_hides_a_headers label=architecture @source@
"""Checks that no constant of a source has the name of a constant in a header of its room.

    constants.py ROOT

Sources are compiled in batches. In a batch, later sources would use the constant of an unnamed namespace in place of the constant of
the header, without a warning of the compiler.
"""
import collections
import pathlib
import re
import sys

import rooms

CONSTANT = re.compile(r"^(?:inline |static )*constexpr [\w:<>,&* ]*?(k[A-Z]\w*)\b *(?:=|\{|\[|\()", re.M)
NEXT = re.compile(r"[,}] (k[A-Z]\w*)(?: =|\{)")  # of a list in one line
NAMESPACE = re.compile(r"^namespace (brdf[\w:]*) \{", re.M)
UNNAMED = re.compile(r"^namespace \{\n(.*?)^\}  // namespace\n", re.M | re.S)


def constants(text):
    return {name for line in text.splitlines() if CONSTANT.match(line)
            for name in CONSTANT.findall(line) + NEXT.findall(line)}


def main(root):
    files = rooms.files(root, "*.cpp", "*.h")
    of_headers = collections.defaultdict(list)
    for name in (f for f in files if f.endswith(".h")):
        text = (root / name).read_text()
        for constant in constants(text):
            of_headers[name.split("/")[0], constant].append((name, set(NAMESPACE.findall(text))))
    own = faults = 0
    for name in (f for f in files if f.endswith(".cpp")):
        text = (root / name).read_text()
        spaces = set(NAMESPACE.findall(text))
        for constant in sorted(set().union(*map(constants, UNNAMED.findall(text)))):
            own += 1
            for header, others in of_headers[name.split("/")[0], constant]:
                if spaces & others:
                    faults += 1
                    print(f"{name}: {constant} is also a constant of {header}")
    print(f"{own} constants of files, {len(of_headers)} of headers: {faults} hidden")
    return 1 if faults or not own else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
