#!/usr/bin/env python3
# ctest: exports.table_files label=exports needs=plain @brdf@ @here@/table_files
"""table_files_test.py BRDF FOLDER: a lookup table has the numbers of its layout's program: 16-bit floats in OpenEXR for half, a PNG for
8 bits, and no PNG for other numbers."""
import json
import math
import pathlib
import shutil
import struct
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "render"))
from pixels import png

brdf, folder = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
FLOAT, HALF = 2, 1  # OpenEXR's types of channels


def export(layout, name, code=0):
    """Returns the JSON of the export, or the message of a refusal."""
    run = subprocess.run([brdf, "export", "--form", "cook_torrance", "--to", "dfg", "--table-layout", layout, "-o", folder / name, "--json",
                          "--quiet"], text=True, capture_output=True, check=False)
    assert run.returncode == code, run.stderr
    return json.loads(run.stdout) if code == 0 else run.stderr


def types_of_channels(name):
    """Returns the types of an OpenEXR image's channels."""
    data = (folder / name).read_bytes()
    at, types = data.index(b"channels\0chlist\0") + len(b"channels\0chlist\0") + 4, []
    while data[at]:
        at = data.index(b"\0", at) + 1
        types.append(struct.unpack_from("<i", data, at)[0])
        at += 16
    return types


for layout, kind in (("three", HALF), ("unity", FLOAT)):
    export(layout, f"{layout}.exr")
    assert types_of_channels(f"{layout}.exr") == [kind, kind], (layout, types_of_channels(f"{layout}.exr"))
    for wrong in (f"{layout}.png", f"{layout}.dds"):
        said = export(layout, wrong, 2)
        assert ("write .exr" if wrong.endswith("png") else "known: .exr") in said and not (folder / wrong).exists(), said

assert export("gltf", "gltf.png")["table"]["format"] == "8 bits"
rows = png((folder / "gltf.png").read_bytes())
assert len(rows) == 256 and all(len(row) == 256 for row in rows)
# Scale and bias are the albedo of the lobe with f0 = 1 by another way, each rounded to 1/255.
for x, y in ((200, 60), (30, 128), (250, 250), (100, 20)):
    cosine, alpha = (x + 0.5) / 256, ((y + 0.5) / 256) ** 2
    run = subprocess.run([brdf, "albedo", "--form", "cook_torrance", "--set", "kd=0", "--set", "ks=1", "--set", "f0=1", "--set",
                          f"alpha={alpha!r}", "--theta", repr(math.degrees(math.acos(cosine))), "--json"], text=True, capture_output=True,
                         check=True)
    albedo, (scale, bias, blue) = json.loads(run.stdout)["results"][0]["value"], rows[y][x]
    print(f"texel ({x}, {y}): scale {scale}, bias {bias} of 255; albedo {255 * albedo:.2f}")
    assert blue == 0 and abs(scale + bias - 255 * albedo) <= 1.01, (x, y)
