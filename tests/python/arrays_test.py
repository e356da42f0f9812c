# ctest: python.arrays label=python timeout=1200 module
"""Evaluation on arrays: numpy's rules for shapes, types and memory."""
import itertools
import pickle
import unittest

import numpy as np

import brdf

MATERIAL = brdf.material("ward", kd=[0.3, 0.2, 0.1], ks=0.2, alpha_x=0.1, alpha_y=0.3, tangent_phi=20)
SIZES = (0, 1, 2, 3)


def shapes(most):
    """Returns every shape of up to `most` dimensions."""
    return [s for n in range(most + 1) for s in itertools.product(SIZES, repeat=n)]


def random_directions(shape, seed=1):
    random = np.random.default_rng(seed)
    return brdf.directions(random.uniform(0, 89, shape), random.uniform(-180, 180, shape))


def one_by_one(material, wi, wo):
    """Returns the values pair by pair, for arrays that numpy has broadcast."""
    wi, wo = np.broadcast_arrays(wi, wo)
    values = [material.eval(i, o) for i, o in zip(wi.reshape(-1, 3), wo.reshape(-1, 3))]
    return np.array(values).reshape(wi.shape[:-1] + (len(material.channels),))


class Shapes(unittest.TestCase):
    def test_every_pair_of_shapes_broadcasts_as_in_numpy(self):
        tried = refused = 0
        for a, b in itertools.product(shapes(3), repeat=2):
            wi, wo = random_directions(a, 1), random_directions(b, 2)
            try:
                shape = np.broadcast_shapes(a, b)
            except ValueError:
                with self.assertRaisesRegex(brdf.InputError, "do not broadcast"):
                    MATERIAL.eval(wi, wo)
                refused += 1
                continue
            f = MATERIAL.eval(wi, wo)
            self.assertEqual(f.shape, shape + (3,))
            flat = [np.array(np.broadcast_to(w, shape + (3,))).reshape(-1, 3) for w in (wi, wo)]
            np.testing.assert_array_equal(f, MATERIAL.eval(*flat).reshape(f.shape), f"{a} {b}")
            tried += 1
        self.assertEqual(tried + refused, 85 * 85)
        self.assertGreater(min(tried, refused), 1000)

    def test_batches_are_single_pairs(self):
        for count in (1, 2, 511, 512, 513, 1500):
            wi, wo = random_directions((count,), 3), random_directions((count,), 4)
            np.testing.assert_array_equal(MATERIAL.eval(wi, wo), one_by_one(MATERIAL, wi, wo))

    def test_more_dimensions_than_a_block_is_long(self):
        wi, wo = random_directions((7, 1, 300), 5), random_directions((5, 1), 6)
        np.testing.assert_array_equal(MATERIAL.eval(wi, wo)[3, 2], MATERIAL.eval(wi[3, 0], wo[2, 0]))

    def test_angles_broadcast(self):
        theta, phi = np.array([0, 30, 60])[:, None], np.linspace(0, 180, 5)
        f = MATERIAL.eval_degrees(theta, 180, theta, phi)
        self.assertEqual(f.shape, (3, 5, 3))
        np.testing.assert_array_equal(f, MATERIAL.eval(brdf.directions(theta, 180), brdf.directions(theta, phi)))
        self.assertEqual(brdf.directions(30, 0).shape, (3,))

    def test_what_is_no_direction_is_refused(self):
        up = [0, 0, 1]
        for wi, wo, sentence in (([1, 1, 1], up, "wi: pair 0: length 1.732"), (up, [0, 0, 0.5], "wo: pair 0"),
                                 (up, [0, 0, np.nan], "wo: pair 0"), ([0, 1], up, "must end in 3"),
                                 (3.0, up, "must end in 3"), (["a", "b", "c"], up, "must be numbers"),
                                 ([[up] * 600 + [[0, 0, 2]]], up, "wi: pair 600: length 2")):
            with self.assertRaisesRegex(brdf.InputError, sentence):
                MATERIAL.eval(wi, wo)


class Memory(unittest.TestCase):
    def setUp(self):
        self.wi, self.wo = random_directions((40, 30), 7), random_directions((40, 30), 8)
        self.expected = MATERIAL.eval(self.wi, self.wo)

    def test_strides_do_not_matter(self):
        planes = np.ascontiguousarray(np.moveaxis(self.wi, -1, 0))
        wide = np.zeros((40, 30, 7))
        wide[..., 1:6:2] = self.wi
        odd = np.frombuffer(b"x" + self.wi.tobytes(), dtype=np.uint8)[1:].view(np.float64).reshape(self.wi.shape)
        self.assertFalse(odd.flags.aligned)
        for name, array in (("by coordinate", np.moveaxis(planes, 0, -1)), ("in between", wide[..., 1:6:2]),
                            ("Fortran's order", np.asfortranarray(self.wi)), ("unaligned", odd),
                            ("other bytes", self.wi.astype(">f8"))):
            np.testing.assert_array_equal(MATERIAL.eval(array, self.wo), self.expected, name)
        np.testing.assert_array_equal(MATERIAL.eval(self.wi[::-2, ::3], self.wo[::-2, ::3]),
                                      self.expected[::-2, ::3])

    def test_out_is_written_whatever_its_strides(self):
        wide = np.full((30, 40, 6), 7.0)
        out = wide.transpose(1, 0, 2)[..., ::2]
        self.assertIs(MATERIAL.eval(self.wi, self.wo, out=out), out)
        np.testing.assert_array_equal(out, self.expected)
        self.assertTrue(np.all(wide[..., 1::2] == 7.0))

    def test_out_may_be_the_input(self):
        both = self.wi.copy()
        MATERIAL.eval(both[:, ::-1], self.wo, out=both)
        np.testing.assert_array_equal(both, MATERIAL.eval(self.wi[:, ::-1], self.wo))

    def test_out_of_another_shape_is_refused(self):
        for out in (np.empty((40, 30, 2)), np.empty((40, 30, 3), np.float32), "out"):
            with self.assertRaisesRegex(brdf.InputError, "out: must be an array of shape"):
                MATERIAL.eval(self.wi, self.wo, out=out)
        locked = np.empty((40, 30, 3))
        locked.flags.writeable = False
        with self.assertRaisesRegex(brdf.InputError, "writeable"):
            MATERIAL.eval(self.wi, self.wo, out=locked)

    def test_columns_of_a_table_are_views(self):
        table = brdf.synth(MATERIAL, grid="in_plane")
        again = table["r"].__array_interface__
        self.assertEqual(table["r"].__array_interface__["data"], again["data"])
        self.assertFalse(table["r"].flags.writeable or table["r"].flags.owndata)
        column, copy = table.theta_o, np.array(table.theta_o)
        del table  # the view keeps it
        np.testing.assert_array_equal(column, copy)


class Types(unittest.TestCase):
    def test_float32_gives_float32(self):
        wi, wo = random_directions((2000,), 9), random_directions((2000,), 10)
        exact = MATERIAL.eval(wi, wo)
        f = MATERIAL.eval(wi.astype(np.float32), wo.astype(np.float32))
        self.assertEqual((f.dtype, exact.dtype), (np.float32, np.float64))
        off = np.abs(f - exact) / exact
        self.assertLess(off.max(), 2e-3)  # mirror directions of a narrow lobe magnify the rounding of the directions
        self.assertLess(np.median(off), 1e-6)
        self.assertGreater(np.median(off), 1e-9)
        self.assertEqual(MATERIAL.eval(wi.astype(np.float32), wo).dtype, np.float64)
        self.assertEqual(MATERIAL.eval([0, 0, 1], [0, 0, 1]).dtype, np.float64)

    def test_every_form_in_both_types(self):
        wi, wo = random_directions((300,), 11), random_directions((300,), 12)
        for form in brdf.forms():
            m = brdf.material(form.name)
            f, single = m.eval(wi, wo), m.eval(wi.astype(np.float32), wo.astype(np.float32))
            np.testing.assert_allclose(single, f, rtol=1e-3, atol=1e-5, err_msg=form.name)
            np.testing.assert_allclose(m.eval_cos(wi, wo), f * wi[:, 2:], rtol=1e-9, err_msg=form.name)

    def test_sums_add_their_terms(self):
        a, b = brdf.material("lambert", rho=[0.2, 0.3, 0.4]), brdf.material("phong", kd=[0.1, 0.2, 0.3])
        wi, wo = random_directions((600,), 13), random_directions((600,), 14)
        np.testing.assert_array_equal((a + b).eval(wi, wo), a.eval(wi, wo) + b.eval(wi, wo))
        with self.assertRaisesRegex(brdf.InputError, "same channels"):
            a + brdf.material("lambert")


class Sampling(unittest.TestCase):
    def test_values_over_densities_average_to_the_albedo(self):
        u = np.random.default_rng(17).random((40_000, 3))
        # The channels of the last material have lobes of different widths, and the sampler must follow all of them.
        content = brdf.material("ward", kd=[0, 0, 0], ks=0.4).to_dict()
        content["shape"] = {"alpha_x": [0.05, 0.2, 0.5], "alpha_y": [0.05, 0.2, 0.5]}
        for material in (brdf.material("ward", kd=0.2, ks=0.4, alpha_x=0.1, alpha_y=0.3, tangent_phi=30),
                         brdf.material("lambert", rho=0.3) + brdf.material("cook_torrance", alpha=0.3),
                         brdf.Material.from_dict(content)):
            wo = brdf.directions(40, 70)
            wi = material.sample(wo, u)
            self.assertEqual(wi.shape, (40_000, 3))
            up = wi[:, 2] > 0
            weights = np.zeros((len(u), len(material.channels)))
            weights[up] = material.eval_cos(wi[up], wo) / material.pdf(wi[up], wo)[:, None]
            error = weights.std(axis=0) / np.sqrt(len(u))
            albedo = material.albedo(40, 70, fixed="o").value
            self.assertTrue(np.all(np.abs(weights.mean(axis=0) - albedo) < 4 * error), material)
            self.assertTrue(np.all(error < 0.02 * albedo), material)
        with self.assertRaisesRegex(brdf.InputError, "u: pair 1: 1: must be from 0 to below 1"):
            material.sample(wo, [[0, 0, 0], [0, 0, 1]])
        with self.assertRaisesRegex(brdf.InputError, "unit vector"):
            material.pdf([0, 0, 2], wo)


class Tables(unittest.TestCase):
    def test_arrays_there_and_back(self):
        wi, wo = random_directions((4, 1), 15), random_directions((5,), 16)
        f = MATERIAL.eval(wi, wo)
        table = brdf.Table(wi, wo, f, sigma=0.1 * f, metadata={"sample": "made"})
        self.assertEqual((len(table), table.channels), (20, ["r", "g", "b"]))
        np.testing.assert_array_equal(table.values, f.reshape(-1, 3))
        np.testing.assert_array_equal(table.sigma, 0.1 * f.reshape(-1, 3))
        np.testing.assert_allclose(table.wi, np.broadcast_to(wi, (4, 5, 3)).reshape(-1, 3), atol=1e-14)
        self.assertIn(("sample", "made"), table.metadata)
        self.assertEqual(brdf.Table(wi, wo, f[..., 0]).channels, ["fr"])

    def test_text_and_pickles_are_exact(self):
        table = brdf.synth(MATERIAL, grid="in_plane", noise=0.03, sigma_columns=True)
        for other in (brdf.Table.from_csv(table.to_csv()), pickle.loads(pickle.dumps(table)),
                      brdf.Table.from_pandas(table.to_pandas())):
            for name in ("theta_i", "phi_i", "theta_o", "phi_o", "values", "sigma", "channels"):
                np.testing.assert_array_equal(getattr(other, name), getattr(table, name), name)
        self.assertEqual(pickle.loads(pickle.dumps(MATERIAL)), MATERIAL)
        self.assertTrue(MATERIAL.anisotropic and not MATERIAL.replace(alpha=0.2).anisotropic)

    def test_what_breaks_a_rule_is_refused(self):
        up = [0, 0, 1]
        for make, sentence in ((lambda: brdf.Table(up, up, np.nan), "finite"),
                               (lambda: brdf.Table(up, up, 1, channels=["a", "b"]), "2 names for 1 channels"),
                               (lambda: brdf.Table([up, up], up, [1, 2, 3]), r"values: shape \(3,\)"),
                               (lambda: brdf.Table([0, 0, 0], up, 1), "longer than 0"),
                               (lambda: brdf.Table([0, 0, -1], up, 1), "theta_i 180"),
                               (lambda: brdf.Table.from_degrees(95, 0, 0, 0, 1), "theta_i 95"),
                               (lambda: brdf.Table([up] * 2, [up] * 3, 1), r"wi and wo: shapes \(2, 3\) and \(3, 3\)"),
                               (lambda: brdf.Table.from_degrees([1, 2], [1, 2, 3], 0, 0, 1),
                                r"theta_i, phi_i, theta_o and phi_o: shapes \(2,\), \(3,\), \(\) and \(\) do not"),
                               (lambda: brdf.Table(up, up, "x"), "values: <U1: must be numbers"),
                               (lambda: brdf.Table(up, up, 1j), "values: complex128: must be numbers"),
                               (lambda: brdf.directions([1, 2], [1, 2, 3]), "theta and phi: shapes"),
                               (lambda: brdf.material("ward", kd="x"), "kd: 'x': must be a number"),
                               (lambda: brdf.material("ward", kd=[[1]]), "kd: .*: must be a number")):
            with self.assertRaisesRegex(brdf.InputError, sentence):
                make()

    def test_what_no_frame_may_be_is_refused(self):
        frame = brdf.synth(MATERIAL, grid="in_plane").to_pandas()
        for made, sentence in ((frame.drop(columns="phi_o"), "column 'phi_o' is missing"),
                               (frame.assign(sigma_x=0.1), "column 'sigma_x' has no column of values"),
                               (frame.assign(note="wet"), "column 'note': must be an array of numbers"),
                               (frame.rename(columns={"g": "r"}), "two columns have the same name"),
                               (frame[["theta_i", "phi_i", "theta_o", "phi_o"]], "no column of values")):
            with self.assertRaisesRegex(brdf.InputError, sentence):
                brdf.Table.from_pandas(made)

    def test_channels_are_what_it_is_made_of(self):
        table = brdf.synth(MATERIAL, grid="in_plane")
        self.assertEqual((list(table), "r" in table, "x" in table), (["r", "g", "b"], True, False))
        self.assertEqual(brdf.Table([0, 0, 1], [0, 0, 1], 1, channels="green").channels, ["green"])


if __name__ == "__main__":
    unittest.main()
