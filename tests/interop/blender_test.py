#!/usr/bin/env python3
"""blender_test.py BRDF BLENDER FOLDER: exports materials to Blender 3.4, measures them there with a virtual goniometer and
compares every value with the target that the export says it wrote, and the loss seen there with that of the target."""
import csv
import math
import pathlib
import random
import re
import shlex
import shutil
import subprocess
import sys

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
    "ward": "--form ward --set kd=0.2 --set ks=0.3 --set alpha=0.2",
    "clay": "--form oren_nayar --set rho=0.6,0.5,0.4 --set sigma=0.4",
}


def tolerance(target):
    """Relative, of a renderer in float: 1e-5, and what rounding n.h to float costs a narrow lobe at its peak."""
    alphas = [float(a) for a in re.findall(r"alpha_[xy]=([0-9.e-]+)", target)]
    return max(1e-5, 3e-7 / min(alphas) ** 2 if alphas else 0)


def evaluated(words, directions):
    """f_r of a material given in words, rows of three channels."""
    text = subprocess.run([brdf, "eval", *shlex.split(words), str(directions)], check=True, text=True,
                          capture_output=True).stdout
    rows = [line.split(",")[4:] for line in text.splitlines() if not line.startswith("#")][1:]
    return [[float(x) for x in (row if len(row) == 3 else row * 3)] for row in rows]


def rms(ours, theirs, pairs):
    residuals = [math.log1p(b * math.cos(math.radians(p[0]))) - math.log1p(a * math.cos(math.radians(p[0])))
                 for x, y, p in zip(ours, theirs, pairs) for a, b in zip(x, y)]
    return math.sqrt(sum(r * r for r in residuals) / len(residuals))


def main():
    if not shutil.which(blender):
        sys.exit("no Blender: tools/setup interop installs it")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    draw = random.Random(20)
    pairs = [[round(draw.uniform(0, high), 3) for high in (80, 360, 80, 360)] for _ in range(PAIRS)]
    rows = "".join(",".join(map(str, pair)) + "\n" for pair in pairs)
    (folder / "pairs.csv").write_text(rows)
    directions = folder / "directions.csv"
    directions.write_text("theta_i,phi_i,theta_o,phi_o\n" + rows)
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
    failed = False
    for name, words in MATERIALS.items():
        with open(folder / f"{name}.csv") as file:
            seen = [[float(x) for x in row] for row in csv.reader(file)]
        target, source = evaluated(targets[name], directions), evaluated(words, directions)
        assert len(seen) == len(target) == PAIRS
        worst = max(abs(b / a - 1) for x, y in zip(target, seen) for a, b in zip(x, y))
        said, found = rms(source, target, pairs), rms(source, seen, pairs)
        good = worst < tolerance(targets[name]) and abs(said - found) < 1e-4
        failed |= not good
        print(f"{name:14} largest difference {worst:.2g}, loss said {said:.6f} seen {found:.6f}"
              f"{'' if good else '  FAILED'}")
    sys.exit(failed)


main()
