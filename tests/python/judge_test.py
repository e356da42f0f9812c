# ctest: python.judge label=python timeout=1200 module
"""Functions of numpy arrays as eval, sample and pdf: right ones pass, wrong ones fail with their cause, absent ones leave checks
undecided, and results that are no arrays of the right shape are errors."""
import concurrent.futures
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import brdf

EXPONENT = 20.0
NINE = ["density_mass", "density_match", "sample_value", "jacobian", "sample_distribution", "sample_mean", "density_support",
        "sample_range", "sample_float"]


def dot(a, b):
    return np.einsum("ij,ij->i", a, b)


# A Lambertian surface, sampled by the cosine.
def lambert(wi, wo):
    return np.full(len(wi), 0.7 / np.pi)


def by_cosine(u, wo):
    rho, phi = np.sqrt(u[:, 0]), 2 * np.pi * u[:, 1]
    return np.stack([rho * np.cos(phi), rho * np.sin(phi), np.sqrt(np.maximum(1 - u[:, 0], 0))], axis=1)


def cosine_pdf(wi, wo):
    return wi[:, 2] / np.pi


def full_lambert(u, wo):
    wi = by_cosine(u, wo)
    return wi, cosine_pdf(wi, wo), lambert(wi, wo)


# A coloured lobe in the half vector; samples below the horizon are lost.
def half_vector(wi, wo):
    h = wi + wo
    return h / np.linalg.norm(h, axis=1, keepdims=True)


def lobe(wi, wo):
    shape = (EXPONENT + 2) / (8 * np.pi) * half_vector(wi, wo)[:, 2] ** EXPONENT
    return shape[:, None] * [0.8, 0.5, 0.2]


def density_of_half(wi, wo):
    return (EXPONENT + 1) / (2 * np.pi) * half_vector(wi, wo)[:, 2] ** EXPONENT


def lobe_pdf(wi, wo):
    return density_of_half(wi, wo) / (4 * dot(wo, half_vector(wi, wo)))


def by_lobe(u, wo):
    cosine, phi = (1 - u[:, 0]) ** (1 / (EXPONENT + 1)), 2 * np.pi * u[:, 1]
    sine = np.sqrt(np.maximum(1 - cosine**2, 0))
    h = np.stack([sine * np.cos(phi), sine * np.sin(phi), cosine], axis=1)
    wi = 2 * dot(wo, h)[:, None] * h - wo
    return {"wi": wi, "valid": (wi[:, 2] > 0) & (dot(wo, h) > 0)}


def verdicts(judged):
    return {finding.check: finding.verdict for finding in judged.findings}


def statement(judged, check):
    return next(f["statement"] for f in judged.findings if f.check == check)


class Verdicts(unittest.TestCase):
    def test_a_right_sampler_passes_all_checks_in_double_precision(self):
        judged = brdf.judge(eval=lambert, sample=full_lambert, pdf=cosine_pdf, name="matt", require=NINE[:8])
        self.assertEqual([f.check for f in judged.findings], NINE)
        self.assertEqual({f.subject for f in judged.findings}, {"matt"})
        self.assertEqual(verdicts(judged), dict.fromkeys(NINE[:8], "pass") | {"sample_float": "undecided"})
        self.assertEqual(statement(judged, "sample_float"), "sample is available in double precision only")
        self.assertTrue(judged.passed)
        self.assertFalse(brdf.judge(eval=lambert, sample=full_lambert, pdf=cosine_pdf, require="sample_float").passed)

    def test_a_lobe_that_loses_samples_passes(self):
        judged = brdf.judge(eval=lobe, sample=by_lobe, pdf=lobe_pdf, seed=2)
        self.assertEqual(judged.failed, [])
        for check in ("density_mass", "jacobian", "sample_distribution", "sample_mean", "density_support", "sample_range"):
            self.assertEqual(verdicts(judged)[check], "pass", statement(judged, check))

    def test_the_density_of_the_half_vector(self):
        judged = brdf.judge(eval=lobe, sample=by_lobe, pdf=density_of_half)
        self.assertEqual(verdicts(judged)["jacobian"], "fail")
        self.assertIn("pdf is that of the half vector: the factor 1 / (4 dot(V, H)) is missing", statement(judged, "jacobian"))
        self.assertEqual(verdicts(judged)["density_mass"], "fail")
        stated = brdf.judge(eval=lobe, sample=by_lobe, pdf=density_of_half, density_of="half")
        self.assertEqual(stated.failed, [])
        self.assertEqual(verdicts(stated)["jacobian"], "pass")

    def test_a_density_per_projected_solid_angle(self):
        constant = lambda wi, wo: np.full(len(wi), 1 / np.pi)  # noqa: E731
        self.assertIn("is per projected solid angle: the factor cos_i is missing",
                      statement(brdf.judge(sample=by_cosine, pdf=constant), "jacobian"))
        self.assertEqual(brdf.judge(eval=lambert, sample=by_cosine, pdf=constant, density_of="projected").failed, [])

    def test_one_percent_in_a_quarter(self):
        def wrong(wi, wo):
            return cosine_pdf(wi, wo) * np.where((wi[:, 0] > 0) & (wi[:, 1] > 0), 1.01, 1)

        judged = brdf.judge(eval=lambert, sample=full_lambert, pdf=wrong)
        for check in ("density_mass", "density_match", "jacobian"):
            self.assertEqual(verdicts(judged)[check], "fail", statement(judged, check))
        # Only a quarter of the samples differs, so that the factor is not one of the whole density.
        self.assertRegex(statement(judged, "density_match"), r"differ at 2[45](\.\d)? % of the samples")
        self.assertIn("at these samples pdf has a wrong constant factor", statement(judged, "density_match"))
        self.assertFalse(judged.passed)
        witness = next(f for f in judged.failed if f.check == "jacobian")["witness"]
        self.assertLessEqual({"theta_o", "phi_o", "theta_i", "phi_i", "u0", "u1"}, set(witness))

    def test_quantities(self):
        def weights(u, wo):
            wi = by_cosine(u, wo)
            return wi, cosine_pdf(wi, wo), np.full(len(u), 0.7)

        judged = brdf.judge(eval=lambert, sample=weights, pdf=cosine_pdf)
        self.assertIn("f*cos_i/pdf", statement(judged, "sample_value"))
        self.assertEqual(judged.failed, [])
        judged = brdf.judge(eval=lambert, sample=weights, pdf=cosine_pdf, value="f")
        self.assertEqual(verdicts(judged)["sample_value"], "fail")
        self.assertIn('declare it with value="f*cos_i/pdf"', statement(judged, "sample_value"))
        judged = brdf.judge(eval=lambda wi, wo: lambert(wi, wo) * wi[:, 2], returns="f*cos_i", sample=full_lambert, value="f")
        self.assertEqual(judged.failed, [])
        self.assertEqual(verdicts(judged)["sample_value"], "pass")

    def test_values_that_are_no_numbers_are_findings(self):
        def broken(wi, wo):
            return np.where(wi[:, 0] > 0.9, np.nan, 0.7 / np.pi)

        judged = brdf.judge(eval=broken, sample=by_cosine, pdf=cosine_pdf)
        self.assertEqual(verdicts(judged)["sample_mean"], "fail")
        self.assertIn("f*cos_i of eval is nan", statement(judged, "sample_mean"))


class Absent(unittest.TestCase):
    def undecided(self, judged, absent, checks):
        """Requires that these checks and no others are undecided, apart from sample_float, and that each names the function."""
        self.assertEqual({c for c, v in verdicts(judged).items() if v == "undecided"}, {*checks, "sample_float"})
        for check in checks:
            self.assertIn(absent, statement(judged, check))
        self.assertEqual(judged.failed, [])

    def test_without_pdf(self):
        checks = ["density_mass", "density_match", "sample_distribution", "density_support"]
        self.undecided(brdf.judge(eval=lambert, sample=full_lambert), "no pdf is given", checks)
        judged = brdf.judge(eval=lambert, sample=by_cosine)
        self.assertIn("no pdf is given, and sample returns neither a density nor a weight", statement(judged, "sample_mean"))
        self.assertEqual(verdicts(judged)["jacobian"], "undecided")

    def test_without_sample(self):
        checks = [c for c in NINE if c not in ("density_mass", "density_support", "sample_float")]
        judged = brdf.judge(eval=lambert, pdf=cosine_pdf)
        self.undecided(judged, "no sample is given", checks)
        self.assertEqual(statement(judged, "sample_float"), "no sample is given")
        self.assertIn("the density integrates to 1 in 6 cases", statement(judged, "density_mass"))
        lost = brdf.judge(eval=lobe, pdf=lobe_pdf)
        self.assertEqual(verdicts(lost)["density_mass"], "undecided")
        self.assertIn("there is no sampler to count them", statement(lost, "density_mass"))

    def test_without_eval(self):
        checks = ["sample_value", "sample_mean", "density_support"]
        self.undecided(brdf.judge(sample=full_lambert, pdf=cosine_pdf), "no eval is given", checks)

    def test_without_parts_of_a_sample(self):
        judged = brdf.judge(eval=lambert, sample=by_cosine, pdf=cosine_pdf)
        self.undecided(judged, "sample returns no", ["density_match", "sample_value"])

    def test_without_anything_to_judge(self):
        with self.assertRaisesRegex(brdf.InputError, "nothing to judge: give sample, pdf or both"):
            brdf.judge(eval=lambert)

    def test_too_few_random_numbers(self):
        def on_a_circle(u, wo):
            return by_cosine(np.stack([np.full(len(u), 0.5), u[:, 0]], axis=1), wo)

        judged = brdf.judge(sample=on_a_circle, pdf=cosine_pdf, randoms=1)
        self.assertEqual(verdicts(judged)["jacobian"], "undecided")
        self.assertIn("a draw takes fewer than 2 random numbers", statement(judged, "jacobian"))
        self.assertEqual(verdicts(judged)["sample_distribution"], "fail")


class Errors(unittest.TestCase):
    def refused(self, pattern, **functions):
        with self.assertRaisesRegex(brdf.InputError, pattern):
            brdf.judge(**({"eval": lambert, "sample": full_lambert, "pdf": cosine_pdf} | functions))

    def test_shapes(self):
        self.refused(r"pdf: shape \(16, 1\): must be \(16,\), one number for each row", pdf=lambda wi, wo: wi[:, 2:])
        self.refused(r"pdf: shape \(\): must be \(16,\)", pdf=lambda wi, wo: 1 / np.pi)
        self.refused(r"eval: shape \(3, 16\): must be \(16,\), or this shape followed by", eval=lambda wi, wo: wi.T)
        self.refused(r"eval: 4 channels: must be 1 to 3", eval=lambda wi, wo: np.ones((len(wi), 4)))
        self.refused(r"sample: wi: shape \(3, 16\): must be \(16, 3\)", sample=lambda u, wo: by_cosine(u, wo).T)
        self.refused(r"sample: value: 3 channels: must be 1, as in the other results",
                     sample=lambda u, wo: (*full_lambert(u, wo)[:2], np.ones((len(u), 3))))
        self.refused("sample: the key direction is unknown", sample=lambda u, wo: {"direction": by_cosine(u, wo)})
        self.refused("sample: the key wi is missing", sample=lambda u, wo: {"pdf": u[:, 0]})
        self.refused("sample: a tuple of 4: must be wi, ", sample=lambda u, wo: (1, 2, 3, 4))

    def test_no_numbers(self):
        self.refused("pdf: complex128: must be numbers", pdf=lambda wi, wo: wi[:, 2] + 0j)
        self.refused("eval: the function returned None: it must return an array", eval=lambda wi, wo: None)
        self.refused("eval: must be an array of numbers", eval=lambda wi, wo: [[1], [1, 2]])
        self.refused("sample: wi: <U4: must be numbers", sample=lambda u, wo: np.full((len(u), 3), "here"))
        self.refused("pdf: 3: must be a function of arrays", pdf=3)

    def test_options(self):
        self.refused("value g: must be one of f, f\\*cos_i, f\\*cos_i/pdf", value="g")
        self.refused("returns f\\*cos_i/pdf: must be one of f, f\\*cos_i$", returns="f*cos_i/pdf")
        self.refused("density_of area: must be one of solid_angle, projected, half", density_of="area")
        self.refused("randoms: 0: must be a whole number from 1 to 32", randoms=0)
        self.refused("require energy: must be one of density_mass, ", require="energy")
        self.refused("--effort: most: must be quick or full", effort="most")
        self.refused("--seed: '-1' must be", seed=-1)

    def test_what_a_function_raises_is_the_cause(self):
        def fails(wi, wo):
            raise LookupError("no such table")

        with self.assertRaisesRegex(brdf.InputError, "pdf: the function raised LookupError: no such table") as raised:
            brdf.judge(sample=by_cosine, pdf=fails)
        self.assertIsInstance(raised.exception.__cause__, LookupError)

        def fails_later(wi, wo):
            return cosine_pdf(wi, wo) if len(wi) == 16 else 1 / 0

        with self.assertRaisesRegex(brdf.InputError, "pdf: the function raised ZeroDivisionError") as raised:
            brdf.judge(sample=by_cosine, pdf=fails_later)
        self.assertIsInstance(raised.exception.__cause__, ZeroDivisionError)

        def shrinks(wi, wo):
            return cosine_pdf(wi, wo)[: len(wi) if len(wi) == 16 else -1]

        self.refused(r"pdf: shape \(\d+,\): must be", pdf=shrinks)

    def test_a_sampler_with_a_generator_of_its_own_is_refused(self):
        random = np.random.default_rng(1)
        self.refused("sample: the results differ if the same rows are given in another order",
                     sample=lambda u, wo: by_cosine(random.random(u.shape), wo))

    def test_parts_that_change(self):
        calls = []

        def changes(u, wo):
            calls.append(len(u))
            return full_lambert(u, wo)[: 3 if len(calls) < 3 else 2]

        self.refused("sample: the function must return the same parts in every call", sample=changes)


class Around(unittest.TestCase):
    def test_threads_judge_at_the_same_time(self):
        def judged(seed):
            return verdicts(brdf.judge(eval=lambert, sample=full_lambert, pdf=cosine_pdf, seed=seed))

        with concurrent.futures.ThreadPoolExecutor(3) as pool:
            for found in pool.map(judged, range(3)):
                self.assertEqual(found, dict.fromkeys(NINE[:8], "pass") | {"sample_float": "undecided"})

    def test_the_same_seed_gives_the_same_findings(self):
        first, second = (brdf.judge(eval=lobe, sample=by_lobe, pdf=lobe_pdf, seed=5).to_dict() for _ in range(2))
        # numpy rounds by the alignment of its arrays, which differs from call to call.
        for one, other in zip(first["findings"], second["findings"], strict=True):
            self.assertEqual((one["check"], one["verdict"]), (other["check"], other["verdict"]))
            np.testing.assert_allclose(one["value"], other["value"], rtol=1e-9)

    def test_a_material_of_the_module(self):
        material = brdf.material("ward", kd=0.2, ks=0.3, alpha=0.3)

        def sample(u, wo):
            inside = np.minimum(u, 1 - 2**-53)  # the module takes numbers below 1
            return material.sample(wo, inside)

        judged = brdf.judge(eval=lambda wi, wo: material.eval(wi, wo)[:, :1], sample=sample, pdf=material.pdf, randoms=3)
        self.assertEqual(judged.failed, [])

    def test_control_c_ends_the_work(self):
        program = ("import signal, numpy, brdf\n"
                   "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
                   "def sample(u, wo):\n"
                   "    print('called', flush=True)\n"
                   "    z = numpy.sqrt(1 - u[:, 0])\n"
                   "    rho, phi = numpy.sqrt(u[:, 0]), 2 * numpy.pi * u[:, 1]\n"
                   "    return numpy.stack([rho * numpy.cos(phi), rho * numpy.sin(phi), z], axis=1)\n"
                   "try:\n    brdf.judge(sample=sample, pdf=lambda wi, wo: wi[:, 2] / numpy.pi, effort='full')\n"
                   "except KeyboardInterrupt:\n    print('interrupted', flush=True)\n")
        with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as running:
            for _ in range(20):
                self.assertEqual(running.stdout.readline(), "called\n")
            running.send_signal(signal.SIGINT)
            rest = running.stdout.read()
        self.assertTrue(rest.endswith("interrupted\n"))

    def test_reports(self):
        judged = brdf.judge(eval=lambert, sample=by_cosine, pdf=cosine_pdf, name="my sampler")
        with tempfile.TemporaryDirectory() as folder:
            for name in ("report.html", "report.md"):
                judged.report(pathlib.Path(folder, name))
                text = pathlib.Path(folder, name).read_text()
                self.assertIn("my sampler", text)
                self.assertIn("sample_mean" if name.endswith("html") else "| sample_mean | pass |", text)
            self.assertNotIn("Data check of the measurements", pathlib.Path(folder, "report.html").read_text())
        self.assertIn("sample_mean", judged._repr_html_())


if __name__ == "__main__":
    unittest.main()
