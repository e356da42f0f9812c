#!/usr/bin/env python3
# ctest: architecture.build_files_stay_small label=architecture @source@
"""build_files.py ROOT: checks that the files of the build stay small and treat sources by folders.

Fails if all files of CMake (including presets and lists of tests) have more than MOST lines together or a line beyond COLUMNS, if
more than OWN_FLAGS sources have separate flags, if a source is taken out of its batch (except generated sources, which are batches
already), or if CITATION.cff names another version or date than CMakeLists.txt.
"""
import pathlib
import re
import sys

MOST, OWN_FLAGS, COLUMNS = 799, 6, 110
NAMES = re.compile(r"(CMakeLists\.txt|\.cmake|CMakePresets\.json|\.cmake\.in)$")

root = pathlib.Path(sys.argv[1])
files = [p for p in root.rglob("*") if p.is_file() and NAMES.search(p.name) and "build" not in p.relative_to(root).parts]
texts = {str(p.relative_to(root)): p.read_text() for p in files}
lines = sum(text.count("\n") for text in texts.values())
own_flags = [f"{name}: {line.strip()}" for name, text in texts.items() for line in text.splitlines()
             if re.match(r"\s*set_(source_files_properties|property\(SOURCE)", line)]
out_of_batch = [line for line in own_flags if "SKIP_UNITY" in line and "${shards}" not in line]
faults = []
if lines > MOST:
    faults.append(f"{lines} lines of CMake are more than {MOST}")
faults += [f"{name}:{k}: {len(line)} columns are more than {COLUMNS}" for name, text in texts.items()
           for k, line in enumerate(text.splitlines(), 1) if len(line) > COLUMNS]
if len(own_flags) > OWN_FLAGS:
    faults.append("sources with flags of their own:\n  " + "\n  ".join(own_flags))
faults += [f"out of its batch: {line}" for line in out_of_batch]
main = texts["CMakeLists.txt"]
cited = (root / "CITATION.cff").read_text()
for pattern, key in ((r"project\(brdf VERSION (\S+)", "version"), (r"BRDF_RELEASE_DATE (\S+)\)", "date-released")):
    if f"{key}: {re.search(pattern, main)[1]}\n" not in cited:
        faults.append(f"CITATION.cff: its {key} is not that of CMakeLists.txt")
print("\n".join(faults) or f"{lines} lines of CMake in {len(files)} files, {len(own_flags)} sources or lists with flags of their own")
sys.exit(bool(faults))
