#!/usr/bin/env python3
# ctest: interop.babylon label=interop timeout=600 needs=plain @brdf@ chromium @npm@ @here@/babylon
"""babylon_test.py BRDF CHROMIUM NPM FOLDER: exports rotated, brushed metals as glTF and measures them as Babylon.js shades
them in a headless browser. Babylon.js multiplies its lobes by its own energy term. The test therefore judges axes and rotation by
ratios: light and viewer share one direction, which goes around the normal and hardly changes that term."""
import base64
import json
import math
import pathlib
import shutil
import statistics
import sys

from exported import Export
from glb import around
from measured import evaluated, write_directions

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "validate"))
from browser import SOFTWARE, Browser

STEP = 10  # degrees
TILT = 20
METALS = [(0.3, 0.1, tangent) for tangent in (0, 30, 75, 90, 120, -40)] + [(0.1, 0.3, 30), (0.2, 0.5, -65), (0.6, 0.25, 160)]


def around_normal():
    return [[TILT, phi, TILT, phi] for phi in range(0, 360, STEP)]


def of_green(values):
    return [row[1] for row in values]


def wide_axis(values):
    """Returns the azimuth, in 0 to 180 degrees, in which the lobe is wide: the azimuth of the second harmonic of ln f."""
    turns = [2 * math.radians(pair[1]) for pair in around_normal()]
    x, y = (sum(math.log(f) * turn(t) for f, t in zip(values, turns)) for turn in (math.cos, math.sin))
    return math.degrees(math.atan2(y, x)) / 2 % 180


def apart(a, b):
    """Returns the angle between two axes, in degrees."""
    return abs((a - b + 90) % 180 - 90)


def judge(words, here, seen):
    """Returns whether the measured lobe equals ours up to one factor and lies along the axis of the given tangent."""
    ratios = [b / a for a, b in zip(here, seen)]
    scatter = max(ratios) / min(ratios) - 1
    turned = apart(wide_axis(here), wide_axis(seen))
    good = scatter < 0.04 and turned < 1e-5
    print(f"{words}: wide along {wide_axis(seen):.3f} degrees, {turned:.1g} from ours; {statistics.mean(ratios):.4f} times ours, "
          f"the same to {scatter:.1g}{'' if good else '  FAILED'}", flush=True)
    return good


def main():
    brdf, chromium, npm, folder = sys.argv[1:3] + [pathlib.Path(p) for p in sys.argv[3:5]]
    if not shutil.which(chromium):
        sys.exit(f"no {chromium}: tools/setup interop installs it")
    for package in ("babylonjs", "babylonjs-loaders"):
        if not (npm / package).exists():
            sys.exit(f"no {npm}/{package}: tools/setup interop installs it")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    page = folder / "babylon_page.html"
    page.write_text(pathlib.Path(__file__).with_name("babylon_page.html").read_text().replace("NPM", npm.as_uri()))
    directions = write_directions(folder / "directions.csv", around_normal())
    good = True
    with Browser(chromium, *SOFTWARE, "--allow-file-access-from-files") as browser, browser.open(page) as tab:
        tab.wait("window.version")
        print("Babylon.js", tab.evaluate("window.version"))
        for k, (alpha_x, alpha_y, tangent) in enumerate(METALS):
            words = f"--form cook_torrance --set kd=0 --set ks=1 --set f0=0.9 --set alpha_x={alpha_x} --set alpha_y={alpha_y}" \
                    f" --set tangent_phi={tangent}"
            export = Export(brdf, words, "gltf", folder / f"{k}.gltf", "--naive")
            here = of_green(evaluated(brdf, words, directions))
            expected = (tangent if alpha_x > alpha_y else tangent + 90) % 180
            assert apart(wide_axis(here), expected) < 1e-6
            scene = base64.b64encode(around(export.text)).decode()
            seen = of_green(tab.evaluate(f"measure({json.dumps(scene)}, {json.dumps(around_normal())})"))
            good &= judge(f"widths {alpha_x} {alpha_y}, tangent {tangent}", here, seen)
        assert all("Babylon.js v" in line for line in tab.console), tab.console
    sys.exit(not good)


main()
