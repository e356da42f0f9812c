#!/usr/bin/env python3
# ctest: scale.resume label=scale timeout=5400 needs=plain @brdf@
"""resume_test.py BRDF [TABLES]: a study of 20,000 tables is ended three times, twice by SIGKILL and once by Ctrl-C, and resumed. All files
must have the bytes of a study that ran without a break. A resumed study writes its first new tables in half a second and the time of 30
tables at most: the contents of the tables that are done are compared between the new tables. Needs 20 GB of disk."""
import hashlib
import os
import signal
import subprocess
import sys
import tempfile
import time

from jobs import Place

TABLES = int(sys.argv[2]) if len(sys.argv) > 2 else 20_000
WORDS = ["study", "many", "--form", "lambert", "--no-pictures", "--jobs", "2", "-o"]


def make_small_tables(folder):
    (folder / "many").mkdir()
    for k in range(TABLES):
        rows = "".join(f"{i},0,{o},180,{0.1 + 0.2 * k / TABLES + 0.001 * ((o * (k + 3)) % 7):.6f}\n"
                       for i in (10, 40) for o in (0, 20, 40, 60))
        (folder / f"many/t{k:05d}.csv").write_text("theta_i,phi_i,theta_o,phi_o,r\n" + rows)


def hashes(folder):
    return {str(p.relative_to(folder)): hashlib.sha256(p.read_bytes()).hexdigest() for p in folder.rglob("*") if p.is_file()}


def done_in(folder):
    return len(os.listdir(folder)) if folder.is_dir() else 0


def until(process, folder, count):
    """Waits until the folder has so many entries, and returns the seconds. The entries are counted only after a change: a list of
    20,000 names takes a processor as long as a table does."""
    begin = time.monotonic()
    seen = None
    while True:
        changed = folder.stat().st_mtime_ns if folder.is_dir() else None
        if changed != seen:
            seen = changed
            if done_in(folder) >= count:
                return time.monotonic() - begin
        assert process.poll() is None, process.returncode
        time.sleep(0.005)


with tempfile.TemporaryDirectory() as name:
    place = Place(sys.argv[1], name)
    make_small_tables(place.folder)
    broken_off = place.folder / "broken_off"
    for k, ending in enumerate((signal.SIGKILL, signal.SIGINT, signal.SIGKILL)):
        before = done_in(broken_off)
        process = subprocess.Popen([place.brdf, *WORDS, "broken_off"], cwd=place.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        try:
            first = until(process, broken_off, before + 4)  # index.html and study.json may be new
            more = 100
            each = until(process, broken_off, before + 4 + more) / more
            if k:
                print(f"{before} tables done: first new tables after {first:.2f} s, then {1e3 * each:.0f} ms for each", flush=True)
                assert first < 30 * each + 0.5, (before, first, each)
            until(process, broken_off, (k + 1) * TABLES // 4)
            ended = time.monotonic()
            process.send_signal(ending)
            code = process.wait()
            print(f"ended after {time.monotonic() - ended:.2f} s", flush=True)
            assert code == (-signal.SIGKILL if ending == signal.SIGKILL else 1), code
        finally:
            process.kill()
    subprocess.run([place.brdf, *WORDS, "broken_off"], cwd=place.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    subprocess.run([place.brdf, *WORDS, "at_once"], cwd=place.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    resumed, whole = hashes(broken_off), hashes(place.folder / "at_once")
    assert resumed.keys() == whole.keys(), sorted(resumed.keys() ^ whole.keys())[:10]
    differing = [file for file in whole if whole[file] != resumed[file]]
    assert not differing, differing[:10]
    assert len(whole) > 6 * TABLES
    print(f"{len(whole)} files of {TABLES} tables have the same bytes")
