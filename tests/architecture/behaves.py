#!/usr/bin/env python3
"""behaves.py ROOT: the rooms that are libraries never print, exit, listen or change what belongs to the whole process. What
only a program calls is named here, with the sources that may call it."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
LIBRARIES = ["libbrdf", "io", "sheet", "measured", "synth", "fit", "validate"]
FORBIDDEN = re.compile(
    r"std::(cout|cerr|clog|cin)\b|\b(printf|puts|putchar|perror|vprintf|fputs|fputc|fprintf)\s*\("
    r"|\b(exit|_exit|_Exit|quick_exit|abort|terminate|set_terminate|set_new_handler|atexit|at_quick_exit)\s*\("
    r"|\b(setlocale|uselocale|fesetround|fesetenv|feenableexcept|fedisableexcept|_mm_setcsr|_MM_SET\w+)\s*\(|locale::global"
    r"|\b(socket|bind|listen|accept|connect)\s*\(|\b(signal|sigaction|sigprocmask|raise)\s*\("
    r"|\b(chdir|umask|setenv|unsetenv|putenv|srand|setrlimit|nice|fork|vfork|system|popen|execv\w*)\s*\("
    r"|current_path\s*\([^)]|\bFLAGS_\w+\s*=[^=]|google::(Init|Set|Install|Log)")
# FILE: the function that a program calls if it wants it; only its own sources may.
OF_A_PROGRAM = {"io/leftovers.cpp": "remove_temporaries_on_signals", "fit/solve/quiet.cpp": "silence_solver_log"}

faults = []
sources = [p for room in LIBRARIES for p in sorted((root / room).rglob("*")) if p.suffix in (".h", ".cpp", ".in")]
for path in sources:
    name = str(path.relative_to(root))
    text = re.sub(r'"(\\.|[^"\\\n])*"', '""', re.sub(r"//[^\n]*", "", path.read_text()))
    found = [m[0].strip() for m in FORBIDDEN.finditer(text)]
    if name in OF_A_PROGRAM:
        if not found:
            faults.append(f"{name}: nothing left to allow")
        continue
    faults += [f"{name}: {word}" for word in found]
    faults += [f"{name}: calls {f}(), which is the program's" for owner, f in OF_A_PROGRAM.items()
               if name != owner.replace(".cpp", ".h") and re.search(rf"\b{f}\s*\(", text)]
assert len(sources) > 100, sources
if faults:
    sys.exit("\n".join(faults))
