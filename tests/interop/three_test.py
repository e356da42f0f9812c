#!/usr/bin/env python3
# ctest: interop.three label=interop timeout=1800 setup=clients needs=plain @brdf@ node chromium @npm@ @here@/three
"""three_test.py BRDF NODE CHROMIUM NPM FOLDER: exports materials for three.js, validates the files with gltf-validator (no error,
no warning), and measures them as three.js shades them in a headless browser. Each value must be the value of the target that the
export names."""
import json
import pathlib
import shutil
import sys

from exported import Exports, Judged
from gltf_validator import reports, validate

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "validate"))
from browser import SOFTWARE, Browser


def refuses_what_is_no_gltf(node, npm, folder):
    """Requires that the errors of the validator are reported."""
    broken = folder / "broken.gltf"
    broken.write_text('{"asset": {"version": "2.0"}, "materials": [{"pbrMetallicRoughness": {"metallicFactor": 2}}]}')
    assert reports(node, npm, [broken])[0][1] == 1


def tolerance(widths):
    """Returns the relative bound for a shader in float, which reads its table with a few digits fewer. The denominator of an
    isotropic lobe is 1 - c^2 (1 - alpha^2), which amplifies rounding by 1/alpha^2."""
    return 1e-4 + (9e-7 / widths[0] ** 2 if widths and widths[0] == widths[1] else 0)


def main():
    brdf, node, chromium, npm, folder = sys.argv[1:4] + [pathlib.Path(p) for p in sys.argv[4:6]]
    for tool in (node, chromium):
        if not shutil.which(tool):
            sys.exit(f"no {tool}: tools/setup interop installs it")
    if not (npm / "three").exists():
        sys.exit(f"no {npm}/three: tools/setup interop installs it")
    exports = Exports(brdf, "three", ".gltf", folder)
    validate(node, npm, [export.path for export in exports.of.values()])
    refuses_what_is_no_gltf(node, npm, folder)
    page = folder / "three_page.html"
    page.write_text(pathlib.Path(__file__).with_name("three_page.html").read_text().replace("NPM", npm.as_uri()))
    with Browser(chromium, *SOFTWARE, "--allow-file-access-from-files") as browser, browser.open(page) as tab:
        tab.wait("window.revision !== undefined")
        judged = Judged(exports, f"three.js 0.{tab.evaluate('window.revision')}")
        for name, export in exports.of.items():
            seen = tab.evaluate(f"measure({json.dumps(export.text)}, {json.dumps(exports.pairs_of(name))})")
            judged.add(name, seen, tolerance(export.widths()))
        assert not tab.console, tab.console
    sys.exit(not judged.end())


main()
