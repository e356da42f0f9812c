#!/usr/bin/env python3
# ctest: interop.textured_gltf label=interop timeout=1800 setup=clients needs=plain @brdf@ node chromium @npm@ @here@/textured_gltf
"""textured_gltf_test.py BRDF NODE CHROMIUM NPM FOLDER: exports fitted maps as textured glTF, which gltf-validator must accept without an
error or a warning, and measures stated texels as the viewer of Khronos and three.js shade them in a headless browser: each value must be
that of the target with the parameters that the export states."""
import base64
import json
import pathlib
import shutil
import struct
import sys
import zlib

from gltf_validator import validate
from textured import SIZE, STACKS, exported, fitted_maps

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "validate"))
from browser import SOFTWARE, Browser

# The program, its page and the relative bound of its shaders, which decode 8 bits with the sRGB curve in float.
CLIENTS = {"gltf": ("khronos_page.html", "window.ready", 5e-5), "three": ("three_page.html", "window.revision !== undefined", 1e-4)}


def parts(glb):
    """Returns the document and the binary chunk of a .glb."""
    length = struct.unpack_from("<I", glb, 12)[0]
    assert glb[:4] == b"glTF" and glb[16:20] == b"JSON" and glb[24 + length:28 + length] == b"BIN\0"
    return json.loads(glb[20:20 + length]), glb[28 + length:]


def with_studio(glb, place):
    """Returns the .glb with the texel of the place at the origin, a directional light and an orthographic camera."""
    document, data = parts(glb)
    x, y = place.centre()
    document["extensionsUsed"].append("KHR_lights_punctual")
    document["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": 1}]}}
    document["cameras"] = [{"type": "orthographic", "orthographic": {"xmag": 1e-5, "ymag": 1e-5, "znear": 1, "zfar": 10}}]
    document["nodes"][0]["translation"] = [-x, -y, 0]
    document["nodes"] += [{"name": "camera", "camera": 0}, {"name": "light", "extensions": {"KHR_lights_punctual": {"light": 0}}}]
    document["scenes"] = [{"nodes": [0, 1, 2]}]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def measured(tab, scene, place, pairs):
    glb = base64.b64encode(with_studio(scene.read_bytes(), place)).decode()
    return tab.evaluate(f"measure({json.dumps(glb)}, {json.dumps(pairs)})")


def alpha_of(glb):
    """Returns the alpha of base_color by texel, from the PNG without filters that the exporter writes."""
    document, data = parts(glb)
    image = next(image for image in document["images"] if image["name"] == "base_color")
    view = document["bufferViews"][image["bufferView"]]
    png = data[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]
    width, height, depth, kind = struct.unpack_from(">IIBB", png, 16)
    assert (width, height, depth, kind) == (*SIZE, 8, 6)
    at, packed = 8, b""
    while at < len(png):
        length, name = struct.unpack_from(">I4s", png, at)
        packed += png[at + 8:at + 8 + length] if name == b"IDAT" else b""
        at += 12 + length
    rows = zlib.decompress(packed)
    assert all(rows[y * (4 * width + 1)] == 0 for y in range(height)), "a filter"
    return {(x, y): rows[y * (4 * width + 1) + 4 * (x + 1)] for y in range(height) for x in range(width)}


def holes_are_seen(tab, brdf, folder, to):
    """Returns whether a texel that the program cannot hold shows nothing. Without --fix some ks are above 1."""
    maps, scene = fitted_maps(brdf, "ambiguous", folder), folder / f"ambiguous_{to}.glb"
    place = exported(brdf, maps, to, scene)[0]
    holes = [texel for texel, alpha in alpha_of(scene.read_bytes()).items() if alpha == 0]
    place.x, place.y = holes[0]
    try:
        seen = measured(tab, scene, place, place.pairs)
    except AssertionError as error:  # the page of Khronos' viewer
        return "the plane was not drawn" in str(error)
    return all(value == 0 for row in seen for value in row)


def main():
    brdf, node, chromium, npm, folder = sys.argv[1:4] + [pathlib.Path(p) for p in sys.argv[4:6]]
    for tool in (node, chromium):
        if not shutil.which(tool):
            sys.exit(f"no {tool}: tools/setup interop installs it")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    maps = {name: fitted_maps(brdf, name, folder) for name in STACKS}
    good, files = [], []
    with Browser(chromium, *SOFTWARE, "--allow-file-access-from-files") as browser:
        for to, (name, ready, bound) in CLIENTS.items():
            page = folder / name
            page.write_text(pathlib.Path(__file__).with_name(name).read_text().replace("NPM", npm.as_uri()))
            with browser.open(page) as tab:
                tab.wait(ready)
                for stack, path in maps.items():
                    scene = folder / f"{stack}_{to}.glb"
                    places = exported(brdf, path, to, scene)
                    files.append(scene)
                    print(f"{stack} as {to}")
                    for place in places:
                        seen = measured(tab, scene, place, place.pairs)
                        good.append(place.judge(brdf, folder, seen, bound))
                    # The texels differ: the values of another texel are not those of the place.
                    other = measured(tab, scene, places[1], places[0].pairs)
                    good.append(not places[0].judge(brdf, folder, other, bound, "another texel"))
                assert holes_are_seen(tab, brdf, folder, to), to
                files.append(folder / f"ambiguous_{to}.glb")
                assert not [line for line in tab.console if "was not drawn" not in line], tab.console
    validate(node, npm, files)
    assert len(good) == 4 * len(STACKS) * len(CLIENTS)
    sys.exit(not all(good))


main()
