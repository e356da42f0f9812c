# ctest: fit.ranking_short label=fit timeout=300 needs=plain @brdf@ --first 10 --tables 6
# ctest: fit.ranking label=slow timeout=3600 needs=plain @brdf@ --tables 200
"""Tests the ranking of forms on seeded synthetic tables of known form, and the verdict on matt forms for glossy samples.

    ranking_test.py EXECUTABLE [--tables 200] [--first 0] [--verbose]

The tables combine families with scan patterns (light scanned, viewer scanned, both, in plane, hemisphere), noise of 1 to
5 % and alpha from 0.02 to 0.6. The test requires that the generating form is first in at least 80 % of the tables with
alpha <= 0.3 and noise <= 2 %. In at least 95 % of all tables the first form must be the generating form, or a form that is
not significantly worse on the held-out values of the JSON (a paired, one-sided 5 % test of this script). On glossy tables (the
noise-free highlight is at least twice the diffuse value in three rows or more) lambert and oren_nayar must be a misfit with
exit code 1 under every metric.
"""
import argparse
import collections
import csv
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

METRICS = ["log", "cosine_l2", "cube_root", "log_relative"]
FORMS = ["phong", "blinn_phong", "ward", "cook_torrance", "oren_nayar"]
MATT = ["lambert", "oren_nayar"]


def steps(first, last, step):
    return [first + k * step for k in range(int((last - first) / step + 1e-9) + 1)]


def light_scanned(_):
    return [(i, 180, o, 0) for o in (15, 20, 30, 40, 45, 50, 60, 70, 80) for i in steps(1, 80, 1)]


def viewer_scanned(_):
    return [(o, 180, i, 0) for i, _, o, _ in light_scanned(None)]


def both_scanned(draw):
    """Returns rows for which both arms move at random over the hemisphere; half of the rows are near the mirror direction."""
    rows = []
    while len(rows) < 1200:
        i, o, turn = (math.degrees(math.acos(draw.uniform(0.2, 1))), math.degrees(math.acos(draw.uniform(0.2, 1))),
                      draw.uniform(-180, 180))
        if len(rows) % 2:
            o, turn = min(max(i + draw.gauss(0, 8), 0), 79), draw.gauss(0, 12)
        rows.append((round(i, 1), 180, round(o, 1), round(turn, 1) % 360))
    return rows


def in_plane(draw):
    incidences = sorted(draw.sample(range(5, 75, 5), 7))
    return [(i, 180, abs(o), 0 if o >= 0 else 180) for i in incidences for o in steps(-80, 80, 2)]


def hemisphere(_):
    rows = []
    for i in (0, 15, 30, 45, 60, 75):
        rows.append((i, 180, 0, 0))
        rows += [(i, 180, o, phi) for o in steps(5, 80, 5) for phi in steps(0, 350, 10)]
    return rows


PATTERNS = [light_scanned, viewer_scanned, both_scanned, in_plane, hemisphere]


def truth(form, draw):
    """Returns the settings for `synth` and the width of the lobe (1 for oren_nayar, which has no lobe)."""
    alpha = math.exp(draw.uniform(math.log(0.02), math.log(0.6)))
    kd = draw.uniform(0.05, 0.8)
    ks = draw.uniform(0.1, 0.9) * (1 - kd)
    if form == "oren_nayar":
        return {"rho": kd + 0.1, "sigma": draw.uniform(0.25, 0.6)}, 1.0
    settings = {"kd": kd, "ks": ks}
    if form == "phong":
        settings["exponent"] = 0.5 / alpha ** 2
    elif form == "blinn_phong":
        settings["exponent"] = 2 / alpha ** 2
    else:
        settings["alpha"] = alpha
    if form == "cook_torrance":
        settings["f0"] = draw.choice([0.04, 0.3, 0.6, 0.9])
        settings["ks"] = 1 - kd
    return settings, alpha


def write_grid(path, rows):
    with path.open("w", encoding="utf-8") as out:
        out.write("theta_i,phi_i,theta_o,phi_o\n")
        out.writelines(",".join(map(str, row)) + "\n" for row in rows)


def values(path):
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    return [float(row[4]) for row in list(csv.reader(lines))[1:]]


class Program:
    def __init__(self, executable):
        self.executable = executable

    def run(self, *words, good=(0,)):
        done = subprocess.run([self.executable, *map(str, words)], capture_output=True, text=True, check=False)
        if done.returncode not in good:
            sys.exit(f"brdf {' '.join(map(str, words))}: exit {done.returncode}: {done.stderr}")
        return done

    def synth(self, form, settings, grid, out, *options):
        given = [word for name, value in settings.items() for word in ("--set", f"{name}={value!r}")]
        self.run("synth", "--form", form, *given, "--grid", grid, *options, "-o", out)

    def fit(self, table, *options):
        done = self.run("fit", table, "--json", *options, good=(0, 1))
        return json.loads(done.stdout), done.returncode


def t_95(freedom):
    """Returns the 95 % quantile of Student's t (Abramowitz and Stegun 26.7.5; 1 % off at 2 degrees of freedom)."""
    z = 1.6448536269514722
    terms = [(z ** 3 + z) / 4, (5 * z ** 5 + 16 * z ** 3 + 3 * z) / 96, (3 * z ** 7 + 19 * z ** 5 + 17 * z ** 3 - 15 * z) / 384]
    return z + sum(term / freedom ** (k + 1) for k, term in enumerate(terms))


def worse(a, b):
    """Returns whether the values per incidence of `a` are significantly larger than the values of `b` (paired, one-sided, 5 %)."""
    differences = [x["value"] - y["value"] for x, y in zip(a, b, strict=True)]
    n = len(differences)
    mean = sum(differences) / n
    error = math.sqrt(sum((d - mean) ** 2 for d in differences) / (n * (n - 1)))
    return mean > t_95(n - 1) * error


def glossy(program, form, settings, grid, folder):
    """Returns whether the highlight alone is at least as bright as the diffuse part in three rows or more."""
    if "kd" not in settings:
        return False
    parts = []
    for kd, name in ((settings["kd"], "whole.csv"), (0, "lobe.csv")):
        program.synth(form, settings | {"kd": kd}, grid, folder / name)
        parts.append(values(folder / name))
    return sum(lobe >= whole - lobe for whole, lobe in zip(*parts)) >= 3


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("executable", type=pathlib.Path)
    arguments.add_argument("--tables", type=int, default=200)
    arguments.add_argument("--first", type=int, default=0, help="number of the first table")
    arguments.add_argument("--metric", default="log", choices=METRICS)
    arguments.add_argument("--verbose", action="store_true")
    options = arguments.parse_args()
    program = Program(options.executable.resolve())
    counts = collections.Counter()
    wrong = []
    with tempfile.TemporaryDirectory(prefix="ranking.") as name:
        folder = pathlib.Path(name)
        for k in range(options.first, options.first + options.tables):
            draw = random.Random(k)
            form, pattern = FORMS[k % len(FORMS)], PATTERNS[k // len(FORMS) % len(PATTERNS)]
            settings, alpha = truth(form, draw)
            noise = round(draw.uniform(0.01, 0.05), 4)
            grid, table = folder / "grid.csv", folder / "table.csv"
            write_grid(grid, pattern(draw))
            program.synth(form, settings, grid, table, "--noise", noise, "--seed", k + 1)
            result, _ = program.fit(table, "--form", "all", "--metric", options.metric)
            by_form = {fit["form"]: fit for fit in result["ranking"]}
            first = result["ranking"][0]["form"]
            own = by_form[form]["left_out_by_incidence"]
            as_good = first == form or not worse(own, by_form[first]["left_out_by_incidence"])
            counts["all"] += 1
            counts["first or as good"] += as_good
            easy = alpha <= 0.3 and noise <= 0.02
            counts["easy"] += easy
            counts["easy, first"] += easy and first == form
            told = f"{k}: {form} {settings} {pattern.__name__} noise {noise}: first {first}"
            if options.verbose or not as_good:
                print(told, "" if first == form else "as good" if as_good else "WORSE",
                      *(f"{f['form']} {f['verdict']} {f['left_out']:.4g};" for f in result["ranking"][:3]), flush=True)
            if not glossy(program, form, settings, grid, folder):
                continue
            counts["gloss"] += 1
            for metric in METRICS:
                for matt in MATT:
                    fitted, code = program.fit(table, "--form", matt, "--metric", metric)
                    verdict = fitted["ranking"][0]["verdict"]
                    if verdict != "misfit" or code != 1:
                        wrong.append(f"{told}: {matt} by {metric} is {verdict}, exit {code}")
    print(*(f"{what}: {count}" for what, count in counts.items()), sep=", ")
    print(*wrong, f"{len(wrong)} matt forms on gloss are no misfit", sep="\n")
    failed = bool(wrong)
    for part, whole, least in (("easy, first", "easy", 0.8), ("first or as good", "all", 0.95)):
        if counts[part] < least * counts[whole]:
            print(f"{part}: {counts[part]} of {counts[whole]} are below {least:.0%}")
            failed = True
    sys.exit(failed)


if __name__ == "__main__":
    main()
