# ctest: python.plots label=slow timeout=1200 module @brdf@
"""Tests the pictures of matplotlib: the sphere and the slices of a material. The test belongs to ./test --full, because matplotlib
depends on two dozen packages. Usage: plots_test.py BRDF"""
import io
import os
import sys
import unittest

import matplotlib
import matplotlib.image as images
import numpy as np

import brdf

matplotlib.use("Agg")
os.environ["BRDF_PROGRAM"] = sys.argv[1]
WARD = brdf.material("ward", kd=[0.3, 0.2, 0.1], ks=0.2, alpha=0.1)
TABLE = brdf.synth(WARD, grid="in_plane", step=5, noise=0.02)


class Plots(unittest.TestCase):
    def test_the_sphere_shows_its_colour(self):
        red = brdf.material("lambert", rho=[0.6, 0.1, 0.1]).picture(64)
        pixels = images.imread(io.BytesIO(red))
        self.assertEqual(pixels.shape, (64, 64, 4))
        lit = pixels[pixels[..., 3] == 1]
        self.assertGreater(lit[:, 0].max(), 2 * lit[:, 1].max())
        self.assertEqual(pixels[0, 0, 3], 0)

    def test_slices(self):
        axes = WARD.plot([0, 45], table=TABLE)
        lines = axes.get_lines()
        self.assertEqual(len(lines), 4)
        x, y = lines[2].get_data()
        np.testing.assert_allclose(y, WARD.eval_degrees(45, 180, abs(x), np.where(x < 0, 180, 0)).mean(axis=-1))
        self.assertEqual(lines[0].get_data()[0].size, 357)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
