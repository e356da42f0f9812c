# ctest: io.sphere_in_a_browser label=browser timeout=600 @sphere_page@ @brdf@ chromium @here@/spheres
"""Tests the spheres of a report in a headless browser without a network. Values must equal the values of `brdf eval`, and the
pictures must equal the still pictures, under one light and in the studio. Covers mouse, keys and controls, light and dark, widths of
1280 and 400 pixels, and a browser without WebGL 2.
sphere_test.py SPHERE_PAGE BRDF BROWSER FOLDER"""
import json
import math
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "validate"))
from browser import SOFTWARE, Browser  # noqa: E402

LOBE = {"form": "cook_torrance", "weights": {"kd": [0.2, 0.15, 0.05], "ks": [0.6] * 3, "f0": [0.6] * 3}}
FITTED = {"format": "brdf-material", "version": 1, "channels": ["r", "g", "b"], **LOBE,
          "shape": {"alpha_x": 0.25, "alpha_y": 0.25}}
TRUE = {"format": "brdf-material", "version": 1, "form": "sum", "channels": ["r", "g", "b"], "terms": [
    {**LOBE, "weights": {**LOBE["weights"], "ks": [0.3] * 3}, "shape": {"alpha_x": 0.15, "alpha_y": 0.15}},
    {**LOBE, "weights": {"kd": [0] * 3, "ks": [0.3] * 3, "f0": [0.5] * 3}, "shape": {"alpha_x": 0.4, "alpha_y": 0.4}}]}

# Helpers for the spheres, which must be drawn first. The first figure shows the fitted material in the studio,
# the second the measured one under a single light, the third another material in the studio.
TOOLS = """
const figures = [...document.querySelectorAll("figure.sphere")];
const pixels = figure => { const c = figure.querySelector("canvas"), copy = new OffscreenCanvas(c.width, c.height);
  copy.getContext("2d").drawImage(c, 0, 0);
  return [...copy.getContext("2d").getImageData(0, 0, c.width, c.height).data]; };
const changed = (a, b) => a.length !== b.length ? -1 : a.filter((v, k) => v !== b[k]).length;
// The values in the middle of the first panel, and `x`, `y` radii beside it.
const at = (k, x = 0, y = 0) => { const s = figures[k].sphere, side = s.panelAt(0, 0).side;
  return s.read(side * (0.5 + 0.47 * x), side * (0.5 - 0.47 * y)); };
"""


def open_page(browser, page, **words):
    opened = browser.open(page, **words)
    opened.wait("""[...document.querySelectorAll("figure.sphere")].every(f => f.dataset.shown)""")
    opened.evaluate(TOOLS + "window.figures = figures, window.pixels = pixels, window.changed = changed, window.at = at, 0")
    return opened


def evaluated(brdf, folder, material, pairs):
    """Returns f_r of the pairs by `brdf eval`, which receives the azimuths and polar angles of the unit vectors."""
    def degrees(w):
        return math.degrees(math.atan2(math.hypot(w[0], w[1]), w[2])), math.degrees(math.atan2(w[1], w[0]))
    (folder / "m.json").write_text(json.dumps(material), encoding="utf-8")
    (folder / "d.csv").write_text("theta_i,phi_i,theta_o,phi_o\n" + "".join(
        ",".join(map(repr, degrees(p["wi"]) + degrees(p["wo"]))) + "\n" for p in pairs), encoding="utf-8")
    done = subprocess.run([brdf, "eval", "--material", "m.json", "d.csv"], cwd=folder, capture_output=True, text=True,
                          check=True)
    rows = [line for line in done.stdout.splitlines() if not line.startswith("#")][1:]
    return [[float(v) for v in row.split(",")[4:7]] for row in rows]


def worst(found, expected):
    return max(abs(a / b - 1) for f, e in zip(found, expected) for a, b in zip(f, e))


def check_values(page, brdf, folder):
    middle = [page.evaluate("at(1)"), page.evaluate("at(1, 0.001, 0.001)")]
    for pair in middle:
        assert abs(pair["wo"][2] - 1) < 1e-5 and abs(math.degrees(math.acos(pair["wi"][2])) - 44.813) < 0.1, pair
    points = [page.evaluate(f"at(1, {x / 10}, {y / 10})") for x in range(-8, 9, 2) for y in range(-8, 9, 2)
              if math.hypot(x, y) < 9.5]
    known = [p for p in points if p["measured"][3] >= 0.5]
    beyond = [p for p in points if min(p["wi"][2], p["wo"][2]) < math.cos(math.radians(75))]
    within = [p for p in points if min(p["wi"][2], p["wo"][2]) > math.cos(math.radians(65))]
    assert len(beyond) > 5 and len(within) > 20, (len(beyond), len(within))
    assert not [p for p in beyond if p["measured"][3] >= 0.5] and not [p for p in within if p["measured"][3] < 0.5]
    lit = [p for p in points if p["wi"][2] > 0.01]
    by_middle = worst([p["fitted"] for p in middle], evaluated(brdf, folder, FITTED, middle))
    by_fitted = worst([p["fitted"] for p in lit], evaluated(brdf, folder, FITTED, lit))
    by_measured = worst([p["measured"] for p in known], evaluated(brdf, folder, TRUE, known))
    print(f"middle against brdf eval {by_middle:.2g}, {len(lit)} points {by_fitted:.2g}; what was measured, "
          f"{len(known)} points, {by_measured:.2g}")
    assert by_fitted < 1e-5, by_fitted
    assert by_measured < 0.01, by_measured
    return by_middle


def check_picture(page, figure):
    """Compares the canvas with the still picture at the same size. In the studio all rounds of directions are drawn first."""
    apart = page.evaluate("""(async () => {
      const figure = figures[FIGURE], sphere = figure.sphere;
      const still = figure.querySelector("img.still"), canvas = document.createElement("canvas");
      await still.decode();
      const stage = sphere.canvas;
      stage.style.width = still.naturalWidth + "px";
      const painted = () => { for (let k = 0; k < 300; ++k) { sphere.paint(); if (!sphere.studio || sphere.done >= 256) break; } };
      painted();
      Object.assign(canvas, {width: still.naturalWidth, height: still.naturalHeight});
      const context = canvas.getContext("2d");
      context.drawImage(still, 0, 0);
      const a = context.getImageData(0, 0, canvas.width, canvas.height).data, b = pixels(figure);
      stage.style.width = "";
      painted();
      const far = [0, 0, 0], side = canvas.height;
      for (let k = 0; k < a.length; k += 4)
        far[Math.floor(k / 4 % canvas.width / side)] +=
          Math.max(...[0, 1, 2, 3].map(j => Math.abs(a[k + j] - b[k + j]))) > 8;
      return a.length === b.length && far.map(count => count / side ** 2);
    })()""".replace("FIGURE", str(figure)))
    print("canvas against the still picture, pixels that differ: " + ", ".join(f"{100 * part:.2f} %" for part in apart))
    # The edge of the measured region is visible, because the table of the canvas has a finite number of nodes.
    if figure == 1:
        assert apart[0] < 0.001 and max(apart[1:]) < 0.04, apart
    else:  # the still picture has fewer rounds of directions
        assert apart[0] < 0.002, apart


def check_controls(page):
    page.evaluate("window.first = pixels(figures[1]), figures[1].sphere.canvas.focus()")

    def after(action):
        if callable(action):
            action()
        else:
            page.evaluate(action)
        page.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        return page.evaluate("changed(first, pixels(figures[1]))")

    def arrow(name, modifiers=0):
        for kind in ("keyDown", "keyUp"):
            page.ask("Input.dispatchKeyEvent", type=kind, key=name, code=name, modifiers=modifiers)

    light = "figures[1].sphere.lightTurn"
    assert after(lambda: arrow("ArrowRight")) > 10000 and page.evaluate(light) == -35
    assert after(lambda: arrow("Home")) == 0
    assert after(lambda: arrow("ArrowLeft", modifiers=8)) > 10000 and page.evaluate(light) == -40
    assert after("figures[1].querySelector('.reset').click()") == 0
    box = page.evaluate("(() => { const b = figures[1].sphere.canvas.getBoundingClientRect();"
                        " return [b.left + b.width / 6, b.top + b.height / 2]; })()")

    def mouse(kind, x, y, **more):
        page.ask("Input.dispatchMouseEvent", type=kind, x=box[0] + x, y=box[1] + y, **more)

    def drag():
        mouse("mousePressed", 0, 0, button="left", buttons=1)
        mouse("mouseMoved", 30, 10, button="left", buttons=1)
        mouse("mouseReleased", 30, 10, button="left")

    assert after(drag) > 10000 and page.evaluate("figures[1].sphere.turn") == -15
    after("figures[1].sphere.reset()")
    mouse("mouseMoved", 3, 2)
    reading = page.evaluate("figures[1].querySelector('.reading').textContent")
    assert "fitted 0.1" in reading and "measured 0.1" in reading, reading
    slider = "(() => { const e = figures[1].querySelector('.exposure'); e.value = Number(e.value) + 1;" \
             " e.dispatchEvent(new Event('input')); })()"
    assert after(slider) > 10000
    after("figures[1].sphere.reset()")
    after("(() => { const e = figures[1].querySelector('.show'); e.value = 'difference';"
          " e.dispatchEvent(new Event('input')); })()")
    assert page.evaluate("figures[1].dataset.shown") == "difference"
    assert page.evaluate("(() => { const c = figures[1].sphere.canvas; return c.width === c.height; })()")


def check_studio(page):
    """The studio's sphere turns, and so does its light; every change begins a new sum, which ends."""
    page.evaluate("window.studio = figures[0].sphere, studio.canvas.focus(), 0")

    def settled():
        page.evaluate("(async () => { while (studio.done < 256) await new Promise(requestAnimationFrame); })()")
        return page.evaluate("pixels(figures[0])")

    first = settled()
    for change in ("studio.move(false, 40, 0)", "studio.move(true, 60, 0)"):
        page.evaluate(change)
        page.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        moved = settled()
        assert sum(a != b for a, b in zip(first, moved)) > 5000, change
        page.evaluate("studio.reset()")
        page.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        again = settled()
        # The light is summed in other portions, so that single roundings differ.
        assert sum(abs(a - b) > 1 for a, b in zip(first, again)) == 0, change


def main():
    make, brdf, name, folder = sys.argv[1], sys.argv[2], sys.argv[3], pathlib.Path(sys.argv[4])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for file, material in (("fitted.json", FITTED), ("true.json", TRUE)):
        (folder / file).write_text(json.dumps(material), encoding="utf-8")
    path = folder / "spheres.html"
    subprocess.run([make, folder / "fitted.json", folder / "true.json", path], check=True)
    text = path.read_text(encoding="utf-8")
    assert "http://" not in text and "https://" not in text and "@import" not in text
    wrong = folder / "wrong.html"
    assert "0.318309873" in text
    wrong.write_text(text.replace("0.318309873", "0.318313"), encoding="utf-8")

    with Browser(name, *SOFTWARE) as browser:
        with open_page(browser, path) as page:
            assert check_values(page, brdf, folder) < 2e-6
            for figure in range(3):
                check_picture(page, figure)
            check_controls(page)
            check_studio(page)
            assert not page.console, page.console
        with open_page(browser, wrong) as page:  # the check above must see a constant that is wrong in its fifth digit
            assert check_values(page, brdf, folder) > 2e-6
        for width, dark in ((1280, False), (400, True)):
            with open_page(browser, path, width=width, dark=dark) as page:
                assert page.evaluate("document.scrollingElement.scrollWidth") <= width
                assert page.evaluate("figures.every(f => f.querySelector('canvas').getAttribute('aria-label'))")
                drawn = page.evaluate("figures.map(f => pixels(f).filter((v, k) => k % 4 == 3 && v > 0).length)")
                assert all(count > 0.2 * (width / 4) ** 2 for count in drawn), drawn
                page.screenshot(folder / f"spheres_{width}_{'dark' if dark else 'light'}.png")
    with Browser(name, "--disable-3d-apis") as browser, browser.open(path) as page:
        shown = page.evaluate("""[...document.querySelectorAll("figure.sphere")].map(f => ["img.still", ".note", "canvas",
            ".controls"].map(s => f.querySelector(s).getClientRects().length > 0))""")
        assert shown == [[True, True, False, False]] * 3, shown
        assert not page.console, page.console
    print(f"pages of {path.stat().st_size} bytes: {folder}")


main()
