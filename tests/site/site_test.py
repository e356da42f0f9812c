#!/usr/bin/env python3
# ctest: site.links label=style timeout=300 cost=20 needs=plain @here@/links
# ctest: site.browser label=browser timeout=600 needs=plain @here@/browser chromium
"""The web site of the documents: site_test.py FOLDER [BROWSER]

The site is built in FOLDER. Every link of every page leads to a file and to a place of that file, no page
loads anything from another address, and the site is smaller than 17 MB. A document that docs/index.md does
not list and a link to a file that does not exist are errors of tools/site. With BROWSER the site has the
pages of the public headers too. Its first page and the first page of the headers have no message in the
console and nothing wider than the window at 390, 1280 and 1920 pixels, light and dark. No document
is wider than a window of 390 pixels, and the search finds pages. Exit code 77: MkDocs or Doxygen is missing.
"""
import functools
import html.parser
import http.server
import pathlib
import re
import shutil
import subprocess
import sys
import threading
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/validate"))
from browser import Browser

# Attributes that hold an address; all but the first two load a file.
ADDRESSES = {("a", "href"), ("area", "href"), ("link", "href"), ("img", "src"), ("script", "src"),
             ("iframe", "src"), ("source", "src"), ("source", "srcset"),
             ("object", "data"), ("video", "src"), ("use", "href")}


class Page(html.parser.HTMLParser):
    """The names of the places of a page, and its addresses as (tag, address)."""

    def __init__(self, path):
        super().__init__()
        self.places, self.addresses = set(), []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (tag == "a" and name == "name"):
                self.places.add(value)
            if (tag, name) in ADDRESSES and value:
                self.addresses.append((tag, value))


def faults_of(site):
    """Returns a sentence for each dead link and for each load from another machine, and the number of links."""
    pages = {path: Page(path) for path in sorted(site.rglob("*.html"))}
    faults, looked_at = [], 0
    for path, page in pages.items():
        for tag, address in page.addresses:
            parts = urllib.parse.urlsplit(address)
            here = path.relative_to(site)
            if parts.scheme or parts.netloc:
                if tag not in ("a", "area") and parts.scheme != "data":
                    faults.append(f"{here}: <{tag}> loads {address}")
                continue
            looked_at += 1
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if target.is_dir():
                target = target / "index.html"
            if not target.is_file():
                faults.append(f"{here}: {address}: there is no such file")
            elif parts.fragment and target in pages and parts.fragment != "__skip" and \
                    urllib.parse.unquote(parts.fragment) not in pages[target].places:
                faults.append(f"{here}: {address}: {target.name} has no such place")
    for path in site.rglob("*.css"):
        text = path.read_text(encoding="utf-8")
        for found in re.findall(r"""url\(\s*["']?([^"')]+)|@import\s+["']([^"']+)""", text):
            address = "".join(found)
            file = path.parent / address.split("?")[0]
            if re.match(r"https?:|//", address):
                faults.append(f"{path.relative_to(site)}: the style loads {address}")
            elif not address.startswith(("data:", "#")) and not file.is_file():
                faults.append(f"{path.relative_to(site)}: {address}: there is no such file")
    for path in site.rglob("*.js"):
        text = path.read_text(encoding="utf-8")
        for address in re.findall(r"""["'`](https?://(?:\$\{|[\w-]+\.)[^"'`]*)""", text):
            faults.append(f"{path.relative_to(site)}: the script names {address}")
    return faults, looked_at


def check_that_faults_are_found(folder):
    """Requires that each kind of fault is reported for a site with this fault."""
    folder.mkdir()
    (folder / "a.html").write_text('<p id="here"><a href="#here"></a><a href="b.html#there"></a>'
                                   '<a href="c.html"></a><a href="https://example.org"></a>'
                                   '<img src="https://example.org/x.png">')
    (folder / "b.html").write_text('<script src="//example.org/x.js"></script>')
    (folder / "a.css").write_text("@import 'https://example.org/a.css'; p { background: url(none.png) }")
    (folder / "a.js").write_text("load('https://example.org/x.js'); // https://example.org")
    faults, looked_at = faults_of(folder)
    assert len(faults) == 7 and looked_at == 3, faults


def check_errors(folder):
    """Runs tools/site on a copy of the documents with one planted fault."""
    for name, text, expected in (
            ("docs/strange.md", "# Strange\n", "docs/strange.md: no section of docs/index.md links to"),
            ("docs/tour.md", "# Tour\n\nSee [this](no.md).\n", "docs/tour.md, line 3: the link no.md")):
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(ROOT / "docs", folder / "docs")
        for copied in [*ROOT.glob("*.md"), ROOT / "CITATION.cff"]:
            shutil.copy(copied, folder)
        shutil.copytree(ROOT / "examples", folder / "examples")
        for part in ("tools", "packaging"):
            (folder / part).mkdir()
        shutil.copy(ROOT / "tools/site", folder / "tools/site")
        shutil.copy(ROOT / "packaging/org.brdf.view.svg", folder / "packaging")
        (folder / name).write_text(text)
        done = subprocess.run([folder / "tools/site", "--without-api"], capture_output=True, text=True,
                              check=False)
        assert done.returncode == 2 and expected in done.stderr, done
        assert not (folder / "build/site").exists()


def check_in_browser(site, name):
    class Quiet(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(site)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_address[1]}"
    backgrounds = set()
    for dark in (False, True):
        # The page keeps the first choice of colours, so that each browser is new.
        with Browser(name, server="127.0.0.1") as browser:
            for first in ("index.html", "readme.html", "api/index.html"):
                for width in (390, 1280, 1920):
                    with browser.open(f"{address}/{first}", width, 900, dark) as page:
                        page.evaluate("new Promise(done => setTimeout(done, 300))")
                        shot = f"{first.replace('/', '_')}_{width}_{'dark' if dark else 'light'}.png"
                        page.screenshot(site.parent / shot, whole=False)
                        assert not page.console, (first, width, dark, page.console)
                        assert page.evaluate("document.links.length") > 5, first
                        scrolled = page.evaluate("document.scrollingElement.scrollWidth")
                        assert scrolled <= width, (first, width, scrolled)
                        if first == "index.html":
                            backgrounds.add(page.evaluate("getComputedStyle(document.body).backgroundColor"))
            for path in sorted(site.glob("**/*.html")) if not dark else ():
                document = path.relative_to(site).as_posix()
                if document.startswith("api/"):
                    continue
                with browser.open(f"{address}/{document}", 390, 900) as page:
                    scrolled = page.evaluate("document.scrollingElement.scrollWidth")
                    assert scrolled <= 390 and not page.console, (document, scrolled, page.console)
            with browser.open(f"{address}/index.html?q=reciprocity", 1280, 900, dark) as page:
                page.wait("document.querySelectorAll('.md-search-result__item').length > 2")
                assert not page.console, page.console
    assert len(backgrounds) == 2, backgrounds
    server.shutdown()


def main():
    folder, browser = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2] if len(sys.argv) > 2 else None
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    site = folder / "site"
    done = subprocess.run([ROOT / "tools/site", "--output", site, *([] if browser else ["--without-api"])],
                          capture_output=True, text=True, check=False)
    if done.returncode == 3:
        print("skipped:", done.stderr)
        sys.exit(77)
    assert done.returncode == 0, done
    print(done.stdout.strip())
    check_that_faults_are_found(folder / "faults")
    faults, looked_at = faults_of(site)
    assert not faults and looked_at > 2000, (looked_at, faults[:20])
    size = sum(p.stat().st_size for p in site.rglob("*") if p.is_file())
    assert 1e6 < size < 17e6, size
    records = (site / "records.html").read_text(encoding="utf-8")
    for record in (ROOT / "docs/decisions").glob("*.md"):
        assert f'id="{record.name[:5]}' in records, record.name
    if browser:
        check_in_browser(site, browser)
    else:
        check_errors(folder / "copy")
    print(f"{looked_at} links")


main()
