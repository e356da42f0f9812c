#!/usr/bin/env python3
# ctest: style.documents label=style,driver timeout=900 cost=50 needs=brdf_micro --brdf @brdf@ @source@/README.md @source@/docs/tour.md @source@/docs/data.md @source@/docs/howto --quick
# ctest: documents.all label=slow,driver timeout=900 needs=brdf_micro --brdf @brdf@ @source@/README.md @source@/docs/tour.md @source@/docs/data.md @source@/docs/howto
"""Runs the commands of documents and compares their output with the output in the document.

    tools/run_documents.py [--update] [--quick] --brdf build/release/brdf README.md docs/tour.md docs/data.md docs/howto

A folder means every Markdown file in it, so that no page is forgotten. A document without a command fails.
A command is an indented line that starts with `$ brdf`; `\\` continues it. The indented lines after it are its
output, to the next command or the end of the block; a line `...` matches any number of lines. Words must be equal,
numbers within 2 % (below 1e-5 any two numbers are equal: they are rounding). A command that ends in `# times vary` is
run, but its output is not compared; a command marked `# half a minute` or `# some seconds` is left out by --quick. A command that
exits with 2, 3 or more than 4 (bad input, a missing driver) fails. Commands of one document run in one scratch folder, in order, so that a
command may read the output of an earlier one; `data` in this folder is the repository's. If BRDF_DATA_DIR is unset, a command that
names the variable is left out and reported. Output that names a form which docs/models.md does not have yet is listed, not
compared. A table headed `| verb | purpose |` lists the verbs of `brdf --help`, in its order and words. --update writes the real
output, and that table, into the document.
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

INDENT = "    "
VERBS = "| verb | purpose |"


def blocks(lines):
    """Yields (command, line after the command, line after its output) of every command."""
    k = 0
    while k < len(lines):
        if not lines[k].startswith(INDENT + "$ brdf "):
            k += 1
            continue
        command = lines[k][len(INDENT) + 2 :]
        k += 1
        while command.endswith("\\"):
            command = command[:-1] + lines[k].strip()
            k += 1
        begin = end = k
        while k < len(lines) and (not lines[k] or lines[k].startswith(INDENT)) and not lines[k].startswith(INDENT + "$ "):
            k += 1
            if lines[k - 1]:
                end = k  # an empty line belongs to the output if more output follows
        yield command, begin, end


def same_token(expected, printed):
    strip = lambda text: text.strip("%,;:()")
    try:
        a, b = float(strip(expected)), float(strip(printed))
    except ValueError:
        return expected == printed
    return max(abs(a), abs(b)) < 1e-5 or abs(a - b) <= 0.02 * max(abs(a), abs(b))


def same_line(expected, printed):
    a, b = expected.replace(",", " ").split(), printed.replace(",", " ").split()
    return len(a) == len(b) and all(map(same_token, a, b))


def difference(expected, printed):
    """Returns the first line that differs, as text; None if the output is as shown."""
    if "..." in expected:
        cut = expected.index("...")
        head, tail = expected[:cut], expected[cut + 1 :]
        if len(printed) < len(head) + len(tail):
            return f"expected at least {len(head) + len(tail)} lines, printed {len(printed)}"
        expected, printed = head + tail, printed[: len(head)] + printed[len(printed) - len(tail) :]
    for a, b in zip(expected, printed):
        if not same_line(a, b):
            return f"shown:   {a}\n  printed: {b}"
    if len(expected) != len(printed):
        return f"shown {len(expected)} lines, printed {len(printed)}"
    return None


def shortened(expected, printed):
    """Returns the printed lines, shortened at the places at which the document shortens them."""
    if "..." not in expected or len(printed) < len(expected):
        return printed
    cut = expected.index("...")
    return printed[:cut] + ["..."] + printed[len(printed) - (len(expected) - cut - 1) :]


def forms_without_a_page(brdf):
    listed = json.loads(subprocess.run([brdf, "models", "--json"], check=True, capture_output=True, text=True).stdout)
    page = (pathlib.Path(__file__).resolve().parents[1] / "docs/models.md").read_text()
    return [form["form"] for form in listed["forms"] if f"`{form['form']}`" not in page]


def verbs_of_help(brdf):
    """Rows of the table of verbs: name and description, in the order of `brdf --help`."""
    rows = []
    text = subprocess.run([brdf, "--help"], check=True, capture_output=True, text=True).stdout
    for line in text.partition("\nOptions:\n")[2].split("\n"):  # the introduction above it may have lines of the same shape
        if found := re.match(r"  (\w[\w-]*) +(\S.*)", line):
            rows.append([found[1], found[2]])
        elif rows and line.startswith(" " * 30) and line.strip():
            rows[-1][1] += " " + line.strip()
    return [f"| `{verb}` | {text} |" for verb, text in rows]


def check_verbs(document, brdf, lines, update):
    """Returns whether the document's table of verbs, if it has one, equals the table of the help. For an update, the table in `lines` is
    replaced."""
    if VERBS not in lines:
        return True
    begin = end = lines.index(VERBS) + 2
    while end < len(lines) and lines[end].startswith("|"):
        end += 1
    rows = verbs_of_help(brdf)
    if update:
        lines[begin:end] = rows
    elif lines[begin:end] != rows:
        print(f"{document}:{begin}: the table of verbs is not that of brdf --help: give --update")
        return False
    return True


def check(document, brdf, update, quick):
    young = forms_without_a_page(brdf)
    lines = document.read_text().split("\n")
    failed = 0 if check_verbs(document, brdf, lines, update) else 1
    ran, left_out = int(VERBS in lines), 0
    replacements = []
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(pathlib.Path(__file__).resolve().parent.parent / "data", f"{folder}/data")
        os.makedirs(f"{folder}/docs/img")
        for command, begin, end in blocks(lines):
            if "$BRDF_DATA_DIR" in command and not os.environ.get("BRDF_DATA_DIR"):
                print(f"{document}:{begin}: left out, BRDF_DATA_DIR is unset: {command}")
                left_out += 1
                continue
            if quick and re.search("# (half a minute|some seconds)", command):
                print(f"{document}:{begin}: left out by --quick: {command}")
                left_out += 1
                continue
            run = subprocess.run(
                ["bash", "-c", f'brdf() {{ "{brdf}" "$@" 2>&1; }}; {command}\n'], cwd=folder, stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT, text=True, check=False)
            ran += 1
            if run.returncode in (2, 3) or run.returncode > 4:
                failed += 1
                print(f"{document}:{begin}: exit code {run.returncode}: {command}\n  {run.stdout.strip()}")
                continue
            printed = [line.rstrip() for line in run.stdout.rstrip("\n").split("\n")] if run.stdout else []
            expected = [line[len(INDENT) :].rstrip() for line in lines[begin:end]]
            if update:
                replacements.append((begin, end, [(INDENT + line).rstrip() for line in shortened(expected, printed)]))
                continue
            named = sorted({form for form in young if re.search(rf"\b{form}\b", run.stdout)})
            if named:
                print(f"{document}:{begin}: not compared, names {', '.join(named)}: {command}")
                continue
            wrong = None if command.endswith("times vary") else difference(expected, printed)
            if wrong:
                failed += 1
                print(f"{document}:{begin}: {command}\n  {wrong}")
    for begin, end, output in reversed(replacements):
        lines[begin:end] = output
    if update:
        document.write_text("\n".join(lines))
    print(f"{document}: {ran} commands and tables, {failed} differ from what is shown")
    return ran + left_out > 0 and failed == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("documents", nargs="+", type=pathlib.Path)
    parser.add_argument("--brdf", required=True, help="the program")
    parser.add_argument("--update", action="store_true", help="write the real output into the documents")
    parser.add_argument("--quick", action="store_true", help="leave out what says that it takes long")
    options = parser.parse_args()
    brdf = pathlib.Path(options.brdf).resolve()
    documents = [d for given in options.documents for d in (sorted(given.glob("*.md")) if given.is_dir() else [given])]
    good = [check(document, brdf, options.update, options.quick) for document in documents]
    sys.exit(0 if good and all(good) else 1)


if __name__ == "__main__":
    main()
