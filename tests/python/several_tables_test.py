# ctest: python.several_tables label=python module @brdf@
"""brdf.compare and brdf.consensus return the same numbers as the program."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import brdf

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
BUDGET = "source,standard_uncertainty,unit,shared_by\nreference_standard,{},relative,table\nrepeatability,0.01,relative,row\n"
FIT = {"form": "cook_torrance", "fix": {"f0": 0.04}}
WORDS = ["--form", "cook_torrance", "--fix", "f0=0.04", "--json"]


class SeveralTables(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.tables = []
        for seed, alpha in ((1, 0.25), (2, 0.25), (3, 0.29)):
            surface = brdf.material("cook_torrance", channels=["v"], kd=0.3, ks=1, alpha=alpha, f0=0.04)
            self.tables.append(brdf.synth(surface, grid="hemisphere", step=15, theta_i=[0, 20, 40, 60], noise=0.01, seed=seed))
        self.files = [self.folder / f"{k}.csv" for k in range(3)]
        self.budgets = [self.folder / f"budget_{k}.csv" for k in range(3)]
        for k, (table, file, budget) in enumerate(zip(self.tables, self.files, self.budgets)):
            table.save(file)
            budget.write_text(BUDGET.format(0.01 + 0.002 * k))

    def said(self, *words):
        run = subprocess.run([PROGRAM, *map(str, words), *WORDS], capture_output=True, text=True, check=False)
        return run.returncode, {k: v for k, v in json.loads(run.stdout).items() if k not in ("provenance", "tables")}

    def plain(self, found):
        return {k: v for k, v in found.items() if k not in ("provenance", "tables")}

    def test_compare(self):
        code, said = self.said("compare", *self.files[1:], "--budget", self.budgets[0])
        self.assertEqual((code, said["answer"], said["differing"]), (1, "different", ["alpha"]))
        self.assertEqual(self.plain(brdf.compare(*self.files[1:], budget=self.budgets[0], **FIT)), said)
        same = brdf.compare(*self.tables[:2], budget=self.budgets[:2], **FIT)
        self.assertEqual(same["answer"], "no_difference")
        self.assertEqual(brdf.compare(*self.tables[:2], **FIT)["answer"], "cannot_be_told")

    def test_tables_keep_the_budget_that_their_comment_names(self):
        for file, budget in zip(self.files, self.budgets):
            file.write_text(f"# budget: {budget.name}\n" + file.read_text())
        read = [brdf.read(file) for file in self.files]
        same, files = brdf.compare(*read[1:], **FIT), brdf.compare(*self.files[1:], **FIT)
        self.assertEqual([same[key] for key in ("answer", "statistic", "p")], [files[key] for key in ("answer", "statistic", "p")])
        self.assertEqual(brdf.consensus(*read, **FIT)["budget"], True)

    def test_consensus(self):
        words = [word for budget in self.budgets for word in ("--budget", budget)]
        code, said = self.said("consensus", *self.files, *words, "--at", "0:45", "--at", "30:10")
        self.assertEqual(code, 0)
        found = brdf.consensus(*self.files, budget=self.budgets, at=["0:45", "30:10"], **FIT)
        self.assertEqual(self.plain(found), said)
        self.assertEqual(found["quantities"][1]["name"], "f(30:10)")

    def test_faults(self):
        with self.assertRaisesRegex(brdf.InputError, "given 2 times for 3 tables"):
            brdf.consensus(*self.files, budget=self.budgets[:2], **FIT)
        with self.assertRaisesRegex(brdf.InputError, "at least two tables"):
            brdf.consensus(self.files[0], **FIT)


if __name__ == "__main__":
    unittest.main()
