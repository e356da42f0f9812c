#!/usr/bin/env python3
# ctest: cli.progress label=cli @brdf@
"""progress_test.py BRDF: on a terminal, verbs show their progress in one line and erase it; with --quiet, and if stderr is not
a terminal, they show none."""
import os
import pathlib
import pty
import re
import subprocess
import sys
import tempfile

brdf = pathlib.Path(sys.argv[1]).resolve()
COMMANDS = {
    "synth --form lambert -o s.csv": "brdf synth: directions: ",
    "fit s.csv --form all -o m.json": "brdf fit: lambert",
    "study s.csv --form lambert --no-pictures -o st": "brdf study: ",
    "validate m.json": "brdf validate: checks: ",
    "prove --form lambert --form ward --property non_negative": "brdf prove: forms: 1 of 2",
    "prove m.json --property non_negative": "brdf prove: materials: 0 of 1",
}


def on_terminal(command, folder):
    """What the command writes on stderr, which is a terminal of 80 columns."""
    ours, theirs = pty.openpty()
    environment = os.environ | {"COLUMNS": "80", "TERM": "xterm", "NO_COLOR": "1"}
    with subprocess.Popen([brdf, *command.split()], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                          stdout=subprocess.DEVNULL, stderr=theirs) as run:
        os.close(theirs)
        written = b""
        while True:
            try:
                block = os.read(ours, 65536)
            except OSError:  # Linux reports the closed other side as an error
                break
            if not block:
                break
            written += block
    os.close(ours)
    assert run.returncode == 0, (command, run.returncode, written)
    return written.decode()


def left(written):
    """What is left on the screen."""
    lines = [""]
    for part in re.split(r"(\r\n|\r|\x1b\[K)", written):
        if part == "\r\n":
            lines.append("")
        elif part == "\r":
            lines[-1] += "\r"
        elif part == "\x1b[K":
            lines[-1] = lines[-1].split("\r")[-1]
        else:
            lines[-1] += part
    return [line for line in lines if line.strip()]


with tempfile.TemporaryDirectory() as name:
    for command, shown in COMMANDS.items():
        written = on_terminal(command, name)
        assert shown in written, (command, written)
        still = left(written)
        assert not any(shown in line or "\r" in line for line in still), (command, still)
        assert shown not in on_terminal(command + " --quiet", name), command
        piped = subprocess.run([brdf, *command.split()], cwd=name, text=True, capture_output=True, check=True)
        assert shown not in piped.stderr and "\x1b[K" not in piped.stderr, (command, piped.stderr)
