"""The HTML reports in a headless browser without a network: no console message, every plot drawn; screenshots in
FOLDER: browser_test.py EXECUTABLE BROWSER FOLDER"""
import html
import json
import pathlib
import re
import shutil
import subprocess
import sys

from html_report import make_reports, plots_of

# Put into a copy of the report: what the page's canvases hold, as an attribute that --dump-dom shows.
PROBE = """<script>
document.documentElement.dataset.probe = JSON.stringify([...document.querySelectorAll("canvas")].map(canvas => {
  const box = canvas.getBoundingClientRect();
  const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  let drawn = 0;
  for (let k = 3; k < pixels.length; k += 4) drawn += pixels[k] > 0;
  return {id: canvas.id, width: box.width, height: box.height, drawn: drawn};
}));
document.documentElement.dataset.pictures =
  [...document.images].filter(image => image.complete && image.naturalWidth > 0).length;
</script>"""
# Not one address can be reached, and none is looked for.
WORDS = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-sync",
         "--disable-extensions", "--no-first-run", "--hide-scrollbars", "--proxy-server=127.0.0.1:9",
         "--host-resolver-rules=MAP * ~NOTFOUND", "--enable-logging=stderr", "--v=0", "--virtual-time-budget=5000"]


def browse(browser, profile, page, *words):
    done = subprocess.run([browser, *WORDS, f"--user-data-dir={profile}", *words, page.as_uri()], timeout=240,
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout, [line for line in done.stderr.splitlines() if "CONSOLE" in line]


def probe(browser, folder, page):
    """Canvases, pictures and console messages of a page."""
    copy = folder / f"probe_{page.name}"
    text = page.read_text(encoding="utf-8")
    copy.write_text(text.replace("</body>", PROBE + "</body>"), encoding="utf-8")
    dom, console = browse(browser, folder / "profile", copy, "--window-size=1000,1400", "--dump-dom")
    root = re.search(r"<html[^>]*>", dom).group(0)
    found = json.loads(html.unescape(re.search(r'data-probe="([^"]*)"', root).group(1)))
    return found, int(re.search(r'data-pictures="(\d+)"', root).group(1)), console


def check_the_probe(browser, folder):
    """An error on the page must be seen, and a canvas that nobody drew on."""
    page = folder / "broken.html"
    page.write_text("<!DOCTYPE html><html><body><canvas id='c' width='9' height='9'></canvas>"
                    "<script>undefined_function();</script></body></html>", encoding="utf-8")
    canvases, _, console = probe(browser, folder, page)
    assert console and canvases[0]["drawn"] == 0, (canvases, console)


def main():
    executable, browser, folder = sys.argv[1], shutil.which(sys.argv[2]), pathlib.Path(sys.argv[3])
    if not browser:
        sys.exit(f"{sys.argv[2]} is not installed: tools/setup test")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    check_the_probe(browser, folder)
    for page in make_reports(executable, folder):
        text = page.read_text(encoding="utf-8")
        canvases, pictures, console = probe(browser, folder, page)
        assert not console, console
        assert [c["id"] for c in canvases] == [f"plot{k}" for k in range(len(plots_of(text)))], canvases
        for canvas in canvases:
            assert canvas["width"] > 200 and canvas["height"] > 100, canvas
            assert canvas["drawn"] > 2000, canvas
        assert pictures == text.count("<img "), f"{pictures} pictures shown of {text.count('<img ')}"
        shot = folder / f"{page.stem}.png"
        browse(browser, folder / "profile", page, "--window-size=1000,4500", f"--screenshot={shot}")
        assert shot.stat().st_size > 50000, shot
        print(f"{page.name}: {len(canvases)} plots and {pictures} pictures drawn, no console message; {shot}")
    shutil.rmtree(folder / "profile")


main()
