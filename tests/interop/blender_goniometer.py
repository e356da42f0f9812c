"""Runs inside Blender: measures exported materials.

    blender -b --factory-startup --python blender_goniometer.py -- SCRIPT.py...

The scene is a plane in z = 0 with tangent +x, a sun of angle 0 and irradiance 1, and an orthographic camera, without
bounces, so that a pixel is f_r cos_i. Each SCRIPT.py defines make_material(name, tangent). SCRIPT_pairs.csv holds pairs of
directions (theta_i, phi_i, theta_o, phi_o in degrees, one row per pair); f_r of every pair in red, green and blue is
written to SCRIPT.csv in the same folder. A script with make_plane(material) has a plane of its own: SCRIPT_places.csv holds places
(x, y) on it, SCRIPT_K_pairs.csv the pairs at place K, and SCRIPT_K.csv receives the values.
"""
import csv
import math
import pathlib
import statistics
import sys
import tempfile

import bpy
from mathutils import Vector

SIZE = 4  # pixels


def scene_with_plane():
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = 1
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    scene.cycles.max_bounces = 0
    scene.cycles.light_sampling_threshold = 0  # else dark values are left to chance
    scene.cycles.pixel_filter_type = "BOX"
    scene.render.resolution_x = scene.render.resolution_y = SIZE
    scene.render.resolution_percentage = 100
    scene.render.use_persistent_data = True
    scene.view_settings.view_transform = "Raw"
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.world = bpy.data.worlds.new("dark")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs[1].default_value = 0
    bpy.ops.mesh.primitive_plane_add(size=2)
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.angle, sun.data.energy = 0, 1
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type, camera.data.ortho_scale = "ORTHO", 0.02
    for thing in (sun, camera):
        scene.collection.objects.link(thing)
    scene.camera = camera
    return scene, bpy.context.object, sun, camera


def direction(theta, phi):
    t, p = math.radians(theta), math.radians(phi)
    return Vector((math.sin(t) * math.cos(p), math.sin(t) * math.sin(p), math.cos(t)))


def turn_towards(thing, w):
    """Turns the +z axis of the object along w. Euler angles would lose four digits near the normal."""
    q = (1 + w.z, -w.y, w.x, 0)
    length = math.sqrt(sum(x * x for x in q))
    thing.rotation_mode = "QUATERNION"
    thing.rotation_quaternion = [x / length for x in q]


def measure(pairs, scene, sun, camera, picture):
    scene.render.filepath = picture
    for theta_i, phi_i, theta_o, phi_o in pairs:
        wi, wo = direction(theta_i, phi_i), direction(theta_o, phi_o)
        turn_towards(sun, wi)
        camera.location = 5 * wo
        turn_towards(camera, wo)
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(picture)
        pixels = list(image.pixels)
        bpy.data.images.remove(image)
        # All pixels are equal, except one pixel that may fall on the edge between the two triangles of the plane.
        yield [statistics.median(pixels[c::4]) / wi.z for c in range(3)]


def read(path):
    with open(path) as file:
        return [[float(x) for x in row] for row in csv.reader(file)]


def write(path, rows):
    with open(path, "w") as file:
        csv.writer(file).writerows(rows)


def main():
    scripts = sys.argv[sys.argv.index("--") + 1 :]
    scene, plane, sun, camera = scene_with_plane()
    with tempfile.TemporaryDirectory() as folder:
        for script in map(pathlib.Path, scripts):
            def measured(name):
                pairs = read(script.with_name(f"{name}_pairs.csv"))
                write(script.with_name(f"{name}.csv"), measure(pairs, scene, sun, camera, folder + "/pixel.exr"))
            names = {"__file__": str(script)}
            exec(compile(script.read_text(), script, "exec"), names)
            plane.hide_render = "make_plane" in names
            if plane.hide_render:
                own = names["make_plane"](names["make_material"]())
                for k, (x, y) in enumerate(read(script.with_name(f"{script.stem}_places.csv"))):
                    own.location = (-x, -y, 0)
                    measured(f"{script.stem}_{k}")
                bpy.data.objects.remove(own)
                continue
            plane.data.materials.clear()
            plane.data.materials.append(names["make_material"](script.stem, tangent=(1, 0, 0)))
            measured(script.stem)


main()
