#!/usr/bin/env python3
# ctest: io.formats_page label=io @brdf@ @source@
"""formats_page_test.py BRDF SOURCE: runs the command of each row of the table of docs/formats.md, and tests that the rows read every
format that the program has a reader for (io/formats/read.cpp), and that the written formats are the ones that the page states."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

brdf, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
page = (source / "docs/formats.md").read_text()
table = page[page.index("| format | recognised by |"):].split("\n\n")[0].splitlines()[2:]
faults, read = [], set()
with tempfile.TemporaryDirectory() as folder:
    bench = pathlib.Path(folder)
    (bench / "data").symlink_to(source / "data")
    (bench / "bin").mkdir()
    (bench / "bin/brdf").symlink_to(brdf)
    for row in table:
        cells = [cell.strip() for cell in row.strip("|").split(" | ")]
        if len(cells) != 7 or not all(cells):
            faults.append(f"{row[:40]}: a row has seven filled cells")
            continue
        done = subprocess.run(["bash", "-e", "-c", cells[6].strip("` ")], cwd=bench, capture_output=True, text=True, check=False,
                              env=os.environ | {"PATH": f"{bench / 'bin'}:{os.environ['PATH']}"})
        formats = re.findall(r"rows? of (\w+) to", done.stderr)
        if done.returncode != 0 or not formats:
            faults.append(f"{cells[6]}: exit code {done.returncode}, {done.stderr[-300:]}")
            continue
        read.add(formats[-1])
        suffix = re.search(r"`convert (x\.\w+)`", cells[5])
        if suffix and f"{suffix[1][1:]} " not in cells[6] + " " and formats[-1] != "csv":
            faults.append(f"{cells[0]}: the example does not write {suffix[1]}")
readers = re.findall(r"FORMAT\((\w+)\)", re.sub(r"#define \w+\(FORMAT\)", "", (source / "io/formats/read.cpp").read_text()))
if len(read - {"csv"}) != len(set(readers)):
    faults.append(f"the rows read {sorted(read)}, the program has readers {sorted(set(readers))}")
print("\n".join(faults) or f"{len(table)} rows, formats {', '.join(sorted(read))}")
sys.exit(bool(faults))
