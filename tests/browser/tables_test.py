#!/usr/bin/env python3
# ctest: browser.tables label=wasm timeout=3600 serial @brdf@ chromium firefox-esr @source@/build/wasm/browser @here@/tables
"""tables_test.py BRDF CHROMIUM FIREFOX PAGE FOLDER: both browsers fit every table of data/synthetic and the measured ones of
BRDF_DATA_DIR, on the page from a disk (PAGE/brdf.html) and from a web server (PAGE/site). The verdicts equal the program's, the
saved materials have its parameters within 1e-9, its intervals within 1e-6, and its intervals by other metrics within 1e-4. No request leaves the page, and its console is empty.
Exit code 77: the page has not been built."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

from firefox import Firefox
from page_driver import READY, SOFTWARE, STATES, Browser, Server, drop, text_of

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Largest relative differences: parameters, the ends of their intervals, and the ends over other metrics.
MOST = {"value": 1e-9, "interval": 1e-6, "other metrics": 1e-4}


def of_the_program(brdf, table, folder):
    """Returns the row of a study and the material."""
    run = subprocess.run([brdf, "study", table, "--form", "all", "-o", folder, "--json", "--quiet"], text=True, capture_output=True,
                         check=False)
    row = json.loads(run.stdout)["results"][0]
    found = [json.loads(path.read_text()) for path in folder.rglob("*.json") if path.name.endswith("material.json")]
    assert len(found) == 1, list(folder.rglob("*.json"))
    return row, found[0]


def ends(interval, place=""):
    """Yields (place, number) of the value and of every end in an interval's JSON, which may have a part for each channel."""
    for key, part in interval.items():
        if isinstance(part, dict):
            yield from ends(part, f"{place}.{key}")
        elif key in ("value", "low", "high"):
            yield f"{place}.{key}", part


def dropped(page, table, folder):
    """Drops a table, waits for its result, and returns its sentence, its form and the material that the page saves."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    before = page.evaluate("document.querySelectorAll('#queue li').length")
    drop(page, (table.name, table.read_text()))
    page.wait(f"{STATES}.length === {before + 1} && /^(fitted|refused)/.test({STATES}.at(-1))")
    page.wait(f"document.querySelector('.pane h3')?.textContent === {json.dumps(table.name)}")
    page.evaluate("document.querySelector('.pane .downloads a[data-file=\"material.json\"]').click()")
    saved, deadline = folder / f"{table.stem}_material.json", time.monotonic() + 60
    while not (saved.exists() and saved.stat().st_size and not list(folder.glob("*.part"))):
        assert time.monotonic() < deadline, list(folder.iterdir())
        time.sleep(0.05)
    return text_of(page, ".pane .verdict"), json.loads(saved.read_text())


def kind_of(place):
    return "value" if place.endswith("value") else "other metrics" if ".other_metrics." in place else "interval"


def compare(table, told, material, row, right):
    """Returns the largest difference of each kind, relative to the parameter."""
    assert told == row["statement"], (table.name, told, row["statement"])
    assert (material["form"], material["channels"]) == (right["form"], right["channels"]), table.name
    ours, theirs = (dict(ends(m["fit"]["intervals"])) for m in (material, right))
    assert ours.keys() == theirs.keys() and theirs, table.name
    worst, scale = dict.fromkeys(MOST, 0.0), 1.0
    for place, there in theirs.items():
        here = ours[place]
        scale = abs(there) or 1.0 if place.endswith("value") else scale  # the value is written before its ends
        assert (here is None) == (there is None), (table.name, place, here, there)
        worst[kind_of(place)] = max(worst[kind_of(place)], abs((here or 0) - (there or 0)) / scale)
    assert all(worst[kind] <= most for kind, most in MOST.items()), (table.name, worst)
    return worst


def fit_all(name, browser, address, right, saved):
    """Fits the tables one after the other on a page. Returns the largest differences."""
    worst = dict.fromkeys(MOST, 0.0)
    with browser.open(address) as page:
        page.wait(READY)
        asked, begin = len(page.requests), time.monotonic()
        for table, (row, material) in right.items():
            for kind, size in compare(table, *dropped(page, table, saved), row, material).items():
                worst[kind] = max(worst[kind], size)
        sent = [url for url in page.requests[asked:] if not url.startswith(("blob:", "data:", "about:"))]
        assert not sent and not page.console, (sent, page.console)
    print(f"{name}: {len(right)} tables in {time.monotonic() - begin:.0f} s; largest differences: "
          f"{', '.join(f'{kind} {size:.1e}' for kind, size in worst.items())}", flush=True)


def main():
    brdf, chromium, firefox = sys.argv[1:4]
    built, folder = map(pathlib.Path, sys.argv[4:6])
    if not (built / "brdf.html").exists():
        print(f"skipped: {built} has no page; `cmake --preset wasm && cmake --build --preset wasm` builds it")
        sys.exit(77)
    tables = sorted((ROOT / "data/synthetic").glob("*.csv"))
    if data := os.environ.get("BRDF_DATA_DIR"):
        tables += sorted(pathlib.Path(data, "measured").glob("*.csv"))
    else:
        print("BRDF_DATA_DIR is unset: measured tables are left out")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    right = {table: of_the_program(brdf, table, folder / table.stem) for table in tables}
    saved, server = (folder / "saved").resolve(), Server(built / "site")
    places = {"from a disk": (built / "brdf.html").resolve().as_uri(), "from a server": server.address + "index.html"}
    with Browser(chromium, *SOFTWARE, patience=300, server="127.0.0.1") as browser:
        browser.ask("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(saved))
        for place, address in places.items():
            fit_all(f"Chromium, {place}", browser, address, right, saved)
    with Firefox(firefox, saved) as browser:
        for place, address in places.items():
            fit_all(f"Firefox {browser.version}, {place}", browser, address, right, saved)
    server.close()


if __name__ == "__main__":
    main()
