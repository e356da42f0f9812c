#!/usr/bin/env python3
# ctest: cli.scenes label=cli needs=brdf_render @brdf@ @source@
"""scenes_test.py BRDF SOURCE: tests that the shipped scenes follow docs/scene.schema.json, and that the schema and the program
accept and refuse the same scenes. ./test draws every third scene, ./test --full (BRDF_THOROUGH) all. Exit code 77 without
python3-jsonschema."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(77)

from documents import changer_of

brdf, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
BAD_FILE = 2
schema = json.loads((source / "docs/scene.schema.json").read_text())
jsonschema.Draft7Validator.check_schema(schema)
follows = jsonschema.Draft7Validator(schema).is_valid

paint = {"format": "brdf-material", "version": 1, "form": "lambert", "channels": ["r", "g", "b"], "weights": {"rho": 0.5},
         "shape": {}}
# Every key, each at an unusual value.
FULL = {
    "format": "brdf-scene", "version": 1,
    "camera": {"position": [0, 1, 5], "target": [0, 0, 0], "up": [0, 1, 0], "vertical_fov": 30, "width": 8, "height": 8},
    "ambient": [0.1, 0.1, 0.1], "background": {"horizon": [0.4, 0.4, 0.4], "zenith": [0.1, 0.1, 0.2]},
    "back_color": [0.5, 0, 0], "shadow": True,
    "lights": [{"type": "directional", "direction": [1, -1, -1], "intensity": 2, "color": [1, 0.9, 0.8]},
               {"type": "point", "position": [3, 2, 3], "intensity": 8}],
    "environment": {"picture": "uniform", "rotation": 30, "intensity": 0.5},
    "objects": [{"mesh": "sphere:100", "material": paint, "label": "paint", "textures": {}, "position": [1, 0, 0],
                 "rotation": [0, 20, 0], "scale": 0.5},
                {"mesh": "plane", "material": {"format": "brdf-material", "version": 1, "form": "sum", "terms": [paint]},
                 "scale": [1, 2, 3]}],
    "shading": "brdf", "per_vertex": False, "as_coded": False, "tone_map": "srgb", "exposure": 1,
}
changed = changer_of(FULL)

GOOD = {
    "every key": FULL,
    "as little as possible": {"format": "brdf-scene", "version": 1, "objects": [{"material": paint}]},
    "one colour behind": changed(["background"], [0.5, 0.5, 0.5]),
    "a slope behind": changed(["background"], {"bottom": [0.4, 0.4, 0.4], "top": [0.1, 0.1, 0.1]}),
    "no lights": changed(["lights"], []),
    "mirrored": changed(["objects", 0, "scale"], -1),
    **{f"tone map {name}": changed(["tone_map"], name) for name in schema["properties"]["tone_map"]["enum"]},
    **{f"shading {name}": changed(["environment"], "del", changed(["shading"], name))
       for name in schema["properties"]["shading"]["enum"]},
}
BAD = {
    "another format": changed(["format"], "brdf-material"),
    "another version": changed(["version"], 2),
    "no version": changed(["version"], "del"),
    "no objects": changed(["objects"], "del"),
    "an empty list of objects": changed(["objects"], []),
    "201 objects": changed(["objects"], 201 * [{"material": paint}]),
    "65 lights": changed(["lights"], 65 * [FULL["lights"][0]]),
    "an unknown key": changed(["ambiant"], [0, 0, 0]),
    "an unknown key of the camera": changed(["camera", "fov"], 30),
    "a view of half a degree": changed(["camera", "vertical_fov"], 0.5),
    "a width of 0": changed(["camera", "width"], 0),
    "half a pixel": changed(["camera", "height"], 8.5),
    "two numbers for a place": changed(["camera", "position"], [0, 1]),
    "negative ambient light": changed(["ambient"], [-0.1, 0, 0]),
    "half a sky": changed(["background"], {"horizon": [0, 0, 0]}),
    "a sky and a slope": changed(["background", "top"], [0, 0, 0]),
    "a light of no type": changed(["lights", 0, "type"], "del"),
    "a light of another type": changed(["lights", 0, "type"], "area"),
    "a direction of no length": changed(["lights", 0, "direction"], [0, 0, 0]),
    "a lamp with a direction": changed(["lights", 1, "direction"], [0, 0, 1]),
    "a negative intensity": changed(["lights", 0, "intensity"], -1),
    "a shadow of 1": changed(["shadow"], 1),
    "an environment without a picture": changed(["environment", "picture"], "del"),
    "a picture without a name": changed(["environment", "picture"], ""),
    "an environment turned twice": changed(["environment", "rotation"], 720),
    "an object without a material": changed(["objects", 0, "material"], "del"),
    "a mesh that is no name": changed(["objects", 0, "mesh"], 1),
    "an unknown texture": changed(["objects", 0, "textures", "bump"], "a.png"),
    "a scale of 0": changed(["objects", 0, "scale"], 0),
    "flat along one axis": changed(["objects", 1, "scale"], [1, 0, 1]),
    "a material of another format": changed(["objects", 0, "material", "format"], "brdf-scene"),
    "a tangent turned too far": changed(["objects", 0, "material", "tangent_phi"], 270),
    "an unknown shading": changed(["shading"], "toon"),
    "an unknown tone map": changed(["tone_map"], "aces"),
    "too much exposure": changed(["exposure"], 21),
}

for path in sorted((source / "data/scenes").glob("*.json")):
    errors = list(jsonschema.Draft7Validator(schema).iter_errors(json.loads(path.read_text())))
    if errors:
        sys.exit(f"{path.name}: {jsonschema.exceptions.best_match(errors).message[:300]}")

with tempfile.TemporaryDirectory() as folder:
    file = pathlib.Path(folder) / "scene.json"

    def refusal(scene):
        """Returns the message of the program about the scene; empty if the program accepts the scene. A missing driver is reported after
    the scene has been read."""
        file.write_text(json.dumps(scene))
        done = subprocess.run([brdf, "render", "--scene", file, "--supersample", "1", "-o", file.with_suffix(".png")],
                              capture_output=True, text=True)
        return done.stderr if done.returncode == BAD_FILE else ""

    for what, scene in list(GOOD.items())[::1 if "BRDF_THOROUGH" in os.environ else 3]:
        if not follows(scene) or refusal(scene):
            sys.exit(f"{what}: the schema {'accepts' if follows(scene) else 'refuses'} it, the program says: {refusal(scene)}")
    for what, scene in BAD.items():
        if follows(scene) or not refusal(scene):
            sys.exit(f"{what}: the schema {'accepts' if follows(scene) else 'refuses'} it, the program says: {refusal(scene)}")
    for key in ("shading", "tone_map"):
        known = refusal(changed([key], "unknown")).split("one of ")[-1].strip().split(", ")
        if known != schema["properties"][key]["enum"]:
            sys.exit(f"{key}: the program knows {known}")
print("schema and program agree on scenes")
