#!/usr/bin/env python3
# ctest: platforms.fits label=platforms timeout=3600 needs=plain @source@ @build@ @here@/fits
"""aarch64_test.py SOURCE BUILD FOLDER: tests that fits on aarch64 give the verdicts and parameters of this machine. Builds libbrdf, io and
fit with a cross compiler on a root of Debian's arm64 packages, and fits small tables under qemu. Exit code 77 without the tools or
without a mirror."""
import pathlib
import shutil
import subprocess
import sys

source, build, folder = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
BOUND = 2e-14  # relative, and absolute below 1: the parameters of converged fits; 6.3e-15 so far
TABLES = ("lambert.csv", "ward_grazing.csv", "phong_sparse.csv", "instrument.csv")
PACKAGES = ("libc6-dev libstdc++-12-dev libceres-dev libblas-dev liblapack-dev libopenexr-dev libimath-dev nlohmann-json3-dev "
            "libexpat1-dev libutfcpp-dev libnanoflann-dev libeigen3-dev libstb-dev libboost-dev").split()
LIBRARIES = "ceres glog OpenEXR-3_1 Imath-3_1 Iex-3_1 expat stb".split()
ROOMS = ("fit", "measured", "sheet", "io", "libbrdf")
root, cross = folder / "root", folder / "build"
multiarch = root / "usr/lib/aarch64-linux-gnu"


def run(*words, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **options)
    assert done.returncode == 0, (words, (done.stdout + done.stderr)[-2000:])
    return done.stdout


def make_root():
    """Extracts the packages; their scripts, which would need the other processor, are not run."""
    if (folder / "root_is_made").exists():
        return
    shutil.rmtree(root, ignore_errors=True)
    mirror = next(uri for uri in run("apt-get", "indextargets", "--format", "$(REPO_URI)").split() if "security" not in uri)
    codename = next(line.split("=")[1] for line in pathlib.Path("/etc/os-release").read_text().splitlines()
                    if line.startswith("VERSION_CODENAME"))
    made = subprocess.run(["mmdebstrap", "--quiet", "--variant=extract", "--architectures=arm64", f"--include={','.join(PACKAGES)}", codename,
                           root, mirror], capture_output=True, text=True, check=False)
    if made.returncode:
        print(f"skipped: no root from {mirror}: {made.stderr[-300:]}")
        sys.exit(77)
    for kind in ("blas", "lapack"):  # update-alternatives would make these links
        for file in (multiarch / kind).iterdir():
            link = multiarch / file.name
            link.unlink(missing_ok=True)
            link.symlink_to(f"{kind}/{file.name}")
    (folder / "root_is_made").touch()


def make_libraries():
    settings = {"CMAKE_SYSTEM_NAME": "Linux", "CMAKE_SYSTEM_PROCESSOR": "aarch64", "CMAKE_C_COMPILER": "aarch64-linux-gnu-gcc",
                "CMAKE_CXX_COMPILER": "aarch64-linux-gnu-g++", "CMAKE_SYSROOT": root, "CMAKE_LIBRARY_ARCHITECTURE": "aarch64-linux-gnu",
                "CMAKE_FIND_ROOT_PATH": root, "CMAKE_FIND_ROOT_PATH_MODE_PROGRAM": "NEVER",
                "CMAKE_CROSSCOMPILING_EMULATOR": f"qemu-aarch64-static;-L;{root}"}
    settings |= {f"CMAKE_FIND_ROOT_PATH_MODE_{kind}": "ONLY" for kind in ("LIBRARY", "INCLUDE", "PACKAGE")}
    toolchain = folder / "toolchain.cmake"
    toolchain.write_text("".join(f'set({name} "{value}")\n' for name, value in settings.items()))
    run("cmake", "-S", source, "-B", cross, "-G", "Ninja", "--toolchain", toolchain, "-DCMAKE_BUILD_TYPE=Release", "-DBRDF_PROGRAM=OFF", "-DCMAKE_UNITY_BUILD=ON")
    run("cmake", "--build", cross, "-j2", "--target", *(f"brdf_{room}" for room in ROOMS))


def make_program(compiler, tree, more):
    words = ["-std=c++20", "-O1", "-ffp-contract=off", f"-I{tree}/libbrdf/include", f"-I{tree}/libbrdf/generated", f"-I{source}"]
    program = tree / "fits_of_the_test"
    archives = [tree / room / ("libbrdf.a" if room == "libbrdf" else f"libbrdf_{room}.a") for room in ROOMS]
    run(compiler, *words, pathlib.Path(__file__).with_name("fits.cpp"), "-o", program, "-Wl,--start-group", *archives, "-Wl,--end-group", *more,
        *(f"-l{name}" for name in LIBRARIES), "-pthread", "-Wl,--allow-shlib-undefined")
    return program


def fits(*command):
    """Returns verdict and parameters by table and form."""
    out = {}
    for line in run(*command, *TABLES, cwd=source / "data/synthetic").splitlines():
        table, form, verdict, *values = line.split()
        out[table, form] = verdict, [float(value) for value in values]
    return out


for tool in ("mmdebstrap", "qemu-aarch64-static", "aarch64-linux-gnu-g++"):
    if not shutil.which(tool):
        print(f"skipped: {tool} is not installed")
        sys.exit(77)
folder.mkdir(parents=True, exist_ok=True)
make_root()
make_libraries()
here = fits(make_program("c++", build, []))
there = fits("qemu-aarch64-static", "-L", root, make_program("aarch64-linux-gnu-g++", cross, [f"--sysroot={root}"]))
assert here.keys() == there.keys() and len(here) >= 4 * len(TABLES), (sorted(here.keys() ^ there.keys()), len(here))
worst = 0.0, ("", "")
for key, (verdict, values) in here.items():
    assert verdict == there[key][0] and len(values) == len(there[key][1]), (key, verdict, there[key])
    if verdict in ("converged", "breaks_energy"):
        worst = max(worst, *((abs(a - b) / max(1, abs(a)), key) for a, b in zip(values, there[key][1])))
print(f"{len(here)} fits have the same verdicts; the parameters of converged fits differ by at most {worst[0]:.2g} ({worst[1]})")
assert worst[0] < BOUND, worst
