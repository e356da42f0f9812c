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
    run("study", "chalk #1.csv", "--form", "oren_nayar", "-o", "one")
    return folder / "study"


def check_overview(browser, study):
    with browser.open(study / "index.html") as page:
        before = page.evaluate(NAMES)
        assert before == ["chalk #1", "paint", "broken"], before
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


def check_sphere(browser, folder):
    """Requires that the sphere replaces the picture by its own drawing."""
    with browser.open(folder / "index.html") as page:
        shown = page.evaluate(SPHERE)
        assert shown == "fitted measured difference", shown
        assert not page.console, page.console


def main():
    executable, name, folder = str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2], pathlib.Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    study = make_study(executable, folder)
    with Browser(name, *SOFTWARE) as browser:
        check_overview(browser, study)
        check_sphere(browser, study / "paint")
        for page in (study, study / "paint", folder / "one"):
            shots = folder / f"pictures_{page.name}"
            shots.mkdir()
            check_page(browser, shots, page / "index.html", most_paper=6)


main()
