#!/usr/bin/env python3
"""Makes docs/img/interop_NAME.png: spheres under one distant light with the material, with the refitted export in the program, and
with the copied parameters. Blender and three.js are run; the pictures of Mitsuba are computed from its formula.
Usage: tools/interop_pictures.py BRDF [blender] [mitsuba] [three] (tools/setup interop first)."""
import array
import json
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path += [str(ROOT / "tests/validate"), str(ROOT / "tests/interop")]
from measured import evaluated

SIZE, LIGHT, STRENGTH = 240, (math.radians(40), math.radians(130)), 2.2
MATERIALS = {
    "blender": ("blender-3.4", "--form oren_nayar --set rho=0.7,0.45,0.3 --set sigma=0.6"),
    "mitsuba": ("mitsuba", "--form cook_torrance --set kd=0.3,0.1,0.05 --set ks=0.5 --set f0=0.04 --set alpha=0.2"),
    "three": ("three", "--form cook_torrance --set kd=0 --set ks=1 --set f0=0.95,0.64,0.54 --set alpha=0.6"),
}


def light():
    theta, phi = LIGHT
    return math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)


def as_it_is(brdf, words, folder):
    """Returns the radiance of every pixel, top row first, of the sphere seen along -z without perspective."""
    l, pixels, rows = light(), [], []
    for y in range(SIZE):
        for x in range(SIZE):
            nx, ny = (2 * (x + 0.5) / SIZE - 1) * 1.05, (1 - 2 * (y + 0.5) / SIZE) * 1.05
            r2 = nx * nx + ny * ny
            n = (nx, ny, math.sqrt(1 - r2)) if r2 < 1 else None
            cos_i = sum(a * b for a, b in zip(n, l)) if n else 0
            if cos_i <= 0:
                pixels.append(None)
                continue
            cos_d = l[2] - n[2] * cos_i  # cosine between the tangential parts
            sines = math.sqrt(max((1 - cos_i**2) * (1 - n[2]**2), 1e-30))
            phi = math.acos(max(-1, min(1, cos_d / sines)))
            rows.append((math.degrees(math.acos(min(cos_i, 1))), 0, math.degrees(math.acos(n[2])), math.degrees(phi)))
            pixels.append((len(rows) - 1, cos_i))
    table = folder / "sphere.csv"
    table.write_text("theta_i,phi_i,theta_o,phi_o\n" + "".join("%r,%r,%r,%r\n" % row for row in rows))
    f = evaluated(brdf, words, table)
    return [[0, 0, 0] if p is None else [v * p[1] for v in f[p[0]]] for p in pixels]


BLENDER = """
import array, bpy, math, sys
script, out, size, lx, ly, lz = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, GONIOMETER)
for thing in list(bpy.data.objects): bpy.data.objects.remove(thing)
from mathutils import Vector
scene = bpy.context.scene
scene.render.engine, scene.cycles.samples, scene.cycles.max_bounces = "CYCLES", 16, 0
scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
scene.render.resolution_x = scene.render.resolution_y = int(size)
scene.view_settings.view_transform = "Raw"
scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"
scene.world = bpy.data.worlds.new("dark")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs[1].default_value = 0
bpy.ops.mesh.primitive_uv_sphere_add(segments=256, ring_count=128)
ball = bpy.context.object
bpy.ops.object.shade_smooth()
sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
sun.data.angle, sun.data.energy = 0, 1
sun.rotation_mode = "QUATERNION"
sun.rotation_quaternion = Vector((float(lx), float(ly), float(lz))).to_track_quat("Z", "Y")
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
camera.data.type, camera.data.ortho_scale, camera.location = "ORTHO", 2.1, (0, 0, 5)
for thing in (sun, camera): scene.collection.objects.link(thing)
scene.camera = camera
names = {}
exec(compile(open(script).read(), script, "exec"), names)
ball.data.materials.append(names["make_material"]("it"))
scene.render.filepath = out + ".exr"
bpy.ops.render.render(write_still=True)
image = bpy.data.images.load(out + ".exr")
array.array("f", image.pixels).tofile(open(out, "wb"))
"""


def in_blender(script, folder):
    program, out = folder / "sphere.py", folder / "pixels"
    program.write_text(BLENDER.replace("GONIOMETER", repr(str(folder))))
    subprocess.run(["blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python", program, "--", script, out,
                    str(SIZE), *map(str, light())], check=True, capture_output=True)
    values = array.array("f", out.read_bytes())
    rows = [[list(values[4 * (y * SIZE + x):4 * (y * SIZE + x) + 3]) for x in range(SIZE)] for y in range(SIZE)]
    return [pixel for row in reversed(rows) for pixel in row]


THREE = """
const sphere = async (text, size, l) => {
  const file = await new GLTFLoader().parseAsync(text, "");
  const ball = new THREE.Mesh(new THREE.SphereGeometry(1, 256, 128), await file.parser.getDependency("material", 0));
  const sun = new THREE.DirectionalLight(0xffffff, 1), eye = new THREE.OrthographicCamera(-1.05, 1.05, 1.05, -1.05, 1, 10);
  sun.position.set(...l);
  eye.position.set(0, 0, 5);
  const stage = new THREE.Scene().add(ball, sun);
  const image = new THREE.WebGLRenderTarget(size, size, {type: THREE.FloatType, samples: 4});
  renderer.setRenderTarget(image);
  renderer.render(stage, eye);
  const pixels = new Float32Array(4 * size * size);
  renderer.readRenderTargetPixels(image, 0, 0, size, size, pixels);
  return [...pixels];
};
window.sphere = sphere;
</script>
"""


def in_three(gltf, folder):
    from browser import SOFTWARE, Browser
    page = folder / "sphere.html"
    text = (ROOT / "tests/interop/three_page.html").read_text().replace("</script>\n", "\0")
    head, _, _ = text.rpartition("\0")
    page.write_text((head + THREE).replace("\0", "</script>\n").replace("NPM", (ROOT / "build/npm/node_modules").as_uri()))
    with Browser("chromium", *SOFTWARE, "--allow-file-access-from-files") as browser, browser.open(page) as tab:
        tab.wait("window.sphere !== undefined")
        values = tab.evaluate(f"sphere({json.dumps(gltf.read_text())}, {SIZE}, {list(light())})")
    rows = [[values[4 * (y * SIZE + x):4 * (y * SIZE + x) + 3] for x in range(SIZE)] for y in range(SIZE)]
    return [pixel for row in reversed(rows) for pixel in row]


def write_png(path, pictures):
    """Returns the pictures side by side, in sRGB."""
    def byte(x):
        x = min(max(x * STRENGTH, 0), 1)
        return round(255 * (12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055))

    lines = b"".join(b"\0" + bytes(byte(c) for p in pictures for pixel in p[y * SIZE:(y + 1) * SIZE] for c in pixel)
                     for y in range(SIZE))
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", SIZE * len(pictures), SIZE, 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


def by_its_formula(exported, folder):
    said = re.search(r"the same here: brdf eval (.*)", exported.read_text())[1]
    return as_it_is(sys.argv[1], said, folder)


SHOW = {"blender": in_blender, "mitsuba": by_its_formula, "three": in_three}


def main():
    brdf, *wanted = sys.argv[1:]
    for name in wanted or MATERIALS:
        to, words = MATERIALS[name]
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            pictures = [as_it_is(brdf, words, folder)]
            for more in ([], ["--naive"]):
                exported = folder / "exported"
                subprocess.run([brdf, "export", *words.split(), "--to", to, *more, "-o", exported], check=True)
                pictures.append(SHOW[name](exported, folder))
            write_png(ROOT / f"docs/img/interop_{name}.png", pictures)
        differences = [sum(abs(a - b) for p, q in zip(pictures[0], other) for a, b in zip(p, q)) /
                       sum(a for p in pictures[0] for a in p) for other in pictures[1:]]
        print(f"{name}: light that differs: refitted {differences[0]:.2%}, copied {differences[1]:.2%}")


main()
