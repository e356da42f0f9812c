#!/usr/bin/env python3
# ctest: interop.khronos label=interop timeout=1800 setup=clients needs=plain @brdf@ node chromium @npm@ @here@/khronos
"""khronos_test.py BRDF NODE CHROMIUM NPM FOLDER: exports materials as glTF and puts each on a plane in a .glb, which
gltf-validator must accept without an error or a warning. Then measures the plane as the viewer of Khronos shades it in a headless
browser: each value must be the value of the target that the export names."""
import base64
import json
import math
import pathlib
import shutil
import sys

from exported import Export, Exports, Judged
from glb import around
from gltf_validator import validate
from measured import evaluated, write_directions

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "validate"))
from browser import SOFTWARE, Browser

VIEWER = "@khronosgroup/gltf-viewer"

# A metal with base colour 0.9 and widths 0.3 and 0.1, at pairs for which KHR_materials_anisotropy limits the visibility to 1, and at
# one pair without this limit. The extension's text: KhronosGroup/glTF@0554a7f3, extensions/2.0/Khronos/KHR_materials_anisotropy/README.md.
HELD = "--form gltf_metallic_roughness --set base_color=0.9 --set alpha_x=0.3 --set alpha_y=0.1 --set metallic=1"
HELD_PAIRS = [[75, 0, 75, 180], [70, 90, 70, 270], [60, 0, 60, 180]]


def visibility_and_value(pair):
    """Returns the visibility before it is limited to 1, and f_r, of HELD in a mirror direction; the half vector is the normal."""
    theta, phi = (math.radians(angle) for angle in pair[:2])
    c, along, across = math.cos(theta), 0.3 * math.sin(theta) * math.cos(phi), 0.1 * math.sin(theta) * math.sin(phi)
    visibility = 0.25 / (c * math.sqrt(along * along + across * across + c * c))
    peak = 1 / (math.pi * 0.3 * 0.1)
    return visibility, (0.9 + 0.1 * (1 - c) ** 5) * peak * min(visibility, 1)


def tolerance(widths):
    """Returns the relative bound for a shader in float. The denominator of an isotropic lobe is 1 - c^2 (1 - alpha^2), which
    amplifies rounding by 1/alpha^2; the denominator of a lobe with two widths is a sum of squares and does not."""
    if not widths:
        return 1e-6
    return 1e-6 + (7e-7 if widths[0] == widths[1] else 1.2e-7) / min(widths) ** 2


class Viewer:
    """The viewer in a tab of a browser."""

    def __init__(self, tab):
        self.tab = tab
        tab.wait("window.ready")

    def measure(self, glb, pairs):
        return self.tab.evaluate(f"measure({json.dumps(base64.b64encode(glb).decode())}, {json.dumps(pairs)})")


def holds_the_visibility(viewer, brdf, folder):
    """Requires that the viewer and the target of the library have the values of the extension's text."""
    export = Export(brdf, HELD, "gltf", folder / "held.gltf")
    seen = viewer.measure(around(export.text), HELD_PAIRS)
    here = evaluated(brdf, HELD, write_directions(folder / "held.csv", HELD_PAIRS))
    right = [visibility_and_value(pair) for pair in HELD_PAIRS]
    assert [visibility > 1 for visibility, _ in right] == [True, True, False]
    for pair, (visibility, value), a, b in zip(HELD_PAIRS, right, seen, here):
        good = abs(a[0] / value - 1) < 2e-5, abs(b[0] / value - 1) < 1e-12
        print(f"visibility {visibility:.3f}: the text {value:.6g}, the viewer {a[0]:.6g}, here {b[0]:.6g}"
              f"{'' if all(good) else '  FAILED'}")
        yield all(good)


def main():
    brdf, node, chromium, npm, folder = sys.argv[1:4] + [pathlib.Path(p) for p in sys.argv[4:6]]
    for tool in (node, chromium):
        if not shutil.which(tool):
            sys.exit(f"no {tool}: tools/setup interop installs it")
    if not (npm / VIEWER).exists():
        sys.exit(f"no {npm / VIEWER}: tools/setup interop installs it")
    version = json.loads((npm / VIEWER / "package.json").read_text())["version"]
    exports = Exports(brdf, "gltf", ".gltf", folder)
    scenes = {}
    for name, export in exports.of.items():
        scenes[name] = folder / f"{name}.glb"
        scenes[name].write_bytes(around(export.text))
    validate(node, npm, [*scenes.values(), *(export.path for export in exports.of.values())])
    page = folder / "khronos_page.html"
    page.write_text(pathlib.Path(__file__).with_name("khronos_page.html").read_text().replace("NPM", npm.as_uri()))
    judged = Judged(exports, f"Khronos glTF viewer {version}")
    with Browser(chromium, *SOFTWARE, "--allow-file-access-from-files") as browser, browser.open(page) as tab:
        viewer = Viewer(tab)
        held = list(holds_the_visibility(viewer, brdf, folder))
        for name, scene in scenes.items():
            seen = viewer.measure(scene.read_bytes(), exports.pairs_of(name))
            judged.add(name, seen, tolerance(exports.of[name].widths()))
        assert not tab.console, tab.console
    sys.exit(not judged.end() or not all(held))


main()
