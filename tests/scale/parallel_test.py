#!/usr/bin/env python3
# ctest: scale.parallel label=scale,driver timeout=1800 needs=plain @brdf@
"""parallel_test.py BRDF: tests planned work with GNU parallel on two processors. 64 units of a stack must give the same bytes as the
verb alone, even if parallel is killed and resumed. 1,000 tables must give one overview that reports the one bad table, and two
units at a time must use both processors. Exit code 77 without GNU parallel."""
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from jobs import Place

if not shutil.which("parallel"):
    print("GNU parallel is not installed")
    sys.exit(77)
TABLES = 1000


def parallel(place, job, units, processes, *words):
    command = f"parallel {' '.join(words)} -j{processes} {place.brdf} work {job} --unit {{}}"
    return subprocess.Popen(["sh", "-c", f"seq 0 {units - 1} | {command}"], cwd=place.folder, start_new_session=True,
                            env={**os.environ, "BRDF_THREADS": "1"})


def wait(process):
    """Seconds that passed, and seconds of the processors."""
    begin, used = time.monotonic(), sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])
    assert process.wait() == 0
    return time.monotonic() - begin, sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2]) - used


with tempfile.TemporaryDirectory() as name:
    place = Place(sys.argv[1], name)
    place.make_stack("64x64", 60)
    fit = "fit stack --form cook_torrance --normals fit "
    place.run(fit + "-o at_once")
    place.run(f"plan {fit}--unit-size 8x8 -o job")
    first = parallel(place, "job", 64, 2, "--joblog log")
    while len(place.units("job") if (place.folder / "job/units").is_dir() else {}) < 5:
        time.sleep(0.02)
    os.killpg(first.pid, signal.SIGKILL)
    first.wait()
    assert place.run("collect job --missing", 1).stdout
    wait(parallel(place, "job", 64, 2))
    place.run("collect job -o maps")
    place.same("at_once", "maps")

    place.make_tables(TABLES, broken=321)
    place.run("plan study measurements --form ward --no-pictures --unit-size 20 -o tables")
    shutil.copytree(place.folder / "tables", place.folder / "tables_alone")
    alone, alone_used = wait(parallel(place, "tables_alone", TABLES // 20, 1))
    both, both_used = wait(parallel(place, "tables", TABLES // 20, 2))
    print(f"{TABLES} tables: one process {alone:.1f} s ({alone_used:.1f} s of processors), two {both:.1f} s ({both_used:.1f})")
    print(f"two at a time: {alone / both:.2f} times as fast; of the processors' own time {both_used / both:.2f} of 2")
    done = place.run("collect tables -o out", 1)
    assert done.stderr.count("paint_0321.csv") == 1, done.stderr
    rows = json.loads((place.folder / "out/study.json").read_text())["results"]
    assert len(rows) == TABLES and [r["name"] for r in rows if r["error"]] == ["paint_0321"], len(rows)
    assert (place.folder / "out/index.html").read_text().count("paint_") >= TABLES
    place.run("collect tables_alone -o out_alone", 1)
    place.same("out", "out_alone")
    # A busy machine gives less than two processors. The test requires only that two processes do not need more processor time.
    assert both_used < 1.35 * alone_used, (alone_used, both_used)
    if os.getloadavg()[0] < 2.5:
        assert alone / both > 1.7, (alone, both)
print("GNU parallel does the units")
