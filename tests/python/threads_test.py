# ctest: python.threads label=slow timeout=1200 module
"""1,000 fits in threads: the same results as one by one. Prints processor time over wall time."""
import concurrent.futures
import os
import time

import brdf

FITS, DIFFERENT = 1000, 20


def main():
    tables = [brdf.synth(brdf.material("ward", kd=0.3, ks=0.2, alpha=0.1), grid="in_plane", step=10, noise=0.02, seed=k)
              for k in range(DIFFERENT)]
    alone = [brdf.fit(t, "ward").to_dict() for t in tables]
    begin = time.perf_counter()
    for k in range(FITS // 10):
        brdf.fit(tables[k % DIFFERENT], "ward")
    one = FITS // 10 / (time.perf_counter() - begin)
    wall, processor = time.perf_counter(), time.process_time()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        beside = list(pool.map(lambda k: brdf.fit(tables[k % DIFFERENT], "ward").to_dict(), range(FITS)))
    wall, processor = time.perf_counter() - wall, time.process_time() - processor
    print(f"{FITS} fits on {os.cpu_count()} processors: {wall:.1f} s by the clock, {processor:.1f} s of processor time: "
          f"{processor / wall:.2f} in use; {FITS / wall:.0f} a second, in one thread {one:.0f}")
    for k, result in enumerate(beside):
        assert result == alone[k % DIFFERENT], f"fit {k} differs from the one made alone"


main()
