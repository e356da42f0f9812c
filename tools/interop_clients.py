#!/usr/bin/env python3
# ctest: interop.clients label=interop after=clients needs=plain @tests@/interop @source@/docs/interop.md
"""Checks or writes the table of docs/interop.md with the differences between the pictures of programs and their files.

    ctest --test-dir build/release -L interop
    tools/interop_clients.py [--update] build/release/tests/interop docs/interop.md

The folder holds a summary.json of each test of a program. Without --update the script fails if the table of the document
differs (figures may differ by a factor of 2, because they are rounding errors in float).
"""
import json
import pathlib
import re
import sys

CLIENTS = ("blender", "three", "khronos", "materialx")
HEADER = ("| program | materials | pairs of directions | median | largest | largest, widths below 0.09 |",
          "|---|---|---|---|---|---|")
MARK = "clients: written by tools/interop_clients.py"


def row(summary):
    narrow = f"{summary['largest_of_narrow']:.1e} ({summary['narrow']} materials)" if summary["narrow"] else "-"
    return (f"| {summary['client']} | {summary['materials']} | {summary['pairs']} | {summary['median']:.1e} | "
            f"{summary['largest']:.1e} | {narrow} |")


def cells(table):
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in table.strip().splitlines()]


def same(old, new):
    def equal(a, b):
        figures = [re.match(r"\d\.\de-\d+", cell) for cell in (a, b)]
        if not all(figures):
            return a == b
        x, y = (float(figure[0]) for figure in figures)
        return max(x, y) <= 2 * min(x, y) and a[figures[0].end():] == b[figures[1].end():]
    old, new = cells(old), cells(new)
    return len(old) == len(new) and all(len(a) == len(b) and all(map(equal, a, b)) for a, b in zip(old, new))


def main():
    update = "--update" in sys.argv
    folder, document = (pathlib.Path(a) for a in sys.argv[1:] if a != "--update")
    missing = [name for name in CLIENTS if not (folder / name / "summary.json").exists()]
    if missing:
        sys.exit(f"no {folder}/NAME/summary.json of {', '.join(missing)}: ctest --test-dir build/release -L interop writes them")
    summaries = [json.loads((folder / name / "summary.json").read_text()) for name in CLIENTS]
    new = "\n".join([*HEADER, *map(row, summaries)])
    text = document.read_text()
    before, rest = text.split(f"<!-- {MARK} -->")
    old, after = rest.split("<!-- end of clients -->")
    if update:
        document.write_text(f"{before}<!-- {MARK} -->\n{new}\n<!-- end of clients -->{after}")
    elif not same(old, new):
        sys.exit(f"{document} holds another table than the programs show (--update writes it):\n{new}")


main()
