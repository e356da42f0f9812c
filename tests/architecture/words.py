#!/usr/bin/env python3
# ctest: style.words label=style @source@ --check
"""Counts words that make English hard to read, per 1,000 words: in the comments of every room and of scripts, in documents, and in
messages.

    words.py ROOT [--check | --update | --lines GROUP]

Groups: a room (the comments of its C++), `scripts` (comments and docstrings of Python and shell), `documents` (Markdown without code)
and `messages` (string literals with a blank). Ceilings are in tests/words.json; no ceiling is below the target. --check fails if a group has more than one occurrence above one of its ceilings; --update
lowers ceilings to the present figures and raises no ceiling; --lines prints the lines of a group that hold such words.
"""
import argparse
import collections
import json
import math
import pathlib
import re
import sys

import rooms

# A word, its target (twice the frequency in the public headers of Ceres Solver, at least 0.2), and the reason why it is counted.
WORDS = {
    "what": (0.8, "used as a noun instead of a noun"),
    "where": (4.6, "used for if or when"),
    "none": (0.2, "used for null, empty or no value"),
    "those": (0.2, "used for a noun of the sentence before"),
    "it": (9.5, "used for a noun that the reader must look for"),
    "beside(?:s)?": (0.2, "used for with, next to, in addition"),
    "told|tells?": (0.2, "used for detected, passed, reported"),
    "says?|said": (0.2, "used for states, gives, names"),
    "stands?|stood": (0.2, "used for is, depends, is placed"),
    "whose": (0.4, "used for a second sentence"),
}
TOKEN = re.compile(r"""//[^\n]*|/\*.*?\*/|R"([^(\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'""", re.S)
IN_SCRIPT = re.compile(r'"""(.*?)"""|^[ \t]*#(?![!]| ctest:)([^\n]*)', re.M | re.S)
NOT_PROSE = re.compile(r"^(?:```|~~~).*?^(?:```|~~~)|^(?: {4}|\t).*?$|`[^`\n]*`|\]\([^)]*\)", re.M | re.S)


def pieces(name, text):
    """Returns (group, line, prose) of a file."""
    if name.endswith(".md"):
        cleaned = NOT_PROSE.sub(lambda m: "\n" * m[0].count("\n"), text)
        return [("documents", k, line) for k, line in enumerate(cleaned.split("\n"), 1)]
    if not name.endswith((".h", ".cpp")):
        return [("scripts", text.count("\n", 0, m.start()) + 1 + k, line) for m in IN_SCRIPT.finditer(text)
                for k, line in enumerate((m[1] or m[2] or "").replace("None", "").split("\n"))]  # None is a value of Python
    found, room = [], name.split("/")[0]
    for m in TOKEN.finditer(text):
        line = text.count("\n", 0, m.start()) + 1
        if m[0].startswith("/"):
            found += [(room, line + k, part) for k, part in enumerate(m[0].split("\n"))]
        elif m[0].startswith('"') and " " in m[0] and room not in ("tests", "bench"):
            found.append(("messages", line, m[0].replace("\\n", " ")))
    return found


def all_pieces(root):
    for name in rooms.files(root):
        if name.endswith((".h", ".cpp", ".md", ".py")) or is_script(root / name):
            yield from ((group, f"{name}:{line}", prose) for group, line, prose in pieces(name, (root / name).read_text()))


def is_script(path):
    """Returns whether the file is a script of Python or of a shell without a suffix."""
    with path.open("rb") as file:
        return path.suffix == "" and re.match(rb"#!.*\b(python3?|bash|sh)\b", file.readline()) is not None


def hits(prose):
    return {word: len(re.findall(rf"\b(?:{word})\b", prose, re.I)) for word in WORDS}


def counted(root):
    """Returns {group: (words, {word: occurrences})}"""
    counts, words = collections.defaultdict(collections.Counter), collections.Counter()
    for group, _, prose in all_pieces(root):
        words[group] += len(re.findall(r"[A-Za-z][A-Za-z'-]*", prose))
        counts[group].update(hits(prose))
    return {group: (words[group], counts[group]) for group in sorted(words) if words[group]}


def faults_of(group, words, counts, ceilings):
    for word, (target, reason) in WORDS.items():
        ceiling = max(target, ceilings.get(word, target))
        if counts[word] > ceiling * words / 1000 + 1:
            yield f"{group}: '{word}' {counts[word]} times in {words} words, the ceiling is {ceiling} per 1,000 words ({reason})"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--lines", metavar="GROUP")
    options = parser.parse_args()
    if options.lines:
        for group, place, prose in all_pieces(options.root):
            if group == options.lines and any(hits(prose).values()):
                print(f"{place}: {prose.strip()}")
        return 0
    stated = options.root / "tests/words.json"
    ceilings = json.loads(stated.read_text()) if stated.exists() else {}
    print(f"{'per 1,000 words':16}" + "".join(f"{word.split('|')[0].split('(')[0]:>8}" for word in WORDS))
    faults, lowered = [], {}
    for group, (words, counts) in counted(options.root).items():
        figure = {word: 1000 * counts[word] / words for word in WORDS}
        print(f"{group:16}" + "".join(f"{figure[word]:8.1f}" for word in WORDS))
        own = ceilings.get(group, {})
        faults += faults_of(group, words, counts, own)
        lowest = {word: min(math.ceil(10 * figure[word]) / 10, own.get(word, math.inf)) for word in WORDS}
        lowered[group] = {word: value for word, value in lowest.items() if value > WORDS[word][0]}
    if options.update:
        stated.write_text(json.dumps({group: own for group, own in lowered.items() if own}, indent=1) + "\n")
        return 0
    print("\n".join(faults) if options.check else "")
    return 1 if options.check and faults else 0


if __name__ == "__main__":
    sys.exit(main())
