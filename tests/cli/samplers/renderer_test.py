#!/usr/bin/env python3
# ctest: cli.renderers_sampler label=cli cost=15 needs=plain @brdf@ @build@ retro_beckmann
# ctest: cli.renderers_samplers label=slow timeout=3600 needs=plain @brdf@ @build@
"""renderer_test.py BRDF BUILD [FORM...]: the samplers that the renderer draws directions with follow their densities.

`brdf validate --shader` judges the traced value, sampler and density of each form with a sampler (or of the FORMs) in float, around the
default parameters: no check of the sampler may fail. Exit code 77: this build has no renderer, or no compiler of shaders.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

brdf, generated = sys.argv[1], pathlib.Path(sys.argv[2]) / "render/generated"
if not (generated / "samplers.glsl").exists():
    print("this build has no renderer")
    sys.exit(77)
CODE = {name: (generated / name).read_text(encoding="utf-8") for name in ("brdf.glsl", "samplers.glsl")}
KERNELS = ("brdf_exp", "brdf_log", "brdf_log1p", "brdf_erfcx", "brdf_angle")
CHECKS = re.compile(r"density_\w+|sample_\w+|jacobian")


def function(file, name):
    return re.search(rf"^\w+ {name}\(.*?^\}}$", CODE[file], re.M | re.S)[0]


def shader_of(form):
    shapes = [p for p in form["parameters"] if p["kind"] == "shape"]
    weights = [p for p in form["parameters"] if p["kind"] == "weight"]
    ranges = "".join(f"//: param {p['name']} {max(p['min'], p['default'] / 2)} {min(p['max'], 2 * p['default'])} {p['default']}\n" for p in shapes)
    declared = "".join(f", float {p['name']}" for p in shapes)
    given = "".join(f", {p['name']}" for p in shapes)
    constants = "".join(f", vec3({float(p['default'])})" for p in weights)
    name = form["form"]
    parts = [ranges, *(function("brdf.glsl", kernel) for kernel in KERNELS), function("brdf.glsl", f"brdf_eval_{name}"),
             function("samplers.glsl", f"brdf_sample_{name}"), function("samplers.glsl", f"brdf_pdf_{name}"),
             f"vec3 brdf(vec3 L, vec3 V{declared}) {{ return brdf_eval_{name}(L, V{given}{constants}); }}",
             f"vec3 brdfSample(vec3 u, vec3 V{declared}) {{ return brdf_sample_{name}(u, V{given}); }}",
             f"float brdfPdf(vec3 L, vec3 V{declared}) {{ return brdf_pdf_{name}(L, V{given}); }}"]
    return "\n".join(parts) + "\n"


forms = json.loads(subprocess.run([brdf, "models", "--json"], capture_output=True, text=True, check=True).stdout)["forms"]
wanted = [f for f in forms if f"brdf_sample_{f['form']}(" in CODE["samplers.glsl"] and (f["form"] in sys.argv[3:] or len(sys.argv) == 3)]
assert len(wanted) >= max(1, len(sys.argv[3:])) and (sys.argv[3:] or len(wanted) > 20), [f["form"] for f in wanted]
wrong = []
with tempfile.TemporaryDirectory() as folder:
    for form in wanted:
        file = pathlib.Path(folder) / f"{form['form']}.glsl"
        file.write_text(shader_of(form), encoding="utf-8")
        done = subprocess.run([brdf, "validate", "--shader", file, "--entry", "brdf", "--effort", "quick", "--json"],
                              capture_output=True, text=True, check=False)
        if "no shader compiler" in done.stderr:
            print(done.stderr)
            sys.exit(77)
        assert done.stdout, done.stderr
        found = {f["check"]: f["verdict"] for f in json.loads(done.stdout)["findings"] if CHECKS.fullmatch(f["check"])}
        assert found["sample_distribution"] in ("pass", "fail"), found  # decided, so that the test can fail
        print(form["form"], found, flush=True)
        wrong += [f"{form['form']}: {check}" for check, verdict in found.items() if verdict == "fail"]
assert not wrong, wrong
