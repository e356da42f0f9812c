#!/usr/bin/env python3
# ctest: style.checks label=style @source@ --check
"""checks_doc.py ROOT [--check]: writes docs/checks.md from the two tables of checks in the sources; --check fails if the page differs
from the tables, or if docs/validation.md does not explain a check of tables."""
import argparse
import pathlib
import re
import sys

ROW = re.compile(r'\{"(\w+)",\s*((?:"(?:[^"\\]|\\.)*"\s*)+),([^{}]*)')
INTRODUCTION = """# The checks

`tools/checks_doc.py .` writes this page from the tables of checks in the program (`validate/form/checks.h`, `sheet/checks.cpp`); a
test compares both. The names are the arguments of `brdf validate --require`. [Validation](validation.md) defines the verdicts and
explains the methods; [judging a measurement](howto/judge.md) shows the checks of a table at work.
"""


def rows_of(source):
    """Returns (name, meaning, remaining fields) of every check of a table of checks."""
    text = source.read_text()
    table = text[text.index("kChecks[] = {") :]
    table = table[: table.index("\n};")]
    rows = [(name, "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', meaning)), rest) for name, meaning, rest in ROW.findall(table)]
    starts = len(re.findall(r'^    \{"\w+"', table, re.M))
    assert rows and len(rows) == starts, f"{source}: {len(rows)} of {starts} checks were understood"
    return rows


def table_of(rows, heading):
    lines = [f"| check | {heading} |", "|---|---|"]
    return lines + [f"| `{name}` | {meaning} |" for name, meaning, _ in rows]


def page_of(root):
    forms, tables = rows_of(root / "validate/form/checks.h"), rows_of(root / "sheet/checks.cpp")
    own = [row for row in forms if "outside" in row[2]]
    sampled = [row for row in forms if "sampled" in row[2]]
    general = [row for row in forms if row not in own and row not in sampled]
    page = [INTRODUCTION, "## Of forms, materials and shaders", "", *table_of(general, "question"), "",
            "Only of shaders:", "", *table_of(own, "question"), "",
            "Only of shaders with a sampler or a density of their own, and of forms with `--samplers`:", "", *table_of(sampled, "question"), "",
            "## Of tables of measurements", "", *table_of(tables, "question")]
    return "\n".join(page) + "\n", [name for name, _, _ in tables]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    text, of_tables = page_of(options.root)
    page = options.root / "docs/checks.md"
    if not options.check:
        page.write_text(text)
        return 0
    faults = [] if page.exists() and page.read_text() == text else ["docs/checks.md differs from the sources: run tools/checks_doc.py ."]
    cells = re.findall(r"^\| (`.*?) \|", (options.root / "docs/validation.md").read_text(), re.M)
    explained = {name for cell in cells for name in re.findall(r"`(\w+)`", cell)}
    faults += [f"docs/validation.md: no row explains the check {name}" for name in of_tables if name not in explained]
    print("\n".join(faults) or f"{text.count('| `')} checks")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
