#!/usr/bin/env python3
# ctest: architecture.batches_are_compiled_once label=architecture needs=plain @brdf@
"""one_copy.py BRDF: checks that the program has one copy of each batch of a form.

A batch is compiled with its own flags, in the library alone. A second copy, from another source that uses the form, can take its
place at linking, and fits are then many times slower, with the same values. The clones of a batch for different processors are
local symbols, so that a second copy shows in the program's table. Exit code 77 if the program has no clones at
all, as by clang or without symbols; it fails if there are clones, but no batch among them.
"""
import collections
import re
import subprocess
import sys

symbols = subprocess.run(["nm", sys.argv[1]], check=True, capture_output=True, text=True).stdout.split()
clones = [name for name in symbols if name.endswith(".default")]
if not clones:
    print("the compiler made no clones in this program")
    sys.exit(77)
batch = re.compile(r"_ZN4brdf6repeatIZNS_6detail15(eval|lobe)_directionsINS_")
copies = collections.Counter(name for name in clones if batch.match(name))
faults = [f"{count} copies of {name}" for name, count in copies.items() if count > 1]
if not copies:
    faults = ["no batch of a form is among the clones: were eval_directions and lobe_directions renamed?"]
print("\n".join(faults) or f"{len(copies)} batches, each compiled once")
sys.exit(bool(faults))
