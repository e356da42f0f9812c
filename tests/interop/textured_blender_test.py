#!/usr/bin/env python3
# ctest: interop.textured_blender label=interop timeout=1800 setup=clients needs=plain @brdf@ blender @here@/textured_blender
"""textured_blender_test.py BRDF BLENDER FOLDER: exports fitted maps to Blender 3.4, and measures stated texels there with the virtual
goniometer: each value must be that of the target with the parameters that the export states."""
import csv
import pathlib
import shutil
import subprocess
import sys

from measured import rows_of
from textured import STACKS, exported, fitted_maps

BOUND = 5e-5  # relative, for a renderer in float


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def is_unchanged(normal, wi, wo):
    """Returns whether Cycles shades a normal of a texture as it is: it darkens the diffuse part of a light that is nearer to the
    horizon of the plane than to that of the normal (bump_shadowing_term), and bends a normal that mirrors the viewer below the plane
    (ensure_valid_reflection)."""
    mirrored = 2 * dot(normal, wo) * normal[2] - wo[2]
    return wi[2] >= dot(normal, wi) * normal[2] and mirrored >= min(0.9 * wo[2], 0.01)


def main():
    brdf, blender, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    if not shutil.which(blender):
        sys.exit("no Blender: tools/setup interop installs it")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    places = {}
    for name in STACKS:
        places[name] = exported(brdf, fitted_maps(brdf, name, folder), "blender-3.4", folder / f"{name}.py")
        # The last place is measured a second time at another texel, where the values must differ.
        shown = [*places[name], places[name][0]]
        (folder / f"{name}_places.csv").write_text(rows_of([*(p.centre() for p in places[name]), places[name][1].centre()]))
        for k, place in enumerate(shown):
            (folder / f"{name}_{k}_pairs.csv").write_text(rows_of(place.pairs))
    gonio = pathlib.Path(__file__).with_name("blender_goniometer.py")
    run = subprocess.run([blender, "-b", "--factory-startup", "--python-exit-code", "1", "--python", gonio, "--",
                          *(folder / f"{name}.py" for name in STACKS)], text=True, capture_output=True)
    if run.returncode:
        sys.exit(run.stdout + run.stderr)
    good = []
    for name, of_maps in places.items():
        print(name)
        for k, place in enumerate([*of_maps, of_maps[0]]):
            with open(folder / f"{name}_{k}.csv") as file:
                seen = [[float(x) for x in row] for row in csv.reader(file)]
            right = place.judge(brdf, folder, seen, BOUND, "another texel" if k == 3 else "",
                                is_unchanged if name == "tilted" else lambda normal, wi, wo: True)
            good.append(right != (k == 3))
    assert len(good) == 4 * len(STACKS)
    sys.exit(not all(good))


main()
