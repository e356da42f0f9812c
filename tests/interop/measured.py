"""Shared parts of the virtual goniometers: pairs of directions, materials that the library evaluates, and differences."""
import math
import random
import shlex
import subprocess

PAIRS = 140
MOST = 80  # degrees


def polar(v):
    return [math.degrees(math.acos(min(1, v[2]))), math.degrees(math.atan2(v[1], v[0])) % 360]


def unit(theta, phi):
    t, p = math.radians(theta), math.radians(phi)
    return [math.sin(t) * math.cos(p), math.sin(t) * math.sin(p), math.cos(t)]


def about_mirror(draw, least, most):
    """Returns a pair up to 80 degrees with a half vector of a slope between these limits."""
    while True:
        incident = [draw.uniform(0, MOST), draw.uniform(0, 360)]
        wi, slope, turn = unit(*incident), math.exp(draw.uniform(math.log(least), math.log(most))), draw.uniform(0, 2 * math.pi)
        half = [slope * math.cos(turn), slope * math.sin(turn), 1]
        scale = 2 * sum(a * b for a, b in zip(half, wi)) / (1 + slope * slope)
        outgoing = [scale * h - w for h, w in zip(half, wi)]
        if outgoing[2] > math.cos(math.radians(MOST)):
            return incident + polar(outgoing)


def draw_pairs():
    """Returns pairs theta_i, phi_i, theta_o, phi_o in degrees: random pairs, pairs from the mirror direction out to the edge of a
    rough lobe, mirror directions, and pairs with both directions at grazing angles, including the mirror directions at 80 degrees."""
    draw = random.Random(20)
    pairs = [[draw.uniform(0, high) for high in (MOST, 360, MOST, 360)] for _ in range(60)]
    pairs += [about_mirror(draw, 0.005, 1) for _ in range(40)]
    for _ in range(16):
        theta, phi = draw.uniform(0, MOST), draw.uniform(0, 360)
        pairs.append([theta, phi, theta, phi + 180])
    for _ in range(20):
        phi = draw.uniform(0, 360)
        pairs.append([draw.uniform(65, MOST), phi, draw.uniform(65, MOST), phi + 180 + draw.gauss(0, 25)])
    pairs += [[MOST, phi, MOST, phi + 180] for phi in (0, 45, 90, 300)]
    assert len(pairs) == PAIRS
    return [[round(theta_i, 3), round(phi_i % 360, 3), round(theta_o, 3), round(phi_o % 360, 3)]
            for theta_i, phi_i, theta_o, phi_o in pairs]


def rows_of(pairs):
    return "".join(",".join(map(str, pair)) + "\n" for pair in pairs)


def write_directions(path, pairs):
    path.write_text("theta_i,phi_i,theta_o,phi_o\n" + rows_of(pairs))
    return path


def evaluated(brdf, words, directions):
    """Returns f_r of a material that is given by options, as rows of three channels."""
    text = subprocess.run([brdf, "eval", *shlex.split(words), str(directions)], check=True, text=True,
                          capture_output=True).stdout
    rows = [line.split(",")[4:] for line in text.splitlines() if not line.startswith("#")][1:]
    return [[float(x) for x in (row if len(row) == 3 else row * 3)] for row in rows]


def rms(ours, theirs, pairs):
    """Returns the rms difference of ln(1 + f cos_i), the loss of `brdf export`."""
    residuals = [math.log1p(b * math.cos(math.radians(p[0]))) - math.log1p(a * math.cos(math.radians(p[0])))
                 for x, y, p in zip(ours, theirs, pairs) for a, b in zip(x, y)]
    return math.sqrt(sum(r * r for r in residuals) / len(residuals))


def differences(target, seen, beyond=0):
    """Returns relative differences; absolute differences up to `beyond` count as 0."""
    return [max(0, abs(b - a) - beyond) / a for x, y in zip(target, seen) for a, b in zip(x, y)]


def largest(target, seen):
    return max(differences(target, seen))
