#!/usr/bin/env python3
"""The places where people wait: the time of each, its goal, and, with --before, the time of another build in the same run.

    python3 bench/places.py build/release [--before OTHER/build/release] [--rounds N] [PLACE...]

Both builds take turns, and the least of the rounds counts, so that a busy machine changes both columns alike. The table is written as
Markdown. The programs of bench/ are built by `ninja -C build/release bench`. The goals hold for an idle machine with two processors, on
which the program of the day of the goals (commit 8172a034) had the figures in the column `then`. On another machine, give that program
with --before, and compare now / before with goal / then.
"""
import argparse
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
OWN_SHADER = """//: param kd 0 1 0.3
//: param ks 0 1 0.5
//: param alpha 0.02 1 0.2 log
//: param f0 0.02 1 0.2
//: param veil 0 1 0.05
//: param fall 3 7 5
float brdf(vec3 L, vec3 V, float kd, float ks, float alpha, float f0, float veil, float fall) {
  vec3 H = normalize(L + V);
  float a2 = alpha * alpha, nl = max(L.z, 1e-6), nv = max(V.z, 1e-6), away = 1.0 - max(dot(L, H), 0.0);
  float d = H.z * H.z * (a2 - 1.0) + 1.0;
  float shadow = 0.5 / (nv * sqrt(a2 + (1.0 - a2) * nl * nl) + nl * sqrt(a2 + (1.0 - a2) * nv * nv));
  return kd / 3.14159265 + ks * a2 / (3.14159265 * d * d) * shadow * (f0 + (1.0 - f0) * pow(away, fall)) + veil * pow(away, 5.0);
}
"""
# Sixteen parameters, in the style of Burley's principled model (2012).
PRINCIPLED = """//: color base 0.6 0.3 0.2
//: param metallic 0 1 0.2
//: param under 0 1 0.1
//: param specular 0 1 0.5
//: param roughness 0.05 1 0.4
//: param specular_tint 0 1 0.1
//: param along 0 1 0.3
//: param sheen 0 1 0.1
//: param sheen_tint 0 1 0.5
//: param coat 0 1 0.2
//: param coat_gloss 0 1 0.8
//: param flatness 0 1 0.1
//: param coat_tint 0 1 0.2
//: param fall 3 7 5
const float PI = 3.14159265358979;
float away(float u, float power) { return pow(clamp(1.0 - u, 0.0, 1.0), power); }
float masked(float z, float a) { return 1.0 / (z + sqrt(a * a + z * z - a * a * z * z)); }
float stretched(vec3 w, vec2 a) { return 1.0 / (w.z + sqrt(w.x * w.x * a.x * a.x + w.y * w.y * a.y * a.y + w.z * w.z)); }
vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 base, float metallic, float under, float specular, float roughness, float specular_tint,
          float along, float sheen, float sheen_tint, float coat, float coat_gloss, float flatness, float coat_tint, float fall) {
  if (L.z <= 0.0 || V.z <= 0.0) return vec3(0.0);
  vec3 H = normalize(L + V);
  float lh = dot(L, H), light = 0.3 * base.x + 0.6 * base.y + 0.1 * base.z;
  vec3 tint = light > 0.0 ? base / light : vec3(1.0), f0 = mix(0.08 * specular * mix(vec3(1.0), tint, specular_tint), base, metallic);
  float rough = lh * lh * roughness, fl = away(L.z, fall), fv = away(V.z, fall), fh = away(lh, fall);
  float diffuse = mix(1.0, 0.5 + 2.0 * rough, fl) * mix(1.0, 0.5 + 2.0 * rough, fv);
  float flat_part = 1.25 * (mix(1.0, rough, fl) * mix(1.0, rough, fv) * (1.0 / (L.z + V.z) - 0.5) + 0.5);
  float aspect = sqrt(1.0 - 0.9 * along);
  vec2 a = max(vec2(0.001), vec2(roughness * roughness / aspect, roughness * roughness * aspect));
  float q = H.x * H.x / (a.x * a.x) + H.y * H.y / (a.y * a.y) + H.z * H.z;
  float lobe = stretched(L, a) * stretched(V, a) / (PI * a.x * a.y * q * q);
  float g2 = pow(mix(0.1, 0.001, coat_gloss), 2.0), t = 1.0 + (g2 - 1.0) * H.z * H.z;
  float clear = 0.25 * coat * mix(0.04, 1.0, fh) * (g2 - 1.0) / (PI * log(g2) * t) * masked(L.z, 0.25) * masked(V.z, 0.25);
  vec3 matt = base / PI * mix(mix(diffuse, flat_part, under), flat_part, flatness) + fh * sheen * mix(vec3(1.0), tint, sheen_tint);
  return matt * (1.0 - metallic) + lobe * mix(f0, vec3(1.0), fh) + clear * mix(vec3(1.0), tint, coat_tint);
}
"""
COOK_FIT = "--form cook_torrance --fix f0=0.04"
COOK = "--form cook_torrance --set kd=0.3,0.2,0.1 --set ks=0.4 --set f0=0.04"
STACK = "64x64"
TEXELS = 64 * 64
BATCHES = {}  # the output of bench_eval, by build


class Place:
    """A folder in which the commands of both builds run."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def copy(self, path):
        shutil.copy(ROOT / path, self.folder)

    def prepare(self, build, command):
        subprocess.run(f"{build}/brdf {command}", shell=True, cwd=self.folder, check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)

    def run(self, build, command):
        """Returns the output, and seconds by the clock, seconds of the processors, and the largest resident size in MB."""
        begin = time.monotonic()
        process = subprocess.Popen(f"exec {build}/{command}", shell=True, cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.DEVNULL, text=True)
        out = process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode not in (0, 1, 4):
            raise SystemExit(f"{command}: exit code {process.returncode}")
        return out, time.monotonic() - begin, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def clock(command):
    return lambda place, build: place.run(build, command)[1]


def resumed(place, build):
    """Resumes a study of 20,000 tables of which 100 or a few more are done. Returns the seconds until its first new table, and the seconds
    from Ctrl-C, which follows at once, to its end."""
    done = place.folder / f"done_{abs(hash(build))}"
    if not done.exists():
        (place.folder / "few").mkdir(exist_ok=True)
        for k in range(100):
            shutil.copy(place.folder / f"many/t{k:05d}.csv", place.folder / "few")
        place.prepare(build, f"study few --form lambert --no-pictures -o {done}")
    before, begin = len(os.listdir(done)), time.monotonic()
    process = subprocess.Popen([f"{build}/brdf", "study", "many", "--form", "lambert", "--no-pictures", "-o", done], cwd=place.folder,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while len(os.listdir(done)) == before:
        if process.poll() is not None:
            raise SystemExit(f"study: exit code {process.returncode} without a new table")
        time.sleep(0.01)
    first = time.monotonic()
    process.send_signal(signal.SIGINT)
    process.wait()
    return first - begin, time.monotonic() - first


def many_tables(place, _):
    (place.folder / "many").mkdir()
    for k in range(20000):
        rows = "".join(f"{i},0,{o},180,{0.1 + k * 1e-6:.6f}\n" for i in (10, 40) for o in (0, 20, 40, 60))
        place.write(f"many/t{k:05d}.csv", "theta_i,phi_i,theta_o,phi_o,r\n" + rows)


def shader_table(place, build):
    place.write("own.glsl", OWN_SHADER)
    place.prepare(build, "synth --shader own.glsl --set alpha=0.25 --set f0=0.1 --theta-i 0,20,40,60,75 --step 3.2 --noise 0.01 --seed 3 "
                         "-o own.csv")


def fits_of_forms(place, build):
    """How many fits of the built-in form one fit of the shader takes, both of the same table."""
    own = place.run(build, "brdf fit own.csv --shader own.glsl --jobs 1 -o own.json")[2]
    return own / place.run(build, "brdf fit own.csv --form cook_torrance --jobs 1 -o form.json")[2]


def texel(words):
    def measure(place, build):
        whole = place.run(build, f"brdf fit stack {COOK_FIT} {words} --jobs 1 -o maps_{len(words)}")[2]
        return (whole - place.run(build, "brdf --version")[2]) / TEXELS * 1e6
    return measure


def stack(place, build):
    if not (place.folder / "stack").exists():
        place.prepare(build, f"synth {COOK} --texels {STACK} --lights 151 --vary alpha=0.08:0.5 --noise 0.03 --seed 1 -o stack")


def solver(place, build):
    out = place.run(build, "bench/bench_fit --no-python --repeats 5")[0]
    return float(re.search(r"^variable projection \(cosine_l2\) +([\d.]+)", out, re.M).group(1))


def share(form, column):
    """The share of the limit of a form's batch, from the row of bench_eval; `column` counts the types: double, float."""
    def measure(place, build):
        if build not in BATCHES:
            BATCHES[build] = place.run(build, "bench/bench_eval")[0]
        return int(re.findall(rf"^{form} .*?(\d+) %", BATCHES[build], re.M)[column]) / 100
    return measure


PLACES = {  # name: (description, unit, then or None, goal, whether less is better, preparation, measurement)
    "resume": ("first new table of a `study` of 20,000 tables of which 100 are done", "s", None, 2, True, many_tables,
               lambda place, build: resumed(place, build)[0]),
    "interrupt": ("end of this study after Ctrl-C", "s", None, 1, True, many_tables, lambda place, build: resumed(place, build)[1]),
    "fit-shader": ("`fit --shader`, 6 parameters, in fits of a built-in form", "", 250, 10, True, shader_table, fits_of_forms),
    "validate-shader": ("`validate --shader` of 16 parameters, `--effort quick`", "s", 67, 20, True,
                        lambda place, _: place.write("principled.glsl", PRINCIPLED),
                        clock("brdf validate --shader principled.glsl --effort quick")),
    "solver": ("solver on 1.458 million RGB rows", "s of processor", 0.114, 0.05, True, None, solver),
    "texel-given": ("a texel of 151 RGB rows, normals given", "us", 135, 50, True, stack, texel("")),
    "texel-fitted": ("a texel of 151 RGB rows, normals fitted", "us", 379, 150, True, stack, texel("--normals fit")),
    "validate-all": ("`validate --all --effort full`", "s", 25, 12, True, None, clock("brdf validate --all --effort full")),
    "render": ("`render` of a material, 512 x 512, studio", "s", 3.9, 1.5, True,
               lambda place, _: place.copy("data/materials/satin.json"),
               clock("brdf render satin.json --width 512 --height 512 --environment studio -o sphere.png")),
    "synth-texels": ("`synth --texels 2048x2048`, resident", "MB", None, 200, True, None,
                     lambda place, build: place.run(build, f"brdf synth {COOK} --texels 2048x2048 --lights 2 -o big")[3]),
    "version": ("`brdf --version`", "ms", 20, 8, True, None, lambda place, build: 1e3 * place.run(build, "brdf --version")[1]),
    **{f"batch-{form}-{kind}": (f"batch of {form} in {kind}, share of the limit", "", then, goal, False, None, share(form, column))
       for form, kind, column, then, goal in (("cook_torrance", "double", 0, 0.95, 0.95), ("cook_torrance", "float", 1, 0.82, 0.9),
                                              *((form, kind, k, None, 0.6) for form in ("ward", "phong", "cook_torrance_beckmann",
                                                                                        "cook_torrance_student")
                                                for k, kind in enumerate(("double", "float"))))},
}


def machine():
    model = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")).group(1)
    return f"{model}, {os.cpu_count()} processors, load {os.getloadavg()[0]:.2f}"


def measured(name, builds, rounds):
    """Returns the best of the rounds for each build. The builds take turns."""
    *_, less, preparation, measurement = PLACES[name]
    with tempfile.TemporaryDirectory() as folder:
        place = Place(folder)
        if preparation:
            preparation(place, builds[0])
        rows = [[measurement(place, build) for build in builds] for _ in range(rounds)]
    return [min(column) if less else max(column) for column in zip(*rows)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("places", nargs="*", metavar="PLACE", help="default: every place: " + ", ".join(PLACES))
    parser.add_argument("--before", type=pathlib.Path, metavar="BUILD")
    parser.add_argument("--rounds", type=int, default=3)
    asked = parser.parse_intermixed_args()
    if unknown := set(asked.places) - set(PLACES):
        parser.error(f"no such place: {', '.join(sorted(unknown))}; places: {', '.join(PLACES)}")
    builds = [build.resolve() for build in (asked.build, asked.before) if build]
    print(f"{machine()}; best of {asked.rounds} rounds\n")
    print("| place | before | now | now / before | then | goal | goal / then | |\n|---|---|---|---|---|---|---|---|")
    for name in asked.places or PLACES:
        description, unit, then, goal, less, _, _ = PLACES[name]
        now, *before = measured(name, builds, asked.rounds)
        met = "" if (now <= goal if less else now >= goal) else "missed"
        old, ratio = (f"{before[0]:.3g}", f"{now / before[0]:.2f}") if before else ("", "")
        first, wanted = (f"{then:g}", f"{goal / then:.2f}") if then else ("", "")
        print(f"| {description}{', ' + unit if unit else ''} | {old} | {now:.3g} | {ratio} | {first} | {goal:g} | {wanted} | {met} |",
              flush=True)


if __name__ == "__main__":
    main()
