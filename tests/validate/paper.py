"""Checks a page as it is printed: Chromium writes a PDF, pdftotext of poppler gives the position of every word, and pdftoppm the pixels.

    check_print(page, folder, most=6)     # a page of browser.py, on A4; the pages of the PDF that it took
"""
import base64
import html
import pathlib
import re
import shutil
import subprocess
import sys

DOTS = 72  # per inch: a pixel is a point
HEADINGS = """[...document.querySelectorAll("h1, h2, h3, p.title")]
  .filter(e => e.offsetHeight && !e.closest("details.screen")).map(e => e.innerText).filter(text => text.trim())"""
HIDE = "document.head.append(Object.assign(document.createElement('style'), {textContent: '.chart canvas { visibility: hidden; }'}))"


def write_pdf(page, path):
    data = page.ask("Page.printToPDF", paperWidth=8.27, paperHeight=11.69, preferCSSPageSize=False)["data"]
    path.write_bytes(base64.b64decode(data))


def words_of(path):
    """Returns for each page its words as (text, left, top, right, bottom) in points."""
    text = subprocess.run(["pdftotext", "-bbox", path, "-"], check=True, capture_output=True, text=True).stdout
    row = re.compile(r'<word xMin="([\d.]+)" yMin="([\d.]+)" xMax="([\d.]+)" yMax="([\d.]+)">(.*?)</word>')
    return [[(html.unescape(m[5]), *map(float, m.groups()[:4])) for m in row.finditer(part)]
            for part in text.split("<page ")[1:]]


def pixels_of(path, folder):
    """Returns for each page its width and its rows of grey bytes."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    subprocess.run(["pdftoppm", "-r", str(DOTS), "-gray", path, folder / "p"], check=True)
    pages = []
    for file in sorted(folder.glob("p*.pgm")):
        data = file.read_bytes()
        head = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", data)
        width = int(head[1])
        pages.append([data[k : k + width] for k in range(head.end(), len(data), width)])
    return pages


def ink(rows, box):
    """Returns the grey values inside a box of points, row by row."""
    left, top, right, bottom = (int(round(x)) for x in box)
    return [row[max(left, 0) : right] for row in rows[max(top, 0) : bottom]]


def found(words, heading):
    """Returns the boxes of words that follow one another as in the heading; a long word may be broken."""
    wanted = "".join(heading.split())
    for k in range(len(words)):
        text, end = "", k
        while end < len(words) and len(text) < len(wanted) and wanted.startswith(text):
            text += words[end][0]
            end += 1
        if text == wanted:
            part = words[k:end]
            yield (min(w[1] for w in part), min(w[2] for w in part), max(w[3] for w in part), max(w[4] for w in part))


def same(a, b):
    """Returns whether both have the same amount of ink, except for the smoothing of letters, which may be shifted by a fraction of a pixel."""
    dark = [sum(255 - value for row in part for value in row) for part in (a, b)]
    return abs(dark[0] - dark[1]) <= 0.1 * max(dark)


def faults_of(headings, pages, drawn, without_charts):
    """Returns a sentence for every heading that is missing, painted over, or alone at the foot of its page."""
    faults = []
    for heading in dict.fromkeys(headings):
        places = [(k, box) for k, words in enumerate(pages) for box in found(words, heading)]
        count = headings.count(heading)
        if len(places) < count:
            faults.append(f"{heading!r}: {len(places)} of {count} on paper")
        for k, box in sorted(places, key=lambda place: place[1][1] - place[1][3])[:count]:  # tables hold smaller ones
            if not same(ink(drawn[k], box), ink(without_charts[k], box)):
                faults.append(f"page {k + 1}: {heading!r} is painted over")
            below = ink(drawn[k], (box[0], box[3] + 1, box[0] + 150, box[3] + 60))
            if all(value > 200 for row in below for value in row):
                faults.append(f"page {k + 1}: nothing follows {heading!r}")
    return faults


def check_print(page, folder, most=None):
    if not shutil.which("pdftotext"):
        sys.exit("pdftotext is not installed: tools/setup full")
    folder = pathlib.Path(folder)
    headings = page.evaluate(HEADINGS)
    write_pdf(page, folder / "paper.pdf")
    page.evaluate(HIDE)
    write_pdf(page, folder / "paper_without_charts.pdf")
    pages = words_of(folder / "paper_without_charts.pdf")  # charts hold words too
    faults = faults_of(headings, pages, pixels_of(folder / "paper.pdf", folder / "paper"),
                       pixels_of(folder / "paper_without_charts.pdf", folder / "paper_without_charts"))
    assert not faults, faults
    assert most is None or len(pages) <= most, f"{len(pages)} pages of paper, {most} at most"
    return len(pages)
