"""Shared parts of the tests of planned work: the program in a folder, the bytes of folders, and small inputs."""
import pathlib
import subprocess


class Place:
    """A folder that the program is called in."""

    def __init__(self, brdf, folder):
        self.brdf, self.folder = pathlib.Path(brdf).resolve(), pathlib.Path(folder)

    def run(self, words, code=0, **options):
        done = subprocess.run([self.brdf, *words.split()], cwd=self.folder, capture_output=True, text=True, **options)
        assert done.returncode == code, (words, done.returncode, done.stdout, done.stderr[-2000:])
        return done

    def refused(self, words, text):
        message = self.run(words, 2).stderr
        assert text in message, (words, message)

    def digest(self, name):
        root = self.folder / name
        return {str(p.relative_to(root)): p.read_bytes() for p in sorted(root.rglob("*")) if p.is_file()}

    def same(self, one, other):
        """Returns whether two folders contain the same files, and names the first file that differs."""
        a, b = self.digest(one), self.digest(other)
        assert a.keys() == b.keys(), (one, other, sorted(a.keys() ^ b.keys())[:10])
        for name, content in a.items():
            assert content == b[name], f"{one}/{name} and {other}/{name} differ"
        assert a, one

    def units(self, job):
        """Returns the file of each unit, with the properties that show whether the file was written again."""
        return {int(p.stem): (p, p.stat().st_ino, p.stat().st_mtime_ns)
                for p in sorted((self.folder / job / "units").rglob("*.unit"))}

    def make_stack(self, texels, lights=24, name="stack"):
        self.run(f"synth --form cook_torrance --set kd=0.3,0.2,0.1 --set ks=0.5 --texels {texels} --lights {lights} "
                 f"--vary alpha=0.1:0.5 --tilt 20 --noise 0.02 --seed 3 -o {name}")

    def make_tables(self, count, name="measurements", broken=None):
        """Writes `count` tables of different paints; the table with the number `broken` is cut in the middle of a row."""
        (self.folder / name).mkdir()
        for k in range(count):
            file = f"{name}/paint_{k:04d}.csv"
            self.run(f"synth --form ward --set alpha={0.1 + 0.3 * k / count:.4f} --set kd={0.1 + 0.4 * (k % 7) / 7:.3f} "
                     f"--grid in_plane --theta-i 15,45,70 --step 5 --noise 0.02 --seed {k} -o {file}")
        if broken is not None:
            path = self.folder / f"{name}/paint_{broken:04d}.csv"
            text = path.read_text()
            path.write_text(text[:len(text) // 2].rsplit(",", 1)[0] + "\n")


def damage(path):
    """Flips one bit of a byte in the middle."""
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 16
    path.write_bytes(content)
