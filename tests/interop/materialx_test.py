#!/usr/bin/env python3
# ctest: interop.materialx label=interop timeout=1800 setup=clients needs=plain @brdf@ @here@/materialx
"""materialx_test.py BRDF FOLDER: tests that exports to MaterialX are well-formed XML (xmllint) with nodes and inputs that
MaterialX 1.39 declares, each with its type, and that every link leads to an earlier node of the requested type. The stated lobe must
agree with recorded values of the shader that MaterialX generates (materialx_seen.csv, materialx_textured_seen.csv), because MaterialX has no package here."""
import csv
import itertools
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

from exported import DARK, Export, summary_of
from measured import evaluated, rms, unit, write_directions
from textured import STACKS, exported, fitted_maps

brdf, folder = sys.argv[1], pathlib.Path(sys.argv[2])

# Node: its type or types, and the type of every input. From libraries/pbrlib/pbrlib_defs.mtlx and libraries/stdlib/stdlib_defs.mtlx of
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
    "open_pbr_surface": ("surfaceshader", dict(base_weight="float", base_color="color3", base_diffuse_roughness="float",
                                               base_metalness="float", specular_weight="float", specular_color="color3",
                                               specular_roughness="float", specular_ior="float",
                                               specular_roughness_anisotropy="float", geometry_tangent="vector3")),
    "standard_surface": ("surfaceshader", dict(base="float", base_color="color3", diffuse_roughness="float", metalness="float",
                                               specular="float", specular_color="color3", specular_roughness="float",
                                               specular_IOR="float", specular_anisotropy="float", tangent="vector3")),
    "gltf_pbr": ("surfaceshader", dict(base_color="color3", metallic="float", roughness="float", ior="float", specular="float",
                                       specular_color="color3", anisotropy_strength="float", anisotropy_rotation="float")),
    "UsdPreviewSurface": ("surfaceshader", dict(diffuseColor="color3", metallic="float", roughness="float", ior="float")),
    "disney_principled": ("surfaceshader", dict(baseColor="color3", metallic="float", roughness="float", anisotropic="float",
                                                specular="float")),
    "surfacematerial": ("material", dict(surfaceshader="surfaceshader", backsurfaceshader="surfaceshader",
                                         displacementshader="displacementshader")),
    "tangent": ("vector3", dict(space="string", index="integer")),
    "normal": ("vector3", dict(space="string")),
    "image": (("color3", "float", "vector2", "vector3"), dict(file="filename", filtertype="string", uaddressmode="string",
                                                              vaddressmode="string")),
    "normalmap": ("vector3", {"in": "vector3"}),
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
PROGRAMS = ("materialx", "open_pbr_surface", "standard_surface", "gltf_pbr", "UsdPreviewSurface", "disney_principled")
METAL = "--form materialx_schlick --set kd=0 --set ks=1 --set f0=0.9,0.6,0.3 --set alpha=0.25"


def of_node(target, metallic, colour, alpha, *more):
    words = [f"--form {target}", f"metallic={metallic}", f"base_color={colour}", f"alpha={alpha}", *more]
    return " --set ".join(words)


# The measured nodes: the material that has their values, and their inputs.
GOLD, BROWN = [0.9, 0.6, 0.3], [0.3, 0.2, 0.1]
SEEN = {
    ("gltf_pbr", "metal"): (METAL, dict(base_color=GOLD, metallic=[1], roughness=[0.5])),
    ("open_pbr_surface", "metal"): (METAL, dict(base_color=GOLD, base_metalness=[1], specular_roughness=[0.5], base_weight=[1])),
    ("disney_principled", "metal"): (METAL, dict(baseColor=GOLD, metallic=[1], roughness=[0.5])),
    ("standard_surface", "metal"): (of_node("standard_surface", 1, "0.9,0.6,0.3", 0.25, "specular=1"),
                                    dict(base=[1], base_color=GOLD, metalness=[1], specular_roughness=[0.5])),
    ("standard_surface", "metal_aniso"): (
        of_node("standard_surface", 1, "0.9,0.6,0.3", f"{0.25 / 0.4**0.5},{0.25 * 0.4**0.5}", "specular=1").replace(
            f"alpha={0.25 / 0.4**0.5},", f"alpha_x={0.25 / 0.4**0.5} --set alpha_y="),
        dict(metalness=[1], specular_roughness=[0.5], specular_anisotropy=[0.6])),
    ("UsdPreviewSurface", "metal"): (of_node("usd_preview_surface", 1, "0.9,0.6,0.3", 0.25),
                                     dict(diffuseColor=GOLD, metallic=[1], roughness=[0.5])),
    ("open_pbr_surface", "plastic"): (
        of_node("open_pbr_surface", 0, "0.3,0.2,0.1", 0.16, "eta=1.6", "specular=0.8"),
        dict(base_color=BROWN, base_metalness=[0], specular_roughness=[0.4], specular_ior=[1.6], specular_weight=[0.8])),
    ("standard_surface", "plastic"): (
        of_node("standard_surface", 0, "0.3,0.2,0.1", 0.16, "eta=1.6", "specular=0.7"),
        dict(base_color=BROWN, metalness=[0], specular_roughness=[0.4], specular_IOR=[1.6], specular=[0.7])),
    ("disney_principled", "plastic"): (of_node("disney_principled", 0, "0.3,0.2,0.1", 0.16, "f0=0.056"),
                                       dict(baseColor=BROWN, metallic=[0], roughness=[0.4], specular=[0.7])),
}


def check(path):
    """Requires that MaterialX accepts the document. Returns the names of the nodes."""
    subprocess.run(["xmllint", "--noout", path], check=True)
    root = ElementTree.parse(path).getroot()
    assert root.tag == "materialx" and root.get("version") == "1.39" and root.get("colorspace") == "lin_rec709"
    before = {}
    for node in root:
        kinds, inputs = NODES[node.tag]
        name = node.get("name")
        kind = node.get("type")
        assert kind in (kinds if isinstance(kinds, tuple) else (kinds,)) and name and name not in before, name
        for item in node:
            wanted = inputs[item.get("name")]
            assert item.tag == "input" and item.get("type") == wanted, (name, item.attrib)
            link, value = item.get("nodename"), item.get("value")
            assert (link is None) != (value is None), (name, item.attrib)
            if link:
                assert before[link] == wanted, (name, link)
            elif wanted == "filename":
                assert (path.parent / value).is_file(), value
            elif wanted in NUMBERS:
                assert len([float(x) for x in value.split(",")]) == NUMBERS[wanted], value
        before[name] = kind
    assert [kind for kind in before.values()][-1] == "material"
    return [node.tag for node in root]


def seen_cases():
    """Yields (node, case, rows) of the recorded values."""
    lines = [line for line in pathlib.Path(__file__).with_name("materialx_seen.csv").read_text().splitlines() if line[0] != "#"]
    for case, rows in itertools.groupby(csv.reader(lines[1:]), key=lambda row: tuple(row[:2])):
        yield *case, [[float(x) for x in row[2:]] for row in rows]


def compare_case(program, words, inputs, rows):
    """Exports the stated material, requires the inputs of the measured node, and returns the relative differences of f_r + 0.001/sr
    between the target and the values that MaterialX showed."""
    export = Export(brdf, words, program, folder / "seen.mtlx")
    check(export.path)
    for node in ElementTree.parse(export.path).getroot():
        written = {item.get("name"): [float(x) for x in item.get("value").split(",")] for item in node
                   if item.get("type") in NUMBERS and item.get("value")}
        if inputs.keys() <= written.keys():
            break
    for name, right in inputs.items():
        assert len(written[name]) == len(right) and all(abs(a - b) < 1e-8 for a, b in zip(written[name], right)), (program, name, written)
    directions = write_directions(folder / "seen.csv", [row[:4] for row in rows])
    assert export.said["loss"]["largest"] < 1e-9 and len(export.terms) == 1 and len(rows) == 16, (program, words)
    return [abs(b - a) / (a + DARK) for target, row in zip(evaluated(brdf, export.terms[0], directions), rows)
            for a, b in zip(target, row[4:])]


def compare_with_seen():
    """Returns the largest relative difference between the targets and the values of MaterialX."""
    apart = []
    for node, case, rows in seen_cases():
        words, inputs = SEEN[node, case]
        apart.append(compare_case(node, words, inputs, rows))
        if (node, case) == ("gltf_pbr", "metal"):  # the nodegraph has the same lobe
            apart.append(compare_case("materialx", METAL, {"color0": [0.9, 0.6, 0.3], "color90": [1, 1, 1], "roughness": [0.25, 0.25]}, rows))
    assert len(apart) == len(SEEN) + 1
    summary = summary_of("MaterialX 1.39.6, values measured before", [(False, case) for case in apart])
    (folder / "summary.json").write_text(json.dumps(summary) + "\n")
    print(json.dumps(summary))
    return max(max(case) for case in apart)


def biquadratic(c, x, y):
    return sum(c[k] * x**i * y**j for k, (i, j) in enumerate([(0, 0), (1, 0), (0, 1), (1, 1), (2, 0), (0, 2), (2, 1), (1, 2), (2, 2)]))


def white_albedo(x, y):
    """Returns mx_ggx_dir_albedo_analytic of a white lobe (lib/mx_microfacet_specular.glsl) at the cosine x and the width y."""
    over = [([0.1003, -0.6303, 9.748, -2.038, 29.34, -8.245, -26.44, 19.99, -5.448],
             [1, -1.765, 8.263, 11.53, 28.96, -7.507, -36.11, 15.86, 33.37]),
            ([0.9345, -2.323, 2.229, -3.748, 1.424, -0.7684, 1.436, 0.2913, 0.6286],
             [1, 0.2281, 15.94, -55.83, 13.08, 41.26, 54.9, 300.2, -285.1])]
    return sum(min(max(biquadratic(a, x, y) / biquadratic(b, x, y), 0), 1) for a, b in over)


def earlier_compensation(words, pairs):
    """Returns f_r of materialx_schlick with the energy compensation of MaterialX 1.39.4: the Fresnel term at wi.h takes the place of its
    mean."""
    named = dict(word.split("=") for word in shlex.split(words) if "=" in word)
    f0, alpha = [float(x) for x in named["f0"].split(",")], float(named["alpha_x"])
    directions = write_directions(folder / "seen.csv", pairs)
    whole, diffuse = (evaluated(brdf, text, directions) for text in (words, words.replace("ks=" + named["ks"], "ks=0")))
    out = []
    for pair, all_of_it, without in zip(pairs, whole, diffuse):
        wi, wo = unit(*pair[:2]), unit(*pair[2:])
        half = [a + b for a, b in zip(wi, wo)]
        cosine = sum(a * b for a, b in zip(wi, half)) / sum(x * x for x in half) ** 0.5
        more = 1 / white_albedo(wo[2], alpha) - 1
        later, earlier = ([1 + (f + (1 - f) * rise) * more for f in (f0 if len(f0) == 3 else f0 * 3)]
                          for rise in (1 / 21, (1 - cosine) ** 5))
        out.append([d + (w - d) * b / a for w, d, a, b in zip(all_of_it, without, later, earlier)])
    return out


def nodes_of(path):
    """Returns the document without its header."""
    return re.sub(r"<\?brdf.*?\?>\n", "", path.read_text(), flags=re.S)


def compare_textures_with_seen():
    """Requires that the recorded values of texels are those of the stated parameters, and that the measured documents are written today.
    Returns the largest relative difference."""
    here = pathlib.Path(__file__).parent
    lines = (here / "materialx_textured_seen.csv").read_text().splitlines()
    words = dict(re.match(r"# (\w+): (--form .*)", line).groups() for line in lines if "--form" in line)
    rows = list(csv.reader(line for line in lines if not line.startswith(("#", "case"))))
    apart = 0
    for case, text in words.items():
        seen = [[float(x) for x in row[1:]] for row in rows if row[0] == case]
        assert len(seen) == 16, case
        for right, row in zip(earlier_compensation(text, [row[:4] for row in seen]), seen):
            apart = max(apart, *(abs(a / b - 1) for a, b in zip(row[4:], right)))
    for name in {case.split("_")[0] for case in words}:
        today, measured = (ElementTree.fromstring(nodes_of(p)) for p in (folder / f"{name}.mtlx", here / f"materialx_textured_{name}.mtlx"))
        for a, b in itertools.zip_longest(today.iter(), measured.iter()):
            assert (a.tag, a.keys()) == (b.tag, b.keys()), (a.attrib, b.attrib)
            for key, value in b.items():
                assert a.get(key) == value or abs(float(a.get(key)) / float(value) - 1) < 1e-6, (a.attrib, b.attrib)
    print(f"{len(words)} texels of textures, {len(rows)} values measured before: largest difference {apart:.2g}")
    return apart


def main():
    if not shutil.which("xmllint"):
        sys.exit("no xmllint: tools/setup interop installs it")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    seen = set()
    for name, words in MATERIALS.items():
        for program in PROGRAMS:
            path = folder / f"{name}_{program}.mtlx"
            made = subprocess.run([brdf, "export", *shlex.split(words), "--to", program, "-o", path], capture_output=True, text=True, check=False)
            if program == "disney_principled" and "tangent_phi" in words:
                assert made.returncode == 2 and "orient dp/du" in made.stderr, made.stderr  # the node has no tangent
                continue
            assert made.returncode == 0, made.stderr
            seen |= set(check(path))
    for name in STACKS:
        maps = fitted_maps(brdf, name, folder)
        for place in exported(brdf, maps, "materialx", folder / f"{name}.mtlx"):
            wanted, carried = place.values(brdf, folder)
            print(f"{name}: texel {place.x},{place.y}, rms {rms(wanted, carried, place.pairs):.6f}")
        seen |= set(check(folder / f"{name}.mtlx"))
    assert seen == set(NODES), set(NODES) - seen
    mitsuba = folder / "paint.xml"
    subprocess.run([brdf, "export", *shlex.split(MATERIALS["metal"]), "--to", "mitsuba", "-o", mitsuba], check=True,
                   capture_output=True)
    subprocess.run(["xmllint", "--noout", mitsuba], check=True)
    assert 6e-7 < compare_with_seen() < 1.5e-6
    assert 1e-7 < compare_textures_with_seen() < 1.5e-6
    broken = folder / "broken.mtlx"
    broken.write_text((folder / "metal_materialx.mtlx").read_text().replace("color82", "colour82"))
    try:
        check(broken)
    except KeyError:
        print(f"{len(MATERIALS)} documents, {len(NODES)} kinds of nodes")
        return
    sys.exit("an input that MaterialX does not have was not seen")


main()
