#!/usr/bin/env python3
# ctest: maps.verbs label=maps @brdf@ @source@
"""verbs_test.py BRDF SOURCE: tests `synth --texels` and `fit STACK` from the command line: the written files, the same bytes for any number
of threads and any memory limit, and the messages of refused calls."""
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(77)

brdf, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])


def check_page(page, summary):
    """Verdicts by name with counts, a colour bar for each map, no map twice, and a headline that counts the converged."""
    converged = summary["verdicts"]["converged"]
    headline = f'{converged} of {summary["fitted"]} texels converged; {summary["usable"]} '
    assert re.search(rf'class="verdict[^>]*>{headline}', page), (headline, re.findall('class="verdict.*', page))
    for name, count in summary["verdicts"].items():
        assert (f"</i>{name.replace('_', ' ')}: {count}</li>" in page) == (count > 0), (name, count)
    titles = re.findall(r'<p class="title">(.*?)</p>', page)
    assert len(titles) == len(set(titles)) and {"verdict", "residual", "alpha_x = alpha_y"} <= set(titles), titles
    known = [p for p in summary["parameters"] if p["identified"] > 0 and p["name"] != "alpha_y"]
    assert page.count('class="bar"') == len(known) + 1, titles  # and the residual


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)

    def run(words, code=0):
        done = subprocess.run([brdf, *words.split()], cwd=folder, capture_output=True, text=True)
        assert code is None or done.returncode == code, (words, done.returncode, done.stdout, done.stderr)
        return done

    def refused(words, text):
        message = run(words, 2).stderr
        assert text in message, (words, message)

    def digest(path):
        return {p.name: p.read_bytes() for p in sorted((folder / path).iterdir()) if p.is_file()}

    synth = ("synth --form cook_torrance --set kd=0.3,0.2,0.1 --set ks=0.5 --texels 66x10 --lights 40 "
             "--vary alpha=0.1:0.5 --tilt 20 --noise 0.02 --dark-level 0.001 --saturation 5 --seed 3 -o ")
    said = run(synth + "stack").stderr
    assert "40 images of 66 x 10 texels" in said, said
    run(synth + "again")
    first, second = digest("stack"), digest("again")
    assert len(first) == 41 and first == second
    lights = (folder / "stack/lights.csv").read_text()
    assert "# dark_level: 0.001" in lights and "# saturation: 5" in lights, lights
    assert (folder / "stack/truth/truth.exr").is_file()

    fit = "fit stack --form cook_torrance --normals stack/truth/truth.exr "
    printed = run(fit + "-o one --report maps.html").stdout
    assert "660 fitted" in printed and "us for each texel" in printed, printed
    run(fit + "-o two --jobs 2")
    assert digest("one") == digest("two")
    page = (folder / "maps.html").read_text()
    assert "kd.r" in page and "Worst texels" in page
    check_page(page, json.loads((folder / "one/maps.json").read_text()))
    summary = json.loads((folder / "one/maps.json").read_text())
    assert summary["usable"] <= summary["fitted"] == 660 and sum(summary["verdicts"].values()) == 660
    assert {p["name"] for p in summary["parameters"]} >= {"alpha_x", "kd.g", "f0.b"}
    # Another limit of memory is another command, and the same maps.
    few = json.loads(run(fit + "-o few --memory-limit 100K --json").stdout)
    assert {**few, "command": summary["command"]} == summary

    # The scene: every texel of a matt surface shows its own rho (a form's smooth variation, docs/scale.md), right way up.
    run("synth --form lambert --texels 16x8 --lights 12 --vary rho=0.1:0.6 -o matt")
    assert "scene.json: 8 bits of rho and the normal" in run("fit matt --form lambert -o matt_maps").stdout
    for column, row in ((2, 1), (13, 1), (2, 6), (13, 6), (5, 2)):
        share = 0.5 + 0.5 * math.sin(2 * math.pi * (0.5 * (column + 0.5) / 16 + 0.5 * (row + 0.5) / 8 + 3 * 0.6180339887498949 % 1))
        place = f"{32 * column + 16},{32 * row + 16}"
        said = run(f"render --scene matt_maps/scene.json --probe {place}").stdout
        f_r = [line for line in said.splitlines() if line.startswith("f_r")][0]
        red = float(f_r.split("(")[1].split(",")[0])
        assert abs(red * math.pi - (0.1 + 0.5 * share)) < 0.01 * (0.1 + 0.5 * share) + 0.002, (column, row, red * math.pi, share)
    assert "no scene: a sum of forms" in run("fit matt --form lambert+phong -o sum --jobs 2", None).stdout

    # Tied channels have one plane, which the scene and the textures of each channel read.
    run("synth --form cook_torrance --set kd=0.3 --set ks=0.5,0.4,0.3 --texels 3x2 --lights 30 --seed 4 -o small")
    for tie in ("kd", "f0", "kd ks f0"):
        assert "scene.json: 8 bits of kd" in run("fit small --form cook_torrance -o tied" + "".join(f" --tie {name}" for name in tie.split())).stdout, tie
        tied = json.loads((folder / "tied/scene.json").read_text())["objects"][0]["material"]
        for name in tie.split():
            assert len(set(tied["weights"][name])) == 1, (tie, tied)
        assert "6 carried" in run("export --maps tied/maps.exr --to materialx -o tied.mtlx").stderr, tie

    # Textures: the same texels in the file's header, in the JSON and in the map of losses; one message for what is no map.
    run(fit + "-o bounded --fix ks=0.5")
    export = "export --maps bounded/maps.exr --to gltf -o one.glb"
    said = run(export + " --loss-map loss.exr").stderr
    assert "66 x 10 texels of cook_torrance, 660 carried as gltf_metallic_roughness" in said and "at texel" in said, said
    assert "degrees by which the rounding turns a normal" in said and (folder / "loss.exr").is_file(), said
    told = json.loads(run(export + " --json").stdout)
    jsonschema.validate(told, json.loads((source / "docs/export.schema.json").read_text()))
    rms = told["maps"]["rms"]
    assert told["maps"]["held"] == 660 and told["maps"]["without_fit"] == 0 and rms["median"] <= rms["percentile_95"] <= rms["largest"]
    assert [told["maps"]["places"][0][key] for key in ("x", "y", "rms")] == [rms[key] for key in ("x", "y", "largest")], told
    text = (folder / "one.glb").read_bytes()
    assert f'at texel {rms["x"]},{rms["y"]}'.encode() in text and text.count(b"\x89PNG") == 4, text[:3000]
    said = run("export --maps one/maps.exr --to gltf -o many.glb").stderr
    assert "that the program cannot hold: holes; the first: texel" in said and "--fix ks=1" in said, said
    assert b'"alphaMode": "MASK"' in (folder / "many.glb").read_bytes()
    assert "above --max-loss" in run(export + " --max-loss 1e-6", 1).stderr
    run(export + f" --max-loss {1.01 * rms['largest']}")
    refused("export --maps one/maps.exr --to hlsl -o x.hlsl", "--to hlsl: textures are written for blender, blender-3.4, gltf, three, materialx")
    refused("export --maps one/maps.exr --to gltf -o x.gltf", "needs -o NAME.glb")
    refused("export --maps one/maps.exr --to gltf", "needs -o NAME.glb")
    refused("export --maps one/maps.exr --form ward --to gltf -o x.glb", "--maps: is the only input")
    refused("export --maps one/maps.exr --to gltf --naive -o x.glb", "--naive: --maps always copies")
    refused("export --form ward --to gltf --loss-map x.exr", "--loss-map: applies to --maps only")
    refused("export --maps stack/image_00000.exr --to gltf -o x.glb", "no attribute 'form'")
    refused("export --maps stack/lights.csv --to gltf -o x.glb", "lights.csv")
    assert not (folder / "x.glb").exists()
    run("fit stack --form ward --per-channel -o channels", None)
    refused("export --maps channels/maps.exr --to gltf -o x.glb", "a shape for each channel")

    # A shared width is the same in every texel, and is refused if no width is fitted.
    run(fit + "--share alpha -o shared --jobs 2")
    told = json.loads((folder / "shared/maps.json").read_text())
    assert told["shared"] == ["alpha"] and told["regions"] is None, told
    alpha = next(p for p in told["parameters"] if p["name"] == "alpha_x")
    assert alpha["low"] == alpha["high"] and alpha["identified"] == 660, alpha
    refused(fit + "--share kd -o maps", "--share kd: must be a shape that is fitted: alpha")
    refused("fit stack --form lambert --share alpha -o maps", "--share alpha: must be a shape that is fitted: this fit has no fitted shape")
    refused(fit + "--regions stack/image_00000.exr -o maps", "--regions: has no effect without --share")
    refused(fit + "--share alpha --regions stack/image_00000.exr -o maps", "regions must be one channel of the stack's 66 x 10")
    refused("fit stack/lights.csv --share alpha", "--share: has no effect on one table of samples")
    refused("fit stack --form all -o maps", "--form all: a stack is fitted with one form")
    refused("fit stack --form ward", "a stack needs -o FOLDER")
    refused("fit stack --form ward --robust huber -o maps", "a stack needs the loss's scale")
    refused("fit one --form ward -o maps", "one: is not a stack")
    refused("fit stack small --form ward -o maps", "stack: is a stack of photographs, not a folder of tables; fit it alone: brdf fit stack")
    refused("study stack -o page", "stack: is a stack of photographs")
    refused("fit stack/lights.csv --normals fit", "--normals: has no effect on one table of samples")
    refused("fit stack --form ward --normals stack/image_00000.exr -o maps", "image_00000.exr: has no channel normal.x")
    refused("synth --form ward --lights 3 -o x.csv", "--texels")
    refused("synth --form ward --texels 8 --lights 3 -o x", "--texels 8: must be WIDTHxHEIGHT")
    refused("synth --form ward --texels 8x8 -o x", "--lights 0: must be between 1")
    refused("synth --form ward --texels 8x8 --lights 3 --vary alpha=0.1 -o x", "--vary alpha=0.1: must be NAME=LOW:HIGH")
    refused("synth --form ward --texels 8x8 --lights 3 --vary rough=0:1 -o x", "rough")
    refused("synth --form ward --texels 8x8 --lights 3 -o stack", "stack: holds image_000")
    (folder / "stack/image_00007.exr").unlink()
    refused(fit + "-o maps", "lights.csv: 40 rows for 39 images")
print("stacks are made and fitted")
