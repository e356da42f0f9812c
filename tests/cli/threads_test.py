# ctest: cli.threads label=threads timeout=1800 needs=threads @brdf@
"""Everything that has threads, under ThreadSanitizer: threads_test.py EXECUTABLE

Reports from libraries that are not instrumented (Embree, TBB, Vulkan's driver) are left out by the sanitizer itself.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

executable = pathlib.Path(sys.argv[1]).resolve()
FOUND = 66  # exit code of a process with a report
COMMANDS = [
    "synth --form cook_torrance --set alpha=0.2 --grid in_plane --noise 0.02 -o a.csv",
    "synth --form ward --grid in_plane --noise 0.02 -o b.csv",
    "synth --form lambert --grid in_plane --noise 0.02 -o c.csv",
    "fit a.csv b.csv c.csv --form lambert+cook_torrance --jobs 3 -o batch",
    "study a.csv b.csv c.csv --form ward --jobs 3 -o studied",
    "fit a.csv --form all -o a.json",
    "synth --microsurface gaussian --set alpha=0.3 --theta-i 30 --surfaces 8 --rays 256 --size 64 --threads 3 -o g.csv",
    "synth --microsurface mirror_grooves --set alpha=0.3 --theta-i 30 --surfaces 8 --rays 256 --threads 3 -o m.csv",
    "synth --microsurface lambert_grooves --set sigma=0.3 --theta-i 30 --surfaces 8 --rays 64 --threads 3 -o l.csv",
    "synth --form ward --texels 16x16 --lights 12 --noise 0.02 -o stack",
    "fit stack --form ward --normals fit --jobs 3 -o maps",
    "fit stack --form ward --share alpha --jobs 3 -o shared",
    "fit a.csv --form ward --bootstrap 20",
    "validate a.json a.csv --form ward",
    "validate --numerics --form lambert",
    "prove a.json --property energy --seconds 5",
    "prove --form oren_nayar --form cook_torrance",
    "render a.json --width 64 --height 64 --compare embree -o r.png",
    "trade --quick --only masking",
]

environment = os.environ | {
    "BRDF_THREADS": "3",
    "TSAN_OPTIONS": f"ignore_noninstrumented_modules=1 exitcode={FOUND} halt_on_error=0",
}
failed = 0
with tempfile.TemporaryDirectory(prefix="threads.") as folder:
    for command in COMMANDS:
        done = subprocess.run([executable, *command.split()], cwd=folder, capture_output=True, text=True, check=False,
                              env=environment)
        good = done.returncode in (0, 1)  # 1: a result that fails
        print(f"exit {done.returncode}  brdf {command}", flush=True)
        if not good:
            print(done.stderr[-8000:])
            failed += 1
print(f"{len(COMMANDS)} commands, {failed} with a report or a failure")
sys.exit(failed != 0)
