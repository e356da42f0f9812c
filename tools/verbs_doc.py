#!/usr/bin/env python3
# ctest: style.verbs label=style needs=brdf_viewer,plain @brdf@ --check
"""verbs_doc.py BRDF [--check]: writes docs/verbs.md, the reference of the verbs, from `BRDF --help` and `BRDF VERB --help`; --check
fails if the page differs from the help of BRDF."""
import argparse
import difflib
import os
import pathlib
import re
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs/verbs.md"
INTRODUCTION = """# The verbs

`tools/verbs_doc.py build/release/brdf` writes this page from the help of the program; a test compares both. `brdf VERB --help`
prints the same text for the width of the terminal, `man brdf-VERB` shows it after an installation. The [tour](tour.md) shows each
verb with its real output, the [how-to pages](index.md#how-to) show tasks.
"""
ENVIRONMENT = os.environ | {"COLUMNS": "100", "NO_COLOR": "1"}


def help_of(brdf, *verb):
    run = subprocess.run([brdf, *verb, "--help"], env=ENVIRONMENT, check=True, capture_output=True, text=True)
    return [line.rstrip() for line in run.stdout.rstrip("\n").split("\n")]


def groups_of(lines):
    """Returns the verbs as {group: [(verb, purpose)]}, in the order of the help of the program."""
    groups, group = {}, None
    for line in lines[lines.index("Options:") + 1 :]:
        if heading := re.fullmatch(r"(\S[^:]*):", line):
            group = heading[1]
        elif group and (row := re.match(r"  (\w[\w-]*)(?: +(\S.*))?$", line)):
            groups.setdefault(group, []).append([row[1], row[2] or ""])
        elif group in groups and re.match(r" {20,}\S", line):
            groups[group][-1][1] = f"{groups[group][-1][1]} {line.strip()}".strip()
    return groups


def page_of(brdf):
    lines = help_of(brdf)
    groups = groups_of(lines)
    assert groups, "brdf --help lists no verbs under a heading"
    page = [INTRODUCTION, "```text", *lines[: lines.index("Options:")], "```", "", "| | verb | purpose |", "|---|---|---|"]
    for group, verbs in groups.items():
        for k, (verb, purpose) in enumerate(verbs):
            page.append(f"| {'' if k else group} | [`{verb}`](#{verb}) | {purpose} |")
    for verb, _ in (row for verbs in groups.values() for row in verbs):
        page += ["", f"## {verb}", "", "```text", *help_of(brdf, verb), "```"]
    text = "\n".join(page) + "\n"
    return re.sub(r"\n{2,}(```\n)", r"\n\1", text)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("brdf", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    text = page_of(options.brdf.resolve())
    if not options.check:
        PAGE.write_text(text)
        return 0
    present = PAGE.read_text() if PAGE.exists() else ""
    if present != text:
        changes = difflib.unified_diff(present.split("\n"), text.split("\n"), "docs/verbs.md", "the help", lineterm="", n=0)
        print("\n".join(list(changes)[:20]))
        print("docs/verbs.md differs from the help: run tools/verbs_doc.py build/release/brdf")
    return int(present != text)


if __name__ == "__main__":
    sys.exit(main())
