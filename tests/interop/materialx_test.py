#!/usr/bin/env python3
# ctest: interop.materialx label=interop timeout=1800 setup=clients needs=plain @brdf@ @here@/materialx
"""materialx_test.py BRDF FOLDER: tests that exports to MaterialX are well-formed XML (xmllint) with nodes and inputs that
MaterialX 1.39 declares, each with its type, and that every link leads to an earlier node of the requested type. The stated lobe must
agree with recorded values of the shader that MaterialX generates (materialx_metal.csv), because MaterialX has no package here.
Plastics and other metals of its surface nodes were measured as well; no export uses their formulas."""
import csv
import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

from exported import DARK, Export, summary_of
from measured import evaluated, write_directions

brdf, folder = sys.argv[1], pathlib.Path(sys.argv[2])

# Node: its type, and the type of every input. From libraries/pbrlib/pbrlib_defs.mtlx and libraries/stdlib/stdlib_defs.mtlx of
# MaterialX 1.39.
NODES = {
    "oren_nayar_diffuse_bsdf": ("BSDF", dict(weight="float", color="color3", roughness="float", normal="vector3",
                                             energy_compensation="boolean")),
    "generalized_schlick_bsdf": ("BSDF", dict(weight="float", color0="color3", color82="color3", color90="color3",
                                              exponent="float", roughness="vector2", thinfilm_thickness="float",
                                              thinfilm_ior="float", normal="vector3", tangent="vector3",
                                              distribution="string", scatter_mode="string")),
    "add": ("BSDF", dict(in1="BSDF", in2="BSDF")),
    "surface": ("surfaceshader", dict(bsdf="BSDF", edf="EDF", opacity="float", thin_walled="boolean")),
    "surfacematerial": ("material", dict(surfaceshader="surfaceshader", backsurfaceshader="surfaceshader",
                                         displacementshader="displacementshader")),
    "tangent": ("vector3", dict(space="string", index="integer")),
    "normal": ("vector3", dict(space="string")),
    "rotate3d": ("vector3", {"in": "vector3", "amount": "float", "axis": "vector3"}),
}
NUMBERS = {"float": 1, "vector2": 2, "vector3": 3, "color3": 3}

MATERIALS = {
    "clay": "--form oren_nayar --set rho=0.6,0.5,0.4 --set sigma=0.4",
    "metal": "--form cook_torrance --set kd=0 --set ks=1 --set f0=0.9,0.6,0.3 --set alpha=0.3",
    "brushed": "--form cook_torrance --set kd=0.1 --set ks=0.8 --set f0=0.9 --set alpha_x=0.2 --set alpha_y=0.4"
               " --set tangent_phi=30",
    "own": "--form materialx_schlick --set kd=0.3,0.2,0.1 --set ks=0.5 --set f0=0.04 --set alpha=0.2 --set sigma=0.3",
}


def check(path):
    """Requires that MaterialX accepts the document. Returns the names of the nodes."""
    subprocess.run(["xmllint", "--noout", path], check=True)
    root = ElementTree.parse(path).getroot()
    assert root.tag == "materialx" and root.get("version") == "1.39" and root.get("colorspace") == "lin_rec709"
    before = {}
    for node in root:
        kind, inputs = NODES[node.tag]
        name = node.get("name")
        assert node.get("type") == kind and name and name not in before, name
        for item in node:
            wanted = inputs[item.get("name")]
            assert item.tag == "input" and item.get("type") == wanted, (name, item.attrib)
            link, value = item.get("nodename"), item.get("value")
            assert (link is None) != (value is None), (name, item.attrib)
            if link:
                assert before[link] == wanted, (name, link)
            elif wanted in NUMBERS:
                assert len([float(x) for x in value.split(",")]) == NUMBERS[wanted], value
        before[name] = kind
    assert [kind for kind in before.values()][-1] == "material"
    return [node.tag for node in root]


def compare_with_seen():
    """Returns the largest relative difference, of f_r + 0.001/sr, between the stated exported metal and the values of MaterialX."""
    lines = [line for line in pathlib.Path(__file__).with_name("materialx_metal.csv").read_text().splitlines() if line[0] != "#"]
    rows = [[float(x) for x in row] for row in csv.reader(lines[1:])]
    words = "--form materialx_schlick --set kd=0 --set ks=1 --set f0=0.9,0.6,0.3 --set alpha=0.25"
    export = Export(brdf, words, "materialx", folder / "seen.mtlx")
    lobe = ElementTree.parse(export.path).getroot().find("generalized_schlick_bsdf")
    written = {item.get("name"): item.get("value") for item in lobe}
    for name, right in (("color0", [0.9, 0.6, 0.3]), ("color90", [1, 1, 1]), ("roughness", [0.25, 0.25])):
        assert [float(x) for x in written[name].split(",")] == right, (name, written)
    directions = write_directions(folder / "seen.csv", [row[:4] for row in rows])
    apart = [abs(b - a) / (a + DARK) for words in export.terms for target, row in zip(evaluated(brdf, words, directions), rows)
             for a, b in zip(target, row[4:])]
    assert len(export.terms) == 1 and len(apart) == 3 * 16
    summary = summary_of("MaterialX 1.39.6, values measured before", [(False, apart)])
    (folder / "summary.json").write_text(json.dumps(summary) + "\n")
    print(json.dumps(summary))
    return max(apart)


def main():
    if not shutil.which("xmllint"):
        sys.exit("no xmllint: tools/setup interop installs it")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    seen = set()
    for name, words in MATERIALS.items():
        path = folder / f"{name}.mtlx"
        subprocess.run([brdf, "export", *shlex.split(words), "--to", "materialx", "-o", path], check=True, capture_output=True)
        seen |= set(check(path))
    assert seen == set(NODES), set(NODES) - seen
    mitsuba = folder / "paint.xml"
    subprocess.run([brdf, "export", *shlex.split(MATERIALS["metal"]), "--to", "mitsuba", "-o", mitsuba], check=True,
                   capture_output=True)
    subprocess.run(["xmllint", "--noout", mitsuba], check=True)
    assert compare_with_seen() < 1.3e-6
    broken = folder / "broken.mtlx"
    broken.write_text((folder / "metal.mtlx").read_text().replace("color82", "colour82"))
    try:
        check(broken)
    except KeyError:
        print(f"{len(MATERIALS)} documents, {len(NODES)} kinds of nodes")
        return
    sys.exit("an input that MaterialX does not have was not seen")


main()
