# ctest: python.formats label=python module @brdf@ @source@
"""Tests that the module reads every format as the program does: the examples of tests/fuzz/corpus, including damaged ones.
Usage: formats_test.py BRDF SOURCE"""
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile
import unittest

import brdf

PROGRAM, CORPUS = sys.argv[1], pathlib.Path(sys.argv[2], "tests/fuzz/corpus")
FOLDERS = ("alta", "aspecular", "astm", "bird", "cornell", "csv", "exr_table", "fred", "klems", "lens", "openmaterial", "speos",
           "tensor")
NAMES = {"csv", "merl", "rgl", "astm_e1392", "zemax", "alta", "exr", "fred", "cornell", "openmaterial", "bird", "early_bird", "speos", "klems",
         "aspecular"}
MOST = 25  # examples of a folder


def rows(text):
    return [line for line in text.splitlines() if not line.startswith("#")]


class Formats(unittest.TestCase):
    def test_every_format_is_read_as_the_program_reads_it(self):
        files = [path for folder in FOLDERS for path in sorted((CORPUS / folder).iterdir())[:MOST]]

        def by_program(path):
            with tempfile.TemporaryDirectory() as folder:
                out = pathlib.Path(folder, "out.csv")
                done = subprocess.run([PROGRAM, "convert", path, out, "--keep-fill"], capture_output=True, text=True, check=False)
                return rows(out.read_text()) if done.returncode == 0 else done.stderr

        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            expected = list(pool.map(by_program, files))
        seen = set()
        with tempfile.TemporaryDirectory() as folder:  # a whole MERL file is too large for the comparison of texts
            brdf.convert(brdf.material("lambert", rho=[0.3, 0.2, 0.1]), f"{folder}/lambert.binary")
            seen.add(brdf.read(f"{folder}/lambert.binary").format)
        for path, one in zip(files, expected):
            with self.subTest(path):
                try:
                    table = brdf.read(path)
                except brdf.InputError as error:
                    self.assertIsInstance(one, str, error)
                    self.assertIn("".join(str(error)[:80].split()), "".join(one.split()))
                    continue
                self.assertEqual(rows(table.to_csv()), one)
                seen.add(table.format)
        self.assertEqual(NAMES - seen, set(), "each format is read at least once")

    def test_a_matrix_of_klems_xml_is_chosen_as_by_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            xml, out = f"{folder}/x.xml", f"{folder}/out.csv"
            brdf.convert(brdf.material("lambert", rho=[0.3]), xml)
            back = brdf.read(xml, matrix="back")
            self.assertIn("Reflection Back", " ".join(back.warnings))
            self.assertIn("Reflection Front", " ".join(brdf.read(xml).warnings))
            brdf.convert(xml, out, matrix="back")
            self.assertEqual(rows(pathlib.Path(out).read_text()), rows(back.to_csv()))
            with self.assertRaisesRegex(brdf.InputError, "sideways"):
                brdf.read(xml, matrix="sideways")
            for call in (lambda: brdf.read(out, matrix="back"), lambda: brdf.convert(back, out, matrix="back")):
                with self.assertRaisesRegex(brdf.InputError, "(?i)klems"):
                    call()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
