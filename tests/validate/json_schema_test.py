# ctest: validate.json_schema label=validate @brdf@ @source@/docs/validate.schema.json
"""Output of `brdf validate --json` against docs/validate.schema.json: schema_test.py EXECUTABLE SCHEMA"""
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

executable, schema_file = sys.argv[1:3]
with open(schema_file, encoding="utf-8") as f:
    schema = json.load(f)
run = subprocess.run([executable, "validate", "--form", "lambert", "--form", "blinn_phong_n8", "--json"],
                     capture_output=True, text=True, check=False)
assert run.returncode == 0, run.stderr
findings = json.loads(run.stdout)
jsonschema.validate(findings, schema)
verdicts = {f["verdict"] for f in findings["findings"]}
assert {"pass", "known_violation", "not_applicable"} <= verdicts, verdicts

# A table in one plane with an outlier, for the rows of findings and for undecided checks.
with tempfile.TemporaryDirectory() as folder:
    table = pathlib.Path(folder) / "s.csv"
    subprocess.run([executable, "synth", "--form", "lambert", "--grid", "in_plane", "-o", str(table)], check=True,
                   capture_output=True)
    lines = table.read_text().splitlines()
    *angles, value = lines[200].split(",")
    lines[200] = ",".join([*angles, str(10 * float(value))])
    table.write_text("\n".join(lines) + "\n")
    sheet = subprocess.run([executable, "validate", str(table), "--json"], capture_output=True, text=True, check=False)
assert sheet.returncode == 1, sheet.stderr
findings = json.loads(sheet.stdout)
jsonschema.validate(findings, schema)
by_check = {f["check"]: f for f in findings["findings"]}
assert by_check["coverage"]["verdict"] == by_check["energy"]["verdict"] == "undecided", by_check
assert [row["line"] for row in by_check["outliers"]["rows"]] == [201], by_check["outliers"]

required = subprocess.run([executable, "validate", "--form", "blinn_phong_n8", "--require", "energy"],
                          capture_output=True, text=True, check=False)
assert required.returncode == 1, required.returncode
numerics = subprocess.run([executable, "validate", "--numerics", "--form", "lambert", "--json"],
                          capture_output=True, text=True, check=False)
assert numerics.returncode == 0, numerics.stderr
rows = json.loads(numerics.stdout)
jsonschema.validate(rows, schema)
assert [row["scalar"] for row in rows["rows"]] == ["float", "double"], rows
try:
    jsonschema.validate({"findings": [{"subject": "x"}]}, schema)
except jsonschema.ValidationError:
    print("findings follow the schema")
else:
    sys.exit("the schema accepts anything")
