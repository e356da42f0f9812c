#!/usr/bin/env python3
# ctest: browser.same_numbers label=wasm timeout=3600 @brdf@ @source@/build/wasm/browser
"""Fits tables with the page's module under node and with the program, and compares: equal verdicts, parameters within 1e-9,
intervals within 1e-6, equal sentences for broken files. The commands that the page prints for a material give its values. The
tables are data/synthetic, examples that ship, and the measured ones of BRDF_DATA_DIR. Prints the size of the site, the largest
differences, the ratio of processor times and the memory.

same_numbers_test.py BRDF MODULE_FOLDER
"""
import gzip
import json
import os
import pathlib
import resource
import shlex
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PARAMETERS, INTERVALS, ALBEDO = 1e-9, 1e-6, 1e-5
MOST_LOADED = 1_400_000  # bytes of the site, compressed by gzip; it has 1,358,171
BROKEN = {"empty.csv": b"", "picture.csv": b"\x89PNG\r\n\x1a\n" + bytes(40), "words.csv": b"hello, this is no table\n",
          "half.csv": b"theta_i,phi_i,theta_o,phi_o,fr\n10,0,20\n", "exr.csv": b"\x76\x2f\x31\x01" + bytes(60)}


def of_the_page(folder, form, tables):
    told = subprocess.run(["node", HERE / "study.js", folder, form, *tables], capture_output=True, text=True, check=False)
    assert told.returncode == 0, told.stderr
    return [json.loads(line) for line in told.stdout.splitlines()]


def of_the_program(brdf, form, table, work):
    """Returns (row or None, message, seconds of processor time)."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    told = subprocess.run([brdf, "study", table, "--form", form, "-o", work / "out", "--json"], capture_output=True, text=True,
                          cwd=work, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    shutil.rmtree(work / "out", ignore_errors=True)
    row = json.loads(told.stdout)["results"][0] if told.stdout else None
    return row, told.stderr, seconds


def difference(ours, theirs, scale):
    if ours is None or theirs is None:
        return 0.0 if ours is theirs else float("inf")
    return abs(ours - theirs) / max(abs(scale), 1e-300) if ours != theirs else 0.0


def compare(page, first, row):
    """Returns the faults of a table, and the largest differences of parameters and of intervals."""
    faults = [f"{key}: {page[key]!r} for {row[key]!r}" for key in ("form", "verdict", "statement", "usable", "sheet", "properties")
              if page[key] != row[key]]
    if (first or {}).get("statement") != page["statement"]:
        faults.append(f"the first result is {first!r}, the last one {page['statement']!r}")
    names = [(e["name"], e["channel"]) for e in row["estimates"]]
    if names != [(e["name"], e["channel"]) for e in page["estimates"]]:
        return faults + ["other parameters are determined"], 0.0, 0.0
    parameters = intervals = 0.0
    for ours, theirs in zip(page["estimates"], row["estimates"]):
        scale = theirs["value"] or 1.0
        parameters = max(parameters, difference(ours["value"], theirs["value"], scale))
        intervals = max(intervals, *(difference(ours[end], theirs[end], scale) for end in ("low", "high")))
    if parameters > PARAMETERS:
        faults.append(f"a parameter differs by {parameters:.1e}")
    if intervals > INTERVALS:
        faults.append(f"an interval differs by {intervals:.1e}")
    return faults, parameters, intervals


def answer_to(folder, request):
    told = subprocess.run(["node", HERE / "study.js", folder, "--request", json.dumps(request)], capture_output=True, text=True, check=True)
    return json.loads(told.stdout)


def faults_of_commands(brdf, folder, work):
    """Runs the commands that the page prints for a material of one and of three channels, and for a material as JSON."""
    material = json.loads((ROOT / "data/materials/gold.json").read_text())
    (work / "material.json").write_text(json.dumps(material))
    requests = [{"form": "ward", "parameters": {"kd": [0.2], "ks": [0.3], "alpha_x": [0.1], "alpha_y": [0.25]}},
                {"form": "oren_nayar", "parameters": {"rho": [0.2, 0.4, 0.6], "sigma": [0.5]}}, {"material": material}]
    for request in requests:
        page = answer_to(folder, {"do": "material", **request})
        told = subprocess.run([brdf, *shlex.split(page["command"])[1:], "--json"], capture_output=True, text=True, cwd=work, check=False)
        if told.returncode:
            yield f"`{page['command']}` ends with {told.returncode}: {told.stderr.strip()}"
            continue
        values = [value for row in zip(*page["albedo"]) for value in row]  # by angle, then by channel; null: not converged
        if values.count(None) > len(values) // 4:
            yield f"`{page['command']}`: {values.count(None)} of {len(values)} albedos of the page did not converge"
        rows = json.loads(told.stdout)["results"]
        if len(rows) != len(values) or any(
                value is not None and abs(row["value"] - value) > ALBEDO for row, value in zip(rows, values)):
            yield f"`{page['command']}` has other albedos than the page"
        exported = answer_to(folder, {"do": "export", **request})
        told = subprocess.run([brdf, *shlex.split(exported["command"])[1:]], capture_output=True, text=True, cwd=work, check=False)
        # A refit may end elsewhere on another machine, so the sentences on the loss are not compared.
        if told.returncode or exported.get("error"):
            yield f"`{exported['command']}` ends with {told.returncode}: {told.stderr.strip()}"


def faults_of_study_commands(brdf, folder, work):
    """Runs the commands that the page prints for studies of a table whose name is no plain word: they have the page's result. A
    study of a fit that is not usable ends with 1."""
    table = work / "-it's a table.csv"
    shutil.copy(ROOT / "data/synthetic/phong_sparse.csv", table)
    for form in ("all", "auto", "phong,ward", "oren_nayar+ward"):
        [page] = of_the_page(folder, form, [table])
        told = subprocess.run([brdf, *shlex.split(page["command"])[1:], "--json"], capture_output=True, text=True, cwd=work, check=False)
        if told.returncode not in (0, 1) or json.loads(told.stdout)["results"][0]["statement"] != page["row"]["statement"]:
            yield f"`{page['command']}` ends with {told.returncode} and another result than the page: {told.stderr.strip()}"
        shutil.rmtree(work / "studied", ignore_errors=True)


def loaded(site):
    """Returns the bytes of the site without its examples, compressed by gzip."""
    return sum(len(gzip.compress(file.read_bytes(), 9)) for file in site.iterdir() if file.suffix != ".csv")


def main():
    brdf, folder = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    if not (folder / "brdf.js").is_file():
        print(f"{folder}/brdf.js is missing: cmake --preset wasm && cmake --build build/wasm")
        return 77
    tables = sorted((ROOT / "data/synthetic").glob("*.csv"))
    if data := os.environ.get("BRDF_DATA_DIR"):
        tables += sorted(pathlib.Path(data, "measured").glob("*.csv"))
    else:
        print("BRDF_DATA_DIR is unset: measured tables are left out")
    faults, page_time, program_time, largest, worst, worst_interval = [], 0.0, 0.0, 0, 0.0, 0.0
    with tempfile.TemporaryDirectory() as temporary:
        work = pathlib.Path(temporary)
        for told, table in zip(of_the_page(folder, "all", tables), tables):
            row, message, seconds = of_the_program(brdf, "all", table, work)
            found, parameters, intervals = compare(told["row"], told.get("first"), row) if told.get("row") and row else \
                ([f"the page: {told.get('error')}; the program: {message}"], 0.0, 0.0)
            faults += [f"{table.name}: {fault}" for fault in found]
            page_time, program_time = page_time + told["milliseconds"] / 1000, program_time + seconds
            if table.name == "ward.csv" and told.get("first"):
                print(f"{table.name}: the first result needs {told['first']['milliseconds'] / 1000:.1f} s of processor time, the report "
                      f"{told['milliseconds'] / 1000:.1f} s")
            largest, worst, worst_interval = max(largest, told["heap"]), max(worst, parameters), max(worst_interval, intervals)
        faults += [*faults_of_commands(brdf, folder, work), *faults_of_study_commands(brdf, folder, work)]
        for name, content in BROKEN.items():
            (work / name).write_bytes(content)
        for told in of_the_page(folder, "all", [work / name for name in BROKEN]):
            table = pathlib.Path(told["table"])
            _, message, _ = of_the_program(brdf, "all", table, work)
            if not told.get("error"):
                faults.append(f"{table.name}: the page does not refuse it")
            elif table.name != "exr.csv" and told["error"].removeprefix(f"{table.name}: ") not in message:
                faults.append(f"{table.name}: the page says '{told['error']}', the program '{message.strip()}'")
    if (size := loaded(folder / "site")) > MOST_LOADED:
        faults.append(f"the site has {size} bytes, compressed by gzip: more than {MOST_LOADED}")
    print(f"the site has {size} bytes, compressed by gzip")
    print(f"{len(tables)} tables: parameters differ by at most {worst:.1e}, intervals by {worst_interval:.1e}; processor time of "
          f"the page {page_time:.1f} s, of the program {program_time:.1f} s, ratio {page_time / program_time:.2f}; "
          f"memory of the page at most {largest / 2**20:.0f} MiB")
    print("\n".join(faults) or "every verdict and every sentence is equal")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
