"""A million pairs through `import brdf` against the library's own batch: prints the ratio, which no test asks for.

    PYTHONPATH=build/release/python python3 bench/python_batches.py build/release/bench/batch_time [FORM...]

For each form and type: the batch over arrays by coordinate; the copy (numpy's own, of both directions and the values, once);
material.eval of (n, 3) arrays into `out`. The claim is module <= 1.5 batch + copy. Processor time, best of rounds, taken in turns.
"""
import subprocess
import sys
import time

import numpy as np

import brdf

PAIRS, ROUNDS, TURNS = 1_000_000, 10, 4


def best(call):
    times = []
    for _ in range(ROUNDS):
        begin = time.process_time()
        call()
        times.append(time.process_time() - begin)
    return min(times)


def main():
    program, forms = sys.argv[1], sys.argv[2:] or ["lambert", "phong", "ward", "cook_torrance", "oren_nayar_energy"]
    k = np.arange(PAIRS)
    wi, wo = (brdf.directions((k % 89) * turn, k % 360) for turn in (1.0, 0.5))
    print("milliseconds for 1,000,000 pairs, one channel\nform                type     batch    copy  module  module / (1.5 batch + copy)")
    for form in forms:
        material = brdf.material(form)
        for kind, name in ((np.float64, "double"), (np.float32, "float")):
            i, o = wi.astype(kind), wo.astype(kind)
            out = np.empty((PAIRS, 1), kind)
            batch = copy = module = np.inf
            copies = [np.empty_like(a) for a in (i, o, out)]
            for _ in range(TURNS):
                run = subprocess.run([program, form, name, str(ROUNDS)], check=True, capture_output=True, text=True)
                batch = min(batch, float(run.stdout))
                module = min(module, best(lambda: material.eval(i, o, out=out)))
                copy = min(copy, best(lambda: [np.copyto(a, b) for a, b in zip(copies, (i, o, out))]))
            print(f"{form:19} {name:6} {1e3 * batch:7.2f} {1e3 * copy:7.2f} {1e3 * module:7.2f}  "
                  f"{module / (1.5 * batch + copy):.2f}", flush=True)


main()
