"""The commands that faults are tried on, one or more for every verb, and the files that they need."""
import dataclasses
import os
import shutil
import struct
import subprocess

MATERIAL = """{
  "format": "brdf-material", "version": 1, "form": "ward", "channels": ["r", "g", "b"],
  "weights": {"kd": [0.9, 0.5, 0.5], "ks": [0.8, 0.8, 0.8]}, "shape": {"alpha_x": 0.2, "alpha_y": 0.2}
}
"""
DIRECTIONS = "theta_i,phi_i,theta_o,phi_o\n30,180,30,0\n0,0,45,0\n"
SCENE = """{
  "format": "brdf-scene", "version": 1,
  "camera": {"position": [0, 0, 4], "target": [0, 0, 0], "width": 16, "height": 16},
  "lights": [{"type": "directional", "direction": [1, -1, -1], "intensity": 3}],
  "objects": [{"mesh": "model.obj", "material": "material.json", "textures": {"albedo": "texture.png"}}]
}
"""
# As a spreadsheet writes it: UTF-16, semicolons, decimal commas, a row for each value.
LABORATORY = """"Incident angle (deg)";"Incident azimuth";"Viewing angle (deg)";"Viewing azimuth";"Wavelength (nm)";"BRDF"
30,0;180,0;20,0;0,0;450;0,25
30,0;180,0;20,0;0,0;550;0,31
30,0;180,0;40,0;0,0;450;0,26
30,0;180,0;40,0;0,0;550;0,32
"""
BUDGET = """source,standard_uncertainty,unit,shared_by
reference_standard,0.01,relative,table
zero_theta_o,0.2,degree,light
"""
# A layout of laboratory.csv, which gives the values another quantity.
LAYOUT = """{"format": "brdf-layout", "version": 1, "quantity": "BRF", "columns": [
  {"name": "Incident angle (deg)", "is": "theta_i"}, {"name": "Incident azimuth", "is": "phi_i"},
  {"name": "Viewing angle (deg)", "is": "theta_o"}, {"name": "Viewing azimuth", "is": "phi_o"},
  {"name": "Wavelength (nm)", "is": "wavelength", "unit": "nm"}, {"name": "BRDF", "is": "value"}]}
"""
MODEL = """v -1 -1 0
v 1 -1 0
v 0 1 0
vt 0 0
vt 1 0
vt 0 1
f 1/1 2/2 3/3
"""


@dataclasses.dataclass
class Case:
    name: str
    words: list
    outputs: list = dataclasses.field(default_factory=list)
    inputs: list = dataclasses.field(default_factory=list)
    short: bool = False   # in the short selection
    same: bool = True     # the same bytes every time; otherwise an output is complete if it has the end of a file of its kind
    draws: bool = False   # needs a driver of Vulkan
    parts: bool = False   # the failure of one output appears in others (a summary), which are complete nevertheless
    kept: bytes = b""     # words on stdout for results that an earlier run had finished
    before: list = dataclasses.field(default_factory=list)    # commands that make further inputs, from these
    fresh: bool = False   # no output exists before the run
    optional: list = dataclasses.field(default_factory=list)  # outputs that are old or new, however the command ends
    window: bool = False  # needs a display

    @property
    def verb(self):
        return self.words[0]


TEXTURED = ("uniform sampler2D map;\n"
            "float brdf(vec3 L, vec3 V, vec3 N) { return 0.3 * texture(map, L.xy).r; }\n")
STACK = ["stack/lights.csv"] + [f"stack/image_{k:05d}.exr" for k in range(4)]
PLAN = ["plan", "fit", "samples.csv", "more.csv", "--form", "lambert", "--no-pictures", "-o", "job"]
CASES = [
    Case("models", ["models"], short=True),
    Case("doctor", ["doctor"]),
    Case("models --json", ["models", "ward", "--json"]),
    Case("eval", ["eval", "--material", "material.json", "directions.csv", "-o", "values.csv"], ["values.csv"],
         ["material.json", "directions.csv"], short=True),
    Case("eval to stdout", ["eval", "--form", "ward", "directions.csv"], [], ["directions.csv"], short=True),
    Case("albedo", ["albedo", "--material", "material.json", "--theta", "30", "--tolerance", "1e-2", "--json"], [],
         ["material.json"]),
    Case("convert-parameters", ["convert-parameters", "material.json", "--to", "gloss_60", "--json"], [], ["material.json"]),
    Case("synth", ["synth", "--form", "lambert", "--grid", "in_plane", "--step", "20", "-o", "samples.csv"],
         ["samples.csv"]),
    Case("synth --microsurface", ["synth", "--microsurface", "mirror_grooves", "--set", "alpha=0.3", "--theta-i", "30",
                                  "--surfaces", "8", "--rays", "64", "--threads", "2", "-o", "samples.csv"],
         ["samples.csv"]),
    Case("fit", ["fit", "samples.csv", "--form", "lambert", "-o", "fitted.json", "--report", "fit.html", "--json"],
         ["fitted.json", "fit.html"], ["samples.csv"]),
    Case("fit without a report", ["fit", "samples.csv", "--form", "lambert", "-o", "fitted.json", "--json"], ["fitted.json"],
         ["samples.csv"], short=True),
    Case("fit --form auto", ["fit", "samples.csv", "--form", "auto", "-o", "fitted.json", "--report", "fit.html", "--json"],
         ["fitted.json", "fit.html"], ["samples.csv"]),
    Case("fit a batch", ["fit", "samples.csv", "more.csv", "--form", "lambert", "--jobs", "2", "-o", "out"],
         ["out/" + name for name in ("samples.json", "samples.fit.json", "samples.html", "more.json", "more.fit.json",
                                     "more.html", "summary.csv", "summary.html")],
         ["samples.csv", "more.csv"], parts=True, draws=True),
    Case("next", ["next", "samples.csv", "--reach", "reach.csv", "--form", "lambert", "--noise", "0.01", "--rows", "2", "-o",
                  "next.csv"], ["next.csv"], ["samples.csv"],
         before=[["synth", "--form", "lambert", "--grid", "hemisphere", "--step", "35", "-o", "reach.csv"]]),
    Case("consensus", ["consensus", "samples.csv", "more.csv", "--form", "lambert", "--report", "consensus.html", "--json"],
         ["consensus.html"], ["samples.csv", "more.csv"]),
    Case("compare", ["compare", "samples.csv", "more.csv", "--form", "lambert", "--report", "difference.html", "--json"],
         ["difference.html"], ["samples.csv", "more.csv"]),
    Case("study", ["study", "samples.csv", "more.csv", "--form", "lambert", "--jobs", "2", "-o", "out"],
         ["out/index.html", "out/study.json"] +
         [f"out/{sample}/{name}" for sample in ("samples", "more")
          for name in ("index.html", "study.json", "sheet.json", "fit.json", "properties.json", "material.json",
                       "material.glsl", "measured.png", "fitted.png", "difference.png",
                       "studio.png", "studio_small.png")],
         ["samples.csv", "more.csv"], parts=True, draws=True, kept=b" (kept)"),
    Case("validate a table", ["validate", "samples.csv", "-o", "report.html", "--json"], ["report.html"],
         ["samples.csv"]),
    Case("validate a material", ["validate", "material.json", "--picture", "texture.png", "-o", "report.html"],
         ["report.html"], ["material.json", "texture.png"]),
    Case("validate to Markdown", ["validate", "samples.csv", "-o", "report.md"], ["report.md"], ["samples.csv"]),
    Case("parity", ["parity", "--form", "lambert", "--json"], draws=True),
    Case("validate --gpu", ["validate", "--gpu", "--form", "lambert", "--json"], draws=True, same=False),
    Case("render to PNG", ["render", "--scene", "scene.json", "-o", "picture.png"], ["picture.png"],
         ["scene.json", "model.obj", "material.json", "texture.png"], draws=True, same=False),
    Case("render to EXR", ["render", "material.json", "--width", "16", "--height", "16", "-o", "picture.exr"],
         ["picture.exr"], ["material.json"], draws=True, same=False),
    Case("render in a light", ["render", "material.json", "--environment", "light.hdr", "--samples", "16", "--supersample",
                               "2", "--width", "16", "--height", "16", "-o", "picture.png"], ["picture.png"],
         ["material.json", "light.hdr"], draws=True, same=False),
    Case("render samples", ["render", "material.json", "--measured", "samples.csv", "--width", "16", "--height", "16",
                            "-o", "picture.png"], ["picture.png"], ["material.json", "samples.csv"], draws=True,
         same=False),
    Case("render --over", ["render", "material.json", "--over", "alpha=0.1:0.4", "--balls", "2", "--shape", "model.obj",
                           "--width", "16", "--height", "16", "-o", "picture.png"], ["picture.png"],
         ["material.json", "model.obj"], draws=True, same=False),
    Case("render --turntable", ["render", "material.json", "--turntable", "2", "--width", "16", "--height", "16", "-o",
                                "turning.webp"], ["turning.webp"], ["material.json"], draws=True, same=False),
    Case("render frames", ["render", "material.json", "--turntable", "2", "--width", "16", "--height", "16", "-o",
                           "frame%d.png"], ["frame0.png", "frame1.png"], ["material.json"], draws=True, same=False),
    Case("lobes --body", ["lobes", "material.json", "--body", "--measured", "samples.csv", "--width", "64", "-o",
                             "lobe.png"], ["lobe.png"], ["material.json", "samples.csv"]),
    Case("lobes", ["lobes", "material.json", "--width", "64", "-o", "lobes.png"], ["lobes.png"],
         ["material.json"]),
    Case("maps", ["maps", "tiles", "--size", "8", "-o", "maps"], ["maps/tiles.png"]),
    Case("export", ["export", "--material", "material.json", "--to", "glsl", "-o", "material.glsl"],
         ["material.glsl"], ["material.json"]),
    Case("export to GLSL ES", ["export", "--material", "material.json", "--to", "glsl-es", "-o", "material.glsl"],
         ["material.glsl"], ["material.json"]),
    Case("export to glTF", ["export", "--material", "material.json", "--to", "gltf", "-o", "material.gltf"],
         ["material.gltf"], ["material.json"]),
    Case("export a lookup table", ["export", "--material", "material.json", "--to", "dfg", "--table-layout", "three", "-o", "dfg.exr"],
         ["dfg.exr"], ["material.json"]),
    Case("export maps", ["export", "--maps", "fitted/maps.exr", "--to", "gltf", "--loss-map", "loss.exr", "-o", "fitted.glb"],
         ["fitted.glb", "loss.exr"], STACK,
         before=[["fit", "stack", "--form", "lambert", "--metric", "log", "-o", "fitted"]], parts=True),
    Case("fit a stack", ["fit", "stack", "--form", "lambert", "--metric", "log", "-o", "maps", "--report", "maps.html",
                         "--json"],
         ["maps/maps.exr", "maps/maps.json", "maps/scene.json", "maps/albedo.png", "maps/normal.png", "maps.html"], STACK,
         parts=True, same=False),
    Case("synth --texels", ["synth", "--form", "lambert", "--texels", "8x8", "--lights", "4", "-o", "stack"],
         [*STACK, "stack/truth/truth.exr"]),
    Case("plan", ["plan", "fit", "samples.csv", "more.csv", "--form", "lambert", "-o", "job"], ["job/plan.json"],
         ["samples.csv", "more.csv"], fresh=True, same=False),
    Case("work", ["work", "job", "--unit", "0"], ["job/units/000/00000.unit"], ["samples.csv", "more.csv"], before=[PLAN],
         same=False),
    Case("collect", ["collect", "job", "-o", "out"],
         ["out/" + name for name in ("samples.json", "samples.fit.json", "samples.html", "more.json", "more.fit.json",
                                     "more.html", "summary.csv", "summary.html")],
         ["samples.csv", "more.csv"], before=[PLAN, ["work", "job"]], parts=True),
    Case("collect --missing", ["collect", "job", "--missing"], [], ["samples.csv", "more.csv"], before=[PLAN]),
    Case("prove", ["prove", "--form", "lambert", "--property", "finite,energy", "-o", "certificate.json"],
         ["certificate.json"], same=False),
    Case("prove a material", ["prove", "material.json", "--property", "energy", "--gap", "0.2", "--json"], [],
         ["material.json"], same=False),
    Case("prove --check", ["prove", "--check", "certificate.json"], [], ["certificate.json"]),
    Case("prove a shader", ["prove", "--shader", "shader.glsl", "--property", "finite", "--json"], [], ["shader.glsl"],
         same=False),
    Case("check-shader", ["check-shader", "shader.glsl", "--seconds", "1", "--junit", "shader.xml", "--sarif", "shader.sarif"],
         ["shader.xml", "shader.sarif"], ["shader.glsl"]),
    Case("check-shader accepts", ["check-shader", "shader.glsl", "--seconds", "1", "--baseline", "accepted.json", "--update-baseline"],
         ["accepted.json"], ["shader.glsl"]),
    Case("eval a shader", ["eval", "--shader", "shader.glsl", "directions.csv", "-o", "values.csv"], ["values.csv"],
         ["shader.glsl", "directions.csv"]),
    Case("eval a shader with a texture", ["eval", "--shader", "textured.glsl", "--texture", "map=grey.exr", "directions.csv",
                                          "-o", "values.csv"], ["values.csv"],
         ["textured.glsl", "grey.exr", "directions.csv"]),
    Case("view", ["view", "material.json", "--measured", "samples.csv", "--hard-light", "--width", "64", "--height", "64",
                  "--frames", "3"], [], ["material.json", "samples.csv"], optional=["state/brdf/recent"], draws=True,
         window=True, same=False),
    Case("view --commands", ["view", "--commands"]),
    Case("describe", ["describe", "json"]),
    Case("describe for a shell", ["describe", "zsh"]),
    Case("describe as pages", ["describe", "man", "-o", "man"],
         ["man/brdf.1"] + [f"man/brdf-{verb}.1" for verb in
                           ("albedo", "convert", "describe-table", "eval", "export", "fit", "models", "next", "recommend", "render", "study", "synth",
                            "trade", "validate", "view")]),
    Case("convert a laboratory's", ["convert", "laboratory.csv", "table.csv"], ["table.csv"], ["laboratory.csv"]),
    Case("convert by a layout", ["convert", "laboratory.csv", "table.csv", "--layout", "layout.json"], ["table.csv"],
         ["laboratory.csv", "layout.json"]),
    Case("fit with a budget", ["fit", "samples.csv", "--form", "ward", "--budget", "budget.csv", "-o", "certain.json"],
         ["certain.json"], ["samples.csv", "budget.csv"]),
    Case("describe-table", ["describe-table", "laboratory.csv", "-o", "proposal.json"], ["proposal.json"],
         ["laboratory.csv"], short=True),
    Case("describe-table to stdout", ["describe-table", "laboratory.csv"], [], ["laboratory.csv"]),
    Case("convert to CSV", ["convert", "samples.csv", "table.csv"], ["table.csv"], ["samples.csv"], short=True),
    Case("convert to ASTM", ["convert", "samples.csv", "table.astm"], ["table.astm"], ["samples.csv"]),
    Case("convert to EXR", ["convert", "samples.csv", "table.exr"], ["table.exr"], ["samples.csv"], short=True),
    Case("convert to MERL", ["convert", "samples.csv", "table.binary"], ["table.binary"], ["samples.csv"]),
    Case("trade --compare", ["trade", "--compare", "ledger.json", "ledger.json"], [], ["ledger.json"]),
    Case("trade", ["trade", "--quick", "--only", "Fresnel of glass", "-o", "ledger2.json", "-o", "ledger2.csv",
                   "-o", "ledger2.html"],
         ["ledger2.json", "ledger2.csv", "ledger2.html"], same=False),
    Case("recommend", ["recommend", "--scene", "scene.json", "--reference", "material.json", "--ledger", "ledger.json",
                       "-o", "out"],
         ["out/" + name for name in ("material.json", "model.png", "reference.png", "difference.png", "report.html")],
         ["scene.json", "model.obj", "material.json", "texture.png", "ledger.json"], draws=True,
         same=False),
]


def exr_of_one_texel(value):
    """Returns the bytes of an OpenEXR picture with one texel and the channel Y, not compressed."""
    def attribute(name, kind, content):
        return f"{name}\0{kind}\0".encode() + struct.pack("<I", len(content)) + content
    box = struct.pack("<4i", 0, 0, 0, 0)
    header = (struct.pack("<II", 20000630, 2) + attribute("channels", "chlist", b"Y\0" + struct.pack("<4I", 2, 0, 1, 1) + b"\0") +
              attribute("compression", "compression", b"\0") + attribute("dataWindow", "box2i", box) +
              attribute("displayWindow", "box2i", box) + attribute("lineOrder", "lineOrder", b"\0") +
              attribute("pixelAspectRatio", "float", struct.pack("<f", 1)) + attribute("screenWindowCenter", "v2f", bytes(8)) +
              attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0")
    return header + struct.pack("<QiIf", len(header) + 8, 0, 4, value)


def make_inputs(folder, brdf, source):
    """Writes every input once; each case copies the files that it reads."""
    def write(name, text):
        with open(os.path.join(folder, name), "w") as file:
            file.write(text)

    with open(os.path.join(folder, "laboratory.csv"), "wb") as file:
        file.write(LABORATORY.encode("utf-16"))
    with open(os.path.join(folder, "light.hdr"), "wb") as file:
        file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n" + 8 * bytes((128, 120, 110, 129)))

    with open(os.path.join(folder, "grey.exr"), "wb") as file:
        file.write(exr_of_one_texel(0.25))

    def run(*words):
        subprocess.run([brdf, *words], cwd=folder, check=True, capture_output=True)
    write("material.json", MATERIAL)
    write("directions.csv", DIRECTIONS)
    write("layout.json", LAYOUT)
    write("budget.csv", BUDGET)
    write("scene.json", SCENE)
    write("model.obj", MODEL)
    write("textured.glsl", TEXTURED)
    synth = ["synth", "--form", "lambert", "--grid", "in_plane", "--theta-i", "0,30", "--step", "15", "-o"]
    run(*synth, "samples.csv")
    run(*synth, "more.csv")
    run("synth", "--form", "lambert", "--texels", "8x8", "--lights", "4", "-o", "stack")
    run("prove", "--form", "lambert", "--property", "finite,energy", "-o", "certificate.json")
    shutil.copy(os.path.join(source, "data", "shaders", "sound.glsl"), os.path.join(folder, "shader.glsl"))
    run("maps", "tiles", "--size", "8", "-o", ".")
    os.rename(os.path.join(folder, "tiles.png"), os.path.join(folder, "texture.png"))
    with open(os.path.join(source, "data", "ledger.json"), "rb") as file:
        content = file.read()
    with open(os.path.join(folder, "ledger.json"), "wb") as file:
        file.write(content)
