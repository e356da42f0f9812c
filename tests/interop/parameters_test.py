#!/usr/bin/env python3
# ctest: interop.parameters label=interop @brdf@
"""parameters_test.py BRDF: tests `brdf convert-parameters` against values that this file computes by other means: rules from their
sources, and gloss by a quadrature in numpy over the apertures of ISO 2813. Each test is a function with a sentence as its name."""
import json
import math
import subprocess
import sys

import numpy as np

brdf = sys.argv[1]
APERTURES = {20: (1.8, 3.6), 60: (4.4, 11.7), 85: (4.0, 6.0)}  # full widths of the receptor, degrees
SOURCE = (0.75, 2.5)


def run(*words):
    return subprocess.run([brdf, "convert-parameters", *map(str, words)], capture_output=True, text=True, check=False)


def rows(*words, code=0):
    done = run(*words, "--json")
    assert done.returncode == code, (words, done.returncode, done.stderr)
    return {row["name"]: row for row in json.loads(done.stdout)["results"]}


def near(value, expected, tolerance):
    assert abs(value - expected) <= tolerance, (value, expected, tolerance)


def fresnel(n, c):
    """Returns the mean of both polarisations, from Snell's angle."""
    t = np.sqrt(1 - (1 - c * c) / (n * n))
    return 0.5 * (((c - n * t) / (c + n * t))**2 + ((n * c - t) / (n * c + t))**2)


def stop(theta, phi, x, y):
    """Returns unit vectors through the points of a plane across the axis, and their solid angles per area."""
    s, c = math.sin(theta), math.cos(theta)
    axis = np.array([s * math.cos(phi), s * math.sin(phi), c])
    along = np.array([c * math.cos(phi), c * math.sin(phi), -s])
    across = np.array([-math.sin(phi), math.cos(phi), 0])
    w = axis + x[..., None] * along + y[..., None] * across
    length = np.linalg.norm(w, axis=-1)
    return w / length[..., None], length**-3


def ggx(wi, wo, alpha, n):
    """Returns D G F/(4 cos_i cos_o) with Smith's correlated G, with normalised half vectors."""
    h = wi + wo
    h /= np.linalg.norm(h, axis=-1)[..., None]
    z2 = h[..., 2]**2
    d = alpha**2 / (math.pi * (z2 * (alpha**2 - 1) + 1)**2)

    def lam(w):
        return 0.5 * (np.sqrt(1 + alpha**2 * (1 - w[..., 2]**2) / w[..., 2]**2) - 1)

    return d / (1 + lam(wi) + lam(wo)) * fresnel(n, np.sum(wi * h, axis=-1)) / (4 * wi[..., 2] * wo[..., 2])


def midpoints(full_width, count):
    half = math.tan(math.radians(full_width) / 2)
    return (np.arange(count) + 0.5) / count * 2 * half - half


def gloss(alpha, n, angle, source=9, receptor=160):
    theta = math.radians(angle)
    sx, sy = np.meshgrid(midpoints(SOURCE[0], source), midpoints(SOURCE[1], source))
    rx, ry = np.meshgrid(midpoints(APERTURES[angle][0], receptor), midpoints(APERTURES[angle][1], receptor))
    area = (rx[0, 1] - rx[0, 0]) * (ry[1, 0] - ry[0, 0])
    wo, solid = stop(theta, math.pi, rx, ry)
    wi, weight = stop(theta, 0, sx.reshape(-1), sy.reshape(-1))
    flux = [np.sum(ggx(one, wo, alpha, n) * wo[..., 2] * solid) * area for one in wi]
    return 100 * np.sum(weight * flux) / np.sum(weight * fresnel(1.567, wi[:, 2]))


def black_glass_has_100_gloss_units_at_each_angle():
    for row in rows("--from", "glass_index=1.567", "--to", "gloss").values():
        near(row["value"], 100, 1e-9)
    found = rows("--from", "glass_index=1.5")
    for angle in APERTURES:
        c = math.cos(math.radians(angle))
        near(found[f"gloss_{angle}"]["value"], 100 * fresnel(1.5, c) / fresnel(1.567, c), 0.005)
    near(found["gloss_20"]["value"], 82.05, 0.01)
    near(found["distinctness"]["value"], 100, 1e-9)


def a_smooth_lobe_tends_to_the_gloss_of_glass():
    for index in (1.567, 1.4):
        glass = rows("--from", f"glass_index={index}", "--to", "gloss")
        lobe = rows("--from", "ggx_alpha=1e-4", "--index", index, "--to", "gloss")
        for name, row in lobe.items():
            assert row["error_bound"] < 1e-3, row
            lost = glass[name]["value"] - row["value"]  # in the tails beyond the receptor
            assert 0 < lost < 0.02, (name, lost)


def gloss_of_rough_lobes_equals_a_quadrature_in_numpy():
    for alpha in (0.02, 0.1, 0.4):
        found = rows("--from", f"ggx_alpha={alpha}", "--index", 1.5, "--to", "gloss")
        for angle in APERTURES:
            row, expected = found[f"gloss_{angle}"], gloss(alpha, 1.5, angle)
            rougher = abs(gloss(alpha, 1.5, angle, 9, 80) - expected)
            near(row["value"], expected, 2 * rougher + row["error_bound"] + 2e-3 * expected)
            assert row["value"] > 0.99 * expected


def a_diffuse_white_surface_has_the_gloss_of_its_radiance():
    found = rows("--form", "lambert", "--set", "rho=1", "--to", "gloss")
    for angle in APERTURES:
        x, y = np.meshgrid(midpoints(APERTURES[angle][0], 200), midpoints(APERTURES[angle][1], 200))
        wo, solid = stop(math.radians(angle), math.pi, x, y)
        area = (x[0, 1] - x[0, 0]) * (y[1, 0] - y[0, 0])
        expected = 100 * np.sum(wo[..., 2] * solid) * area / math.pi / fresnel(1.567, math.cos(math.radians(angle)))
        near(found[f"gloss_{angle}"]["value"], expected, 1e-3 * expected)


def haze_is_stated_only_where_its_standard_applies():
    smooth = rows("--from", "ggx_alpha=0.005")
    assert smooth["gloss_60"]["value"] > 70
    near(smooth["haze"]["value"], smooth["gloss_60"]["value"] - smooth["gloss_20"]["value"], 1e-9)
    rough = rows("--from", "ggx_alpha=0.1")["haze"]
    assert rough["value"] is None and "above 70" in rough["undecided"], rough
    assert run("--from", "ggx_alpha=0.1", "--to", "haze").returncode == 1
    assert run("--from", "ggx_alpha=0.1").returncode == 0


def distinctness_falls_from_100_as_the_lobe_widens():
    values = [rows("--from", f"ggx_alpha={a}", "--to", "distinctness")["distinctness"]["value"] for a in (1e-4, 1e-3, 3e-3, 0.01, 0.1)]
    assert values == sorted(values, reverse=True) and values[0] > 98 and values[-1] < 1, values


def rules_and_conventions_are_those_of_their_sources():
    near(rows("--from", "blinn_phong_exponent=48", "--to", "beckmann_alpha")["beckmann_alpha"]["value"], 0.2, 1e-12)
    near(rows("--from", "beckmann_alpha=0.2", "--to", "blinn_phong_exponent")["blinn_phong_exponent"]["value"], 48, 1e-9)
    near(rows("--from", "phong_exponent=50", "--to", "blinn_phong_exponent")["blinn_phong_exponent"]["value"], 200, 1e-9)
    for name, value, kind in (("roughness", 0.3, "exact"), ("linear_roughness", 0.09, "exact"), ("ggx_alpha", 0.09, "exact")):
        row = rows("--from", "ggx_alpha=0.09", "--to", name)[name]
        near(row["value"], value, 1e-12)
        assert row["kind"] == kind and "loss" not in row, row
    near(rows("--from", "beckmann_alpha=0.2", "--to", "rms_slope")["rms_slope"]["value"], 0.2 / math.sqrt(2), 1e-12)
    ward = rows("--from", "ward_sigma=0.2", "--to", "beckmann_alpha")["beckmann_alpha"]
    near(ward["value"], 0.2, 1e-12)
    assert ward["kind"] == "rule" and ward["loss"]["rms"] > 0.01 and "Ward 1992" in ward["rule"], ward


def log_residual(alpha, weight, pairs, target):
    """Returns the rms of ln(1 + f cos_i) between a Beckmann lobe and values, by its formula with Smith's rational masking."""
    wi, wo = pairs
    h = wi + wo
    h /= np.linalg.norm(h, axis=-1)[..., None]
    z2 = h[..., 2]**2
    d = np.exp((z2 - 1) / (alpha**2 * z2)) / (math.pi * alpha**2 * z2**2)

    def lam(w):
        a = w[..., 2] / (alpha * np.sqrt(np.maximum(1 - w[..., 2]**2, 1e-30)))
        erf = np.vectorize(math.erf)(np.minimum(a, 30))
        return 0.5 * (np.exp(-a * a) / (a * math.sqrt(math.pi)) + erf - 1)

    f = weight * d / (1 + lam(wi) + lam(wo)) / (4 * wi[..., 2] * wo[..., 2])
    return np.sqrt(np.mean((np.log1p(f * wi[..., 2]) - np.log1p(target * wi[..., 2]))**2))


def the_fitted_lobe_is_nearer_than_its_neighbours():
    row = rows("--from", "ggx_alpha=0.2", "--to", "beckmann_alpha")["beckmann_alpha"]
    assert row["kind"] == "fit" and row["loss"]["rms"] > 0.02, row
    rng = np.random.default_rng(7)
    wi = []
    wo = []
    while len(wi) < 4000:  # half vectors of a wide lobe about the normal
        theta = rng.uniform(0, math.radians(75))
        light = np.array([math.sin(theta), 0, math.cos(theta)])
        tilt, phi = 0.2 * rng.choice([0, 0.3, 0.6, 1, 1.6, 2.5, 4]), rng.uniform(0, 2 * math.pi)
        half = np.array([tilt * math.cos(phi), tilt * math.sin(phi), 1])
        half /= np.linalg.norm(half)
        view = 2 * np.dot(half, light) * half - light
        if view[2] > math.cos(math.radians(80)):
            wi.append(light)
            wo.append(view)
    pairs = np.array(wi), np.array(wo)
    f = ggx(*pairs, 0.2, 1e6)
    best = log_residual(row["value"], row["weight"], pairs, f)
    for factor in (0.7, 1.4):
        assert best < log_residual(row["value"] * factor, row["weight"], pairs, f), (factor, best)
        assert best < log_residual(row["value"], row["weight"] * factor, pairs, f), (factor, best)


def values_outside_a_domain_are_refused():
    for words, sentence in ((("--from", "ggx_alpha=2"), "0.0001 to 1"), (("--from", "phong_exponent=-1"), "0 to 1e+06"),
                            (("--from", "glass_index=0.9"), "1 to 5"), (("--from", "ggx_alpha=0.1", "--index", 9), "1 to 5"),
                            (("--from", "beckmann_alpha=1e-4", "--to", "blinn_phong_exponent"), "0 to 1e+06"),
                            (("--from", "roughnes=0.1"), "must be one of phong_exponent"),
                            (("--from", "glass_index=1.5", "--to", "roughness"), "has no lobe"),
                            (("--form", "ward", "--to", "roughness"), "gloss, haze and distinctness"),
                            (("--form", "ward", "--index", 1.5), "--index"), ((), "either --from")):
        done = run(*words)
        assert done.returncode == 2 and sentence in done.stderr, (words, done.returncode, done.stderr)


def a_shader_that_is_too_smooth_says_so():
    import pathlib
    import tempfile
    with tempfile.TemporaryDirectory() as folder:
        shader = pathlib.Path(folder) / "mirror.glsl"
        shader.write_text("float brdf(vec3 L, vec3 V, vec3 N) { vec3 h = normalize(L + V); float t = 1.0 - h.z * h.z;\n"
                          "  return 1e10 * exp(-t * 1e13); }\n")
        done = run("--shader", shader, "--to", "gloss_60", "--json")
        assert done.returncode == 1, done
        row = json.loads(done.stdout)["results"][0]
        assert row["value"] is None and "did not converge" in row["undecided"], row


for test in (black_glass_has_100_gloss_units_at_each_angle, a_smooth_lobe_tends_to_the_gloss_of_glass,
             gloss_of_rough_lobes_equals_a_quadrature_in_numpy, a_diffuse_white_surface_has_the_gloss_of_its_radiance,
             haze_is_stated_only_where_its_standard_applies, distinctness_falls_from_100_as_the_lobe_widens,
             rules_and_conventions_are_those_of_their_sources, the_fitted_lobe_is_nearer_than_its_neighbours,
             values_outside_a_domain_are_refused, a_shader_that_is_too_smooth_says_so):
    test()
    print(test.__name__.replace("_", " "))
