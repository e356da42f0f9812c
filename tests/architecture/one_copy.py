#!/usr/bin/env python3
# ctest: architecture.batches_are_compiled_once label=architecture needs=plain @brdf@
"""one_copy.py BRDF: checks that the program has one copy of each batch of a form.

A batch is compiled with its own flags, in the library alone. A second copy, from another source that uses the form, can take its
place at linking, and fits are then many times slower, with the same values. The clones of a batch for different processors are
local symbols, so that a second copy shows in the program's table. Exit code 77 if the compiler makes no clones.
"""
import collections
import re
import subprocess
import sys

symbols = subprocess.run(["nm", sys.argv[1]], check=True, capture_output=True, text=True).stdout.split()
# The first argument of the template is a struct of the namespace brdf itself: a form of the catalogue or a target.
batch = re.compile(r"_ZN4brdf6repeatIZNS_6detail15(eval|lobe)_directionsINS_\d+[a-z]\w*\.default$")
copies = collections.Counter(name for name in symbols if batch.match(name))
if not copies:
    print("no batch has clones in this program")
    sys.exit(77)
several = [name for name, count in copies.items() if count > 1]
print("\n".join(f"{copies[name]} copies of {name}" for name in several) or f"{len(copies)} batches, each compiled once")
sys.exit(bool(several))
