#!/usr/bin/env python3
"""Writes the tests that scripts and sources declare as commands of CTest.

    scripts.py ROOT BUILD TARGETS...

A script declares each of its tests in a line at its beginning. So does a C++ source if its program is run with arguments
(// ctest: ...); ARGUMENTS then begin with the program:

    # ctest: NAME label=A,B [timeout=SECONDS] [cost=SECONDS] [needs=THING,...] [setup=FIXTURE] [after=FIXTURE] [env=NAME=VALUE]
             [serial] [module] ARGUMENTS

@brdf@ in the arguments is the program, @source@ and @build@ are the trees, @here@ is a folder of the script's room in the
build. needs= names a target of CMake, or `plain` (no sanitizer), `sanitized`, `threads`, `install`. `module` runs the script with the
interpreter and the path of the Python module. cost= is the duration of a long test in seconds; CTest starts long tests first, even on
a machine that has never run them. Exit code 77 means that the test is skipped. BUILD has a CMakeCache.txt; TARGETS are all targets
that a test may need.
"""
import pathlib
import re
import shlex
import sys

root, build = map(pathlib.Path, sys.argv[1:3])
CACHE = dict(re.findall(r"^(\w+):\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.M))
SANITIZED = CACHE["BRDF_SANITIZED"] == "ON"
THINGS = {*sys.argv[3:], "sanitized" if SANITIZED else "plain"}
if "fsanitize=thread" in CACHE["CMAKE_CXX_FLAGS"]:
    THINGS.add("threads")
if CACHE["BRDF_INSTALL"] == "ON" and not SANITIZED and CACHE["BUILD_SHARED_LIBS"] == "OFF":
    THINGS.add("install")
# The sanitizers drive the viewer's own executable; the leaks of its layers are left out by name.
ENVIRONMENT = [f"LSAN_OPTIONS=suppressions={root}/tests/render/sanitizers.supp:print_suppressions=0",
               "UBSAN_OPTIONS=print_stacktrace=1"] if SANITIZED else []
NAMES = {"source": root, "build": build, "tests": build / "tests", "npm": root / "build/npm/node_modules", "brdf": build / "brdf",
         "brdf_check": build / "brdf_check", "viewer": build / ("brdf_pictures" if SANITIZED else "brdf"),
         "faults": build / "tests/libfaults.so", "sphere_page": build / "tests/sphere_page",
         "forms_values": build / "tests/forms_values", "python": CACHE.get("BRDF_PYTHON_EXECUTABLE", sys.executable)}
LIMIT = 7200 if SANITIZED else 900  # seconds of a script of many commands
PROPERTIES = {"cost": "COST", "setup": "FIXTURES_SETUP", "after": "FIXTURES_REQUIRED", "timeout": "TIMEOUT"}
KNOWN = {"label", "needs", "env", "serial", "module", *PROPERTIES}


def quoted(word):
    return f"[==[{word}]==]"


def command_of(script, module):
    if script.suffix == ".cpp":
        return []
    if script.suffix == ".py" or script.read_text().startswith("#!/usr/bin/env python"):
        return [str(NAMES["python"]) if module else sys.executable, str(script)]
    return [str(script)]


def ctest(script, statement):
    """Returns the commands of one declaration; empty if this build lacks a needed part."""
    names = NAMES | {"here": build / script.parent.relative_to(root)}
    name, *words = shlex.split(re.sub(r"@(\w+)@", lambda m: str(names[m[1]]), statement))
    options = {"timeout": str(LIMIT), "needs": ""}
    flags = set()
    while words and re.match(r"\w+=|serial$|module$", words[0]):
        key, _, value = words.pop(0).partition("=")
        assert key in KNOWN, f"{script}: {key}"
        options[key] = value
        flags.add(key)
    needs = [n for n in options["needs"].split(",") if n] + ["brdf_python"] * ("module" in flags)
    if any(need not in THINGS for need in needs):
        return []
    environment = ENVIRONMENT + ([options["env"]] if "env" in flags else [])
    if "module" in flags:
        environment += [f"PYTHONPATH={build}/python", "PYTHONDONTWRITEBYTECODE=1", f"BRDF_PROGRAM={NAMES['brdf']}"]
    properties = {PROPERTIES[k]: v for k, v in options.items() if k in PROPERTIES}
    properties |= {"LABELS": options["label"].replace(",", ";"), "SKIP_RETURN_CODE": "77", "WORKING_DIRECTORY": str(root if "module" in flags else build / "tests"),
                   "ENVIRONMENT": ";".join(environment)} | ({"RUN_SERIAL": "TRUE"} if "serial" in flags else {})
    return [f"add_test({name} {' '.join(map(quoted, command_of(script, 'module' in flags) + words))})",
            f"set_tests_properties({name} PROPERTIES {' '.join(f'{k} {quoted(v)}' for k, v in properties.items())})"]


def main():
    lines = []
    for script in sorted(p for folder in ("tests", "tools", "docs") for p in (root / folder).rglob("*") if p.is_file()):
        if script.suffix in (".py", ".cpp", "") and "corpus" not in script.parts:
            for statement in re.findall(r"^(?:#|//) ctest: (.*)", script.read_text(errors="replace"), re.M):
                lines += ctest(script, statement)
    print("\n".join(lines))


if __name__ == "__main__":
    main()
