# ctest: python.behaviour label=python timeout=1200 module @brdf@ @source@
"""How the module behaves: errors, progress, interrupts, threads, memory, notebooks. Usage: behaviour_test.py BRDF SOURCE"""
import concurrent.futures
import gc
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np

import brdf

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
os.environ["BRDF_PROGRAM"] = PROGRAM
WARD = brdf.material("ward", kd=[0.3, 0.2, 0.1], ks=0.2, alpha=0.1)
TABLE = brdf.synth(WARD, grid="in_plane", step=5, noise=0.02)


class Errors(unittest.TestCase):
    def same_sentence(self, call, *words):
        """Requires that the module raises the sentence of the program, without the program's name and hint."""
        done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2, done.stderr)
        expected = done.stderr.strip().removeprefix("brdf: ").partition(" (see brdf ")[0]
        with self.assertRaises(brdf.InputError) as raised:
            call()
        self.assertEqual(str(raised.exception), expected)

    def test_the_programs_sentences(self):
        broken = pathlib.Path(self.folder.name, "broken.csv")
        broken.write_text("theta_i,phi_i,theta_o,phi_o,f\n1,2,3\n")
        samples = pathlib.Path(self.folder.name, "samples.csv")
        TABLE.save(samples)
        fit = lambda *words, **options: self.same_sentence(  # noqa: E731
            lambda: brdf.fit(samples, **options), "fit", samples, *words)
        self.same_sentence(lambda: brdf.read(broken), "fit", broken)
        self.same_sentence(lambda: brdf.read("/none"), "fit", "/none")
        self.same_sentence(lambda: brdf.load(broken), "eval", "--material", broken, SOURCE / "data/directions.csv")
        self.same_sentence(lambda: brdf.material("wrd"), "albedo", "--form", "wrd", "--theta", 0)
        self.same_sentence(lambda: brdf.material("ward", kd=-1), "albedo", "--form", "ward", "--set", "kd=-1.0", "--theta", 0)
        self.same_sentence(lambda: brdf.material("ward", kx=0.5), "albedo", "--form", "ward", "--set", "kx=0.5", "--theta", 0)
        self.same_sentence(lambda: WARD.albedo(95), "albedo", "--form", "ward", "--theta", 95)
        self.same_sentence(lambda: WARD.albedo(0, fixed="x"), "albedo", "--form", "ward", "--theta", 0, "--fixed", "x")
        self.same_sentence(lambda: WARD.albedo(0, rule="x"), "albedo", "--form", "ward", "--theta", 0, "--rule", "x")
        fit("--form", "wrd", form="wrd")
        fit("--metric", "x", metric="x")
        fit("--robust", "x", robust="x")
        fit("--max-theta", "95", max_theta=95)
        fit("--starts", "-1", starts=-1)
        fit("--aperture", "91", aperture=91)
        fit("--fix", "kd=inf", fix={"kd": np.inf})
        fit("--form", "ward", "--fix", "kx=0.5", form="ward", fix={"kx": 0.5})
        fit("--bounds", "kd=0.5:0.1", bounds={"kd": (0.5, 0.1)})
        fit("--max-theta", "nan", max_theta=np.nan)
        fit("--starts", "2.5", starts=2.5)
        fit("--seed", "-1", seed=-1)
        folder = f"{self.folder.name}/out"
        self.same_sentence(lambda: brdf.fit_files([samples], folder, jobs=-1), "fit", samples, "--jobs", -1, "-o", folder)
        self.same_sentence(lambda: brdf.validate(samples, seed=-1), "validate", samples, "--seed", -1)
        self.same_sentence(lambda: brdf.validate(samples, effort="x"), "validate", samples, "--effort", "x")
        self.same_sentence(lambda: brdf.synth(WARD, step=np.inf), "synth", "--form", "ward", "--step", "inf", "-o",
                           f"{self.folder.name}/x.csv")
        self.same_sentence(lambda: WARD.albedo(np.nan), "albedo", "--form", "ward", "--theta", "nan")
        self.same_sentence(lambda: brdf.validate(samples, require="x"), "validate", samples, "--require", "x")
        self.same_sentence(lambda: brdf.validate(samples, max_theta=0), "validate", samples, "--max-theta", 0)
        self.same_sentence(lambda: brdf.validate(), "validate")
        self.same_sentence(lambda: brdf.convert(samples, "/tmp/x.txt"), "convert", samples, "/tmp/x.txt")
        self.same_sentence(lambda: WARD.save("/none/x.json"), "fit", samples, "--form", "ward", "-o", "/none/x.json")
        self.same_sentence(lambda: brdf.synth(WARD, noise=-1), "synth", "--form", "ward", "--noise", -1, "-o",
                           f"{self.folder.name}/x.csv")

    def test_what_a_file_does_not_state_is_supplied(self):
        rows = "".join(f"{i},{o},{2.5 + 0.001 * o}\n" for i in (20, 50) for o in range(-60, 61, 20))
        plane = pathlib.Path(self.folder.name, "plane.csv")
        plane.write_text("Incident_angle,Measure_angle,550nm\n" + rows)
        f_r = brdf.read(plane)
        brf = brdf.read(plane, quantity="BRF", mirror_side="negative")
        np.testing.assert_allclose(np.sort(brf.values[:, 0]), np.sort(f_r.values[:, 0]) / np.pi)
        self.assertIn("column '550nm' is a reflectance factor: divided by pi", brf.warnings)
        self.assertIn("column '550nm' is interpreted as f_r in 1/sr, because its name gives no quantity", f_r.warnings)
        self.assertEqual(brdf.Table.from_csv(plane.read_text(), quantity="BRF", mirror_side="negative").to_csv(), brf.to_csv())
        brdf.convert(plane, f"{self.folder.name}/c.csv", quantity="BRF", mirror_side="negative")
        self.assertEqual(brdf.read(f"{self.folder.name}/c.csv").values.tolist(), brf.values.tolist())
        fitted = brdf.fit(plane, "lambert", quantity="BRF", mirror_side="negative")
        self.assertEqual(str(fitted.best.material), str(brdf.fit(brf, "lambert").best.material))
        brdf.validate(plane, quantity="BRF")
        self.same_sentence(lambda: brdf.read(plane, quantity="BTDF"), "fit", plane, "--quantity", "BTDF")
        self.same_sentence(lambda: brdf.fit(plane, mirror_side="x"), "fit", plane, "--mirror-side", "x")
        with self.assertRaisesRegex(brdf.InputError, "this table is already read"):
            brdf.fit(brf, "lambert", quantity="BRF")

    def test_classes(self):
        self.assertTrue(issubclass(brdf.InputError, ValueError))
        self.assertTrue(issubclass(brdf.EnvironmentError, OSError))
        with self.assertRaises(TypeError):
            brdf.Material()
        with self.assertRaises(KeyError):
            TABLE["x"]
        with self.assertRaises(TypeError):
            WARD + 1
        with self.assertRaisesRegex(brdf.InputError, "a shader is made from a material"):
            brdf.export(TABLE, "glsl")

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()


class Waiting(unittest.TestCase):
    def test_progress_names_the_forms(self):
        heard = []
        result = brdf.fit(TABLE, "all", progress=heard.append)
        fitted = [said for said in heard if not said.startswith("intervals of ")]
        self.assertEqual(sorted(fitted), sorted(c.form for c in result.ranking))
        self.assertIn("intervals of " + result.ranking[0].form, heard)
        counted = []
        brdf.validate(WARD, progress=lambda done, total: counted.append((done, total)))
        self.assertEqual(counted, [(k + 1, counted[0][1]) for k in range(counted[0][1])])

    def test_false_returns_the_best_so_far(self):
        heard = []
        result = brdf.fit(TABLE, "every", progress=lambda form: (heard.append(form), len(heard) < 3)[1])
        self.assertTrue(result.interrupted)
        self.assertLess(len(result.ranking), len(brdf.forms(fittable=True)))
        with self.assertRaises(brdf.Stopped):
            brdf.validate(WARD, progress=lambda done, total: done < 2)

    def test_what_a_callback_raises_is_raised(self):
        def fail(*_):
            raise LookupError("mine")

        for call in (lambda: brdf.fit(TABLE, progress=fail), lambda: brdf.validate(WARD, progress=fail),
                     lambda: brdf.synth(WARD, progress=fail)):
            with self.assertRaisesRegex(LookupError, "mine"):
                call()

    def test_control_c_is_raised(self):
        program = ("import signal\nimport brdf\n"
                   "signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # in the background of a shell it is ignored
                   "t = brdf.synth(brdf.material('ward', kd=[.3, .2, .1]), noise=.02)\n"
                   "try:\n    brdf.fit(t, 'every', starts=2000, progress=lambda form: print(form, flush=True))\n"
                   "except KeyboardInterrupt:\n    print('interrupted', flush=True)\n"
                   "print(brdf.fit(brdf.synth(brdf.material('lambert'), grid='in_plane'), 'lambert').verdict)\n")
        with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as child:
            child.stdout.readline()  # the first form is being fitted: thousands of starts of it are to come
            child.send_signal(signal.SIGINT)
            rest, _ = child.communicate(timeout=120)
        self.assertEqual(rest.split()[-2:], ["interrupted", "converged"])
        self.assertEqual(child.returncode, 0)

    def test_other_threads_run_meanwhile(self):
        done, turns = threading.Event(), 0

        def work():
            brdf.fit(TABLE, "all")
            done.set()

        thread = threading.Thread(target=work)
        thread.start()
        while not done.is_set():
            turns += 1
        thread.join()
        self.assertGreater(turns, 1000)  # a thread that keeps the lock leaves a turn or two

    def test_fits_in_threads_are_those_made_one_by_one(self):
        tables = [brdf.synth(WARD, grid="in_plane", step=10, noise=0.02, seed=k) for k in range(8)]
        alone = [brdf.fit(t, "ward").to_dict() for t in tables]
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            beside = list(pool.map(lambda t: brdf.fit(t, "ward").to_dict(), tables))
        self.assertEqual(alone, beside)


def resident():
    return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class Leaks(unittest.TestCase):
    CALLS = 10_000
    ALLOWED = 3 << 20  # bytes: 300 a call; the smallest result kept by each call would be more, see the control

    def growth(self, call):
        for _ in range(1000):
            call()
        gc.collect()
        before = resident()
        for _ in range(self.CALLS):
            call()
        gc.collect()
        return resident() - before

    def test_ten_thousand_calls_leave_nothing(self):
        wi, wo = brdf.directions([10, 20, 30], 180), brdf.directions([10, 20, 30], 0)

        def call():
            m = brdf.material("ward", alpha=0.1)
            m.eval(wi, wo)
            brdf.Table(wi, wo, m.eval(wi, wo)).values
            try:
                m.eval([1, 1, 1], wo)
            except brdf.InputError:
                pass

        self.assertLess(self.growth(call), self.ALLOWED)

    def test_control_what_is_kept_is_seen(self):
        kept = []
        self.assertGreater(self.growth(lambda: kept.append(brdf.material("ward", alpha=0.1))), self.ALLOWED)

    def test_progress_and_threads_leave_nothing(self):
        small = brdf.Table.from_degrees([10, 20, 30, 40], 180, [10, 20, 30, 40], 0, [0.1, 0.1, 0.1, 0.1])
        with unittest.mock.patch.object(Leaks, "CALLS", 1000):
            grown = self.growth(lambda: brdf.fit(small, "lambert", progress=lambda form: None))
        self.assertLess(grown, self.ALLOWED)


class Notebooks(unittest.TestCase):
    def test_pictures_and_tables(self):
        self.assertTrue(WARD._repr_png_().startswith(b"\x89PNG\r\n\x1a\n"))
        self.assertIn("data:image/png;base64,", WARD._repr_html_())
        spectrum = brdf.material("lambert", rho=[0.1, 0.2, 0.3, 0.4])
        self.assertIsNone(spectrum._repr_png_())
        with self.assertRaises(brdf.InputError):
            spectrum.picture()
        self.assertIn("lambert", spectrum._repr_html_())
        self.assertIn("1/sr", TABLE._repr_html_())
        result = brdf.fit(TABLE, "ward")
        self.assertIn("converged", result._repr_html_())
        self.assertTrue("samples" in result and "verdict" in result.best and "x" not in result)
        self.assertIn("alpha_x", brdf.form("ward")._repr_html_())
        self.assertEqual(brdf.form("gltf_metallic_roughness").parameter("eta").max, 3)  # another program's model
        self.assertNotIn("gltf_metallic_roughness", [f.name for f in brdf.forms()])
        self.assertIn("reciprocity", brdf.validate(WARD)._repr_html_())
        self.assertIn("&lt;b&gt;", brdf.Table.from_csv("theta_i,phi_i,theta_o,phi_o,<b>\n0,0,0,0,1\n")._repr_html_())


class Programs(unittest.TestCase):
    def test_a_verb_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "s.csv")
            TABLE.save(file)
            rows = brdf.fit_files([file], f"{folder}/out", "ward")
            self.assertEqual([set(row) for row in rows], [{"file", "material", "kept", "best"}])
            self.assertEqual(brdf.load(rows[0]["material"]).form, "ward")
            self.assertTrue(brdf.fit_files([file], f"{folder}/out", "ward")[0]["kept"])
            found = brdf.program("validate", file, json=True)
            self.assertEqual(found["findings"], brdf.validate(file).to_dict()["findings"])
            with self.assertRaisesRegex(brdf.InputError, "exactly one of MATERIAL, --form"):
                brdf.program("albedo", theta=[0, 30])
            same = brdf.program("albedo", material=WARD, theta=[0, 30], json=True)["results"]
            self.assertEqual([row["value"] for row in same], WARD.albedo([0, 30]).value.reshape(-1).tolist())
            self.assertEqual([f["check"] for f in brdf.program("validate", TABLE, WARD, json=True)["findings"]],
                             [f.check for f in brdf.validate([TABLE, WARD]).findings])
            text = brdf.program("albedo", form="ward", set={"alpha": 0.2, "kd": [0.1, 0.2, 0.3]}, theta=[0, 30])
            self.assertIn("30  b", text)


if __name__ == "__main__":
    import unittest.mock

    unittest.main(argv=sys.argv[:1])
