# ctest: study.browser label=browser timeout=600 @brdf@ chromium @here@/browser
"""Tests the pages of a study in a headless browser: the checks of tests/validate/browser_test.py for every page, sorting the
overview by click and by keyboard, its links and its small pictures. pages_test.py EXECUTABLE BROWSER FOLDER"""
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "validate"))
from browser import SOFTWARE, Browser
from browser_test import check_page

NAMES = "[...document.querySelectorAll('tbody tr')].map(row => row.cells[0].textContent.trim())"
SORT = "[...document.querySelectorAll('th')].find(head => head.textContent.includes('median')).querySelector('button.sort')"

SPHERE = """(async () => {
  const figure = document.querySelector("figure.sphere.measured");
  figure.scrollIntoView();
  for (let k = 0; k < 200 && !figure.dataset.shown; ++k) await new Promise(done => setTimeout(done, 50));
  return figure.dataset.shown ?? "nothing";
})()"""


def make_study(executable, folder):
    def run(*words, expected=0):
        done = subprocess.run([executable, *words], cwd=folder, capture_output=True, text=True, check=False)
        assert done.returncode == expected, (words, done.returncode, done.stderr)

    grid = ["--theta-i", "10,40", "--step", "10", "--noise", "0.02", "-o"]
    run("synth", "--form", "cook_torrance", "--set", "kd=0.3,0.2,0.1", *grid, "paint.csv")
    run("synth", "--form", "oren_nayar", *grid, "chalk #1.csv")
    (folder / "broken.csv").write_text("theta_i,phi_i,theta_o,phi_o,f\n1,2,x,4,5\n")
    run("study", "chalk #1.csv", "paint.csv", "broken.csv", "--form", "oren_nayar", "-o", "study", expected=1)
    run("study", "chalk #1.csv", "--form", "oren_nayar", "--tolerance", "90%", "-o", "one")
    return folder / "study"


def check_overview(browser, study):
    with browser.open(study / "index.html") as page:
        before = page.evaluate(NAMES)
        assert before == ["broken", "paint", "chalk #1"], before  # worst first
        page.evaluate(SORT + ".click()")
        up = page.evaluate(NAMES)
        page.evaluate(SORT + ".focus()")
        page.key("Enter")
        down = page.evaluate(NAMES)
        assert up == ["chalk #1", "paint", "broken"] and down == ["paint", "chalk #1", "broken"], (up, down)
        links = page.evaluate("[...document.querySelectorAll('tbody a')].map(a => decodeURI(a.pathname))")
        assert links and all(pathlib.Path(link.replace("%23", "#")).is_file() for link in links), links
        nameless = page.evaluate("[...document.links].filter(a => !a.textContent.trim() && !a.querySelector('img[alt]:not([alt=\"\"])')).length")
        assert nameless == 0, nameless


TOLERANCE = """(value => {
  const box = document.querySelector(".tolerance"), input = box.querySelector("input"), verdict = box.querySelector("output");
  if (value !== null) { input.value = value; input.dispatchEvent(new Event("input")); }
  return [verdict.className, verdict.textContent, box.querySelector(".share").textContent];
})"""


def check_first_screen(browser, folder):
    """Facts, the tolerance judged again by the page itself, in the words of the program, and the next step."""
    written = (folder / "index.html").read_text(encoding="utf-8")
    with browser.open(folder / "index.html") as page:
        facts = page.evaluate("[...document.querySelectorAll('.facts li')].map(e => e.textContent)")
        assert len(facts) == 6 and facts[2] == "date: not stated", facts
        assert facts[5].endswith("measurements, 2 angles of incidence, 10 to 40\u00b0"), facts
        kind, said, share = page.evaluate(TOLERANCE + "(null)")
        assert kind == "good" and said and f">{said}</output>" in written, (kind, said)
        assert share.endswith("% of the measured values have an error of at most 90 %."), share
        kind, said, share = page.evaluate(TOLERANCE + "('0.0001')")
        assert kind == "bad" and said.startswith("Outside the tolerance") and share.startswith("0 %"), (kind, said, share)
        kind, said, _ = page.evaluate(TOLERANCE + "('')")
        assert kind == "" and said.startswith("Enter a tolerance"), (kind, said)
        assert page.evaluate("document.querySelector('.next code').textContent").startswith("brdf view material.json")
        assert not page.console, page.console


CURVES = "charts[0].data.datasets.map((set, k) => chartVisible(k)).filter(Boolean).length"


def check_charts(browser, folder):
    """The legend switches curves, and both files can be saved from a page that was opened as a file."""
    with browser.open(folder / "index.html") as page:
        page.evaluate("globalThis.chartVisible = (k) => charts[0].isDatasetVisible(k)")
        before = page.evaluate(CURVES)
        page.evaluate("document.querySelector('.legend button').focus()")
        page.key("Enter")
        assert page.evaluate("document.querySelector('.legend button').ariaPressed") == "false"
        assert page.evaluate(CURVES) < before, before
        note = page.evaluate("document.querySelector('.save .shown').textContent")
        assert note.startswith("1 of 2 angles of incidence shown"), note
        page.evaluate("document.dispatchEvent(new Event('scheme'))")  # drawn again, as it was
        assert page.evaluate(CURVES) < before
        svg = page.evaluate("svgOf(charts[0], plots[0])")
        assert page.evaluate("new DOMParser().parseFromString(svgOf(charts[0], plots[0]), 'image/svg+xml').querySelector('parsererror')") is None
        assert svg.count("<polyline") == 1 and "viewing angle theta_o" in svg and plots_title(page) in svg, svg[:400]
        rows = page.evaluate("csvOf(plots[0])").strip().split("\n")
        assert rows[0].startswith("curve,") and len(rows) > 20, rows[:3]
        assert any(row.startswith('"measured, incidence at 10 degrees"') for row in rows), rows[:3]
        saved = page.evaluate("""(() => { let name = ""; const click = HTMLAnchorElement.prototype.click;
          HTMLAnchorElement.prototype.click = function () { name = this.download + " " + this.href.slice(0, 5); };
          document.querySelectorAll(".save button")[1].click(); HTMLAnchorElement.prototype.click = click; return name; })()""")
        assert saved.endswith(".csv blob:"), saved
        assert not page.console, page.console


def plots_title(page):
    return page.evaluate("plots[0].title")


def check_filter(browser, folder):
    """A long table is filtered by its words and by its marks."""
    rows = "".join(f"<tr><td>name {k}</td><td class='{'bad' if k % 3 == 0 else 'good'}'>word</td></tr>" for k in range(9))
    page_text = (folder / "index.html").read_text(encoding="utf-8")
    body = page_text.index("<tbody>") + len("<tbody>")
    path = folder / "filtered.html"
    path.write_text(page_text[:body] + rows + page_text[page_text.index("</tbody>"):], encoding="utf-8")
    shown = "[...document.querySelector('table.sortable tbody').rows].filter(row => !row.hidden).length"
    with browser.open(path) as page:
        assert page.evaluate(shown) == 9
        page.evaluate("document.querySelector('.filter button').click()")
        assert page.evaluate(shown) == 3
        page.evaluate("document.querySelector('.filter button').click()")
        page.evaluate("(e => { e.value = 'name 7'; e.dispatchEvent(new Event('input')); })(document.querySelector('.filter input'))")
        assert page.evaluate(shown) == 1
        assert page.evaluate("document.querySelector('.filter output').textContent") == "1 of 9 rows"
        assert not page.console, page.console
    path.unlink()


def check_sphere(browser, folder):
    """Requires that the sphere replaces the picture by its own drawing."""
    with browser.open(folder / "index.html") as page:
        shown = page.evaluate(SPHERE)
        assert shown == "fitted measured difference", shown
        assert not page.console, page.console


LOBE = """(async (press) => {
  const figure = document.querySelector("figure.body"), canvas = figure.querySelector("canvas");
  canvas.scrollIntoView();
  canvas.focus();
  if (press) canvas.dispatchEvent(new KeyboardEvent("keydown", { key: press }));
  await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
  // A browser may draw a canvas differently once its pixels have been read: a copy is read instead.
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
  copy.drawImage(canvas, 0, 0);
  const bytes = copy.getImageData(0, 0, canvas.width, canvas.height).data;
  const orange = bytes.reduce((sum, v, k) => sum + (k % 4 === 0 && v === 255 && bytes[k + 1] === 140), 0);
  return [getComputedStyle(figure.querySelector("img")).display, orange, bytes.reduce((sum, v) => sum + v, 0)];
})"""


def check_lobe(browser, folder):
    """The lobe is drawn in place of its picture, with dots of measurements; the keyboard turns it and turns it back."""
    with browser.open(folder / "index.html") as page:
        picture, dots, first = page.evaluate(LOBE + "('Home')")
        assert picture == "none" and dots > 100, (picture, dots)
        turned = page.evaluate(LOBE + "('ArrowLeft')")[2]
        back = page.evaluate(LOBE + "('Home')")[2]
        assert turned != first and back == first, (first, turned, back)
        assert not page.console, page.console


def main():
    executable, name, folder = str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2], pathlib.Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    study = make_study(executable, folder)
    with Browser(name, *SOFTWARE) as browser:
        check_overview(browser, study)
        check_filter(browser, study)
        check_first_screen(browser, folder / "one")
        check_charts(browser, folder / "one")
        check_sphere(browser, study / "paint")
        check_lobe(browser, study / "paint")
        for page in (study, study / "paint", folder / "one"):
            shots = folder / f"pictures_{page.name}"
            shots.mkdir()
            check_page(browser, shots, page / "index.html", most_paper=6)


main()
