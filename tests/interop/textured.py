"""Shared parts of the tests of textured exports: fitted maps of synthetic stacks, the texels that an export states, and directions in
the frame of a texel's normal."""
import json
import math
import shlex
import subprocess

from measured import draw_pairs, evaluated, polar, rms, unit, write_directions

# Materials of stacks by name: options of `brdf synth`, and of the fit.
STACKS = {
    "plastic": ("--form cook_torrance --set kd=0.3,0.2,0.1 --set ks=0.8 --set f0=0.05 --vary alpha=0.15:0.5 --vary kd=0.1:0.6",
                "--form cook_torrance"),
    "tilted": ("--form cook_torrance --set kd=0.3,0.2,0.1 --set ks=0.8 --set f0=0.05 --vary alpha=0.15:0.5 --vary kd=0.1:0.6"
               " --tilt 20", "--form cook_torrance --normals fit"),
    "metal": ("--form cook_torrance --set kd=0 --set ks=1 --set f0=0.9,0.6,0.3 --vary alpha=0.15:0.5 --vary f0=0.3:0.9",
              "--form cook_torrance --fix kd=0 --fix ks=1"),
}
# From one viewpoint ks and f0 cannot be distinguished, and some ks are above 1.
AMBIGUOUS = {"ambiguous": ("--form cook_torrance --set kd=0.3,0.2,0.1 --set ks=0.8 --set f0=0.05 --vary alpha=0.1:0.5 --noise 0.02",
                           "--form cook_torrance")}
SIZE = (8, 6)
STEEPEST = 60  # degrees between a direction and the normal of the texel


def made(brdf, words, **options):
    run = subprocess.run([brdf, *map(str, words)], text=True, capture_output=True, **options)
    assert run.returncode == 0, (words, run.stderr)
    return run


def fitted_maps(brdf, name, folder):
    """Returns maps.exr of a synthetic stack of this name."""
    synth, fit = (STACKS | AMBIGUOUS)[name]
    stack = folder / f"{name}_stack"
    made(brdf, ["synth", *shlex.split(synth), "--texels", "{}x{}".format(*SIZE), "--lights", 80, "--seed", 5, "-o", stack])
    made(brdf, ["fit", stack, *shlex.split(fit), "-o", folder / f"{name}_maps"])
    return folder / f"{name}_maps/maps.exr"


def into_frame(normal, w):
    """Returns a direction in the frame of a surface with this normal: the smallest rotation that takes the normal to z."""
    middle = [normal[0], normal[1], normal[2] + 1]
    along = sum(a * b for a, b in zip(middle, w)) / middle[2]
    return [w[0] - middle[0] * along, w[1] - middle[1] * along, w[2] - middle[2] * along + 2 * sum(a * b for a, b in zip(normal, w))]


class Place:
    """A texel that the export states, with the material of the map and the material of the textures."""

    def __init__(self, stated):
        self.x, self.y, self.normal = stated["x"], stated["y"], stated["carried_normal"]
        self.wanted_normal = stated["wanted_normal"]
        self.wanted, self.carried = (stated[key].removeprefix("brdf eval ") for key in ("wanted", "carried"))
        out = [-self.normal[0], -self.normal[1], self.normal[2]]
        self.pairs, self.factors = [], []
        for theta_i, phi_i, theta_o, phi_o in draw_pairs():
            if max(theta_i, theta_o) > STEEPEST:
                continue
            wi, wo = (into_frame(out, unit(*w)) for w in ((theta_i, phi_i), (theta_o, phi_o)))
            self.pairs.append([*polar(wi), *polar(wo)])
            # A program multiplies f_r by the cosine from the texel's normal, and the goniometers divide by that from z.
            self.factors.append(math.cos(math.radians(theta_i)) / wi[2])
        assert len(self.pairs) > 60

    def centre(self):
        """Returns the middle of the texel on the plane of the export, whose longer side is 2."""
        width, height = SIZE
        return [(2 * self.x + 1 - width) / max(SIZE), (height - 2 * self.y - 1) / max(SIZE)]

    def in_frame(self, normal):
        return [[*polar(into_frame(normal, unit(*p[:2]))), *polar(into_frame(normal, unit(*p[2:])))] for p in self.pairs]

    def values(self, brdf, folder):
        """Returns f_r of the map's material and of the material of the textures at the pairs."""
        return [evaluated(brdf, words, write_directions(folder / "texel.csv", self.in_frame(normal)))
                for words, normal in ((self.wanted, self.wanted_normal), (self.carried, self.normal))]

    def judge(self, brdf, folder, seen, bound, label="", shaded=lambda normal, wi, wo: True):
        """Returns whether the f_r that a program shows, times the factors of the normal, is that of the textures up to the bound, and
        whether the difference from the map is as large as with the stated values. `shaded` chooses the pairs that are compared, by the
        normal and both directions."""
        kept = [k for k, p in enumerate(self.pairs) if shaded(self.normal, unit(*p[:2]), unit(*p[2:]))]
        assert len(kept) > 20, len(kept)
        seen = [[value / factor for value in row] for row, factor in zip(seen, self.factors)]
        wanted, carried, seen = ([values[k] for k in kept] for values in (*self.values(brdf, folder), seen))
        apart = max(abs(b - a) / a for x, y in zip(carried, seen) for a, b in zip(x, y))
        said, found = (rms(wanted, values, [self.pairs[k] for k in kept]) for values in (carried, seen))
        good = apart < bound and abs(said - found) < max(2e-4, bound / 10)
        print(f"  {label or f'texel {self.x},{self.y}'}: {len(kept)} pairs, largest difference {apart:.2g} of {bound:.2g}, loss said "
              f"{said:.6f} seen {found:.6f}{'' if good or label else '  FAILED'}", flush=True)
        return good


def exported(brdf, maps, to, path, *options):
    """Exports maps, and returns the stated places."""
    said = json.loads(made(brdf, ["export", "--maps", maps, "--to", to, "-o", path, "--json", *options]).stdout)
    assert said["kind"] == "maps" and said["files"][-1] == str(path), said
    return [Place(stated) for stated in said["maps"]["places"]]
