#!/usr/bin/env python3
# ctest: cli.progress label=cli @brdf@
"""progress_test.py BRDF: tests that verbs show their progress in one line on a terminal and erase the line at the end. With
--quiet, or if stderr is not a terminal, they must show no progress."""
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
    "maps rusty_metal --size 64 -o maps": "brdf maps: pictures: 0 of 4",
    "maps lookup -o lookup": "brdf maps: pictures: 1 of ",
    "lobes m.json -o lobes.png": "brdf lobes: drawing the plot",
    "lobes m.json --body -o lobe.png": "brdf lobes: drawing the body",
    "export m.json --to blender -o m.py": "brdf export: converting to Blender",
    "export m.json --to glsl --max-loss 1": "brdf export: comparing the formula with the material",
    "export m.json --to rgl --size 200K -o m.bsdf": "brdf export: computing the values of the table",
    "parity --form lambert": "brdf parity: forms: 0 of 1",
    "check-shader own.glsl": "brdf check-shader: files: 0 of 1",
}
# A build without the renderer lacks these verbs; each of them then ends with exit code 3.
OF_THE_RENDERER = {"maps", "lobes", "parity"}


def on_terminal(command, folder):
    """Returns the text that the command writes to stderr, which is a terminal of 80 columns."""
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
    """Returns the lines that remain on the screen."""
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


listed = subprocess.run([brdf, "--help"], text=True, capture_output=True, check=True).stdout
with tempfile.TemporaryDirectory() as name:
    (pathlib.Path(name) / "own.glsl").write_text("float brdf(vec3 L, vec3 V) { return 0.3; }\n")
    for command, shown in COMMANDS.items():
        verb = command.split()[0]
        if verb in OF_THE_RENDERER and not re.search(rf"^  {verb} ", listed, re.M):
            print(f"not tested: this build has no `brdf {verb}`")
            continue
        written = on_terminal(command, name)
        assert shown in written, (command, written)
        still = left(written)
        assert not any(shown in line or "\r" in line for line in still), (command, still)
        assert shown not in on_terminal(command + " --quiet", name), command
        piped = subprocess.run([brdf, *command.split()], cwd=name, text=True, capture_output=True, check=True)
        assert shown not in piped.stderr and "\x1b[K" not in piped.stderr, (command, piped.stderr)
