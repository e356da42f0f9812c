# ctest: cli.same_bytes label=cli,driver cost=60 @brdf@ @source@
"""Tests that the same command writes the same bytes on 1, 2 and 3 threads, under a locale with decimal commas, and from another
folder each time. Usage: determinism_test.py EXECUTABLE SOURCE_TREE; exit code 77 if the locale cannot be made. The run on two threads
and the pictures of `study` and `recommend` belong to ./test --full (BRDF_THOROUGH), because they take most of the time.

`trade`, and `recommend` without a ledger, are left out because they measure time. `recommend` is also left out if the ledger lacks a
form.
"""
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

executable, tree = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
data = tree / "data"

# The commands share a folder, so that a command can read the files of earlier commands.
COMMANDS = [
    "models --json",
    "synth --form ward --set alpha_x=0.1 --set alpha_y=0.3 --grid in_plane --azimuths 0,45,90 --noise 0.05 --seed 7 -o w.csv",
    "synth --form cook_torrance --set alpha=0.2 --noise 0.02 --sigma-columns --aperture 1 -o c.csv",
    "synth --microsurface gaussian --set alpha=0.3 --theta-i 30 --surfaces 8 --rays 4096 --size 128 --threads {threads} -o m.csv",
    "synth --microsurface lambert_grooves --set sigma=0.3 --theta-i 45 --surfaces 8 --rays 512 --threads {threads} -o g.csv",
    "eval --form ward c.csv",
    "eval --form oren_nayar -o e.csv w.csv",
    "convert m.csv converted.csv",
    "fit c.csv --form all --json -o c.json --report c.html",
    "fit w.csv --form ward --anisotropic --json -o w.json",
    "fit m.csv g.csv --form lambert+ward --jobs {threads} --no-pictures -o batch",
    "study g.csv c.csv --form ward --jobs {threads} --json -o studied {pictures}",
    "next g.csv --reach w.csv --form lambert --form phong --rows 8 --json -o next.csv",
    "albedo --material c.json --theta 0,30,60,85 --json",
    "validate c.json --json -o v.html",
    "validate --form ward --form oren_nayar_full --json",
    "validate --form lambert --form phong --numerics --json",
    "prove --form oren_nayar --property finite,non_negative --json -o certificate.json",
    "synth --form ward --set kd=0.3,0.2,0.1 --texels 16x16 --lights 20 --vary alpha=0.1:0.4 --tilt 20 --noise 0.02 -o stack",
    "fit stack --form ward --normals fit --jobs {threads} --json -o maps --report maps.html",
    "fit g.csv --form ward --bootstrap 20 --json -o g.json",
    "eval --shader {data}/shaders/sound.glsl w.csv",
    "convert w.csv w.astm",
    "export --material c.json --to gltf -o c.gltf",
    "export --material c.json --to glsl -o c.glsl",
    "export --material c.json --to glsl-es -o c.es.glsl",
    "render c.json --width 96 --height 96 --compare embree --json -o c.png",
    "render w.json --width 64 --height 64 -o w.exr",
]
THOROUGH = "BRDF_THOROUGH" in os.environ
if THOROUGH:
    COMMANDS.append("recommend --scene {data}/scenes/recommend_grazing.json --reference c.json --ledger {data}/ledger.json --json -o advice")
LOCALE = "de_DE.UTF-8"


def digests(folder):
    return {str(p.relative_to(folder)): hashlib.sha256(p.read_bytes()).hexdigest()
            for p in sorted(folder.rglob("*")) if p.is_file()}


def outputs(threads, **environment):
    """Returns the exit code, stdout and every file of all commands, run in a new folder."""
    with tempfile.TemporaryDirectory(prefix="determinism.") as name:
        folder, told = pathlib.Path(name), {}
        for command in COMMANDS:
            if command.startswith(("render", "recommend", "synth --microsurface")) and not can_render:
                continue
            words = command.format(threads=threads, data=data, pictures="" if THOROUGH else "--no-pictures").split()
            done = subprocess.run([executable, *words], cwd=folder, capture_output=True, check=False,
                                  env=os.environ | {"BRDF_THREADS": str(threads)} | environment)
            if command.startswith("recommend") and json.loads(done.stdout)["measured_now"]:
                print("left out: recommend:", json.loads(done.stdout)["measured_now"])
                shutil.rmtree(folder / "advice")
                continue
            said = re.sub(rb'"(ms|seconds)": [^,\n]*', b"", done.stdout)  # how long it took
            told[command] = (done.returncode, hashlib.sha256(said).hexdigest())
            if done.returncode not in (0, 1):
                sys.exit(f"{command}: exit {done.returncode}: {done.stderr.decode()}")
        return told | {"FILE " + path: digest for path, digest in digests(folder).items()}


def german_locale(folder):
    """Compiles the locale for the test, so that the machine need not have it."""
    made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", f"{folder}/{LOCALE}"], capture_output=True, check=False)
    return (pathlib.Path(folder) / LOCALE).is_dir(), made.stderr.decode()


can_render = subprocess.run([executable, "render", "--help"], capture_output=True, check=False).returncode == 0
with tempfile.TemporaryDirectory(prefix="locale.") as locales:
    made, why = german_locale(locales)
    if not made:
        print(f"the locale {LOCALE} cannot be made (package locales): {why}")
        sys.exit(77)
    first = outputs(1)
    variants = {"on three threads, with decimal commas": outputs(3, LC_ALL=LOCALE, LOCPATH=locales)}
    if THOROUGH:
        variants["on two threads"] = outputs(2)
differing = 0
for variant, found in variants.items():
    for what in sorted(first.keys() | found.keys()):
        if first.get(what) != found.get(what):
            print(f"{variant}: {what} differs")
            differing += 1
print(f"{len(COMMANDS)} commands, {len(first) - len(COMMANDS)} files, {1 + len(variants)} runs: {differing} differences")
sys.exit(differing != 0)
