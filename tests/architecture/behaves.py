#!/usr/bin/env python3
# ctest: architecture.libraries_behave label=architecture @source@
"""behaves.py ROOT: checks that the rooms that are libraries never print, exit, open sockets or change the state of the whole
process. This file lists the functions that only a program may call, and the sources that may call them."""
import pathlib
import re
import sys

import rooms

root = pathlib.Path(sys.argv[1])
PROGRAMS = {"cli", "docs", "bench"}
LIBRARIES = [room.name for room in rooms.read(root) if room.name not in PROGRAMS]
FORBIDDEN = re.compile(
    r"std::(cout|cerr|clog|cin)\b|\b(printf|puts|putchar|perror|vprintf|fputs|fputc|fprintf)\s*\("
    r"|\b(exit|_exit|_Exit|quick_exit|abort|terminate|set_terminate|set_new_handler|atexit|at_quick_exit)\s*\("
    r"|\b(setlocale|uselocale|fesetround|fesetenv|feenableexcept|fedisableexcept|_mm_setcsr|_MM_SET\w+)\s*\(|locale::global"
    r"|\bsocket\s*\(|\b(signal|sigaction|sigprocmask)\s*\(|std::raise\b"
    r"|\b(chdir|umask|setenv|unsetenv|putenv|srand|setrlimit|nice|fork|vfork|system|popen|execv\w*)\s*\("
    r"|current_path\s*\([^)]|\bFLAGS_\w+\s*=[^=]|google::(Init|Set|Install|Log)")
# Programs of their own, and a process that a library starts and ends.
EXEMPT = {"prove/check/main.cpp": "brdf_check", "render/shaders/emit_shaders.cpp": "a program of the build",
          "render/viewer/": "the window of a program", "shader/front/compile.cpp": "a shader's process, which may crash",
          "render/vulkan/device.cpp": "the validation layers' words, for developers"}
# FILE: the function that a program calls if it wants it; only its own sources may.
OF_A_PROGRAM = {"io/files/leftovers.cpp": "remove_temporaries_on_signals", "fit/solve/quiet.cpp": "silence_solver_log"}

faults, used = [], set()
sources = [p for room in LIBRARIES for p in sorted((root / room).rglob("*")) if p.suffix in (".h", ".cpp", ".in")]
for path in sources:
    name = str(path.relative_to(root))
    text = re.sub(r'"(\\.|[^"\\\n])*"', '""', re.sub(r"//[^\n]*", "", path.read_text()))
    found = [m[0].strip() for m in FORBIDDEN.finditer(text)]
    exempt = next((place for place in (*OF_A_PROGRAM, *EXEMPT) if name.startswith(place)), None)
    if exempt:
        used |= {exempt} if found else set()
        continue
    faults += [f"{name}: {word}" for word in found]
    faults += [f"{name}: calls {f}(), which is the program's" for owner, f in OF_A_PROGRAM.items()
               if name != owner.replace(".cpp", ".h") and re.search(rf"\b{f}\s*\(", text)]
faults += [f"{place}: nothing left to allow" for place in (*OF_A_PROGRAM, *EXEMPT) if place not in used]
assert len(sources) > 500, sources
if faults:
    sys.exit("\n".join(faults))
