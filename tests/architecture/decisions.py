#!/usr/bin/env python3
# ctest: architecture.decisions_are_records label=architecture @source@ --check
"""Checks the decision records, docs/decisions/NNNN-title.md, and their index, docs/decisions.md.

    decisions.py ROOT --check | --update

--check fails if the numbers have a gap, if a record lacks its date or its status, if the index differs, or if an accepted record
names in backquotes a file or a word of code that the tree lacks. Such a record is marked as replaced, with the number of its
successor. --update writes the index.
"""
import pathlib
import re
import sys

import rooms

ROOT, MODE = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
FOLDER, INDEX = ROOT / "docs/decisions", ROOT / "docs/decisions.md"
HEAD = re.compile(r"# (\d{4})\. (.+)\n\nDate: (\d{4}-\d\d-\d\d)\. Status: (accepted|withdrawn|replaced by (\d{4}))\.\n\n")


def words_of_tree():
    words, paths = set(), set()
    for name in rooms.files(ROOT):
        path = ROOT / name
        parts = pathlib.PurePath(name)
        paths |= {name, str(parts.with_suffix("")), *map(str, parts.parents)}
        if name.startswith("docs/decisions") or path.suffix in (".png", ".exr", ".svg", ".webp"):
            continue
        words |= set(re.findall(r"\w+", path.read_text(errors="ignore")))
    return words, paths


def missing_names(text, words, paths):
    for name in re.findall(r"`([^`\n]+)`", text):
        if re.search(r"[A-Z]{4}", name):
            continue  # a place holder
        if re.fullmatch(r"[a-z]+(/[\w.-]+)+/?(\.\*)?", name):
            if name.rstrip("/").removesuffix(".*") not in paths and not any(p.endswith("/" + name) for p in paths):
                yield name
        elif re.fullmatch(r"[A-Za-z_]\w{3,}(\(\))?", name) and name.removesuffix("()") not in words:
            yield name


def main():
    faults, rows = [], []
    words, paths = words_of_tree()
    for number, path in enumerate(sorted(FOLDER.glob("*.md")), 1):
        text = path.read_text()
        head = HEAD.match(text)
        if not head or int(head[1]) != number or not path.name.startswith(head[1]):
            faults.append(f"{path.name}: begins with '# {number:04d}. TITLE', its date and its status")
            continue
        if head[4] == "accepted":
            faults += [f"{path.name}: `{name}` is not in the tree" for name in missing_names(text, words, paths)]
        rows.append(f"| [{head[1]}](decisions/{path.name}) | {head[2]} | {head[3]} | {head[4]} |")
    index = "\n".join(["# Decisions", "", "A record each: context, decision, consequence. `tests/architecture/decisions.py . --update` writes this index.",
                       "", "| number | decision | date | status |", "|---|---|---|---|", *rows, ""])
    if MODE == "--update":
        INDEX.write_text(index)
    elif INDEX.read_text() != index:
        faults.append("docs/decisions.md: is not the records' index: decisions.py . --update writes it")
    print("\n".join(faults) or f"{len(rows)} decisions")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
