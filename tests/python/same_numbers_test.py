# ctest: python.same_numbers label=python timeout=1200 module @brdf@ @source@
"""The module's numbers are the program's, bit for bit: 50 cases. Usage: same_numbers_test.py BRDF SOURCE"""
import csv
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import brdf

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
DATA = SOURCE / "data"
DIRECTIONS = DATA / "directions.csv"
cases = set()


def run(*words, code=(0,)):
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, check=False)
    assert done.returncode in code, (words, done.returncode, done.stderr)
    return done.stdout


def columns(text):
    """Returns a CSV's columns by name, as floats."""
    rows = list(csv.reader(io.StringIO("\n".join(line for line in text.splitlines() if not line.startswith("#")))))
    return {name: np.array([float(row[k]) for row in rows[1:]]) for k, name in enumerate(rows[0])}


def bare(value):
    """Returns the JSON without the keys about the command line and without "proof", because the module has no prover
    (docs/python.md)."""
    told = ("provenance", "brdf_version", "command", "subject", "proof")
    if isinstance(value, dict):
        return {k: bare(v) for k, v in value.items() if k not in told}
    return [bare(v) for v in value] if isinstance(value, list) else value


def without_head(shader):
    """Returns a shader's text after the line that names the command."""
    return shader.partition("\n")[2]


def settings(values):
    return [word for name, value in values.items()
            for word in ("--set", f"{name}={','.join(map(repr, np.atleast_1d(value).tolist()))}")]


def drawn(form, random):
    """Returns random parameters of a form, with three channels if the form has weights."""
    chosen = {}
    for p in form.parameters:
        low = max(p.min, 0.02 * p.usual_max)
        values = random.uniform(low, min(p.usual_max, p.max), 3 if p.kind == "weight" else 1)
        chosen[p.name] = values if p.kind == "weight" else float(values[0])
    return chosen


class Same(unittest.TestCase):
    def case(self, name):
        self.assertNotIn(name, cases)
        cases.add(name)
        return self.subTest(name)

    def test_eval_of_every_form(self):
        random = np.random.default_rng(2)
        angles = columns(DIRECTIONS.read_text())
        given = [angles[name] for name in ("theta_i", "phi_i", "theta_o", "phi_o")]
        for k, form in enumerate(brdf.forms()):
            with self.case(f"eval {form.name}"):
                values = drawn(form, random)
                cos = k % 5 == 0
                printed = columns(run("eval", "--form", form.name, *settings(values), DIRECTIONS, *["--cos"] * cos))
                material = brdf.material(form.name, **values)
                f = material.eval_degrees(*given, cos=cos)
                channels = ["f"] if len(material.channels) == 1 else [f"f_{c}" for c in material.channels]
                np.testing.assert_array_equal(f, np.stack([printed[c] for c in channels], axis=-1))

    def test_eval_of_every_material_file(self):
        angles = columns(DIRECTIONS.read_text())
        given = [angles[name] for name in ("theta_i", "phi_i", "theta_o", "phi_o")]
        for path in sorted((DATA / "materials").glob("*.json")):
            with self.case(f"eval {path.name}"):
                printed = columns(run("eval", "--material", path, DIRECTIONS))
                material = brdf.load(path)
                channels = ["f"] if len(material.channels) == 1 else [f"f_{c}" for c in material.channels]
                expected = np.stack([printed[c] for c in channels], axis=-1)
                np.testing.assert_array_equal(material.eval_degrees(*given), expected)
                np.testing.assert_array_equal(material.eval(*brdf.read_directions(DIRECTIONS)), expected)

    def test_a_material_that_names_a_shader(self):
        with tempfile.TemporaryDirectory() as folder:
            shader, made, samples = (pathlib.Path(folder, name) for name in ("veil.glsl", "veil.json", "s.csv"))
            shader.write_text("//: param body 0 1 0.4\n//: param edge 0.5 6 2\nfloat brdf(vec3 L, vec3 V, vec3 N, float body, float edge) {\n"
                              "  return body * (0.1 + pow(1.0 - dot(N, L) * dot(N, V), edge));\n}\n")
            words = ["--shader", shader, "--set", "body=0.3", "--set", "edge=3.5"]
            done = subprocess.run([PROGRAM, "synth", *map(str, words), "--grid", "in_plane", "--noise", "0", "-o", str(samples)],
                                  capture_output=True, text=True, check=False)
            if done.returncode == 3:
                self.skipTest("this build has no compiler of shaders")
            for more in ([], ["--embed"]):
                run("fit", samples, "--shader", shader, "-o", made, *more, code=(0, 1))
                material = brdf.load(made)
                printed = columns(run("eval", "--material", made, DIRECTIONS))["f"]
                np.testing.assert_array_equal(material.eval(*brdf.read_directions(DIRECTIONS))[..., 0], printed)
                rows = json.loads(run("albedo", "--material", made, "--theta", "20,70", "--json"))["results"]
                self.assertEqual(material.albedo([20, 70]).value.reshape(-1).tolist(), [row["value"] for row in rows])
                copy = pathlib.Path(folder, "copy.json")
                material.save(copy)
                self.assertEqual(json.loads(copy.read_text())["shader"], json.loads(made.read_text())["shader"])
            run("fit", samples, "--shader", shader, "-o", made, code=(0, 1))
            shader.write_text(shader.read_text().replace("0.1", "0.2"))
            with self.assertRaisesRegex(brdf.InputError, "has changed since this material was made"):
                brdf.load(made)
            shader.unlink()
            with self.assertRaisesRegex(brdf.InputError, "does not exist"):
                brdf.load(made)

    def test_albedo(self):
        for form, values, options in (("lambert", {}, {}), ("ward", {"alpha": 0.1, "ks": 0.4}, {"phi": 30.0}),
                                      ("phong", {"kd": [0.1, 0.2, 0.3]}, {"fixed": "o"}),
                                      ("cook_torrance", {"alpha": 0.3}, {"tolerance": 1e-9}),
                                      ("oren_nayar", {}, {"rule": "adaptive", "tolerance": 1e-3})):
            with self.case(f"albedo {form}"):
                words = [w for name, value in options.items() for w in ("--" + name, value)]
                rows = json.loads(run("albedo", "--form", form, *settings(values), "--theta", "0,37.5,80", *words,
                                      "--json", code=(0, 1)))["results"]
                a = brdf.material(form, **values).albedo([0, 37.5, 80], **options)
                self.assertEqual(a.value.reshape(-1).tolist(), [row["value"] for row in rows])
                self.assertEqual(a.error_bound.reshape(-1).tolist(), [row["error_bound"] for row in rows])
                self.assertEqual(a.evaluations.reshape(-1).tolist(), [row["evaluations"] for row in rows])
                self.assertEqual(a.rule.reshape(-1).tolist(), [row["rule"] for row in rows])

    def test_synth(self):
        for k, (form, words, options) in enumerate((
                ("ward", ["--grid", "in_plane", "--noise", "0.05", "--seed", "7"],
                 {"grid": "in_plane", "noise": 0.05, "seed": 7}),
                ("ward", ["--theta-i", "20,50", "--step", "10", "--noise-floor", "0.001", "--sigma-columns"],
                 {"theta_i": [20, 50], "step": 10, "noise_floor": 0.001, "sigma_columns": True}),
                ("phong", ["--grid", "in_plane", "--aperture", "2", "--saturation", "0.5", "--clip-negatives"],
                 {"grid": "in_plane", "aperture": 2, "saturation": 0.5, "clip_negatives": True}),
                ("cook_torrance", ["--grid", "in_plane", "--azimuths", "0,30", "--blind-zone", "3"],
                 {"grid": "in_plane", "azimuths": [0, 30], "blind_zone": 3}))):
            with self.case(f"synth {k}"), tempfile.TemporaryDirectory() as folder:
                file = pathlib.Path(folder, "s.csv")
                values = {"alpha_x": 0.05, "alpha_y": 0.16} if form == "ward" else {}
                run("synth", "--form", form, *settings(values), *words, "-o", file)
                written, made = brdf.read(file), brdf.synth(brdf.material(form, **values), **options)
                for name in ("theta_i", "phi_i", "theta_o", "phi_o", "values", "sigma", "channels"):
                    np.testing.assert_array_equal(getattr(made, name), getattr(written, name), name)

    def test_fit(self):
        with tempfile.TemporaryDirectory() as folder:
            file, saved = pathlib.Path(folder, "s.csv"), pathlib.Path(folder, "m.json")
            made = brdf.synth(brdf.material("ward", kd=[0.3, 0.2], ks=0.2, alpha=0.12), grid="in_plane", noise=0.03, step=5)
            made.save(file)
            for words, options in ((["--form", "ward"], {"form": "ward"}),
                                   (["--form", "lambert+phong", "--metric", "log", "--starts", "2", "--seed", "3"],
                                    {"form": "lambert+phong", "metric": "log", "starts": 2, "seed": 3}),
                                   (["--form", "phong", "--fix", "ks=0.25,0.2", "--start", "exponent=40", "--bounds",
                                     "kd=0.1:0.9", "--robust", "huber:0.1", "--max-theta", "70"],
                                    {"form": "phong", "fix": {"ks": [0.25, 0.2]}, "start": {"exponent": 40},
                                     "bounds": {"kd": (0.1, 0.9)}, "robust": "huber:0.1", "max_theta": 70}),
                                   (["--form", "cook_torrance", "--physical", "--tie", "f0", "--weights", "uniform"],
                                    {"form": "cook_torrance", "physical": True, "tie": "f0", "weights": "uniform"}),
                                   (["--form", "ward", "--budget", DATA / "laboratory/budget.csv"],
                                    {"form": "ward", "budget": DATA / "laboratory/budget.csv"}),
                                   (["--form", "ward", "--free-scale", "--per-channel", "--anisotropic"],
                                    {"form": "ward", "free_scale": True, "per_channel": True, "anisotropic": True})):
                with self.case(f"fit {' '.join(map(str, words))}"):
                    printed = json.loads(run("fit", file, *words, "--json", "-o", saved, code=(0, 1)))
                    result = brdf.fit(file, **options)
                    self.assertEqual(bare(result.to_dict()), bare(printed))
                    self.assertEqual(bare(result.best.material.to_dict()), bare(json.loads(saved.read_text())))

    def test_albedo_of_a_fit_has_its_interval(self):
        with self.case("albedo of a fit"), tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "m.json")
            table = brdf.synth(brdf.material("ward", alpha=0.2), grid="in_plane", noise=0.05, step=5)
            material = brdf.fit(table, "ward").best.material
            material.save(file)
            row = json.loads(run("albedo", "--material", file, "--theta", 30, "--json"))["results"][0]
            a = material.albedo(30)
            self.assertEqual((a.value[0], a.low[0], a.high[0]), (row["value"], row["low"], row["high"]))
            self.assertLess(a.low[0], a.value[0])
            self.assertLess(a.value[0], a.high[0])

    def test_validate(self):
        for name, file in (("a material", DATA / "materials/rolled_brass.json"),
                           ("a table", sorted((DATA / "synthetic").glob("*.csv"))[0])):
            with self.case(f"validate {name}"):
                seeded = ("--seed", 3) if name == "a material" else ()  # nothing is random in tables
                printed = json.loads(run("validate", file, "--json", *seeded, code=(0, 1)))
                self.assertEqual(bare(brdf.validate(file, seed=3).to_dict()), bare(printed))

    def test_export_and_convert(self):
        path = DATA / "materials/rolled_brass.json"
        with self.case("export material"):
            self.assertEqual(without_head(brdf.load(path).export("glsl-es", include=True)),
                             without_head(run("export", "--material", path, "--to", "glsl-es", "--include")))
        with self.case("export form"):
            self.assertEqual(without_head(brdf.export("ward", "glsl")),
                             without_head(run("export", "--form", "ward", "--to", "glsl")))
        with self.case("models"):
            listed = json.loads(run("models", "--json"))["forms"]
            self.assertEqual([(f.name, [vars(p) for p in f.parameters]) for f in brdf.forms()],
                             [(f["form"], f["parameters"]) for f in listed])
        with self.case("convert"), tempfile.TemporaryDirectory() as folder:
            source = sorted((DATA / "synthetic").glob("*.csv"))[0]
            run("convert", source, f"{folder}/a.exr")
            brdf.convert(source, f"{folder}/b.exr")
            self.assertEqual(pathlib.Path(folder, "a.exr").read_bytes(), pathlib.Path(folder, "b.exr").read_bytes())

    @classmethod
    def tearDownClass(cls):
        print(f"{len(cases)} cases compared")
        assert len(cases) >= 50, len(cases)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
