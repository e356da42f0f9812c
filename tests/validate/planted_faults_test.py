"""Faults planted into synthetic measurements are named by `brdf validate`, and nothing else is:
planted_faults_test.py EXECUTABLE. Every form on every grid in ./test --full (BRDF_THOROUGH), else each form on one."""
import itertools
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

EXECUTABLE = sys.argv[1]
FORMS = {
    "rough": ["--form", "oren_nayar", "--set", "sigma=0.5", "--set", "rho=0.9"],
    "glossy": ["--form", "cook_torrance", "--set", "alpha=0.1", "--set", "kd=0.6,0.5,0.4", "--set", "ks=0.4"],
    "brushed": ["--form", "ward", "--set", "alpha_x=0.1", "--set", "alpha_y=0.3"],
}
GRIDS = {"hemisphere": [], "in_plane": ["--grid", "in_plane"], "coarse": ["--step", "10", "--theta-i", "20,40,60"]}
NAMED = {"negative": "negative", "exchanged": "directions", "cosine": "cosine_factor", "duplicates": "duplicates",
         "outlier": "outliers", "radians": "angle_unit", "azimuth": "azimuth", "elevation": "polar_angle",
         "saturation": "saturation", "counts": "quantity", "percent": "quantity", "brf": "quantity",
         "both_cosines": "cosine_factor"}
# What the statement must say.
WORDS = {"radians": "radians", "azimuth": "phi_o", "elevation": "elevations", "saturation": "saturated",
         "counts": "uncalibrated", "percent": "percent", "brf": "BRF", "both_cosines": "cos_i cos_o"}
# What a table cannot show: a matt surface has no highlight, a plane too little of the hemisphere for a scale of pi.
# An elevation shows where the highlight fades as the stated angle grows, or where values vary at the stated normal; a
# broad anisotropic lobe of the coarse grids does neither.
UNSEEN = {("rough", "azimuth"), ("in_plane", "brf"), ("brushed", "elevation")}


def read(path):
    lines = path.read_text().splitlines()
    comments = [line for line in lines if line.startswith("#")]
    header, *rows = [line for line in lines if not line.startswith("#")]
    return comments + [header], [[float(x) for x in row.split(",")] for row in rows]


def planted(fault, rows, rng):
    """The rows with the fault, and the index of the row that a finding must name (or None)."""
    rows = [list(row) for row in rows]
    at = rng.randrange(len(rows))
    if fault == "negative":
        rows[at][4] = -0.01
        return rows, at
    if fault == "outlier":
        rows[at][4:] = [10 * value for value in rows[at][4:]]
        return rows, at
    if fault == "exchanged":
        return [row[:2] + [row[3], row[2]] + row[4:] for row in rows], None
    if fault == "cosine":
        return [row[:4] + [math.cos(math.radians(row[0])) * v for v in row[4:]] for row in rows], None
    if fault == "radians":
        return [[round(math.radians(x), 6) for x in row[:4]] + row[4:] for row in rows], None
    if fault == "azimuth":
        return [row[:3] + [(row[3] + 180) % 360] + row[4:] for row in rows], None
    if fault == "elevation":
        return [[90 - row[0], row[1], 90 - row[2], row[3]] + row[4:] for row in rows], None
    if fault == "saturation":
        for column in range(4, len(rows[0])):
            ceiling = sorted((row[column] for row in rows), reverse=True)[max(3, len(rows) // 40)]
            for row in rows:
                row[column] = min(row[column], ceiling)
        return rows, None
    if fault in ("counts", "percent", "brf"):
        scale = {"counts": 30000, "percent": 100, "brf": math.pi}[fault]
        return [row[:4] + [round(scale * v) if fault == "counts" else scale * v for v in row[4:]] for row in rows], None
    if fault == "both_cosines":
        cosines = [math.cos(math.radians(row[0])) * math.cos(math.radians(row[2])) for row in rows]
        return [row[:4] + [c * v for v in row[4:]] for row, c in zip(rows, cosines)], None
    if fault == "duplicates":
        return rows + rng.sample(rows, 3), len(rows)
    return rows, None


def failures(path):
    run = subprocess.run([EXECUTABLE, "validate", str(path), "--json"], capture_output=True, text=True, check=False)
    found = {f["check"]: f["statement"] for f in json.loads(run.stdout)["findings"] if f["verdict"] == "fail"}
    assert run.returncode == (1 if found else 0), (path, run.returncode, run.stderr)
    return found


def main():
    tables = list(itertools.product(FORMS, GRIDS)) if "BRDF_THOROUGH" in os.environ else list(zip(FORMS, GRIDS))
    cases = 0
    with tempfile.TemporaryDirectory() as folder:
        for form, grid in tables:
            table = pathlib.Path(folder) / f"{form}_{grid}.csv"
            subprocess.run([EXECUTABLE, "synth", *FORMS[form], *GRIDS[grid], "--noise", "0.05", "--seed", "3", "-o", str(table)],
                           check=True, capture_output=True)
            head, rows = read(table)
            assert not failures(table), f"{table.name} is clean: {failures(table)}"
            for fault, check in NAMED.items():
                if (form, fault) in UNSEEN or (grid, fault) in UNSEEN:
                    continue
                faulty, at = planted(fault, rows, random.Random(f"{form} {grid} {fault}"))
                path = pathlib.Path(folder) / f"{form}_{grid}_{fault}.csv"
                path.write_text("\n".join(head + [",".join(map(repr, row)) for row in faulty]) + "\n")
                found = failures(path)
                assert list(found) == [check], f"{path.name}: {found}"
                assert WORDS.get(fault, "") in found[check], f"{path.name}: {found}"
                assert at is None or f"line {len(head) + at + 1}" in found[check], f"{path.name}: {found}"
                cases += 1
    print(f"{cases} planted faults were named, {len(tables)} clean tables were clean")


main()
