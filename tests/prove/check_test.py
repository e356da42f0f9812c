#!/usr/bin/env python3
# ctest: prove.check_is_alone label=prove @brdf@ @brdf_check@
"""check_test.py BRDF BRDF_CHECK: tests that the printed commands repeat the witnesses of proofs, that exit codes report the verdict,
and that certificates are verified by a program without any code of the search."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

brdf, checker = (pathlib.Path(p).resolve() for p in sys.argv[1:3])


def run(*words, cwd=None):
    return subprocess.run([str(w) for w in words], capture_output=True, text=True, cwd=cwd)


symbols = run("nm", "-C", checker).stdout
assert "brdf::prove::check(" in symbols and "brdf::prove::enclose(" in symbols
for part in ("prove::cover(", "prove::prove(", "prove::find_negative", "prove::find_gain"):
    assert part not in symbols, f"{part} is in the checker"

with tempfile.TemporaryDirectory() as folder:
    done = run(brdf, "prove", "--form", "oren_nayar", "--form", "oren_nayar_full", "--seconds", "5", "-o", "c.json", "--json", cwd=folder)
    assert done.returncode == 1, done.stderr  # refuted
    witnesses = [r["witness"] for r in json.loads(done.stdout)["results"] if r["witness"]]
    assert len(witnesses) >= 4
    for w in witnesses:
        said = subprocess.run(["bash", "-c", w["command"].replace("brdf ", f"{brdf} ", 1)], capture_output=True, text=True).stdout
        numbers = [float(n) for n in re.findall(r"-?\d+\.?\d*(?:e[-+]?\d+)?", said)]
        assert any(abs(n - w["value"]) <= 1e-9 * abs(w["value"]) for n in numbers), (w, said)

    # Both programs give the same verdicts: a refuted property is not proved, and a requested property must have a result.
    for asked, code in (([], 1), (["--require", "energy"], 1), (["--property", "finite,reciprocity"], 0),
                        (["--property", "finite", "--require", "reciprocity"], 0), (["--property", "rounding", "--form", "oren_nayar"], 0),
                        (["--property", "finite", "--form", "lambert"], 1), (["--property", "beauty"], 2), (["--form", "beauty"], 2)):
        told = [run(*words, "c.json", *asked, cwd=folder) for words in ([checker], [brdf, "prove", "--check"])]
        assert [done.returncode for done in told] == [code, code], (asked, told)
        assert told[0].stdout == told[1].stdout, asked
    told = run(checker, "--require=energy", "c.json", cwd=folder).stdout
    assert "energy of oren_nayar: refuted, not proved: the albedo is 1.01518" in told, told
    for words in (["-o", "x.json"], ["--seconds", "3"], ["--gap", "1e-4"], ["--shader", "x.glsl"]):
        done = run(brdf, "prove", "--check", "c.json", *words, cwd=folder)
        assert done.returncode == 2 and "has no effect with --check" in done.stderr, (words, done)
    text = pathlib.Path(folder, "c.json").read_text()
    pathlib.Path(folder, "changed.json").write_text(re.sub(r"0\.3(\d)", lambda m: f"0.3{9 - int(m[1])}", text, count=1))
    assert pathlib.Path(folder, "changed.json").read_text() != text
    for words in ([checker], [brdf, "prove", "--check"]):
        assert run(*words, "changed.json", cwd=folder).returncode == 1
        pathlib.Path(folder, "none.json").write_text("{}")
        assert run(*words, "none.json", cwd=folder).returncode == 2

done = run(checker, "--help")
assert done.returncode == 0 and done.stdout.startswith("usage: brdf_check") and "Example:" in done.stdout, done.stdout
assert re.fullmatch(r"brdf_check \d+\.\d+\.\d+\n", run(checker, "--version").stdout)
for words in ([], ["--beauty"], ["a", "b"], ["a", "--require"]):
    assert run(checker, *words).returncode == 2, words

assert run(brdf, "prove", "--form", "ward", "--property", "finite", "--require", "reciprocity").returncode == 0
assert run(brdf, "prove", "--form", "cook_torrance_student", "--require", "energy").returncode == 1  # nothing is known
with tempfile.TemporaryDirectory() as folder:
    white = pathlib.Path(folder, "white.json")
    white.write_text('{"format": "brdf-material", "version": 1, "form": "lambert", "channels": ["r", "g"], "weights": {"rho": [0.25, 2]}, "shape": {}}')
    done = run(brdf, "prove", white, "--property", "energy", "--json")
    assert done.returncode == 1, done.stderr  # 2 is above 1
    said = json.loads(done.stdout)["results"]
    assert [r["verdict"] for r in said] == ["proved", "refuted"] and [r["channel"] for r in said] == ["r", "g"]
    assert all(abs(r["high"] - v) < 1e-3 and r["low"] <= v <= r["high"] + 1e-15 for r, v in zip(said, (0.25, 2)))
    # The certificate has the same verdict for each channel, and is refused for any other material.
    assert run(brdf, "prove", white, "-o", "c.json", cwd=folder).returncode == 1
    told = run(checker, "c.json", "--require", "energy", cwd=folder)
    assert told.returncode == 1 and "energy of " in told.stdout and " g: refuted, not proved" in told.stdout and " r: " not in told.stdout, told.stdout
    assert run(brdf, "prove", "--check", "c.json", white, "--property", "finite,non_negative,reciprocity", cwd=folder).returncode == 0
    grey = pathlib.Path(folder, "grey.json")
    grey.write_text(white.read_text().replace("0.25", "0.26"))
    told = run(brdf, "prove", "--check", "c.json", grey, "--property", "finite", cwd=folder)
    assert told.returncode == 1 and "has no material with these parameters" in told.stdout, told.stdout
    assert run(brdf, "prove", white, "-o", white).returncode == 2
    nothing = run(brdf, "prove", "--form", "ward", "--property", "rounding", "--seconds", "1e-9", "-o", "n.json", cwd=folder)
    assert nothing.returncode == 0, nothing.stderr
    pathlib.Path(folder, "empty.json").write_text('{"format":"brdf-proof","version":1,"seal":"a301b20c69a2aea0","results":[]}')
    told = run(checker, "empty.json", cwd=folder)
    assert told.returncode == 1 and "has no result" in told.stdout, told.stdout
# Proofs of a sound shader, and of a faulty shader with a witness that its command repeats. Exit code 3: this build has no shader
# compiler.
with tempfile.TemporaryDirectory() as folder:
    sound = pathlib.Path(folder, "sound.glsl")
    sound.write_text("//: param r 0 1 0.5\nfloat brdf(vec3 L, vec3 V, vec3 N, float r) { return r / 3.141592653589793; }\n")
    faulty = pathlib.Path(folder, "faulty.glsl")
    faulty.write_text("//: param r 0 1 0.5\nfloat brdf(vec3 L, vec3 V, vec3 N, float r) { return dot(N, L) - r; }\n")
    done = run(brdf, "prove", "--shader", sound, "--property", "finite,non_negative,energy", "--json")
    if done.returncode != 3:
        assert done.returncode == 0 and [r["verdict"] for r in json.loads(done.stdout)["results"]] == ["proved"] * 5, done.stdout + done.stderr
        done = run(brdf, "prove", "--shader", faulty, "--property", "non_negative,energy", "--json")
        found = json.loads(done.stdout)["results"]
        assert done.returncode == 1 and [r["verdict"] for r in found] == ["refuted"] * 3, done.stdout
        for w in (r["witness"] for r in found):
            said = subprocess.run(["bash", "-c", w["command"].replace("brdf ", f"{brdf} ", 1) if w["command"].startswith("brdf") else w["command"].replace("| brdf", f"| {brdf}")],
                                  capture_output=True, text=True).stdout
            numbers = [float(n) for n in re.findall(r"-?\d+\.?\d*(?:e[-+]?\d+)?", said)]
            assert any(abs(n - w["value"]) <= 1e-6 * abs(w["value"]) for n in numbers), (w, said)
        assert run(brdf, "prove", "--shader", sound, "-o", "c.json", cwd=folder).returncode == 2
    assert run(brdf, "prove", "--param", "r=0:1").returncode == 2

# validate marks its checks as proved or sampled. The one form with such a check takes most of the time of this test, so the check
# belongs to ./test --full.
expected = {("lambert", "finite"): "proved", ("lambert", "energy"): "proved", ("phong", "reciprocity"): "proved",
            ("phong", "non_negative"): "proved", ("phong", "energy"): "proved", ("oren_nayar", "energy"): None, ("lambert", "albedo"): None}
if "BRDF_THOROUGH" in os.environ:
    expected["cook_torrance_student", "energy"] = "sampled"
forms = [f"--form={form}" for form in sorted({form for form, _ in expected})]
said = json.loads(run(brdf, "validate", *forms, "--json").stdout)["findings"]
proof = {(f["subject"], f["check"]): f.get("proof") for f in said}
for (form, check), verdict in expected.items():
    assert proof[form, check] == verdict, (form, check, proof[form, check])
for words in (["--form", "ward", "--property", "beauty"], [], ["--form", "ward", "--seconds", "0"]):
    assert run(brdf, "prove", *words).returncode == 2, words
print("certificates, witnesses and exit codes hold")
