#!/usr/bin/env python3
"""mitsuba_check.py BRDF: for machines that have Mitsuba 3 (pip install mitsuba). Exports materials, loads them in Mitsuba, and
compares bsdf.eval with the target that the export names, and an RGL table with its material. No test runs this script. Without
Mitsuba it prints a message and ends with exit code 77."""
import math
import pathlib
import re
import shlex
import statistics
import subprocess
import sys
import tempfile

from measured import draw_pairs, evaluated, largest, rms, write_directions

try:
    import mitsuba
except ImportError:
    print("not run: there is no Mitsuba here")
    sys.exit(77)

brdf = sys.argv[1]
MATERIALS = {
    "white": "--form lambert --set rho=0.9,0.5,0.2",
    "gold": "--form mitsuba_roughconductor --set kd=0 --set ks=1 --set n=0.2 --set k=3 --set alpha=0.2",
    "blend": "--form mitsuba_roughconductor --set kd=0.3,0.2,0.1 --set ks=0.4 --set n=1.5 --set k=0.5 --set alpha=0.3",
    "brushed": "--form mitsuba_roughconductor --set kd=0 --set ks=0.9 --set n=1 --set k=4 --set alpha_x=0.15 --set alpha_y=0.4",
    "paint": "--form mitsuba_principled --set base_color=0.6,0.3,0.1 --set metallic=0 --set eta=1.45 --set alpha=0.2",
    "metal": "--form cook_torrance --set kd=0 --set ks=1 --set f0=0.9,0.6,0.3 --set alpha=0.3",
}


def direction(theta, phi):
    t, p = math.radians(theta), math.radians(phi)
    return mitsuba.ScalarVector3f(math.sin(t) * math.cos(p), math.sin(t) * math.sin(p), math.cos(t))


def seen(bsdf, pairs):
    """Returns f_r in red, green and blue. The result of eval includes the cosine of its wo, which is the light here."""
    context, hit = mitsuba.BSDFContext(), mitsuba.SurfaceInteraction3f()
    hit.p, hit.n = [0, 0, 0], [0, 0, 1]
    hit.sh_frame = mitsuba.Frame3f([1, 0, 0], [0, 1, 0], [0, 0, 1])
    for theta_i, phi_i, theta_o, phi_o in pairs:
        hit.wi = direction(theta_o, phi_o)
        light = direction(theta_i, phi_i)
        value = bsdf.eval(context, hit, light)
        yield [float(value[c]) / math.cos(math.radians(theta_i)) for c in range(3)]


def bsdf_of(scene):
    """Returns the only BSDF of a file. The BSDF is put on a sphere, because a scene contains shapes."""
    text = scene.read_text()
    name = re.search(r"<bsdf [^>]*id=\"(\w+)\"", text)[1]
    scene.write_text(text.replace("</scene>", f"<shape type=\"sphere\"><ref id=\"{name}\"/></shape></scene>"))
    return mitsuba.load_file(str(scene)).shapes()[0].bsdf()


def main():
    mitsuba.set_variant("scalar_rgb")
    pairs, failed = draw_pairs(), False
    with tempfile.TemporaryDirectory() as folder:
        directions = write_directions(pathlib.Path(folder) / "directions.csv", pairs)
        for name, words in MATERIALS.items():
            scene = pathlib.Path(folder) / f"{name}.xml"
            subprocess.run([brdf, "export", *shlex.split(words), "--to", "mitsuba", "-o", scene], check=True, capture_output=True)
            said = re.search(r"the same here: brdf eval (.*)", scene.read_text())[1]
            target, source = evaluated(brdf, said, directions), evaluated(brdf, words, directions)
            values = list(seen(bsdf_of(scene), pairs))
            worst, expected, found = largest(target, values), rms(source, target, pairs), rms(source, values, pairs)
            good = worst < 1e-4 and abs(expected - found) < 1e-4
            failed |= not good
            print(f"{name:10} largest difference {worst:.2g}, loss said {expected:.6f} seen {found:.6f}{'' if good else '  FAILED'}")
        table = pathlib.Path(folder) / "metal.bsdf"
        subprocess.run([brdf, "export", *shlex.split(MATERIALS["metal"]), "--to", "rgl", "-o", table], check=True,
                       capture_output=True)
        values = list(seen(mitsuba.load_dict({"type": "measured", "filename": str(table)}), pairs))
        source = evaluated(brdf, MATERIALS["metal"], directions)
        median = statistics.median(abs(b / a - 1) for x, y in zip(source, values) for a, b in zip(x, y))
        failed |= median > 0.002
        print(f"rgl table  median difference {median:.2g}{'  FAILED' if median > 0.002 else ''}")
    print("Mitsuba", mitsuba.__version__, "failed" if failed else "agrees")
    sys.exit(failed)


main()
