#!/usr/bin/env python3
# ctest: style.words label=style @source@ --check
"""Words that make English hard to read, per 1,000 words: in the comments of every room, in documents, and in messages.

    words.py ROOT [--check | --update | --lines GROUP]

Groups: a room (the comments of its C++), `documents` (Markdown without code) and `messages` (string literals with a blank). Ceilings are in
tests/words.json. --check fails if a group exceeds one of its ceilings, or has none; --update lowers ceilings to the present figures, and
raises none; --lines prints the lines of a group that hold such words.
"""
import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys

# A word, and the reason why it is counted.
WORDS = {
    "what": "used as a noun instead of a noun",
    "where": "used for if or when",
    "none": "used for null, empty or no value",
    "those": "used for a noun of the sentence before",
    "it": "used for a noun that the reader must look for",
    "beside(?:s)?": "used for with, next to, in addition",
    "told|tells?": "used for detected, passed, reported",
    "says?|said": "used for states, gives, names",
    "stands?|stood": "used for is, depends, is placed",
    "whose": "used for a second sentence",
}
TOKEN = re.compile(r"""//[^\n]*|/\*.*?\*/|R"([^(\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'""", re.S)
NOT_PROSE = re.compile(r"^(?:```|~~~).*?^(?:```|~~~)|^(?: {4}|\t).*?$|`[^`\n]*`|\]\([^)]*\)", re.M | re.S)
SLACK = 1.02  # a sentence more or less moves a small room's figures


def pieces(name, text):
    """(group, line, prose) of a file."""
    if name.endswith(".md"):
        cleaned = NOT_PROSE.sub(lambda m: "\n" * m[0].count("\n"), text)
        return [("documents", k, line) for k, line in enumerate(cleaned.split("\n"), 1)]
    found, room = [], name.split("/")[0]
    for m in TOKEN.finditer(text):
        line = text.count("\n", 0, m.start()) + 1
        if m[0].startswith("/"):
            found += [(room, line + k, part) for k, part in enumerate(m[0].split("\n"))]
        elif m[0].startswith('"') and " " in m[0] and room not in ("tests", "bench"):
            found.append(("messages", line, m[0].replace("\\n", " ")))
    return found


def all_pieces(root):
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=root, text=True, capture_output=True)
    names = listed.stdout.split("\n") if listed.returncode == 0 and listed.stdout else [
        str(p.relative_to(root)) for p in root.rglob("*") if "build" not in p.relative_to(root).parts]
    for name in sorted(n for n in names if n.endswith((".h", ".cpp", ".md")) and (root / n).is_file()):
        yield from ((group, f"{name}:{line}", prose) for group, line, prose in pieces(name, (root / name).read_text()))


def hits(prose):
    return {word: len(re.findall(rf"\b(?:{word})\b", prose, re.I)) for word in WORDS}


def figures(root):
    """{group: {word: times per 1,000 words}}"""
    counts, words = collections.defaultdict(collections.Counter), collections.Counter()
    for group, _, prose in all_pieces(root):
        words[group] += len(re.findall(r"[A-Za-z][A-Za-z'-]*", prose))
        counts[group].update(hits(prose))
    return {group: {word: round(1000 * counts[group][word] / words[group], 1) for word in WORDS} for group in sorted(words) if words[group]}


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
    now = figures(options.root)
    print(f"{'per 1,000 words':16}" + "".join(f"{word.split('|')[0].split('(')[0]:>8}" for word in WORDS))
    faults = []
    for group, figure in now.items():
        print(f"{group:16}" + "".join(f"{figure[word]:8.1f}" for word in WORDS))
        for word, reason in WORDS.items():
            ceiling = ceilings.get(group, {}).get(word)
            if ceiling is None or figure[word] > ceiling * SLACK + 0.05:
                faults.append(f"{group}: '{word}' {figure[word]} times per 1,000 words, the ceiling is {ceiling} ({reason})")
    if options.update:
        lowered = {group: {word: min(figure[word], ceilings.get(group, {}).get(word, figure[word])) for word in WORDS} for group, figure in now.items()}
        stated.write_text(json.dumps(lowered, indent=1) + "\n")
        return 0
    print("\n".join(faults) if options.check else "")
    return 1 if options.check and faults else 0


if __name__ == "__main__":
    sys.exit(main())
