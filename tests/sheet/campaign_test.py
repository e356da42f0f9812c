# ctest: sheet.campaign label=sheet @brdf@
"""Plants every fault of faults.py in every table that can show the fault: campaign_test.py EXECUTABLE.

`brdf validate` must name a planted fault in the right words, or report it as suspected. A clean table must have no failing check. ./test
uses four tables, ./test --full (BRDF_THOROUGH) all tables, including the measured tables of BRDF_DATA_DIR. Prints a table of the results.
"""
import concurrent.futures
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

from faults import FAULTS, Facts, Table

EXECUTABLE = sys.argv[1]
THOROUGH = "BRDF_THOROUGH" in os.environ
SEED = 20
# A sheet that misses more than this is no help, one that cries wolf more often than this is not read.
LEAST_FOUND, LEAST_OF_ONE, MOST_ALARMS = 0.8, 0.5, 1 / 20


def between(rng, low, high):
    return round(low * (high / low) ** rng.random(), 3)


def one_or_three(rng, low, high):
    return ",".join(str(between(rng, low, high)) for _ in range(rng.choice((1, 3))))


# All families, each with parameters that a sample may have.
FORMS = {
    "lambert": lambda r: {"rho": one_or_three(r, 0.1, 0.95)},
    "oren_nayar": lambda r: {"rho": one_or_three(r, 0.1, 0.95), "sigma": between(r, 0.1, 0.8)},
    "phong": lambda r: {"kd": one_or_three(r, 0.03, 0.5), "ks": between(r, 0.1, 0.5), "exponent": between(r, 8, 200)},
    "blinn_phong": lambda r: {"kd": between(r, 0.03, 0.5), "ks": between(r, 0.1, 0.5), "exponent": between(r, 10, 400)},
    "ward": lambda r: {"kd": one_or_three(r, 0.03, 0.5), "ks": between(r, 0.1, 0.4), "alpha": between(r, 0.08, 0.35)},
    "ward_bounded": lambda r: {"kd": between(r, 0.1, 0.4), "ks": between(r, 0.1, 0.4), "alpha_x": between(r, 0.08, 0.2),
                               "alpha_y": between(r, 0.2, 0.4)},
    "cook_torrance": lambda r: {"kd": one_or_three(r, 0.03, 0.6), "ks": 0.4, "f0": r.choice((0.04, 0.5)),
                                "alpha": between(r, 0.08, 0.5)},
    "cook_torrance_beckmann": lambda r: {"kd": between(r, 0.03, 0.5), "ks": 0.5, "f0": 0.05, "alpha": between(r, 0.1, 0.5)},
    "cook_torrance_dielectric": lambda r: {"kd": one_or_three(r, 0.1, 0.8), "ks": 0.2, "eta": 1.5, "alpha": between(r, 0.1, 0.4)},
    "cook_torrance_conductor": lambda r: {"kd": 0, "ks": 0.9, "n": 1.2, "k": 4, "alpha": between(r, 0.1, 0.4)},
    "oren_nayar_energy": lambda r: {"rho": between(r, 0.2, 0.95), "roughness": between(r, 0.1, 1)},
}
GRIDS = (("--step", "5", "--theta-i", "0,15,30,45,60,75"), ("--step", "10", "--theta-i", "10,30,50,70"),
         ("--grid", "in_plane", "--step", "2", "--theta-i", "10,20,30,40,50,60,70"), ("--step", "7.5", "--theta-i", "15,30,45,60,75"))
NOISES = (0, 0.005, 0.01, 0.02, 0.05)


def synthetic(folder):
    rng = random.Random(SEED)
    paths = []
    # Each form meets each grid, once: 44 tables; else one table of each grid.
    cases = [(form, grid) for shift in range(len(GRIDS)) for grid, form in
             ((k % len(GRIDS), f) for k, f in enumerate(FORMS, shift))]
    for k, (form, grid) in enumerate(cases if THOROUGH else [("cook_torrance", 0), ("ward", 1), ("phong", 2), ("lambert", 3)]):
        noise = NOISES[rng.randrange(len(NOISES))] if THOROUGH else 0.02
        path = folder / f"{k:02d}_{form}_{grid}.csv"
        words = [word for name, value in FORMS[form](rng).items() for word in ("--set", f"{name}={value}")]
        subprocess.run([EXECUTABLE, "synth", "--form", form, *words, *GRIDS[grid], "--noise", str(noise), "--seed", str(SEED + k),
                        "-o", str(path)], check=True, capture_output=True)
        paths.append(path)
    return paths


def measured(folder):
    data = os.environ.get("BRDF_DATA_DIR")
    if not (THOROUGH and data):
        print("measured tables are left out: BRDF_DATA_DIR" + ("" if data else " is unset") + (" and BRDF_THOROUGH" if not THOROUGH else ""))
        return []
    paths = []
    for source in sorted([*pathlib.Path(data).glob("measured/*"), *pathlib.Path(data).glob("formats/*")]):
        path = folder / f"{source.name}.csv"
        if subprocess.run([EXECUTABLE, "convert", str(source), str(path)], capture_output=True, check=False).returncode == 0:
            paths.append(path)
    return paths


def sheet_of(path):
    run = subprocess.run([EXECUTABLE, "validate", str(path), "--json"], capture_output=True, text=True, check=False)
    if not run.stdout:
        return {"refused": ("fail", run.stderr)}
    findings = json.loads(run.stdout)["findings"]
    failed = any(f["verdict"] == "fail" for f in findings)
    assert run.returncode == (1 if failed else 0), (path, run.returncode, run.stderr)
    return {f["check"]: (f["verdict"], f["statement"]) for f in findings}


def try_table(path):
    """Returns {fault: "found", "missed" or "untold"}, and the false alarms of the clean table."""
    facts = Facts(Table.read(path))
    clean = sheet_of(path)
    alarms = [f"{check}: {statement}" for check, (verdict, statement) in clean.items() if verdict == "fail"]
    marks = {}
    for name, fault in FAULTS.items():
        if not fault.told(facts):
            marks[name] = "untold"
            continue
        spoiled = path.with_name(f"{path.stem}__{name}.csv")
        facts.table.write(spoiled, fault.plant(facts))
        found = any(verdict in ("fail", "undecided") and fault.words.search(statement) and
                    not (clean.get(check, ("", ""))[0] == verdict and fault.words.search(clean[check][1]))
                    for check, (verdict, statement) in sheet_of(spoiled).items())
        marks[name] = "found" if found else "missed"
        spoiled.unlink()
    return marks, alarms


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        paths = synthetic(folder) + measured(folder)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
            tried = list(pool.map(try_table, paths))
    found = told = 0
    poor = []
    print(f"seed {SEED}, {len(paths)} tables: + found, . missed, - cannot be told")
    for name in FAULTS:
        marks = [marks[name] for marks, _ in tried]
        hits, all_told = marks.count("found"), len(marks) - marks.count("untold")
        found, told = found + hits, told + all_told
        print(f"{name:20s} {''.join({'found': '+', 'missed': '.', 'untold': '-'}[m] for m in marks)}  {hits} of {all_told}")
        if all_told and hits < LEAST_OF_ONE * all_told:
            poor.append(name)
    alarmed = [(path.name, alarms) for path, (_, alarms) in zip(paths, tried) if alarms]
    for name, alarms in alarmed:
        print(f"alarm on the clean table {name}: {'; '.join(alarms)}")
    print(f"found {found} of {told} ({100 * found / told:.1f} %); {len(alarmed)} of {len(paths)} clean tables with an alarm")
    assert found >= LEAST_FOUND * told
    assert not poor, f"found in less than half of the tables: {poor}"
    assert len(alarmed) <= MOST_ALARMS * len(paths), alarmed


main()
