#!/usr/bin/env python3
# ctest: scale.jobs label=maps,driver timeout=300 needs=plain @brdf@
"""jobs_test.py BRDF: tests plan, work and collect. The bytes must be equal to the bytes of the verb alone, for any units in any
order. Finished units are not done again, damaged units are, and a folder without a plan of this work is refused."""
import json
import random
import shutil
import sys
import tempfile
import time

from jobs import Place, damage

with tempfile.TemporaryDirectory() as name:
    place = Place(sys.argv[1], name)
    run, refused = place.run, place.refused

    # A stack, in 32 units.
    place.make_stack("64x64")
    fit = "fit stack --form cook_torrance --normals stack/truth/truth.exr "
    run(fit + "-o at_once --jobs 2 --report at_once.html")
    plan = f"plan {fit}--unit-size 16x8 -o job"
    assert run(plan).stdout == "32 units: 0-31\n"
    first = (place.folder / "job/plan.json").read_bytes()
    run(plan)
    assert (place.folder / "job/plan.json").read_bytes() == first
    run(plan.replace("-o job", "-o another"))
    assert (place.folder / "another/plan.json").read_bytes() == first, "a plan is decided by what is asked for"
    refused(plan.replace("16x8", "8x8"), "job: contains a plan")
    refused(plan + " --max-theta 70", "job: contains a plan")
    refused(plan.replace("16x8", "12x8"), "--unit-size 12x8: must be WIDTHxHEIGHT for a stack, both multiples of 8")
    assert run("collect job --missing", 1).stdout == "0-31\n"
    order = list(range(32))
    random.Random(1).shuffle(order)
    elsewhere = place.folder / "elsewhere"
    elsewhere.mkdir()
    for unit in order[:3]:
        Place(sys.argv[1], elsewhere).run(f"work ../job --unit {unit}")
    for unit in order[3:28]:
        run(f"work job --unit {unit}")
    left = sorted(order[28:])
    said = run("collect job -o maps --missing", 1).stdout
    expanded = [k for part in said.strip().split(",") for a, _, b in [part.partition("-")] for k in range(int(a), int(b or a) + 1)]
    assert expanded == left, (said, left)
    states = json.loads(run("collect job --json", 1).stdout)
    assert [r["unit"] for r in states["results"] if r["state"] == "missing"] == left
    assert "4 of 32 units are missing or damaged" in run("collect job -o maps", 1).stderr
    assert not (place.folder / "maps").exists()
    run("work job")
    run("collect job -o maps --report maps.html")
    place.same("at_once", "maps")
    assert (place.folder / "maps.html").read_bytes() == (place.folder / "at_once.html").read_bytes()

    # Done is done.
    before = place.units("job")
    begin = time.monotonic()
    run("work job")
    assert time.monotonic() - begin < 1 and place.units("job") == before
    before[17][0].unlink()
    damage(before[22][0])
    assert run("collect job --missing", 1).stdout == "17,22\n"
    states = {r["unit"]: r["state"] for r in json.loads(run("collect job --json", 1).stdout)["results"]}
    assert states[17] == "missing" and states[22] == "damaged" and states[21] == "done"
    run("work job")
    after = place.units("job")
    assert {k for k in before if before[k] != after[k]} == {17, 22}
    assert run("collect job --missing").stdout == ""
    run("collect job -o again")
    place.same("at_once", "again")

    # Another plan's unit, and a job that was tampered with.
    shutil.copy(after[3][0], after[4][0])
    assert run("collect job --missing", 1).stdout == "4\n"
    (place.folder / "job/plan.json").write_bytes(first.replace(b'"form"', b'"from"').replace(b"8,", b"16,", 1))
    refused("work job", "plan.json: the plan was changed after it was made")
    refused("work stack", "stack: is not a job")
    refused("work another --unit 32", "--unit 32: the units are 0 to 31")
    lights = place.folder / "stack/lights.csv"
    text = lights.read_text()
    lights.write_text(text + "# more\n")
    refused("work another --unit 0", "stack/lights.csv: has changed since the work was planned")
    lights.write_text(text.replace("theta_i", "theta_j"))
    refused("work another --unit 0 --check-inputs", "lights.csv: has changed")
    lights.write_text(text)

    # Wide units, the metric chosen in the plan, normals fitted.
    place.make_stack("24x20", 30, "small")
    auto = "fit small --form ward --normals fit "
    run(auto + "-o small_at_once")
    run(f"plan {auto}--unit-size 24x8 -o small_job")
    run("work small_job --memory-limit 100K")
    run("collect small_job -o small_maps")
    place.same("small_at_once", "small_maps")

    # Tables: one of them bad.
    place.make_tables(7, broken=4)
    for verb, options, code in (("fit", "--form ward --no-pictures", 1), ("study", "--form ward --no-pictures", 1)):
        run(f"{verb} measurements {options} -o {verb}_at_once", code)
        assert run(f"plan {verb} measurements {options} --unit-size 2 -o {verb}_job").stdout == "4 units: 0-3\n"
        for unit in (3, 0, 2, 1):
            run(f"work {verb}_job --unit {unit}")
        done = run(f"collect {verb}_job -o {verb}_out", code)
        assert done.stderr.count("paint_0004.csv") == 1, done.stderr
        place.same(f"{verb}_at_once", f"{verb}_out")
        assert not list((place.folder / f"{verb}_job").glob("brdf_*"))
    table = (place.folder / "fit_out/summary.csv").read_text().splitlines()
    assert len(table) == 8 and sum(",error," in row for row in table) == 1, table
    refused("plan study measurements/paint_0000.csv --form ward -o one", "a single table cannot be divided")
    refused("plan fit measurements/paint_0000.csv --form auto -o one", "--form auto: chooses by consecutive fits")
    refused("plan study measurements --form ward --bootstrap 9 -o one", "--bootstrap: has no effect on study")
    refused("plan fit stack --form ward --bootstrap 9 -o one", "--bootstrap: not for stacks")
    refused("plan fit measurements --form warp -o one", "warp")
    refused("plan fit measurements --form ward --normals fit -o one", "--normals applies to a stack")
    refused("plan fit stack --form ward --no-pictures -o one", "--no-pictures applies to tables, not to a stack")
    refused("plan fit measurements --form ward --unit-size 8x8 -o one", "--unit-size 8x8: must be a number of files for tables")
    changed = place.folder / "measurements/paint_0002.csv"
    changed.write_text(changed.read_text().replace(",45,", ",46,", 1))
    refused("collect fit_job -o fit_out", "paint_0002.csv: has changed")

    # One table's folds and bootstrap replicates.
    one = "fit measurements/paint_0000.csv --form ward+lambert --bootstrap 20 --seed 5 "
    at_once = run(one + "-o once.json --report once.html").stdout
    said = run(f"plan {one}--unit-size 9 -o refits").stdout
    assert said == "3 units: 0-2\n", said
    for unit in (2, 0):
        run(f"work refits --unit {unit}")
    assert run("collect refits --missing", 1).stdout == "1\n"
    run("work refits")
    damage(place.units("refits")[2][0])
    run("work refits")
    result_of = lambda said: [line for line in said.splitlines() if not line.startswith("look at it: ")]  # noqa: E731
    assert result_of(run("collect refits -o units.json --report units.html").stdout) == result_of(at_once)
    for end in ("json", "html"):
        assert (place.folder / f"once.{end}").read_bytes() == (place.folder / f"units.{end}").read_bytes(), end
    material = json.loads((place.folder / "once.json").read_text())
    assert material["fit"]["bootstrap_replicates"] == 20 and "bootstrap" in at_once
print("units of work are what the verbs do at once")
