#!/usr/bin/env python3
# ctest: cli.products label=cli cost=20 needs=brdf_render,plain @brdf@ @source@/data
# ctest: cli.all_products label=slow timeout=3600 needs=brdf_render,plain @brdf@ @source@/data --all
"""Tests every option of a verb with every product of the verb: the option is refused (exit code 2), or the output differs,
and no signal ends the program.

    products_test.py BRDF DATA [--all] [--verb VERB]

The options name files that do not exist on purpose: a product that does not read them must refuse the option. Without --all,
`fit`, `render` and `validate` do not run, because they take minutes; that each of their options has a value is always tested.
"""
import argparse
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("brdf", type=pathlib.Path)
parser.add_argument("data", type=pathlib.Path)
parser.add_argument("--all", action="store_true")
parser.add_argument("--verb")
call = parser.parse_args()
brdf, data = call.brdf.resolve(), call.data.resolve()
A, B = "a.json", "b.json"

SLOW = {"fit", "render", "validate"}  # verbs that --all adds
# Options that change the time or the exit code of a product, or print the time, but never change the product.
NO_BYTES = {"--jobs", "--memory-limit", "--validation", "--require", "--times"}
FIT = {"--form": "phong", "--metric": "linear", "--anisotropic": None, "--per-channel": None, "--shape": "free", "--free-scale": None,
       "--keep-fill": None, "--polarisation": "average", "--repeats": "average", "--quantity": "BRF", "--mirror-side": "negative",
       "--layout": "none.json", "--budget": "none.csv", "--max-theta": "50", "--fix": "kd=0.3", "--start": "alpha=0.9", "--bounds": "alpha=0.5:0.9", "--tie": "kd", "--physical": None,
       "--robust": "huber:0.1", "--weights": "solid_angle", "--starts": "5", "--seed": "9", "--aperture": "2", "--bootstrap": "5",
       "--normals": "fit", "--no-pictures": None}
SHADER = {"--shader": "none.glsl", "--param": "alpha=0.1:0.5", "--entry": "main", "--returns": "f", "--define": "X=1",
          "--include-folder": "none", "--texture": "map=none.exr", "--set": "ks=0.1"}
# The verb, its products with their command lines, and a value of each of its options; None marks a flag.
VERBS = {
    "lobes": ({"plot": [A, "-o", "OUT.png"], "body": [A, "--body", "-o", "OUT.png"]},
              {"--state": "none.json", "--width": "64", "--compare": B, "--measured": "s.csv", "--theta": "20", "--solo": "A r",
               "--body": None, **SHADER}),
    "maps": ({"tiles": ["tiles", "--size", "16", "-o", "OUT"], "lookup": ["lookup", "-o", "OUT"]}, {"--size": "32", "--seed": "7"}),
    "fit": ({"table": ["s.csv", "--form", "ward", "--json"], "files": ["s.csv", "t.csv", "--form", "ward", "--no-pictures",
                                                                       "--json", "-o", "OUT"],
             "stack": ["stack", "--form", "cook_torrance", "-o", "OUT"]},
            {**FIT, **{k: v for k, v in SHADER.items() if k != "--set"}, "--embed": None, "--report": "OUT.html", "--jobs": "2", "--share": "alpha", "--regions": "none.exr",
             "--memory-limit": "1G", "--tolerance": "0.0001", "--json": None}),
    "validate": ({"form": ["--form", "lambert", "--json"], "material": [A, "--json"], "table": ["s.csv", "--json"],
                  "numerics": ["--numerics", "--form", "lambert", "--json"]},
                 {"--form": "ward", "--all": None, "--such-that": "rho <= 0.5", "--against": "oren_nayar", "--map": "rho=rho",
                  "--effort": "full", "--seconds": "0.001", "--require": "energy", "--max-theta": "40", "--keep-fill": None,
                  "--quantity": "BRF", "--mirror-side": "negative", "--layout": "none.json", "--seed": "3", "--picture": "none.png", "--integrators": None,
                  "--samplers": None,
                  "--microsurface": None, "--numerics": None, "--gpu": None, "--json": None, "--sample": "brdfSample",
                  "--pdf": "brdfPdf", **{k: v for k, v in SHADER.items()
                                                                                              if k != "--set"}}),
    "plan": ({"fit": ["fit", "s.csv", "t.csv", "--form", "ward", "-o", "OUT"], "study": ["study", "s.csv", "t.csv", "-o", "OUT"]},
             {**FIT, "--unit-size": "1"}),
}
VERBS["render"] = ({"picture": [A, "-o", "OUT.png"], "two pictures": [A, "--compare", B, "-o", "OUT.png"], "layers": [A, "-o", "OUT.exr"],
           "measures": [A, "--probe", "256,200", "--json"], "animation": [A, "--turntable", "2", "-o", "OUT.webp"]},
          {"--scene": "none.json", "--state": "none.json", "--width": "80", "--height": "80", "--gbuffer-bits": "8",
           "--shading": "phong", "--per-vertex": None, "--as-coded": None, "--tone-map": "reinhard", "--exposure": "3",
           "--supersample": "2", "--no-dither": None, "--environment": "dusk", "--rotate": "30", "--samples": "16", "--noise": "5%",
           "--hard-light": None, "--forward": None, "--memory-limit": "1G", "--validation": None, "--shape": "vase",
           "--over": "alpha=0.1:0.9", "--balls": "3", "--turntable": "3", "--fps": "10", "--quality": "20", "--compare": "embree",
           "--measured": "s.csv", "--show": "picture", "--split": None, "--split-at": "0.3", "--gbuffer": None, "--no-labels": None,
           "--probe": "5,5", "--times": None, "--json": None, **SHADER})


def made(folder, verb, words, name):
    """Returns the exit code, a checksum of all output files, and the text of both streams."""
    words = [w.replace("OUT", name) for w in words]
    done = subprocess.run([brdf, verb, *words], cwd=folder, capture_output=True)
    text = done.stdout.replace(name.encode(), b"")
    if text.startswith(b"{"):  # what names the command and the seed themselves says nothing of their effect
        told = json.loads(text)
        for place in (told, told.get("provenance", {})):
            for key in ("command", "seed", "seeds", "provenance_seed", "options", "passes"):
                place.pop(key, None) if isinstance(place, dict) else None
        text = json.dumps(told).encode()
    total = hashlib.sha256(text)
    for file in sorted(folder.rglob(f"{name}*")):
        for one in sorted(file.rglob("*")) if file.is_dir() else [file]:
            if one.is_file():
                total.update(re.sub(rb'"command": "[^"]*"', b"", one.read_bytes()).replace(name.encode(), b""))
    return done.returncode, total.hexdigest(), done.stderr.decode(errors="replace").strip()


def with_fill(table):
    """Adds a second channel, with zeros in place of missing measurements."""
    lines = table.read_text().splitlines()
    head = next(k for k, line in enumerate(lines) if line.startswith("theta_i"))
    lines[head] += ",g"
    for k in range(head + 1, len(lines)):
        *angles, value = lines[k].split(",")
        lines[k] = ",".join(angles + (["0", "0"] if k % 40 == 7 else [value, f"{0.8 * float(value):.9g}"]))
    table.write_text("\n".join(lines) + "\n")


def is_wanted(verb):
    return verb == call.verb if call.verb else call.all or verb not in SLOW


def main():
    surface = {v["name"]: v for v in json.loads(subprocess.run([brdf, "describe", "json"], capture_output=True, check=True).stdout)["verbs"]}
    faults = pairs = 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for k, (name, form) in enumerate((("s", "ward"), ("t", "phong"))):
            made_up = subprocess.run([brdf, "synth", "--form", form, "--noise", "0.05", "--seed", str(k), "-o", f"{name}.csv"], cwd=folder,
                                     capture_output=True)
            assert made_up.returncode == 0, made_up.stderr
            with_fill(folder / f"{name}.csv")
        subprocess.run([brdf, "synth", "--form", "cook_torrance", "--set", "kd=0.4,0.3,0.2", "--texels", "3x2", "--lights", "30", "-o",
                        "stack"], cwd=folder, capture_output=True, check=True)
        for name, source in (("a", "alumina_ceramic"), ("b", "copper")):
            (folder / f"{name}.json").write_bytes(next((data / "materials").glob(f"{source}*.json")).read_bytes())
        for verb, (products, values) in VERBS.items():
            known = {n for o in surface[verb]["options"] for n in o["names"] if n.startswith("--")} - {"--help", "--output", "--quiet"}
            if known != set(values):
                print(f"{verb}: no value, or no such option: {sorted(known ^ set(values))}")
                faults += 1
            for product, base in products.items() if is_wanted(verb) else ():
                name = f"{verb}_{product}_".replace(" ", "_")
                code, plain, said = made(folder, verb, base, f"{name}plain")
                if code > 1:
                    sys.exit(f"{verb}, {product}: exit code {code}: {said}")
                for n, (option, value) in enumerate(sorted(values.items())):
                    if option in base or option in NO_BYTES:
                        continue
                    pairs += 1
                    code, bytes_of, said = made(folder, verb, [*base, option, *([value] if value else [])], f"{name}with{n:02d}")
                    if code < 0:
                        print(f"{verb}, {product}: {option} {value or ''} ends by signal {-code}")
                        faults += 1
                    if code != 2 and bytes_of == plain:
                        print(f"{verb}, {product}: {option} {value or ''} has no effect ({code}) {said[:120]}")
                        faults += 1
    print(f"{pairs} pairs of product and option: {faults} faults")
    return 1 if faults else 0


sys.exit(main())
