# ctest: validate.browser label=browser timeout=1200 @brdf@ chromium @here@/browser
"""Tests the pages of fit, validate, trade and recommend in a headless browser without a network, at 1280 and 400 pixels, light
and dark. The console must have no message, and no element may be wider than the screen. Every plot and picture must be drawn in
colours that differ from the background. Words are explained by keyboard, and printed pages are dark on white. Screenshots of all
pages are written to FOLDER:
browser_test.py EXECUTABLE BROWSER FOLDER"""
import pathlib
import shutil
import sys

from browser import SOFTWARE, Browser
from html_report import make_pages, plots_of
from paper import check_print

WIDTHS = (1280, 400)

# The content of the page with every fold open: canvases with their pixels, pictures, and elements beyond the edge.
PROBE = """(async () => {
  for (const fold of document.querySelectorAll("details")) fold.open = true;
  const frames = () => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
  for (const sphere of document.querySelectorAll("figure.sphere")) {  // drawn when they come into sight
    sphere.scrollIntoView();
    for (let k = 0; k < 100 && !sphere.dataset.shown; ++k) await frames();
  }
  scrollTo(0, 0);
  await frames();
  const ground = getComputedStyle(document.body).backgroundColor.match(/\\d+/g).slice(0, 3).map(Number);
  const brightness = (r, g, b) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
  const back = brightness(...ground);
  const look = canvas => {
    const box = canvas.getBoundingClientRect();
    const copy = Object.assign(document.createElement("canvas"), {width: canvas.width, height: canvas.height});
    const ctx = copy.getContext("2d", {willReadFrequently: true});
    ctx.drawImage(canvas, 0, 0);
    const pixels = ctx.getImageData(0, 0, canvas.width, canvas.height).data;
    let drawn = 0, clear = 0;
    for (let k = 0; k < pixels.length; k += 4) {
      drawn += pixels[k + 3] > 0;
      clear += pixels[k + 3] > 200 && Math.abs(brightness(pixels[k], pixels[k + 1], pixels[k + 2]) - back) > 60;
    }
    return {id: canvas.id, width: box.width, height: box.height, drawn, clear};
  };
  const canvases = [...document.querySelectorAll("canvas[id]")].map(look);
  const spheres = [...document.querySelectorAll("figure.sphere canvas")].map(look);
  const inBox = element => { while ((element = element.parentElement)) if (element.matches(".scroll")) return true; };
  const wide = [...document.body.querySelectorAll("*")].filter(e => !inBox(e) && !e.matches("[popover]")
      && e.getBoundingClientRect().right > innerWidth + 0.5).map(e => e.outerHTML.slice(0, 120));
  return {canvases, spheres, wide, ground: back, inner: innerWidth, scroll: document.scrollingElement.scrollWidth,
    pictures: [...document.images].filter(image => image.complete && image.naturalWidth > 0).length};
})()"""

# The contrast (WCAG 2) of every kind of text with its background.
CONTRAST = """(() => {
  const linear = c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  const rgb = text => text.match(/[\\d.]+/g).map(Number);
  const luminance = ([r, g, b]) => 0.2126 * linear(r / 255) + 0.7152 * linear(g / 255) + 0.0722 * linear(b / 255);
  const ground = e => { for (; e; e = e.parentElement) { const c = rgb(getComputedStyle(e).backgroundColor);
    if (c.length < 4 || c[3] > 0) return c; } return [255, 255, 255]; };
  let least = [99, ""];
  for (const e of document.body.querySelectorAll("*")) {
    if (![...e.childNodes].some(n => n.nodeType === 3 && n.data.trim()) || e.matches("script")) continue;
    const a = luminance(rgb(getComputedStyle(e).color)), b = luminance(ground(e));
    const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (ratio < least[0]) least = [ratio, e.outerHTML.slice(0, 120)];
  }
  return least;
})()"""


def check_the_probe(browser, folder):
    """Tests the checks themselves: they must find an error on the page, an empty canvas, and an element wider than the screen."""
    path = folder / "broken.html"
    path.write_text("<!DOCTYPE html><html><body><canvas id='c' width='9' height='9'></canvas><hr style='width:900px'>"
                    "<p style='color:#eee'>pale</p><script>undefined_function();</script></body></html>", encoding="utf-8")
    with browser.open(path, 400) as page:
        found = page.evaluate(PROBE)
        assert page.console and found["canvases"][0]["drawn"] == 0, (found, page.console)
        assert found["wide"] and found["scroll"] > 400, found
        assert page.evaluate(CONTRAST)[0] < 1.5


def check_look(page, path, width):
    """Requires that everything is drawn and no element is beyond the edge. Returns the numbers of plots and pictures."""
    text = path.read_text(encoding="utf-8")
    found = page.evaluate(PROBE)
    assert not page.console, (path, page.console)
    assert found["inner"] == width and found["scroll"] <= width, (path, found["inner"], found["scroll"], found["wide"])
    assert not found["wide"], (path, found["wide"])
    plots = plots_of(text)
    assert [c["id"] for c in found["canvases"]] == [f"plot{k}" for k in range(len(plots))], found["canvases"]
    assert len(found["spheres"]) == text.count('class="sphere'), (path, found["spheres"])
    for canvas in found["canvases"] + found["spheres"]:
        assert canvas["width"] > 200 and canvas["height"] > 100, canvas
        assert canvas["drawn"] > 2000 and canvas["clear"] > 200, (path, canvas)
    assert found["pictures"] == text.count("<img "), f"{found['pictures']} pictures shown of {text.count('<img ')}"
    contrast = page.evaluate(CONTRAST)
    assert contrast[0] >= 4.5, (path, contrast)
    return len(plots), found["pictures"], found["ground"]


def check_keyboard(page, path):
    """Requires that Tab reaches the first explained word, Enter shows the explanation, and Escape hides it."""
    page.evaluate("for (const fold of document.querySelectorAll('details')) fold.open = false")
    for _ in range(60):
        page.key("Tab")
        if page.evaluate("document.activeElement.matches('button.term')"):
            break
    assert page.evaluate("document.activeElement.matches('button.term:focus-visible')"), (path, "no word is reached")
    assert page.evaluate("getComputedStyle(document.activeElement).outlineStyle") != "none", path
    shown = "document.querySelectorAll('[popover]:popover-open').length"
    page.key("Enter")
    assert page.evaluate(shown) == 1, (path, "Enter shows nothing")
    page.key("Escape")
    assert page.evaluate(shown) == 0, (path, "Escape hides nothing")


def check_paper(page, path):
    """Requires that printed pages have folds open or left out, and that curves drawn for the dark scheme are dark on white."""
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.scheme(True, "print")
    closed = page.evaluate("document.querySelectorAll('details:not(.commands, .screen):not([open])').length")
    assert closed == 0, (path, closed)
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") in ("rgb(255, 255, 255)", "rgba(0, 0, 0, 0)")
    assert page.evaluate("[...document.querySelectorAll('details.commands, details.screen')].every(e => !e.offsetHeight)"), path
    if page.evaluate("document.querySelector('canvas[id]') !== null"):
        assert page.evaluate("charts[0].options.scales.x.ticks.color") == "#555", path


def check_page(browser, folder, path, most_paper=None):
    """Checks a page, on at most `most_paper` sheets of A4 if it is given."""
    grounds = []
    with browser.open(path) as page:
        sheets = check_print(page, folder, most_paper)
    for width in WIDTHS:
        for dark in (False, True):
            with browser.open(path, width, dark=dark) as page:
                page.screenshot(folder / f"{path.stem}_{width}_{'dark' if dark else 'light'}.png")
                plots, pictures, ground = check_look(page, path, width)
                grounds.append(ground)
                page.scheme(not dark)  # redrawn as the scheme changes
                assert check_look(page, path, width)[2] != ground, path
                check_keyboard(page, path)
                page.scheme(dark)
                check_paper(page, path)
    assert max(grounds) > 250 and min(grounds) < 40, grounds
    print(f"{path.name}: {plots} plots and {pictures} pictures drawn at {WIDTHS}, light and dark; {sheets} sheets of A4")


def main():
    executable, name, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    with Browser(name, *SOFTWARE) as browser:
        check_the_probe(browser, folder)
        for path in make_pages(executable, folder):
            check_page(browser, folder, path)


if __name__ == "__main__":
    main()
