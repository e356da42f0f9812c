"""What programs' virtual goniometers share: pairs of directions, materials as the library evaluates them, losses."""
import math
import random
import shlex
import subprocess


def draw_pairs(count, most=80):
    """theta_i, phi_i, theta_o, phi_o in degrees."""
    draw = random.Random(20)
    return [[round(draw.uniform(0, high), 3) for high in (most, 360, most, 360)] for _ in range(count)]


def rows_of(pairs):
    return "".join(",".join(map(str, pair)) + "\n" for pair in pairs)


def write_directions(path, pairs):
    path.write_text("theta_i,phi_i,theta_o,phi_o\n" + rows_of(pairs))
    return path


def evaluated(brdf, words, directions):
    """f_r of a material given in words, rows of three channels."""
    text = subprocess.run([brdf, "eval", *shlex.split(words), str(directions)], check=True, text=True,
                          capture_output=True).stdout
    rows = [line.split(",")[4:] for line in text.splitlines() if not line.startswith("#")][1:]
    return [[float(x) for x in (row if len(row) == 3 else row * 3)] for row in rows]


def rms(ours, theirs, pairs):
    """Of ln(1 + f cos_i), as `brdf export` has it."""
    residuals = [math.log1p(b * math.cos(math.radians(p[0]))) - math.log1p(a * math.cos(math.radians(p[0])))
                 for x, y, p in zip(ours, theirs, pairs) for a, b in zip(x, y)]
    return math.sqrt(sum(r * r for r in residuals) / len(residuals))


def largest(target, seen):
    """The largest relative difference."""
    return max(abs(b / a - 1) for x, y in zip(target, seen) for a, b in zip(x, y))
