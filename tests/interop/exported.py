"""Shared parts of the tests of programs: the shared materials, exported for one program, and the checks of the values that the
program shows."""
import concurrent.futures
import json
import os
import shlex
import shutil
import statistics
import subprocess

from materials import MATERIALS, OWN
from measured import PAIRS, differences, draw_pairs, evaluated, rms, write_directions

DARK = 1e-3  # 1/sr: stated relative differences are of f_r + this
NARROW = 0.09  # widths below: there a program's arithmetic in float is seen


class Export:
    """One material as a program's file, with the messages of its export."""

    def __init__(self, brdf, words, to, path, *options):
        run = subprocess.run([brdf, "export", *shlex.split(words), "--to", to, "-o", path, "--json", *options], text=True,
                             capture_output=True)
        assert run.returncode == 0, run.stderr
        self.words, self.path, self.said = words, path, json.loads(run.stdout)
        said = self.said["same_here"]
        self.terms = [words.removeprefix("brdf eval ") for words in ([said] if isinstance(said, str) else said)]
        self.text = path.read_text()
        assert all(words in self.text for words in self.terms), f"{path} does not state what it holds"

    def named(self):
        """Returns the stated parameters of the first term, as text."""
        return dict(word.split("=") for word in shlex.split(self.terms[0]) if "=" in word)

    def widths(self):
        """Returns the stated alpha_x and alpha_y; empty if the surface is diffuse."""
        named = self.named()
        diffuse = (named.get("metallic") == "0" and named.get("specular") == "0") or set(named.get("ks", "").split(",")) == {"0"}
        return [] if diffuse else [float(named[key]) for key in ("alpha_x", "alpha_y") if key in named]

    def witness(self):
        """Returns the pair of the stated largest difference; empty if the difference is 0."""
        loss = self.said["loss"]
        return [] if loss["largest"] < 1e-9 else [[loss[key] for key in ("theta_i", "phi_i", "theta_o", "phi_o")]]


class Exports:
    """The materials of materials.py for one program, in FOLDER."""

    def __init__(self, brdf, to, suffix, folder):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        self.brdf, self.folder, self.pairs = brdf, folder, draw_pairs()
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            def made(item):
                name, words = item
                return name, Export(brdf, words, to, folder / f"{name}{suffix}")
            self.of = dict(pool.map(made, (MATERIALS | OWN[to]).items()))

    def pairs_of(self, name):
        """Returns the pairs at which a program measures a material: the shared pairs and the stated witness."""
        return self.pairs + self.of[name].witness()

    def values(self, name):
        """Returns f_r at pairs_of(name) for the material, and for the material that the file describes."""
        directions = write_directions(self.folder / f"{name}_directions.csv", self.pairs_of(name))
        terms = [evaluated(self.brdf, words, directions) for words in self.of[name].terms]
        return evaluated(self.brdf, self.of[name].words, directions), [[sum(c) for c in zip(*rows)] for rows in zip(*terms)]


def summary_of(client, found):
    """Returns the summary. `found` has for each material whether its lobe is narrow, and the relative differences from the
    values of its file."""
    wide, narrow = ([max(apart) for kind, apart in found if kind == wanted] for wanted in (False, True))
    return {"client": client, "materials": len(found), "pairs": len(found[0][1]) // 3,
            "median": statistics.median(x for _, apart in found for x in apart), "largest": max(wide),
            "narrow": len(narrow), "largest_of_narrow": max(narrow, default=0)}


class Judged:
    """Compares the values that a program shows for each material with the values of its files."""

    def __init__(self, exports, client):
        self.exports, self.client, self.found, self.failed = exports, client, [], []

    def add(self, name, seen, bound, left_out=0):
        """Requires that the largest relative difference between `seen`, which is f_r at pairs_of(name), and the values of the file is
        below `bound` (`left_out` is the f_r that the program omits), and that the stated loss equals the measured loss."""
        source, target = self.exports.values(name)
        assert len(seen) == len(target) == len(self.exports.pairs_of(name))
        apart = differences(target[:PAIRS], seen[:PAIRS], left_out)
        said, found = (rms(source, values, self.exports.pairs) for values in (target, seen))
        largest = max((abs(b - a) / (a + DARK) for x, y in zip(source[PAIRS:], seen[PAIRS:]) for a, b in zip(x, y)), default=0)
        stated = self.exports.of[name].said["loss"]["largest"]
        good = (max(apart) < bound and abs(said - found) < max(1e-4, bound / 10) and
                abs(largest - stated) < 2 * bound * (1 + stated))
        if name in MATERIALS:
            self.found.append((min(self.exports.of[name].widths(), default=1) < NARROW, apart))
        print(f"{name:15} largest difference {max(apart):.2g} of {bound:.2g}, loss said {said:.6f} seen {found:.6f}, "
              f"at the stated place {stated:.6f} seen {largest:.6f}{'' if good else '  FAILED'}", flush=True)
        if not good:
            self.failed.append(name)

    def end(self):
        """Writes summary.json for tools/interop_clients.py. Returns whether every material agrees with its file."""
        summary = summary_of(self.client, self.found)
        (self.exports.folder / "summary.json").write_text(json.dumps(summary) + "\n")
        print(json.dumps(summary))
        if self.failed:
            print("not as said:", ", ".join(self.failed))
        return not self.failed and len(self.found) == len(MATERIALS)
