#!/usr/bin/env python3
# ctest: cli.sampler_seeds_coloured label=slow timeout=5400 needs=plain @brdf@ --seeds 50 --faulty 0 @source@/tests/cli/samplers/coloured.glsl
# ctest: cli.sampler_seeds_lobes label=slow timeout=5400 needs=plain @brdf@ @source@/tests/cli/samplers/three_lobes.glsl @source@/tests/cli/samplers/uniform.glsl
# ctest: cli.sampler_seeds_normals label=slow timeout=5400 needs=plain @brdf@ @source@/tests/cli/samplers/visible_normals.hlsl
# ctest: cli.sampler_seeds_others label=slow timeout=5400 needs=plain @brdf@ @source@/data/shaders/half_density.glsl=REPAIRED @source@/tests/cli/samplers/rejection.glsl
"""Right samplers cause no false alarm over many seeds, and densities that are 1 % wrong in a quarter of the hemisphere are found.

    seeds_test.py BRDF [--seeds 200] [--faulty 20] [--minutes M] FILE[=MACRO]...

The shader of each FILE has a right sampler, and its density function is brdfPdf(L, ...). `brdf validate` judges the file with the
seeds 1 to --seeds: no check of the sampler may fail, and the probabilities and standard errors of the statistical tests must be as
rare as their levels state (LEVEL). The checks that are decided for the seed 1 must be decided for 9 of 10 seeds.

Then the density function is made wrong by 1 % in a quarter of the azimuths, also with the opposite quarter wrong by -1 %, so that
the integral remains. At least 19 of 20 seeds must find each of the two, in at most 10 s of processor time. A file for which `jacobian` is
undecided has no exact test of its density, and is judged with the first fault alone.

coloured.glsl has fewer seeds and no wrong densities, because the other checks take most of its time: sampled_shaders_test.cpp
gives this shader many faults. --minutes ends the first part for each file earlier. Exit code 77: this program has no compiler of shaders.
"""
import argparse
import collections
import json
import math
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time

CHECKS = ("density_mass", "density_match", "sample_value", "jacobian", "sample_distribution", "sample_mean", "density_support",
          "sample_range", "sample_float")
CASES, CHANNELS = 6, 3
LEVEL = 1e-3  # probability at which the tests are counted
RARE = 1e-6  # probability with which such a count may be above its limit
# The value of a check that corresponds to LEVEL, and the number of tests in a run.
COUNTED = {"sample_distribution": (-math.log10(LEVEL), 2 * CASES), "sample_mean": (3.2905, CHANNELS * CASES)}
MOST_SECONDS = 10  # of processor time, for a run that finds a fault
FOUND = 0.95  # the share of runs that must find a fault
FAULTS = {"1 % in a quarter": "(L.x > 0.0 && L.y > 0.0 ? 1.01 : 1.0)",
          "1 % in opposite quarters": "(L.x * L.y > 0.0 ? (L.x > 0.0 ? 1.01 : 0.99) : 1.0)"}


def judged(brdf, shader, seed):
    """Returns {check: finding} of the sampler's checks, and the seconds of processor time."""
    file, _, macro = shader.partition("=")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([brdf, "validate", "--shader", file, *(["--define", macro] if macro else []), "--seed", str(seed), "--json",
                           "--quiet"], capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode not in (0, 1):
        if "no shader compiler" in done.stderr:
            sys.exit(77)
        sys.exit(f"{file}: {done.stderr}")
    findings = {f["check"]: f for f in json.loads(done.stdout)["findings"] if f["check"] in CHECKS}
    if len(findings) != len(CHECKS):
        sys.exit(f"{file}: the sampler is not judged")
    return findings, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def most_often(runs, probability):
    """Returns the largest count of `runs` whose probability, or that of a larger count, is above RARE."""
    tail, count = 1.0, 0
    term = (1 - probability) ** runs
    while tail - term > RARE:
        tail -= term
        count += 1
        term *= (runs - count + 1) / count * probability / (1 - probability)
    return count


def right(brdf, shader, seeds, minutes):
    """Judges a right sampler with many seeds. Returns the sentences on faults of the judge."""
    faults, undecided, above, largest, seconds, runs = [], collections.Counter(), collections.Counter(), collections.Counter(), [], 0
    begin, decided = time.monotonic(), set()
    for seed in range(1, seeds + 1):
        if time.monotonic() - begin > 60 * minutes:
            break
        findings, time_used = judged(brdf, shader, seed)
        runs += 1
        seconds.append(time_used)
        for check, finding in findings.items():
            if finding["verdict"] == "fail":
                faults.append(f"seed {seed}: {check}: {finding['statement']}")
            if finding["verdict"] == "undecided":
                undecided[check] += 1
            elif seed == 1:
                decided.add(check)
        for check, (value, _) in COUNTED.items():
            above[check] += findings[check]["value"] > value
            largest[check] = max(largest[check], findings[check]["value"])
    for check, (_, tests) in COUNTED.items():
        most = most_often(runs, tests * LEVEL)
        if above[check] > most:
            faults.append(f"{check}: {above[check]} of {runs} runs have a test beyond its quantile for {LEVEL}; at most {most} are likely")
    faults += [f"{check}: undecided in {undecided[check]} of {runs} runs" for check in decided if undecided[check] > 0.1 * runs]
    print(f"  {runs} seeds, {sum(seconds) / runs:.1f} s of processor time each, at most {max(seconds):.1f} s; "
          f"undecided: {dict(undecided) or 'no check'}; least probability of a histogram 1e-{largest['sample_distribution']:.1f}, "
          f"largest deviation of a mean {largest['sample_mean']:.1f} standard errors; beyond {LEVEL}: {dict(above)}", flush=True)
    return runs, faults


def with_fault(text, factor):
    """Returns the shader with a density function that returns `factor` times the right density."""
    head = re.search(r"^float brdfPdf\(([^)]*)\)\s*\{", text, re.M)
    if head is None:
        sys.exit("the file has no function float brdfPdf(...)")
    end, depth = head.end(), 1
    while depth > 0:
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        end += 1
    names = ", ".join(argument.split()[-1] for argument in head[1].split(","))
    wrong = f"\nfloat brdfPdf({head[1]}) {{ return rightPdf({names}) * {factor}; }}\n"
    return text[:head.start()] + text[head.start():end].replace("brdfPdf", "rightPdf", 1) + wrong + text[end:]


def wrong(brdf, shader, seeds):
    """Judges the sampler with wrong densities. Returns the sentences on faults that are not found."""
    file, sign, macro = shader.partition("=")
    exact = judged(brdf, shader, 1)[0]["jacobian"]["verdict"] == "pass"
    faults = []
    for name, factor in list(FAULTS.items())[: None if exact else 1]:
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder, pathlib.Path(file).name)
            copy.write_text(with_fault(pathlib.Path(file).read_text(), factor))
            runs = [judged(brdf, f"{copy}{sign}{macro}", seed) for seed in range(1, seeds + 1)]
        by = collections.Counter(check for findings, _ in runs for check in CHECKS if findings[check]["verdict"] == "fail")
        found = sum(any(f["verdict"] == "fail" for f in findings.values()) for findings, _ in runs)
        slowest = max(seconds for _, seconds in runs)
        print(f"  {name}: found in {found} of {seeds} runs, at most {slowest:.1f} s of processor time; by {dict(by)}", flush=True)
        if found < FOUND * seeds:
            faults.append(f"{name}: found in {found} of {seeds} runs only")
        if slowest > MOST_SECONDS:
            faults.append(f"{name}: a run took {slowest:.1f} s of processor time, more than {MOST_SECONDS} s")
    return faults


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("brdf")
    parser.add_argument("shaders", nargs="+")
    parser.add_argument("--seeds", type=int, default=200)
    parser.add_argument("--faulty", type=int, default=20)
    parser.add_argument("--minutes", type=float, default=math.inf)
    options = parser.parse_args()
    runs, faults = 0, []
    for shader in options.shaders:
        print(f"{pathlib.Path(shader).name}:", flush=True)
        own, found = right(options.brdf, shader, options.seeds, options.minutes)
        runs += own
        if options.faulty:
            found += wrong(options.brdf, shader, options.faulty)
        faults += [f"{shader}: {fault}" for fault in found]
    print(f"{runs} runs of right samplers: a false alarm in each run has a probability below {3 / runs:.2g} with 95 % confidence"
          if not faults else "\n".join(faults))
    sys.exit(bool(faults))


main()
