#!/usr/bin/env python3
# ctest: exports.radiance label=exports @brdf@ @here@/radiance
"""radiance_test.py BRDF FOLDER: tests that exports to Radiance are modifiers as its reader takes them (words of at most 127
characters, comments of at most 2047), and that their formula, written here from normal.c, aniso.c and raytrace.c, has the stated
values. Values that Radiance's own lines gave for the same files are in radiance_seen.csv, values of a Klems matrix in
radiance_matrix_seen.csv."""
import csv
import itertools
import json
import math
import pathlib
import shlex
import shutil
import subprocess
import sys

from measured import draw_pairs, evaluated, unit, write_directions

WARD = "--form ward_bounded --set kd={} --set ks={} --set {}"
CASES = {
    "clay": "--form lambert --set rho=0.6,0.5,0.4",
    "plastic": WARD.format("0.3,0.2,0.1", "0.2", "alpha=0.15"),
    "metal": WARD.format("0", "0.9,0.6,0.3", "alpha=0.25"),
    "dull_metal": WARD.format("0.09,0.06,0.03", "0.81,0.54,0.27", "alpha=0.2"),
    "coloured_lobe": WARD.format("0.3,0.2,0.1", "0.2,0.3,0.4", "alpha=0.2"),
    "brushed": WARD.format("0.3,0.2,0.1", "0.2", "alpha_x=0.3 --set alpha_y=0.1 --set tangent_phi=30"),
    "brushed_metal": WARD.format("0", "0.9,0.6,0.3", "alpha_x=0.1 --set alpha_y=0.4 --set tangent_phi=-20"),
}
TYPES = {"plastic": 5, "metal": 5, "plastic2": 6, "metal2": 6, "mixfunc": 0}
LONGEST_WORD, LONGEST_COMMENT = 127, 2047


def read(text):
    """Returns the modifiers in order: type, name, words, numbers."""
    words = []
    for line in text.splitlines():
        if line.startswith("#"):
            assert len(line) < LONGEST_COMMENT, len(line)
            continue
        words += line.split()
    assert all(len(word) <= LONGEST_WORD for word in words)
    words, modifiers = iter(words), []
    for modifier in words:
        assert modifier == "void", modifier
        kind, name = next(words), next(words)
        assert name not in {"void", "inherit"} | {m[1] for m in modifiers}, name
        strings = list(itertools.islice(words, int(next(words))))
        assert next(words) == "0"
        numbers = [float(x) for x in itertools.islice(words, int(next(words)))]
        assert len(numbers) == TYPES[kind], (kind, numbers)
        modifiers.append((kind, name, strings, numbers))
    return modifiers


def lobe(h, u, v, along, across):
    """Returns exp(-((h.u/along)^2 + (h.v/across)^2)/h_z^2) |h|^2/(pi along across h_z^4)."""
    hu, hv = (sum(a * b for a, b in zip(h, w)) for w in (u, v))
    exponent = ((hu / along) ** 2 + (hv / across) ** 2) / h[2] ** 2
    return math.exp(-exponent) * sum(x * x for x in h) / (math.pi * along * across * h[2] ** 4)


def value(modifiers, name, wi, wo):
    """Returns f_r of three colours, per steradian, on a surface in the xy plane."""
    kind, _, strings, numbers = next(m for m in modifiers if m[1] == name)
    if kind == "mixfunc":
        share = float(strings[2])
        assert strings[3] == "." and 0 < share < 1
        return [share * a + (1 - share) * b for a, b in zip(*(value(modifiers, part, wi, wo) for part in strings[:2]))]
    colour, specular, along, across = numbers[:3], numbers[3], numbers[4], numbers[-1]
    assert max(colour) <= 1 and 0 <= specular <= 1
    u = [float(x) for x in strings[:3]] if kind.endswith("2") else [1, 0, 0]
    assert not kind.endswith("2") or (len(strings) == 4 and strings[3] == ".")
    gloss = specular and specular * lobe([a + b for a, b in zip(wi, wo)], u, [-u[1], u[0], 0], along, across)
    return [c * (1 - specular) / math.pi + (c if kind.startswith("metal") else 1) * gloss for c in colour]


BRUSHED = {"format": "brdf-material", "version": 1, "name": "brushed", "form": "ward_bounded", "channels": ["fr"],
           "weights": {"kd": [0.3], "ks": [0.4]}, "shape": {"alpha_x": 0.5, "alpha_y": 0.25}, "tangent_phi": 30}
# LBNL/Klems Full: the lower bound of theta in degrees and the number of patches of each ring.
RINGS = ((0, 1), (5, 8), (15, 16), (25, 20), (35, 24), (45, 24), (55, 24), (65, 16), (75, 12), (90, 0))


def centre(theta, phi):
    """Returns the centre of the patch that holds a direction of the viewer, in degrees."""
    ring = max(k for k, (lower, _) in enumerate(RINGS) if lower <= theta)
    step = 360 / RINGS[ring][1]
    return (RINGS[ring][0] + RINGS[ring + 1][0]) / 2 if ring else 0, round(phi / step) * step % 360


def check_matrix(brdf, folder):
    """The values that Radiance's reader takes from a matrix equal the values that `brdf convert` reads, on both surfaces."""
    def run(*words):
        subprocess.run([brdf, "convert", "-q", *words], check=True)

    (folder / "brushed.json").write_text(json.dumps(BRUSHED))
    run(folder / "brushed.json", folder / "brushed.xml")
    seen = list(measured_rows(pathlib.Path(__file__).with_name("radiance_matrix_seen.csv").read_text()))
    for surface in ("front", "back"):
        run(folder / "brushed.xml", folder / f"{surface}.csv", "--matrix", surface)
        table = {}
        for row in measured_rows((folder / f"{surface}.csv").read_text()):
            place = [round(float(row[key]) % 360, 6) for key in ("theta_i", "phi_i", "theta_o", "phi_o")]
            table[tuple(0 if place[k - k % 2] == 0 else x for k, x in enumerate(place))] = float(row["Visible"])
        # Radiance takes the same values for both surfaces, in axes that differ by the sign of z alone.
        apart = []
        for row in seen:
            light = centre(float(row["theta_i"]), float(row["phi_i"]) - 180)
            place = (light[0], (light[1] + 180) % 360 if light[0] else 0, *centre(float(row["theta_o"]), float(row["phi_o"])))
            here, there = table[tuple(round(x, 6) for x in place)], float(row[surface])
            apart.append(abs(here - there) / there)
        print(f"matrix, {surface}: {len(apart)} pairs of Radiance, largest relative difference {max(apart):.2g}")
        assert len(apart) == 24 and max(apart) < 1e-6, max(apart)


def measured_rows(text):
    return csv.DictReader(line for line in text.splitlines() if not line.startswith("#"))


def main():
    brdf, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)

    def export(words, name, code=0):
        run = subprocess.run([brdf, "export", *shlex.split(words), "--to", "radiance", "--name", name], text=True, capture_output=True)
        assert run.returncode == code, run.stderr
        return run.stdout if code == 0 else run.stderr

    pairs = draw_pairs()
    directions = write_directions(folder / "directions.csv", pairs)
    seen = {}
    lines = pathlib.Path(__file__).with_name("radiance_seen.csv").read_text().splitlines()
    for case, *row in csv.reader(line for line in lines if not line.startswith(("#", "case,"))):
        seen.setdefault(case, []).append([float(x) for x in row])
    check_matrix(brdf, folder)
    kinds = set()
    for case, words in CASES.items():
        text = export(words, case)
        (folder / f"{case}.rad").write_text(text)
        assert ": exact" in text or ": no difference above 1e-9" in text, text
        modifiers = read(text)
        kinds |= {m[0] for m in modifiers}
        assert modifiers[-1][1] == case
        right = evaluated(brdf, words, directions)
        for pair, row in zip(pairs, right):
            here = value(modifiers, case, unit(*pair[:2]), unit(*pair[2:]))
            # Nine digits of the parameters.
            assert all(abs(a - b) < 2e-7 * (b + 1e-3) for a, b in zip(here, row)), (case, pair, here, row)
        measured = evaluated(brdf, words, write_directions(folder / "seen.csv", [row[:4] for row in seen[case]]))
        # Radiance leaves out lobes below 1e-6 /sr, and computes colours in float.
        apart, left_out = 0, 0
        for row, values in zip(seen[case], measured):
            for a, b in zip(row[4:], values):
                dark = b - a > 2e-7 * b and b - a < 1e-6
                left_out += dark
                apart = max(apart, 0 if dark else abs(a - b) / b)
        print(f"{case}: {len(seen[case])} pairs of Radiance, largest difference {apart:.2g}, {left_out} lobes left out")
        assert len(seen[case]) == 16 and apart < 2e-7 and left_out <= 12, (case, apart, left_out)
    assert kinds == set(TYPES), kinds
    assert read(export(CASES["coloured_lobe"], "x" * 300))[-1][1] == "x" * 100
    assert read(export(CASES["plastic"], "void"))[-1][1] == "material_void"
    many = export("--form ward_bounded --set kd=0.1" + "0" * 3000, "many")
    assert max(map(len, many.splitlines())) < LONGEST_COMMENT and len(many) > 3000 and read(many)[-1][1] == "many"
    assert "below which the program shows a mirror" in export(WARD.format("0.1", "0.2", "alpha=0.0005"), "mirror", 2)


main()
