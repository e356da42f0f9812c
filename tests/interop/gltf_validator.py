"""gltf-validator (from npm) on files: no error, no warning."""
import json
import subprocess
import sys

SCRIPT = """
const fs = require("fs"), validator = require(process.argv[1] + "/gltf-validator");
(async () => {
  for (const file of process.argv.slice(2)) {
    const issues = (await validator.validateBytes(new Uint8Array(fs.readFileSync(file)))).issues;
    console.log(JSON.stringify([file, issues.numErrors, issues.numWarnings, issues.messages.filter(m => m.severity < 2)]));
  }
})();
"""


def reports(node, npm, files):
    """Returns the name, the errors, the warnings and the messages of each file."""
    run = subprocess.run([node, "-e", SCRIPT, npm, *files], text=True, capture_output=True)
    if run.returncode:
        sys.exit(run.stdout + run.stderr)
    found = [json.loads(line) for line in run.stdout.splitlines()]
    assert len(found) == len(files)
    return found


def validate(node, npm, files):
    for name, errors, warnings, messages in reports(node, npm, files):
        if errors or warnings:
            sys.exit(f"gltf-validator on {name}: {errors} errors, {warnings} warnings: {messages}")
    print(f"gltf-validator: {len(files)} files, 0 errors, 0 warnings")
