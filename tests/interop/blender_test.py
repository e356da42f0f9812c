#!/usr/bin/env python3
# ctest: interop.blender label=interop timeout=1800 setup=clients needs=plain @brdf@ blender @here@/blender
"""blender_test.py BRDF BLENDER FOLDER: exports materials to Blender 3.4, measures them there with a virtual goniometer, and
compares every value with the target that the export names, and the measured loss with the stated loss."""
import csv
import math
import pathlib
import shutil
import struct
import subprocess
import sys

from exported import Exports, Judged
from measured import rows_of


def in_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def cost_of_float(alpha, pairs):
    """Returns the largest relative error at these pairs that float arithmetic causes in the isotropic
    D = alpha^2/(pi c^4 (alpha^2 + tan^2)^2) of Cycles: Cycles computes tan^2 as (1 - c^2)/c^2 from a cosine c of directions in
    float (bsdf_microfacet_ggx_eval_reflect)."""
    worst, a2 = 0, alpha * alpha
    for theta_i, phi_i, theta_o, phi_o in (map(math.radians, pair) for pair in pairs):
        w = [(math.sin(t) * math.cos(p), math.sin(t) * math.sin(p), math.cos(t)) for t, p in ((theta_i, phi_i), (theta_o, phi_o))]
        h = [a + b for a, b in zip(*w)]
        exact = a2 + (h[0] ** 2 + h[1] ** 2) / h[2] ** 2
        x, y, z = (in_float(in_float(a) + in_float(b)) for a, b in zip(*w))
        length = in_float(math.sqrt(in_float(in_float(in_float(x * x) + in_float(y * y)) + in_float(z * z))))
        c = in_float(z / length)
        c2 = in_float(c * c)
        rounded = a2 + in_float(in_float(1 - c2) / c2)
        worst = max(worst, abs((exact / rounded) ** 2 - 1))
    return worst


def tolerance(widths, pairs):
    """Returns the relative bound for a renderer in float: 1e-5, and for a narrow isotropic lobe its rounding error."""
    return max(1e-5, 1.5 * cost_of_float(widths[0], pairs)) if widths and widths[0] == widths[1] else 1e-5


def left_out(export):
    """Returns the largest f_r of a diffuse part that Cycles does not evaluate, that is, of parts with a weight below 1e-5."""
    named = export.named()
    weight = (1 - float(named.get("metallic", 1))) * max(map(float, named.get("base_color", "0").split(",")))
    return weight if weight < 1e-5 else 0


def shown(blender, exports):
    """Returns f_r in Blender of every material at its pairs."""
    scripts = []
    for name, export in exports.of.items():
        (exports.folder / f"{name}_pairs.csv").write_text(rows_of(exports.pairs_of(name)))
        scripts.append(export.path)
    gonio = pathlib.Path(__file__).with_name("blender_goniometer.py")
    run = subprocess.run([blender, "-b", "--factory-startup", "--python-exit-code", "1", "--python", gonio, "--", *scripts],
                         text=True, capture_output=True)
    if run.returncode:
        sys.exit(run.stdout + run.stderr)
    for name in exports.of:
        with open(exports.folder / f"{name}.csv") as file:
            yield name, [[float(x) for x in row] for row in csv.reader(file)]


def main():
    brdf, blender, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    if not shutil.which(blender):
        sys.exit("no Blender: tools/setup interop installs it")
    version = subprocess.run([blender, "--version"], check=True, text=True, capture_output=True).stdout.split()[1]
    exports = Exports(brdf, "blender-3.4", ".py", folder)
    judged = Judged(exports, f"Blender {version}, Cycles")
    for name, seen in shown(blender, exports):
        export = exports.of[name]
        judged.add(name, seen, tolerance(export.widths(), exports.pairs_of(name)), left_out(export))
    sys.exit(not judged.end())


main()
