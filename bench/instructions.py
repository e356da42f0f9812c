#!/usr/bin/env python3
"""The instructions in the loop of each form's batch, for the widest vectors that this compiler made code for.

    python3 bench/instructions.py build/release [FORM...]

bench_eval's limit counts additions and multiplications in pairs, because a fused multiply-add does two of them. A batch has an instruction
for each, because its values have the same bits on every machine, and it has comparisons, selections and moves, which the limit
does not count. The last column is the share of the limit at one instruction in the time of a fused multiply-add; a processor with more
units for additions, selections or moves than for multiplications does better. It says nothing about forms whose limit is set by the
divider. A form that is evaluated pair by pair has no loop with vectors to count. The table is written as Markdown. Needs objdump and nm
(binutils), and build/release/bench/bench_eval (`ninja -C build/release bench_eval`).
"""
import argparse
import collections
import pathlib
import re
import subprocess
import sys

TYPES = {"d": "double", "f": "float"}
CLASSES = {  # the first that matches
    "arithmetic": r"vf?n?m?(mul|add|sub)(add|sub)?(\d{3})?[ps][sd]$",
    "divisions, roots": r"v(div|sqrt)[ps][sd]$",
    "comparisons, selections": r"v(cmp|u?comis|blend|min|max|and|or|xor|pcmp|pblend|pand|por|pxor|ptern|ptest|range)|k",
    "integers, conversions": r"v(p(add|sub|s[lr]|mul|abs|min|max)|cvt|scalef|rndscale|getexp|getmant)",
    "moves": r"v(mov|zeroupper|broadcast|perm|pbroadcast|pgather|gather|insert|extract|unpck|shuf|p?compress|p?expand|pmov)",
}


def output(*words):
    return subprocess.run(words, capture_output=True, text=True, check=True).stdout


def loop_of(binary, symbol):
    """Returns the mnemonics of the innermost loop with the most vector instructions; None without vectors, or if the loop calls a function."""
    code = [(int(m[1], 16), m[2].strip()) for line in output("objdump", "-d", "--no-show-raw-insn", f"--disassemble={symbol}", binary).splitlines()
            if (m := re.match(r"\s+([0-9a-f]+):\s+(.*)", line))]
    jumps = [(int(m[1], 16), at) for at, words in code if (m := re.match(r"j\w+\s+([0-9a-f]+)", words)) and code[0][0] <= int(m[1], 16) < at]
    innermost = [(a, b) for a, b in jumps if not any((c, d) != (a, b) and a <= c and d <= b for c, d in jumps)]
    loops = [[words for place, words in code if first <= place <= last] for first, last in innermost]
    body = max(loops, key=lambda words: sum("%zmm" in w for w in words))
    if not any("%zmm" in words for words in body) or any(words.startswith("call") for words in body):
        return None
    return [words.split()[0] for words in body]


def class_of(mnemonic):
    """
    >>> [class_of(m) for m in ("vmulpd", "vfmadd231ps", "vsqrtps", "vblendmpd", "vpsllq", "vmovupd", "jne")]
    ['arithmetic', 'arithmetic', 'divisions, roots', 'comparisons, selections', 'integers, conversions', 'moves', 'loop']
    """
    found = next((name for name, pattern in CLASSES.items() if re.match(pattern, mnemonic)), "loop")
    if found == "loop" and mnemonic.startswith("v"):
        sys.exit(f"{mnemonic}: no class of CLASSES holds this vector instruction")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("forms", nargs="*", metavar="FORM")
    options = parser.parse_args()
    binary = str(options.build / "bench/bench_eval")
    symbols = {}
    for line in output("nm", binary).splitlines():
        if m := re.search(r" (\S*15eval_directionsINS_\d+(\w+?)E([df])Lb1EE\S*\.arch_x86_64_v4)$", line):
            symbols[m[2], m[3]] = m[1]
    if unknown := set(options.forms) - {form for form, _ in symbols}:
        sys.exit(f"{binary} has no batch for 512-bit vectors of {', '.join(sorted(unknown))}")
    names = [*CLASSES, "loop"]
    print(f"| form | type | {' | '.join(names)} | share of the limit |\n|---|---|{'---:|' * (len(names) + 1)}")
    for (form, kind), symbol in sorted(symbols.items()):
        if options.forms and form not in options.forms:
            continue
        body = loop_of(binary, symbol)
        if body is None:
            print(f"| {form} | {TYPES[kind]} |{' - |' * len(names)} no vectors |")
            continue
        count = collections.Counter(map(class_of, body))
        fused = sum("fm" in m or "fnm" in m for m in body)
        paid = sum(count.values()) - count["loop"] - count["divisions, roots"]
        share = (count["arithmetic"] + fused) / 2 / paid
        print(f"| {form} | {TYPES[kind]} | {' | '.join(str(count[n]) for n in names)} | {share:.2f} |")


if __name__ == "__main__":
    main()
