#!/usr/bin/env python3
# ctest: style.quality label=style --check
"""Measures the project's quality and writes docs/quality.md: tests of each room, coverage, executions of the fuzz targets, injected faults,
proofs, test clients and benchmarks, each with its command and date.

    tools/quality_page.py --measure NAME...   run the commands of these rows, record their figures with the date, and write the page
    tools/quality_page.py --check             fail if the page differs from the records (tests/quality.json)

The commands need the release build, and the packages of ./test --full for the longer ones. A command that fails records nothing.
"""
import argparse
import collections
import datetime
import doctest
import json
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
RECORDS, PAGE = ROOT / "tests/quality.json", ROOT / "docs/quality.md"


def tests_by_label(out):
    rooms = collections.Counter()
    for test in json.loads(out)["tests"]:
        labels = {p["name"]: p["value"] for p in test.get("properties", [])}.get("LABELS", ["without a label"])
        rooms[labels[0]] += 1
    return {"tests": sum(rooms.values()), **dict(sorted(rooms.items()))}


def coverage_of_rooms(out):
    """
    >>> coverage_of_rooms("io          97.7 % of 9000 lines; floor 97.6 %")
    {'io': '97.7 % of 9000 lines'}
    """
    return {room: f"{share} % of {lines} lines" for room, share, lines in re.findall(r"^(\w+) +([\d.]+) % of (\d+) lines", out, re.M)}


def executions(out):
    """The columns are target, executions, executions per second, slowest input in s, largest memory in MB, result.

    >>> executions("csv   1200   60   0   98  clean\\nply   10   1   0   99  SUMMARY: heap-use-after-free")
    {'targets': 2, 'executions': 1210, 'targets with a finding': 1}
    >>> executions("csv   1200   60   98  clean")
    {}
    """
    rows = re.findall(r"^\w+ +(\d+) +[\d.]+ +[\d.]+ +[\d.]+ +(.+)$", out, re.M)
    if not rows:
        return {}
    return {"targets": len(rows), "executions": sum(int(count) for count, _ in rows),
            "targets with a finding": sum(result != "clean" for _, result in rows)}


def injected(out):
    """
    >>> injected("295 points, 2 deviations")
    {'injected faults': 295, 'deviations': 2}
    """
    points, deviations = re.findall(r"(\d+) points, (\d+) deviations", out)[-1]
    return {"injected faults": int(points), "deviations": int(deviations)}


def verdicts(out):
    results = json.loads(out)["results"]
    counts = collections.Counter(r["verdict"] for r in results)
    return {"results": len(results), **{key.replace("_", " "): counts[key] for key in sorted(counts)}}


def of_suite(out):
    """
    >>> of_suite("1/3 Test #1: a .....***Skipped   0.1 sec\\n67% tests passed, 1 tests failed out of 3")
    {'test clients and their checks': 3, 'failed': 1, 'left out (a program is missing)': 1}
    """
    failed, tests = re.search(r"(\d+) tests failed out of (\d+)", out).groups()
    return {"test clients and their checks": int(tests), "failed": int(failed),
            "left out (a program is missing)": len(re.findall(r"\*\*\*Skipped", out))}


def shares_of_limits(out):
    """
    >>> shares_of_limits("float, ns per evaluation of f cos_i\\nward   30.78   47.09   2.824   1.524   10.9   16.7   54 %   1.98")
    {'ward, float': '54 %'}
    """
    shares, scalar = {}, ""
    for line in out.splitlines():
        if heading := re.match(r"(double|float), ns per evaluation", line):
            scalar = heading[1]
        elif scalar and (row := re.match(r"(\w+) .* (\d+) % ", line)):
            shares[f"{row[1]}, {scalar}"] = f"{row[2]} %"
    return shares


def instructions(out):
    """
    >>> instructions("| form | type | arithmetic | divisions, roots |\\n|---|---|---:|---:|\\n| ward | float | 80 | 3 | 16 | 2 | 11 | 4 | 0.37 |")
    {'ward, float': '80 arithmetic, 3 divisions and roots, 18 others, 11 moves: 37 %'}
    >>> instructions("| retro | float | - | - | - | - | - | - | no vectors |")
    {'retro, float': 'no vectors'}
    """
    found = {}
    for form, kind, counts, share in re.findall(r"^\| (\w+) \| (double|float) \| (.*) \| ([\d.]+|no vectors) \|$", out, re.M):
        found[f"{form}, {kind}"] = share
        if share != "no vectors":
            arithmetic, divider, selections, integers, moves, _ = map(int, counts.split(" | "))
            found[f"{form}, {kind}"] = (f"{arithmetic} arithmetic, {divider} divisions and roots, {selections + integers} others, "
                                        f"{moves} moves: {round(100 * float(share))} %")
    return found


# Name of a row: (command, function from its output to figures, heading, explanation).
FAULTS = "tests/faults/run --brdf build/release/brdf --library build/release/tests/libfaults.so"
ROWS = {
    "tests": ("ctest --test-dir build/release --show-only=json-v1", tests_by_label, "Tests",
              "Tests by their first label: a room of the code, or a piece of `./test`."),
    "coverage": ("tools/coverage", coverage_of_rooms, "Coverage", "Lines that the quick suite runs."),
    "fuzz": ("tests/fuzz/run 20", executions, "Fuzzing", "Every target for 20 s on seeds and on the inputs that earlier runs kept."),
    "faults": (f"{FAULTS} --short", injected, "Injected faults",
               "A system call fails, a signal arrives, or a disk is full; a deviation is a lost file or an unclear message."),
    "proofs": ("build/release/brdf prove --all --json", verdicts, "Proofs",
               "Properties of the forms over their whole domain. A refuted property has a witness, and is a known violation."),
    "clients": ("ctest --test-dir build/release -L ^interop$ -j2", of_suite, "Test clients",
                "Programs that read exported materials, and what they show."),
    "benchmarks": ("build/release/bench/bench_eval", shares_of_limits, "Benchmarks",
                   "Batches: the share of the limit that the machine's throughput sets for the operations of a form. The figures depend on the machine."),
    "instructions": ("bench/instructions.py build/release", instructions, "Instructions of the batches",
                     "The limit counts two additions or multiplications for each instruction. A batch has one for each, because its values have the\n"
                     "same bits on every machine (decision 0024), and it compares, selects and moves. The share is the most of an arithmetic limit\n"
                     "that remains if each instruction takes the time of a fused multiply-add; separate units for additions allow more. It says nothing\n"
                     "about forms whose limit is set by the divider, for example cook_torrance."),
}


def cells(figures):
    return "\n".join(f"| {subject} | {figure:,} |" if isinstance(figure, int) else f"| {subject} | {figure} |"
                     for subject, figure in figures.items())


def page(records):
    missing = ", ".join(sorted(ROWS.keys() - records.keys()))
    parts = ["# Quality\n\nEach figure was printed by the command above it on the stated day. `tools/quality_page.py --measure NAME` measures a\n"
             "part again and writes this page." + (f" Not measured yet: {missing}." if missing else "") + "\n"]
    for name, (command, _, heading, explanation) in ROWS.items():
        if name in records:
            r = records[name]
            parts.append(f"## {heading}\n\n{explanation}\n\n`{command}`, {r['date']}, version {r['version']}:\n\n"
                         f"| subject | figure |\n|---|---:|\n{cells(r['figures'])}\n")
    return "\n".join(parts)


def measure(name, records):
    command, figures, _, _ = ROWS[name]
    done = subprocess.run(shlex.split(command), cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1) or (done.returncode and name != "proofs"):
        sys.exit(f"{name}: {command} ended with {done.returncode}:\n{(done.stdout + done.stderr)[-1500:]}")
    found = figures(done.stdout)
    if not found:
        sys.exit(f"{name}: the output of {command} has no figure")
    version = re.search(r"project\(brdf VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
    records[name] = {"date": datetime.date.today().isoformat(), "version": version, "figures": found}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    choice = parser.add_mutually_exclusive_group(required=True)
    choice.add_argument("--measure", nargs="+", choices=ROWS, metavar="NAME", help=", ".join(ROWS))
    choice.add_argument("--check", action="store_true")
    options = parser.parse_args()
    records = json.loads(RECORDS.read_text()) if RECORDS.exists() else {}
    if options.check:
        if doctest.testmod().failed:
            sys.exit("an example of this program has another result")
        if unknown := records.keys() - ROWS.keys():
            sys.exit(f"{RECORDS.name} has rows that no command measures: {', '.join(sorted(unknown))}")
        if PAGE.read_text() != page(records):
            sys.exit("docs/quality.md differs from tests/quality.json: tools/quality_page.py --measure writes both")
        print(f"{len(records)} of {len(ROWS)} parts are measured")
        return
    for name in options.measure:
        measure(name, records)
        RECORDS.write_text(json.dumps(records, indent=1) + "\n")
        PAGE.write_text(page(records))
        print(name, records[name]["figures"])


if __name__ == "__main__":
    main()
