#!/usr/bin/env python3
# ctest: scale.slurm label=scale,driver timeout=480 serial needs=plain @brdf@ @source@/share/brdf/slurm/brdf-array.sbatch @faults@
"""slurm_test.py BRDF SBATCH FAULTS: planned work through a Slurm of one machine, by the script that is installed. On the way a
unit, slurmd and slurmctld are killed, the disk is full in one unit, a result is deleted and one is damaged; the same three rounds
that docs/scale.md shows give the bytes of the verb at once. FAULTS: the library that fails writes. Exit 77 without Slurm."""
import importlib.machinery
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from jobs import Place, damage

here = pathlib.Path(__file__).parent
loader = importlib.machinery.SourceFileLoader("slurm_one", str(here / "slurm_one"))
slurm_one = importlib.util.module_from_spec(importlib.util.spec_from_loader("slurm_one", loader))
loader.exec_module(slurm_one)

if slurm_one.missing():
    print(slurm_one.missing())
    sys.exit(77)
brdf, sbatch, faults = (str(pathlib.Path(word).resolve()) for word in sys.argv[1:4])
UNITS, KILLED, FULL = 64, 2, 5
# In place of the program: one unit is killed at work, one finds the disk full, each the first time only.
WRAPPER = f"""#!/bin/bash
seen=$PWD/seen.$4
if [ "$4" = {KILLED} ] && [ ! -e "$seen" ]; then
  touch "$seen"
  "{brdf}" "$@" & kill -9 $!
  wait $!
  exit
fi
if [ "$4" = {FULL} ] && [ ! -e "$seen" ]; then
  touch "$seen"
  export LD_PRELOAD="{faults}" FAULTS_KIND=write FAULTS_AT=1 FAULTS_FOLDER="$PWD/job/units"
fi
exec "{brdf}" "$@"
"""
began = time.monotonic()
with tempfile.TemporaryDirectory(prefix="brdf_slurm.") as name:
    place = Place(brdf, name)
    wrapper = place.folder / "wrapper"
    wrapper.write_text(WRAPPER)
    wrapper.chmod(0o755)
    place.make_stack("128x64", 60)
    fit = "fit stack --form cook_torrance --normals fit "
    place.run(fit + "-o at_once --jobs 2")
    assert place.run(f"plan {fit}--unit-size 16x8 -o job").stdout == f"{UNITS} units: 0-{UNITS - 1}\n"
    (place.folder / "slurm").mkdir()
    with slurm_one.Slurm(place.folder / "slurm") as slurm:
        environment = {**slurm.environment, "BRDF_PROGRAM": str(wrapper)}

        def submitted(units):
            return subprocess.Popen(["sbatch", "--wait", "--requeue", f"--array={units}", sbatch, "job"], cwd=place.folder,
                                    env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

        def done():
            return len(list((place.folder / "job/units").rglob("*.unit")))

        def queue():
            return subprocess.run(["squeue", "-h", "-r", "-o", "%i %t %r"], env=slurm.environment, capture_output=True,
                                  text=True).stdout.strip().splitlines()

        def let_finish(seconds):
            """Waits until no job is queued, or until no unit has been finished for this time. Jobs that Slurm still holds are then
            cancelled, and the next round requests their units: jobs that were running when Slurm was killed start again only
            after two minutes."""
            count, since = done(), time.monotonic()
            while queue() and time.monotonic() - since < seconds:
                time.sleep(0.5)
                if done() != count:
                    count, since = done(), time.monotonic()
            held = queue()
            subprocess.run(["scancel", "--user=root"], env=slurm.environment, capture_output=True)
            slurm_one.wait_for(lambda: not queue(), "cancelled jobs stay", 60)
            return held

        submission = submitted(place.run("collect job --missing", 1).stdout.strip())
        slurm_one.wait_for(lambda: done() >= 8, "Slurm does no unit", 120)
        slurm.kill("slurmd")
        slurm.kill("slurmctld")
        at_kill = done()
        time.sleep(1)
        slurm.start("slurmctld")
        slurm.start("slurmd")
        slurm_one.wait_for(slurm.is_idle, "the node does not come back", 60)
        held = let_finish(15)
        submission.kill()  # it may wait for a job that Slurm has forgotten
        submission.wait()
        first = place.run("collect job --missing", 1).stdout.strip()
        units = place.units("job")
        assert FULL not in units and KILLED not in units, "a unit that failed is there"
        logs = "".join(p.read_text() for p in place.folder.glob("slurm-*.log"))
        assert "No space left on device" in logs, logs[-500:]
        gone, spoiled = [k for k in sorted(units) if k not in (KILLED, FULL)][:2]
        units[gone][0].unlink()
        damage(units[spoiled][0])
        for rounds in range(1, 4):
            asked = place.run("collect job --missing", 1).stdout.strip()
            waiting = submitted(asked)
            waiting.wait(240)
            if done() == UNITS and subprocess.run([brdf, "collect", "job", "--missing"], cwd=name,
                                                  capture_output=True).returncode == 0:
                break
        after = place.units("job")
        again = {k for k in units if units[k] != after[k]}
        assert again == {gone, spoiled}, (again, gone, spoiled)
    place.run("collect job -o maps")
    place.same("at_once", "maps")
    left = [f"{p.name}: {words}" for p in pathlib.Path("/proc").glob("[0-9]*")
            for words in [(p / "cmdline").read_bytes() if (p / "cmdline").exists() else b""]
            if name.encode() in words and int(p.name) != os.getpid()]
    assert not left, left
    print(f"killed at {at_kill} of {UNITS} units; Slurm held back {held}; the first round left {first}, {rounds} more did the "
          f"rest; {time.monotonic() - began:.0f} s")
