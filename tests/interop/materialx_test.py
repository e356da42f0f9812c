#!/usr/bin/env python3
"""materialx_test.py BRDF FOLDER: what is exported to MaterialX is well-formed XML (xmllint) of nodes and inputs that
MaterialX 1.39 declares, each with its type; every link leads to a node of the asked type that stands before it."""
import pathlib
import shlex
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

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
    """The nodes' names; asserts that the document is one that MaterialX accepts."""
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
    broken = folder / "broken.mtlx"
    broken.write_text((folder / "metal.mtlx").read_text().replace("color82", "colour82"))
    try:
        check(broken)
    except KeyError:
        print(f"{len(MATERIALS)} documents, {len(NODES)} kinds of nodes")
        return
    sys.exit("an input that MaterialX does not have was not seen")


main()
