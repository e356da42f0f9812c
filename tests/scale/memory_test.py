#!/usr/bin/env python3
# ctest: scale.memory label=scale,driver timeout=1800 needs=plain @brdf@
"""memory_test.py BRDF: a stack of 512 x 512 texels under 151 lights from 151 viewpoints, 36 GB as half floats, is fitted in
less than 1 GB. The test fits one unit of 64 x 8 texels in two bands of rows. One uniform image replaces all 22,801 (hard links)."""
import itertools
import os
import subprocess
import sys
import tempfile
import time

from jobs import Place

SIDE, LIGHTS, CHANNELS = 512, 151, 3
with tempfile.TemporaryDirectory() as name:
    place = Place(sys.argv[1], name)
    place.run(f"synth --form lambert --texels {SIDE}x{SIDE} --lights 1 --set rho=0.5,0.4,0.3 -o one")
    stack = place.folder / "stack"
    stack.mkdir()
    image = next((place.folder / "one").glob("image*.exr"))
    rows = ["theta_i,phi_i,theta_o,phi_o"]
    for k, (light, viewer) in enumerate(itertools.product(range(LIGHTS), repeat=2)):
        os.link(image, stack / f"image_{k:05d}.exr")
        rows.append(f"{5 + 0.4 * light:.1f},{(37 * light) % 360},{3 + 0.4 * viewer:.1f},{(101 * viewer) % 360}")
    (stack / "lights.csv").write_text("\n".join(rows) + "\n")
    decoded = SIDE * SIDE * CHANNELS * LIGHTS ** 2 * 2
    begin = time.monotonic()
    place.run("plan fit stack --form lambert --metric log --unit-size 64x8 -o job")
    planned = time.monotonic() - begin
    begin = time.monotonic()
    process = subprocess.Popen([place.brdf, "work", "job", "--unit", "3", "--memory-limit", "100M"], cwd=place.folder)
    _, status, usage = os.wait4(process.pid, 0)
    assert status == 0
    peak = 1024 * usage.ru_maxrss
    print(f"{decoded / 1e9:.1f} GB: planned in {planned:.0f} s; a unit of 512 texels in {time.monotonic() - begin:.0f} s "
          f"({usage.ru_utime:.0f} s of the processor), {peak / 1e6:.0f} MB")
    assert decoded > 35e9 and peak < 1e9, peak
print("memory is bounded")
