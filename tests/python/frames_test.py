# ctest: python.frames label=python module @brdf@
"""Tests tables from pandas and xarray, layouts, and the module without the two packages. Exit code 77 without them.
Usage: frames_test.py BRDF"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import brdf

try:
    import pandas
    import xarray
except ImportError:
    print("python3-pandas or python3-xarray is not installed")
    sys.exit(77)

os.environ["BRDF_PROGRAM"] = sys.argv[1]
WARD = brdf.material("ward", kd=[0.3, 0.2, 0.1], ks=0.2, alpha=0.3)
TABLE = brdf.synth(WARD, grid="in_plane", step=10, noise=0.02, sigma_columns=True)
COLUMNS = ("theta_i", "phi_i", "theta_o", "phi_o", "values", "sigma", "channels")
LAYOUT = {"format": "brdf-layout", "version": 1, "quantity": "BRF",
          "columns": [{"name": "Einfall", "is": "theta_i"}, {"constant": 180, "is": "phi_i"},
                      {"name": "Ausfall", "is": "theta_o"}, {"constant": 0, "is": "phi_o"}, {"name": "Wert", "is": "value"}]}
LAB = "Einfall,Ausfall,Wert\n10,20,0.5\n30,20,0.4\n30,50,0.7\n"


def grid(name="fr"):
    """Returns values on a grid of 2 x 1 x 3 x 2 directions and two wavelengths."""
    values = np.arange(1.0, 25.0).reshape(2, 1, 3, 2, 2) / 100
    return xarray.DataArray(values, name=name, dims=("theta_i", "phi_i", "theta_o", "phi_o", "wavelength"),
                            coords={"theta_i": [20, 50], "phi_i": [180], "theta_o": [0, 30, 60], "phi_o": [0, 90],
                                    "wavelength": [450, 650.5]})


class Frames(unittest.TestCase):
    def same(self, a, b):
        for name in COLUMNS:
            np.testing.assert_array_equal(getattr(a, name), getattr(b, name), name)

    def test_round_trips_are_exact(self):
        self.same(brdf.Table.from_pandas(TABLE.to_pandas()), TABLE)
        self.same(brdf.Table.from_xarray(TABLE.to_xarray()), TABLE)
        indexed = TABLE.to_pandas().set_index(["theta_i", "phi_i", "theta_o", "phi_o"])
        self.same(brdf.Table.from_pandas(indexed), TABLE)

    def test_a_grid_has_a_row_for_each_pair_and_a_channel_for_each_wavelength(self):
        table = brdf.Table.from_xarray(grid())
        self.assertEqual((len(table), table.channels), (12, ["450nm", "650.5nm"]))
        k = np.flatnonzero((table.theta_i == 50) & (table.theta_o == 30) & (table.phi_o == 90))
        self.assertEqual(table.values[k].tolist(), [grid().sel(theta_i=50, theta_o=30, phi_o=90).values[0].tolist()])
        self.assertEqual(set(table.phi_i), {180})
        turned = grid().transpose("wavelength", "phi_o", "theta_o", "theta_i", "phi_i")
        self.assertEqual({tuple(r) for r in brdf.Table.from_xarray(turned).to_pandas().to_numpy()},
                         {tuple(r) for r in table.to_pandas().to_numpy()})

    def test_units_of_coordinates(self):
        angles = {a: (a, np.radians(grid()[a].values), {"units": "rad"}) for a in ("theta_i", "theta_o")}
        radians = grid().assign_coords(**angles, wavelength=("wavelength", [0.45, 0.6505], {"units": "um"}))
        table = brdf.Table.from_xarray(radians)
        np.testing.assert_allclose(table.theta_o, brdf.Table.from_xarray(grid()).theta_o, atol=1e-12)
        self.assertEqual(table.channels, ["450nm", "650.5nm"])

    def test_a_dataset_has_channels_and_deviations(self):
        one = grid().isel(wavelength=0, drop=True).squeeze("phi_i")
        data = xarray.Dataset({"red": one, "sigma_red": 0.1 * one})
        table = brdf.Table.from_xarray(data)
        self.assertEqual(table.channels, ["red"])
        np.testing.assert_allclose(table.sigma, 0.1 * table.values)
        self.assertEqual(brdf.Table.from_xarray(grid().isel(wavelength=1)).channels, ["650.5nm"])

    def test_gaps_of_a_grid_are_left_out(self):
        gap = grid().copy()
        gap[0, 0, 0, :, :] = np.nan
        self.assertEqual(len(brdf.Table.from_xarray(gap)), 10)
        gap[1, 0, 0, 0, 0] = np.nan
        with self.assertRaisesRegex(brdf.InputError, "NaN in some channels but not in all at theta_i 50, phi_i 180, theta_o 0"):
            brdf.Table.from_xarray(gap)

    def test_what_no_grid_may_be_is_refused(self):
        units = grid()
        units.attrs["units"] = "percent"
        quantity = grid()
        quantity.attrs["quantity"] = "BRF"
        degrees = grid()
        degrees["theta_o"].attrs["units"] = "gon"
        both = xarray.Dataset({"a": grid(), "b": grid()})
        for made, sentence in ((grid().isel(phi_o=0, drop=True), r"coordinate 'phi_o' is missing: assign it"),
                               (units, "units 'percent': must be 1/sr"), (quantity, "quantity 'BRF': must be f_r"),
                               (degrees, "coordinate 'theta_o': units 'gon': must be deg or rad"),
                               (both, "a wavelength needs one variable of values, not 2"),
                               (xarray.Dataset({"sigma_x": grid()}), "no variable of values"),
                               (grid().assign_coords(theta_o=[0, 30, 95]), "theta_o 95")):
            with self.assertRaisesRegex(brdf.InputError, sentence):
                brdf.Table.from_xarray(made)

    def test_functions_take_frames(self):
        frame, data = TABLE.to_pandas(), TABLE.to_xarray()
        fitted = str(brdf.fit(TABLE, "lambert").best.material)
        self.assertEqual(str(brdf.fit(frame, "lambert").best.material), fitted)
        self.assertEqual(str(brdf.fit(data, "lambert").best.material), fitted)
        verdicts = [f.verdict for f in brdf.validate(TABLE).findings]
        self.assertEqual([f.verdict for f in brdf.validate([frame]).findings], verdicts)
        self.assertEqual([f.verdict for f in brdf.validate(data).findings], verdicts)
        with tempfile.TemporaryDirectory() as folder:
            for k, source in enumerate((TABLE, frame, data)):
                brdf.convert(source, f"{folder}/{k}.csv", keep_fill=True)
            texts = [[line for line in pathlib.Path(f"{folder}/{k}.csv").read_text().splitlines() if not line.startswith("#")]
                     for k in range(3)]
            self.assertEqual(texts[0], texts[1])
            self.assertEqual(texts[0], texts[2])
            brdf.program("convert", frame, f"{folder}/program.csv")
        with self.assertRaisesRegex(brdf.InputError, "a Dataset states its columns"):
            brdf.fit(data, "lambert", quantity="BRF")

    def test_a_frame_of_wavelengths_is_read_like_a_file(self):
        long = pandas.DataFrame({"theta_i": 30, "phi_i": 180, "theta_o": [10, 10, 20, 20], "phi_o": 0,
                                 "wavelength": [450, 550, 450, 550], "f": [0.1, 0.2, 0.3, 0.4]})
        table = brdf.Table.from_pandas(long)
        self.assertEqual((len(table), table.channels, table.values.tolist()),
                         (2, ["450nm", "550nm"], [[0.1, 0.2], [0.3, 0.4]]))

    def test_layouts(self):
        with tempfile.TemporaryDirectory() as folder:
            lab, layout = pathlib.Path(folder, "lab.csv"), pathlib.Path(folder, "lab.json")
            lab.write_text(LAB)
            layout.write_text(json.dumps(LAYOUT))
            table = brdf.read(lab, layout=layout)
            np.testing.assert_allclose(table.values[:, 0], np.array([0.5, 0.4, 0.7]) / np.pi)
            self.same(brdf.read(lab, layout=LAYOUT), table)
            self.same(brdf.Table.from_csv(LAB, layout=LAYOUT), table)
            self.same(brdf.Table.from_pandas(pandas.read_csv(lab), layout=LAYOUT), table)
            fitted = str(brdf.fit(table, "lambert").best.material)
            self.assertEqual(str(brdf.fit(lab, "lambert", layout=layout).best.material), fitted)
            self.assertEqual(str(brdf.fit(pandas.read_csv(lab), "lambert", layout=LAYOUT).best.material), fitted)
            brdf.convert(lab, f"{folder}/f.csv", layout=layout, keep_fill=True)
            self.assertEqual(brdf.read(f"{folder}/f.csv").values.tolist(), table.values.tolist())
            brdf.validate(lab, layout=LAYOUT)
            with self.assertRaisesRegex(brdf.InputError, "column 'theta_i' is missing"):
                brdf.read(lab)
            with self.assertRaisesRegex(brdf.InputError, r"layout: \$.quantity: \"x\" is unknown"):
                brdf.read(lab, layout=LAYOUT | {"quantity": "x"})
            with self.assertRaisesRegex(brdf.InputError, "this table is already read"):
                brdf.fit(table, "lambert", layout=LAYOUT)

    def test_the_module_needs_neither_package(self):
        text = ("import sys\nsys.modules['pandas'] = sys.modules['xarray'] = None\nimport brdf\n"
                "t = brdf.Table.from_degrees(30, 180, [0, 20, 40], 0, [1, 1, 1])\nassert brdf.fit(t, 'lambert').best\n"
                "for call, name in ((t.to_pandas, 'pandas'), (t.to_xarray, 'xarray')):\n"
                "    try:\n        call()\n    except ImportError as error:\n        assert f'python3-{name}' in str(error)\n"
                "    else:\n        raise SystemExit(1)\n")
        subprocess.run([sys.executable, "-c", text], check=True)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
