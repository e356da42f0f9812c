"""Shared by the tests here: an installed prefix that was moved, and commands."""
import os
import subprocess
import sys
import tempfile


def run(command, **options):
    """Returns the output of a command. If the command fails, the test ends with its messages."""
    options.setdefault("env", {**os.environ, "LC_ALL": "C"})
    done = subprocess.run([str(word) for word in command], text=True, capture_output=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\nexit {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def moved_prefix(build, folder, components=("program", "development", "chart_js", "libraries", "python")):
    """Installs into one folder and moves it to another, so that a path of the first leads nowhere."""
    first, prefix = folder / "first", folder / "moved" / "prefix"
    for component in components:
        run(["cmake", "--install", build, "--prefix", first, "--component", component])
    prefix.parent.mkdir()
    first.rename(prefix)
    mentions = subprocess.run(["grep", "-rlF", "-e", str(first), "-e", str(build), "--include=*.cmake",
                               "--include=*.pc", str(prefix)], text=True, capture_output=True).stdout
    if mentions:
        sys.exit(f"name the folder of the build or of the first prefix:\n{mentions}")
    return prefix


def library_folder(prefix):
    return next(prefix.glob("lib*/**/pkgconfig")).parent


def temporary_folder():
    return tempfile.TemporaryDirectory(prefix="brdf_install_")


def values_of(text):
    """Returns the last columns of the rows of `brdf eval` as numbers, so that values are compared and not digits."""
    rows = [line.split(",") for line in text.splitlines() if line and line[0] in "-0123456789."]
    return [[float(word) for word in row] for row in rows]


def check_consumer(programs, brdf, source):
    """Requires that examples/consumer prints the same values as `brdf eval`, bit for bit; ./test --full tests all materials and forms."""
    every = 1 if "BRDF_THOROUGH" in os.environ else 4
    directions = source / "data/directions.csv"
    for material in sorted((source / "data/materials").glob("*.json"))[::every]:
        said = values_of(run([programs / "values", material, directions]))
        expected = [row[4:] for row in values_of(run([brdf, "eval", "--material", material, directions]))]
        assert said == expected and said, f"{material}: {said} instead of {expected}"
    pair = programs / "pair.csv"
    pair.write_text("theta_i,phi_i,theta_o,phi_o\n45,0,30,180\n")
    lines = run([programs / "forms"]).splitlines()
    assert len(lines) > 20, lines
    for line in lines[::every]:
        form, value = line.split()
        expected = values_of(run([brdf, "eval", "--form", form, pair]))[0][4]
        assert abs(float(value) - expected) <= 1e-14 * abs(expected), f"{form}: {value} instead of {expected}"
    if (programs / "best").exists():
        best = run([programs / "best", source / "data/synthetic/ward.csv"])
        assert "energy: largest directional albedo found:" in best, best


def needed(binary):
    return [line.split("[")[1].rstrip("]") for line in run(["readelf", "-d", binary]).splitlines() if "(NEEDED)" in line]
