#!/usr/bin/env python3
# ctest: cli.terminal label=cli @brdf@
"""Compares the output at 60, 80 and 200 columns with tests/cli/terminal/COLUMNS.txt. Lines and words must be equal, and numbers
must agree within 2 %, as in the documents. No line may be wider than the terminal, except a single word that is wider. Output
that names a form which docs/models.md lacks is listed and not compared.

    recorded_test.py BRDF [--update]

--update writes the present output into the files.
"""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent
spec = importlib.util.spec_from_file_location("run_documents", here.parents[1] / "tools/run_documents.py")
documents = importlib.util.module_from_spec(spec)
spec.loader.exec_module(documents)

COMMANDS = [
    "brdf",
    "brdf fit --help",
    "brdf models ward",
    "brdf fitt samples.csv",
    "brdf fit samples.csv --form ggx",
    "brdf synth --form cook_torrance --set alpha=0.2 --grid in_plane --noise 0.02 --seed 7 -o samples.csv",
    "brdf fit samples.csv --form all -o paint.json",
    "brdf validate --form ward",
    "brdf albedo --form lambert --theta 0,60",
]


def shown(brdf, columns):
    """Returns every command with the lines of its output."""
    blocks = []
    environment = os.environ | {"COLUMNS": str(columns), "NO_COLOR": "1", "LC_ALL": "C.UTF-8"}
    with tempfile.TemporaryDirectory() as folder:
        for command in COMMANDS:
            done = subprocess.run([brdf, *command.split()[1:]], cwd=folder, env=environment, text=True, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
            blocks.append([f"$ {command}", *(line.rstrip() for line in done.stdout.rstrip("\n").split("\n")),
                           f"(exit code {done.returncode})"])
    return blocks


def recorded(file):
    return [("$ " + block).split("\n") for block in re.split(r"(?:\A|\n\n)\$ ", file.read_text().rstrip("\n"))[1:]]


brdf, update = pathlib.Path(sys.argv[1]).resolve(), "--update" in sys.argv[2:]
young = documents.forms_without_a_page(brdf)
failed = False
for columns in (60, 80, 200):
    file, blocks = here / f"terminal/{columns}.txt", shown(brdf, columns)
    # An error is one line, for programs to read.
    wide = [line for block in blocks for line in block
            if len(line) > columns and not line.startswith(("$ ", "brdf")) and len(line.split()) > 1]
    for line in wide:
        print(f"{columns} columns: {len(line)} wide: {line}")
    failed |= bool(wide)
    if update:
        file.write_text("\n\n".join("\n".join(block) for block in blocks) + "\n")
        continue
    before = recorded(file)
    if [block[0] for block in before] != [block[0] for block in blocks]:
        print(f"{file.name}: holds other commands\n(recorded_test.py BRDF --update where that is meant)")
        failed = True
    for was, now in zip(before, blocks):
        named = [form for form in young if any(re.search(rf"\b{form}\b", line) for line in now)]
        if named:
            print(f"not compared, {', '.join(named)} is younger than {file.name}: {now[0]}")
            continue
        differs = documents.difference(was, now)
        if differs:
            print(f"{file.name}: {differs}\n(recorded_test.py BRDF --update where that is meant)")
            failed = True
sys.exit(failed)
