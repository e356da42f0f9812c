# ctest: sheet.merl label=sheet needs=plain @brdf@
"""Requires that the data check of a whole MERL file takes at most five seconds of processor time and 200 MB: merl_sheet_test.py EXECUTABLE"""
import json
import pathlib
import subprocess
import sys
import tempfile

executable = sys.argv[1]
MATERIAL = {"format": "brdf-material", "version": 1, "form": "cook_torrance", "channels": ["r", "g", "b"],
            "weights": {"kd": [0.3, 0.2, 0.1], "ks": 0.5, "f0": 0.05}, "shape": {"alpha_x": 0.1, "alpha_y": 0.1}}

with tempfile.TemporaryDirectory() as folder:
    material, table = pathlib.Path(folder) / "m.json", pathlib.Path(folder) / "m.binary"
    material.write_text(json.dumps(MATERIAL))
    # In a separate process, because the system reports the memory of the largest child.
    subprocess.run([sys.executable, "-c", "import subprocess, sys; subprocess.run(sys.argv[1:], check=True)", executable,
                    "convert", str(material), str(table)], check=True, capture_output=True)
    command = ("import json, resource, subprocess, sys\n"
               "run = subprocess.run(sys.argv[1:], capture_output=True, text=True)\n"
               "used = resource.getrusage(resource.RUSAGE_CHILDREN)\n"
               "print(json.dumps([run.returncode, run.stdout, used.ru_maxrss / 1024, used.ru_utime + used.ru_stime]))")
    run = subprocess.run([sys.executable, "-c", command, executable, "validate", str(table), "--json"], check=True,
                         capture_output=True, text=True)
code, output, megabytes, seconds = json.loads(run.stdout)
found = {f["check"]: f for f in json.loads(output)["findings"]}
assert code == 0, output
assert found["coverage"]["verdict"] == "pass" and found["coverage"]["value"] == 1, found["coverage"]
assert found["energy"]["verdict"] == "pass", found["energy"]
assert megabytes < 200, megabytes
assert seconds < 5, seconds
print(f"{seconds:.1f} s of processor time, {megabytes:.0f} MB")
