# ctest: study.json_schema label=study @brdf@ @source@/docs/study.schema.json
"""Output of `brdf study --json` and its study.json against docs/study.schema.json: schema_test.py EXECUTABLE SCHEMA"""
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(77)

executable, schema_file = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
schema = json.loads(schema_file.read_text(encoding="utf-8"))
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)

    def run(*words):
        return subprocess.run([executable, *words], cwd=folder, capture_output=True, text=True, check=False)

    assert run("synth", "--form", "ward", "--grid", "in_plane", "-o", "s.csv").returncode == 0
    (folder / "broken.csv").write_text("1,2,3\n")
    studied = run("study", "s.csv", "broken.csv", "--form", "ward", "--json", "-o", "out")
    assert studied.returncode == 1, studied.stderr
    jsonschema.validate(json.loads(studied.stdout), schema)
    for where in ("out", "out/s"):
        jsonschema.validate(json.loads((folder / where / "study.json").read_text(encoding="utf-8")), schema)
try:
    jsonschema.validate({"brdf_version": "0", "results": [{"name": "s", "file": "s.csv"}]}, schema)
except jsonschema.ValidationError:
    print("studies follow the schema")
else:
    sys.exit("the schema accepts anything")
