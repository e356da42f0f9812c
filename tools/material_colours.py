#!/usr/bin/env python3
# ctest: data.material_colours label=cli --check @source@/data/materials
"""Writes the materials of data/materials that come from published tables. The tables are below, with their sources.

The f0 of a metal in a colour is its reflectance at normal incidence relative to a white reflector. The reflectance
R = ((n-1)^2 + k^2)/((n+1)^2 + k^2), with n and k interpolated linearly between the rows of the table, is weighted by illuminant
D65 and the CIE 1931 observer every 10 nm from 380 to 780 nm, converted to linear sRGB (IEC 61966-2-1), and divided by the same
sums for R = 1. The colours of MERL are the colours of its pictures.

Usage: tools/material_colours.py FOLDER   writes the files (as `data/materials` has them)
       tools/material_colours.py --check FOLDER   compares them; exit code 1 if one differs
"""
import json
import os
import sys

def rows_of(name):
    """Returns the rows of a file io/*.csv by wavelength in nm."""
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "io", "colour", name)
    with open(path, encoding="utf-8") as lines:
        rows = [line.split(",") for line in lines if line[0].isdigit()]
    return {int(row[0]): [float(v) for v in row[1:]] for row in rows}


# Every 10 nm: the library's tables; D65 is S0 + M1 S1 + M2 S2 of its multipliers (CIE 15:2004).
OBSERVER = [row for nm, row in rows_of("cie_observer.csv").items() if nm % 10 == 0]
D65 = [s0 - .295 * s1 - .689 * s2 for s0, s1, s2 in rows_of("cie_daylight.csv").values()]
TO_SRGB = [(3.2404542, -1.5371385, -.4985314), (-.9692660, 1.8760108, .0415560), (.0556434, -.2040259, 1.0572252)]

# Wavelength in nm, n, k.
JOHNSON = "Johnson and Christy 1972 (doi 10.1103/PhysRevB.6.4370), table I"
GOLD = [(367.9, 1.48, 1.895), (381.5, 1.46, 1.933), (397.4, 1.47, 1.952), (413.3, 1.46, 1.958), (430.5, 1.45, 1.948),
        (450.9, 1.38, 1.914), (471.4, 1.31, 1.849), (495.9, 1.04, 1.833), (520.9, .62, 2.081), (548.6, .43, 2.455),
        (582.1, .29, 2.863), (616.8, .21, 3.272), (659.5, .14, 3.697), (704.5, .13, 4.103), (756.0, .14, 4.542),
        (821.1, .16, 5.083)]
SILVER = [(367.9, .07, 1.657), (381.5, .05, 1.864), (397.4, .05, 2.070), (413.3, .05, 2.275), (430.5, .04, 2.462),
          (450.9, .04, 2.657), (471.4, .05, 2.869), (495.9, .05, 3.093), (520.9, .05, 3.324), (548.6, .06, 3.586),
          (582.1, .05, 3.858), (616.8, .06, 4.152), (659.5, .05, 4.483), (704.5, .04, 4.838), (756.0, .03, 5.242),
          (821.1, .04, 5.727)]
COPPER = [(367.9, 1.36, 1.975), (381.5, 1.33, 2.045), (397.4, 1.32, 2.116), (413.3, 1.28, 2.207), (430.5, 1.25, 2.305),
          (450.9, 1.24, 2.397), (471.4, 1.25, 2.483), (495.9, 1.22, 2.564), (520.9, 1.18, 2.608), (548.6, 1.02, 2.577),
          (582.1, .70, 2.704), (616.8, .30, 3.205), (659.5, .22, 3.747), (704.5, .21, 4.205), (756.0, .24, 4.665),
          (821.1, .26, 5.180)]
RAKIC = "Rakic 1995 (doi 10.1364/AO.34.004755)"
ALUMINIUM = [(364.66, .39877, 4.3957), (413.28, .52135, 5.0008), (442.80, .60790, 5.3676), (476.87, .72780, 5.7781),
             (516.60, .87340, 6.2418), (563.57, 1.0728, 6.7839), (619.93, 1.3660, 7.4052), (652.25, 1.5724, 7.7354),
             (688.81, 1.8301, 8.0601), (729.32, 2.1606, 8.3565), (774.91, 2.6154, 8.4914), (794.78, 2.7675, 8.3866)]
QUERRY = "Querry 1985 (CRDC-CR-85034), 70 % copper and 30 % zinc"
BRASS = list(zip(
    range(380, 790, 10),
    [1.487, 1.471, 1.445, 1.405, 1.350, 1.278, 1.191, 1.094, .994, .900, .816, .745, .686, .639, .602, .573, .549, .527,
     .505, .484, .468, .460, .450, .452, .449, .445, .444, .444, .445, .444, .444, .445, .446, .448, .450, .452, .455, .457,
     .458, .460, .464],
    [1.818, 1.813, 1.805, 1.794, 1.786, 1.784, 1.797, 1.829, 1.883, 1.957, 2.046, 2.145, 2.250, 2.358, 2.464, 2.568, 2.668,
     2.765, 2.860, 2.958, 3.059, 3.159, 3.253, 3.345, 3.434, 3.522, 3.609, 3.695, 3.778, 3.860, 3.943, 4.025, 4.106, 4.186,
     4.266, 4.346, 4.424, 4.501, 4.579, 4.657, 4.737]))

# f0 is from the table above. The widths are Ward's if he measured such a surface, otherwise chosen.
WARD = "widths of {} by Ward 1992 (doi 10.1145/142920.134078), table 1"
CHOSEN = "the width is chosen, not measured"
METALS = {  # file: name, table, its source, form, widths, source of the widths
    "gold": ("gold", GOLD, JOHNSON, "cook_torrance", (.12, .12), CHOSEN),
    "silver": ("silver", SILVER, JOHNSON, "cook_torrance", (.1, .1), CHOSEN),
    "copper": ("copper", COPPER, JOHNSON, "cook_torrance", (.15, .15), CHOSEN),
    "brushed_aluminium": ("lightly brushed aluminium", ALUMINIUM, RAKIC, "cook_torrance_beckmann", (.088, .13),
                          WARD.format("lightly brushed aluminum")),
    "brass": ("rolled brass", BRASS, QUERRY, "cook_torrance_beckmann", (.05, .16), WARD.format("rolled brass")),
}

# Löw, Kronander, Ynnerman and Unger 2012 (ACM Transactions on Graphics 31, 1), fits of MERL's measurements by the logarithmic
# metric: kd, ks, m, eta. Their Cook-Torrance is ks F D G/(pi cos_i cos_o) with D = exp(-tan^2/m^2)/(m^2 cos^4), V-cavities
# and the exact Fresnel reflectance: 4 ks times the lobe of the form, because the D of the form includes pi.
# MERL's whites are dark (white-diffuse-bball: kd 0.32), so names of materials that are known to be white or of a certain
# brightness state that the level is that of the database.
LEVEL = " (level as in MERL)"
LOW = "Löw et al. 2012 (ACM Transactions on Graphics 31, 1), Cook-Torrance fitted to {} of the MERL database"
FITTED_BY_LOW = {
    "red_plastic": ("glossy red plastic", "red-specular-plastic", (.2489, .0380, .0176), (.12735, .11017, .11215), .008954,
                    1.20782),
    "alumina_ceramic": ("alumina ceramic" + LEVEL, "alumina-oxide", (.3143, .2917, .2567), (.12102, .10255, .11529), .01226, 1.32264),
    "cherry_wood": ("varnished cherry wood" + LEVEL, "cherry-235", (.0425, .0199, .0125), (.04239, .04193, .04176), .151471, 1.70373),
    "red_fabric": ("red fabric" + LEVEL, "red-fabric", (.199, .0246, .0078), (.03061, .01008, .00841), .418454, 2.54883),
    "red_car_paint": ("red metallic paint", "red-metallic-paint", (.0541, .0075, .0033), (.1389, .03126, .02203), .031141,
                      2.05916),
}

# Published colours with the gloss of Löw's fit to white-marble: ks, m, eta. A part of the light is reflected by the gloss, so
# the diffuse weight is the colour times 1 - 0.06, with which both together conserve energy.
MARBLE_GLOSS = (.047, .04361, .04203), .018867, 1.55502
GLOSS_LEFT = .94
PUBLISHED = {  # file: name, colour, its source, source of the gloss
    "white_marble": ("white marble", (.83, .79, .75), "diffuse reflectance of marble by Jensen et al. 2001 (doi "
                     "10.1145/383259.383319), figure 5", "gloss: " + LOW.format("white-marble")),
    "porcelain": ("porcelain", (.745, .745, .723), "colour of porcelain measured by Palmqvist with a Nix Spectro 2, D65 "
                  "(physically-based-api, CC0)", "the gloss is chosen, not measured"),
}

# Ngan, Durand and Matusik 2005 (Experimental analysis of BRDF models, supplement): isotropic Ward fitted to MERL's
# measurements: kd, ks, alpha. Their green and blue lack MERL's factors 1.15 and 1.66.
NGAN = "Ngan, Durand and Matusik 2005 (supplement), Ward's model fitted to {} of the MERL database"
FITTED_BY_NGAN = {
    "blue_car_paint": ("blue metallic paint", "blue-metallic-paint", (.00878, .0046, .0144), (.081, .0664, .1), .239),
    "pearl_paint": ("pearl paint", "pearl-paint", (.189, .145, .0842), (.159, .116, .0564), .262),
}


def reflectance(table, wavelength):
    for (low, n0, k0), (high, n1, k1) in zip(table, table[1:]):
        if low <= wavelength <= high:
            t = (wavelength - low) / (high - low)
            n, k = n0 + t * (n1 - n0), k0 + t * (k1 - k0)
            return ((n - 1) ** 2 + k * k) / ((n + 1) ** 2 + k * k)
    raise ValueError(wavelength)


def colour(spectrum):
    """Returns the linear sRGB colour of 41 reflectances under D65."""
    xyz = [sum(r * d * o[k] for r, d, o in zip(spectrum, D65, OBSERVER)) for k in range(3)]
    return [sum(m * v for m, v in zip(row, xyz)) for row in TO_SRGB]


def colour_of_metal(table):
    white = colour([1] * len(D65))
    metal = colour([reflectance(table, w) for w in range(380, 790, 10)])
    return [m / w for m, w in zip(metal, white)]


def rounded(values, digits=4):
    return [float(f"{v:.{digits}g}") for v in values]


def material(name, source, form, weights, shape):
    return {"format": "brdf-material", "version": 1, "name": name, "source": source, "form": form,
            "channels": ["r", "g", "b"], "weights": {k: rounded(v) for k, v in weights.items()}, "shape": shape}


def materials():
    for file, (name, table, source, form, (along, across), widths) in METALS.items():
        # Clipped to the gamut: a channel above 1 would be more light than a metal reflects under D65.
        f0 = [min(1, max(0, c)) for c in colour_of_metal(table)]
        yield file, material(name, f"f0 from n and k of {source}, under D65; {widths}", form,
                             {"kd": [0, 0, 0], "ks": [1, 1, 1], "f0": f0}, {"alpha_x": along, "alpha_y": across})
    for file, (name, merl, kd, ks, width, eta) in FITTED_BY_LOW.items():
        yield file, material(name, LOW.format(merl), "cook_torrance_vcavity", {"kd": kd, "ks": [4 * k for k in ks]},
                             {"alpha_x": width, "alpha_y": width, "eta": eta})
    for file, (name, colour, source, gloss) in PUBLISHED.items():
        ks, width, eta = MARBLE_GLOSS
        yield file, material(name, f"{source}, times {GLOSS_LEFT}; {gloss}", "cook_torrance_vcavity",
                             {"kd": [GLOSS_LEFT * c for c in colour], "ks": [4 * k for k in ks]},
                             {"alpha_x": width, "alpha_y": width, "eta": eta})
    for file, (name, merl, kd, ks, width) in FITTED_BY_NGAN.items():
        scale = (1, 1.15, 1.66)
        scaled = {"kd": [s * v for s, v in zip(scale, kd)], "ks": [s * v for s, v in zip(scale, ks)]}
        yield file, material(name, NGAN.format(merl), "ward", scaled, {"alpha_x": width, "alpha_y": width})


def text_of(made):
    """Writes arrays of numbers on one line."""
    lines = []
    for key, value in made.items():
        if isinstance(value, dict):
            inner = ",\n".join(f'    "{k}": {json.dumps(v, ensure_ascii=False)}' for k, v in value.items())
            lines.append(f'  "{key}": {{\n{inner}\n  }}')
        else:
            lines.append(f'  "{key}": {json.dumps(value, ensure_ascii=False)}')
    return "{\n" + ",\n".join(lines) + "\n}\n"


def main():
    check = sys.argv[1:2] == ["--check"]
    folder = sys.argv[-1]
    differ = []
    for file, made in materials():
        path = os.path.join(folder, file + ".json")
        if not check:
            with open(path, "w", encoding="utf-8") as out:
                out.write(text_of(made))
        elif not os.path.exists(path) or open(path, encoding="utf-8").read() != text_of(made):
            differ.append(path)
    if differ:
        sys.exit("differ from what tools/material_colours.py makes: " + ", ".join(differ))


if __name__ == "__main__":
    main()
