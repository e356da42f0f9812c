#!/usr/bin/env python3
"""three_test.py BRDF NODE CHROMIUM NPM FOLDER: exports materials for three.js and as glTF, validates the files with
gltf-validator (no error, no warning), and measures them as three.js shades them in a headless browser: within 1e-3 of the
target that the export says it wrote."""
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from measured import draw_pairs, evaluated, largest, rms, write_directions

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "validate"))
from browser import SOFTWARE, Browser

brdf, node, chromium, npm, folder = sys.argv[1:4] + [pathlib.Path(p) for p in sys.argv[4:6]]
PAIRS = 100

MATERIALS = {
    "white": "--form lambert --set rho=0.9,0.5,0.2",
    "narrow_metal": "--form cook_torrance --set kd=0 --set ks=1 --set f0=0.9,0.6,0.3 --set alpha=0.1",
    "metal": "--form cook_torrance --set kd=0 --set ks=1 --set f0=0.9,0.6,0.3 --set alpha=0.3",
    "rough_metal": "--form cook_torrance --set kd=0 --set ks=1 --set f0=1,0.8,0.6 --set alpha=0.7",
    "brushed_metal": "--form cook_torrance --set kd=0 --set ks=1 --set f0=0.9,0.6,0.3 --set alpha_x=0.1 --set alpha_y=0.3"
                     " --set tangent_phi=30",
    "plastic": "--form cook_torrance --set kd=0.3,0.2,0.1 --set ks=1 --set f0=0.04 --set alpha=0.2",
    "half_metal": "--form three_physical --set base_color=0.6,0.3,0.1 --set metallic=0.5 --set eta=1.6 --set alpha=0.3"
                  " --set specular=0.7",
    "ward": "--form ward --set kd=0.2 --set ks=0.3 --set alpha=0.2",
}

VALIDATOR = """
const fs = require("fs"), validator = require(process.argv[1] + "/gltf-validator");
(async () => {
  for (const file of process.argv.slice(2)) {
    const issues = (await validator.validateString(fs.readFileSync(file, "utf8"))).issues;
    console.log(JSON.stringify([file, issues.numErrors, issues.numWarnings, issues.messages.filter(m => m.severity < 2)]));
  }
})();
"""


def exported(words, to, path):
    subprocess.run([brdf, "export", *shlex.split(words), "--to", to, "-o", path], check=True, capture_output=True)
    return path


def validate(files):
    run = subprocess.run([node, "-e", VALIDATOR, npm, *files], text=True, capture_output=True)
    if run.returncode:
        sys.exit(run.stdout + run.stderr)
    reports = [json.loads(line) for line in run.stdout.splitlines()]
    assert len(reports) == len(files)
    for name, errors, warnings, messages in reports:
        if errors or warnings:
            sys.exit(f"gltf-validator on {name}: {errors} errors, {warnings} warnings: {messages}")
    print(f"gltf-validator: {len(reports)} files, 0 errors, 0 warnings")


def refuses_what_is_no_gltf():
    """The validator is heard."""
    broken = folder / "broken.gltf"
    broken.write_text('{"asset": {"version": "2.0"}, "materials": [{"pbrMetallicRoughness": {"metallicFactor": 2}}]}')
    run = subprocess.run([node, "-e", VALIDATOR, npm, broken], text=True, capture_output=True, check=True)
    assert json.loads(run.stdout)[1] == 1, run.stdout


def main():
    for tool in (node, chromium):
        if not shutil.which(tool):
            sys.exit(f"no {tool}: tools/setup interop installs it")
    if not (npm / "three").exists():
        sys.exit(f"no {npm}/three: tools/setup interop installs it")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    files = {name: exported(words, "three", folder / f"{name}.gltf") for name, words in MATERIALS.items()}
    also = [exported(words, "gltf", folder / f"{name}_as_specified.gltf") for name, words in MATERIALS.items()
            if "three" not in words]
    validate([*files.values(), *also])
    refuses_what_is_no_gltf()
    page = folder / "three_page.html"
    page.write_text(pathlib.Path(__file__).with_name("three_page.html").read_text().replace("NPM", npm.as_uri()))
    pairs = draw_pairs(PAIRS)
    directions = write_directions(folder / "directions.csv", pairs)
    failed = False
    with Browser(chromium, *SOFTWARE, "--allow-file-access-from-files") as browser, browser.open(page) as tab:
        tab.wait("window.revision !== undefined")
        print("three.js", tab.evaluate("window.revision"))
        for name, path in files.items():
            text = path.read_text()
            seen = tab.evaluate(f"measure({json.dumps(text)}, {json.dumps(pairs)})")
            words = next(line for line in json.loads(text)["asset"]["extras"]["brdf"] if line.startswith("the same here:"))
            target = evaluated(brdf, re.sub(r"^the same here: brdf eval ", "", words), directions)
            source = evaluated(brdf, MATERIALS[name], directions)
            worst, said, found = largest(target, seen), rms(source, target, pairs), rms(source, seen, pairs)
            good = worst < 1e-3 and abs(said - found) < 1e-4 and len(seen) == PAIRS
            failed |= not good
            print(f"{name:14} largest difference {worst:.2g}, loss said {said:.6f} seen {found:.6f}{'' if good else '  FAILED'}")
        assert not tab.console, tab.console
    sys.exit(failed)


main()
