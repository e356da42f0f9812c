#!/usr/bin/env python3
"""blender_test.py BRDF BLENDER FOLDER: exports materials to Blender 3.4, measures them there with a virtual goniometer and
compares every value with the target that the export says it wrote, and the loss seen there with that of the target."""
import csv
import math
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import sys

from measured import draw_pairs, evaluated, largest, rms, rows_of, write_directions

brdf, blender, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
PAIRS = 100

MATERIALS = {
    "white": "--form lambert --set rho=0.9,0.5,0.2",
    "glossy": "--form blender_glossy --set kd=0 --set ks=0.9,0.6,0.3 --set alpha=0.15",
    "sum": "--form blender_glossy --set kd=0.3,0.2,0.1 --set ks=0.2 --set alpha=0.3",
    "bright": "--form blender_glossy --set kd=0.2 --set ks=1.5,0.7,0.3 --set alpha=0.25",
    "brushed": "--form blender_glossy --set kd=0.1 --set ks=0.8 --set alpha_x=0.1 --set alpha_y=0.4 --set tangent_phi=30",
    "paint": "--form blender_principled --set base_color=0.6,0.3,0.1 --set metallic=0 --set eta=1.45 --set alpha=0.2",
    "half_metal": "--form blender_principled --set base_color=0.6,0.3,0.1 --set metallic=0.5 --set eta=1.6 --set alpha=0.1",
    "brushed_metal": "--form blender_principled --set base_color=0.9,0.6,0.3 --set metallic=1 --set alpha_x=0.3"
                     " --set alpha_y=0.1 --set tangent_phi=-40",
    "metal": "--form cook_torrance --set kd=0 --set ks=1 --set f0=0.9,0.6,0.3 --set alpha=0.3",
    "narrow": "--form cook_torrance --set kd=0 --set ks=1 --set f0=0.6 --set alpha=0.1",
    "plastic": "--form cook_torrance --set kd=0.3,0.2,0.1 --set ks=0.5 --set f0=0.04 --set alpha=0.2",
    "turned": "--form cook_torrance --set kd=0.1 --set ks=0.9 --set f0=0.5,0.4,0.3 --set alpha_x=0.1 --set alpha_y=0.3"
              " --set tangent_phi=30",
    "satin": "--form cook_torrance --set kd=0.05 --set ks=0.9 --set f0=0.7,0.6,0.5 --set alpha=0.4",
    "rubber": "--form cook_torrance_dielectric --set kd=0.04 --set ks=1 --set eta=1.5 --set alpha=0.5",
    "ward": "--form ward --set kd=0.2 --set ks=0.3 --set alpha=0.2",
    "clay": "--form oren_nayar --set rho=0.6,0.5,0.4 --set sigma=0.4",
}


def in_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def cost_of_float(alpha, pairs):
    """What Cycles' own float costs its isotropic D = alpha^2/(pi c^4 (alpha^2 + tan^2)^2): it forms tan^2 as
    (1 - c^2)/c^2 of a cosine c that it has from directions in float (bsdf_microfacet_ggx_eval_reflect). The largest relative
    error at these pairs."""
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


def tolerance(target, pairs):
    """Relative, of a renderer in float: 1e-5, of a narrow isotropic lobe what its rounding costs."""
    alphas = [float(a) for a in re.findall(r"alpha_[xy]=([0-9.e-]+)", target)]
    return max(1e-5, 1.5 * cost_of_float(alphas[0], pairs)) if alphas and alphas[0] == alphas[1] else 1e-5


def main():
    if not shutil.which(blender):
        sys.exit("no Blender: tools/setup interop installs it")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    pairs = draw_pairs(PAIRS)
    (folder / "pairs.csv").write_text(rows_of(pairs))
    directions = write_directions(folder / "directions.csv", pairs)
    targets, scripts = {}, []
    for name, words in MATERIALS.items():
        script = folder / f"{name}.py"
        subprocess.run([brdf, "export", *shlex.split(words), "--to", "blender-3.4", "-o", script], check=True,
                       capture_output=True)
        targets[name] = re.search(r"# the same here: brdf eval (.*)", script.read_text())[1]
        scripts.append(script)
    gonio = pathlib.Path(__file__).with_name("blender_goniometer.py")
    run = subprocess.run([blender, "-b", "--factory-startup", "--python-exit-code", "1", "--python", gonio, "--",
                          folder / "pairs.csv", *scripts], text=True, capture_output=True)
    if run.returncode:
        sys.exit(run.stdout + run.stderr)
    failed, within = False, 0
    for name, words in MATERIALS.items():
        with open(folder / f"{name}.csv") as file:
            seen = [[float(x) for x in row] for row in csv.reader(file)]
        target, source = evaluated(brdf, targets[name], directions), evaluated(brdf, words, directions)
        assert len(seen) == len(target) == PAIRS
        worst = largest(target, seen)
        said, found = rms(source, target, pairs), rms(source, seen, pairs)
        good = worst < tolerance(targets[name], pairs) and abs(said - found) < 1e-4
        failed |= not good
        within += worst < 1e-5
        print(f"{name:14} largest difference {worst:.2g}, loss said {said:.6f} seen {found:.6f}"
              f"{'' if good else '  FAILED'}")
    print(f"{within} materials within 1e-5")
    sys.exit(failed or within < 12)


main()
