#!/usr/bin/env python3
# ctest: browser.page label=wasm timeout=1800 serial chromium @source@/build/wasm/browser @source@/data/synthetic @npm@ @here@/page
"""page_test.py CHROMIUM PAGE TABLES NPM FOLDER: uses the page of the room browser as a person does, from a disk (PAGE/brdf.html) and
from a web server (PAGE/site). Tables are dropped, chosen, queued, cancelled and refused; results are shown next to each other,
downloaded and linked; everything is done by keyboard; the browser refuses every connection; the page answers while a table of 100,000
rows is fitted. The console must be empty. Screenshots are written to FOLDER. Exit code 77: the page has not been built."""
import json
import pathlib
import shutil
import sys
import time

from page_driver import (SOFTWARE, Browser, Server, choose, drop, frame_value, large_table, opened, states, tab_to, text_of,
                         wait_for_states)
from page_look import check_look

MOST_BLOCKED = 100  # milliseconds


def is_new(name):
    return f"document.querySelector('.pane h3')?.textContent === {json.dumps(name)}"


def show_in_catalogue(page):
    """Clicks the button of the first result, which appears when the material has been read."""
    button = "[...document.querySelectorAll('.pane button')].find(b => b.textContent.includes('catalogue'))"
    page.wait(f"{button} !== undefined")
    page.evaluate(f"{button}.click()")


def check_tables(browser, address, tables, folder):
    """Drops and chooses tables: the second waits in the queue, the results have a verdict, a command, files and a report."""
    with browser.open(address) as page:  # the program may not be loaded yet
        drop(page, *((name, (tables / name).read_text()) for name in ("phong_sparse.csv", "lambert.csv")))
        assert len(states(page)) == 2 and states(page)[1] == "waits", states(page)
        page.wait("!document.getElementById('cancel').hidden")
        page.wait("document.querySelector('#queue .first')?.textContent.endsWith('The report is being made.')")
        choose(page, tables / "ward.csv")
        page.wait("document.querySelectorAll('#queue li').length === 3")
        wait_for_states(page, "fitted", "fitted", "fitted")
        assert page.evaluate("document.querySelector('#queue .first') === null")
        page.wait(is_new("ward.csv"))
        assert "ward" in text_of(page, ".pane .verdict") and page.evaluate("document.querySelector('.pane .verdict.good') !== null")
        assert text_of(page, ".pane pre") == "brdf study ward.csv --form all --output studied", text_of(page, ".pane pre")
        assert frame_value(browser, page, "document.querySelectorAll('canvas[id]').length > 3 && charts.length") >= 4
        assert frame_value(browser, page, "document.body.textContent.includes('No lobes: this build has no renderer')")
        check_downloads(browser, page, folder)
        check_paper(page)
        page.evaluate("(right => { right.value = '0'; right.dispatchEvent(new Event('change')); })(document.getElementById('right'))")
        assert page.evaluate("[...document.querySelectorAll('.pane h3')].map(h => h.textContent)") == ["ward.csv", "phong_sparse.csv"]
        check_link_of_fit(browser, page, address)
        check_refusals(page)
        assert not page.console, page.console


def check_downloads(browser, page, folder):
    """Saves two files as a person does, the second through a link within the report."""
    saved = folder / "saved"
    shutil.rmtree(saved, ignore_errors=True)
    saved.mkdir(parents=True)
    browser.ask("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(saved))
    page.evaluate("document.querySelector('.pane .downloads a[data-file=\"material.json\"]').click()")
    frame_value(browser, page, "(link => { link.click(); return true; })(document.querySelector('a[href=\"material.glsl\"]'))")
    deadline = time.monotonic() + 20
    while not all((saved / name).exists() for name in ("ward_material.json", "ward_material.glsl")):
        assert time.monotonic() < deadline, list(saved.iterdir())
        time.sleep(0.1)
    assert json.loads((saved / "ward_material.json").read_text())["form"] == "ward"


def check_paper(page):
    """On paper the report is shown whole: its frame is as high as its text, which is higher than a screen."""
    height = "document.querySelector('.pane iframe').clientHeight"
    page.wait("parseInt(document.querySelector('.pane iframe').style.getPropertyValue('--height')) > 2000")
    on_screen = page.evaluate(height)
    page.ask("Emulation.setEmulatedMedia", media="print")
    assert page.evaluate(height) > 2000 > on_screen, (page.evaluate(height), on_screen)
    page.ask("Emulation.setEmulatedMedia", media="")


def check_link_of_fit(browser, page, address):
    """Shows a fitted material in the catalogue, and opens its permanent link in another tab."""
    show_in_catalogue(page)
    page.wait("document.querySelectorAll('#plots svg').length === 2 && location.hash !== ''")
    link = page.evaluate("location.hash")
    page.wait(f"document.getElementById('permanent_link').value.endsWith({json.dumps(link)})")
    with opened(browser, address + link) as other:
        other.wait("document.querySelectorAll('#plots svg').length === 2")
        assert other.evaluate("document.getElementById('permanent_link').value") == page.evaluate("document.getElementById('permanent_link').value")
        assert not text_of(other, "#link_fault") and not other.console, (text_of(other, "#link_fault"), other.console)


def check_refusals(page):
    """Files that are no tables give a sentence with their name, and no older result stays."""
    for name, content in (("empty.csv", ""), ("broken.csv", "theta_i,theta_o\nnot,numbers\n"), ("readme.txt", "no table\n")):
        assert text_of(page, "#refusal") or page.evaluate("document.querySelectorAll('.pane').length") == 2
        drop(page, (name, content))
        page.wait(f"document.getElementById('refusal').textContent.includes({json.dumps(name)})")
        assert page.evaluate("document.querySelectorAll('.pane').length") == 0, "an older result stays"
        assert states(page)[-1] == "refused" and len(text_of(page, "#refusal")) > len(name) + 10, text_of(page, "#refusal")
        assert text_of(page, "#queue li:last-child .refused") in text_of(page, "#refusal"), "the sentence is not in the queue"
    page.evaluate("(left => { left.value = '1'; left.dispatchEvent(new Event('change')); })(document.getElementById('left'))")
    page.wait(is_new("lambert.csv"))
    assert not text_of(page, "#refusal")


def check_catalogue(browser, address):
    """Moves a slider; the link holds the value. Broken links give a sentence."""
    with opened(browser, address + "#form=ward&kd=0.2&ks=0.1&alpha_x=0.3&alpha_y=0.1") as page:
        page.wait("document.querySelectorAll('#plots svg').length === 2")
        assert page.evaluate("document.getElementById('kd_0').value") == "0.2"
        before = page.evaluate("document.querySelector('#plots .curve').getAttribute('d')")
        page.evaluate("(n => { n.value = '0.4'; n.dispatchEvent(new Event('input')); })(document.getElementById('kd_0'))")
        page.wait(f"document.querySelector('#plots .curve').getAttribute('d') !== {json.dumps(before)}")
        assert page.evaluate("location.hash") == "#form=ward&kd=0.4&ks=0.1&alpha_x=0.3&alpha_y=0.1", page.evaluate("location.hash")
        page.evaluate("document.getElementById('channels').click()")
        page.wait("document.querySelectorAll('#plots figure:first-child .curve').length === 3")
        assert "kd=0.4,0.4,0.4" in page.evaluate("decodeURIComponent(location.hash)")
        for link, words in (("#form=wardd", 'no form "wardd"'), ("#form=ward&kd=x", "kd=x is not a number"), ("#form=ward&kd=-1", "kd is -1"),
                            ("#form=ward&colour=1", 'no parameter "colour"'), ("#FORM=ward", "begins with #form="),
                            ("#form=ward&kd=0.1&kd=0.2", "states kd twice"), ("#material=e30x!", "cut off")):
            page.evaluate(f"location.hash = {json.dumps(link)}")
            page.wait(f"document.getElementById('link_fault').textContent.includes({json.dumps(words)})")
        page.evaluate("location.hash = '#form=ward&kd=0.1'")
        page.wait("document.getElementById('link_fault').textContent === ''")
        assert not page.console, page.console


def check_slider_ends(browser, address):
    """Moves sliders to their ends: every value is possible. Unknown albedos are gaps, and no value above 1 is claimed of rounding."""
    with opened(browser, address + "#form=oren_nayar&rho=0.5&sigma=0.3") as page:
        page.wait("document.querySelectorAll('#plots svg').length === 2")
        page.evaluate("(s => { s.value = s.max; s.dispatchEvent(new Event('input')); })(document.querySelectorAll('#sliders [type=range]')[1])")
        page.wait("document.getElementById('permanent_link').value.includes('sigma=1.57079')")
        assert page.evaluate("document.querySelectorAll('#plots svg').length") == 2, text_of(page, "#material_state")
        page.evaluate("location.hash = '#form=ward&kd=0.5&ks=0.5&alpha_x=0.3&alpha_y=0.0001'")
        page.wait("document.querySelector('#plots figcaption').textContent.includes('are unknown, which are gaps')")
        page.evaluate("location.hash = '#form=phong&kd=0&ks=1&exponent=0'")
        page.wait("document.querySelector('#plots svg').getAttribute('aria-label').includes('to 1 at')")
        assert "reflects more light" not in text_of(page, "#plots figcaption"), text_of(page, "#plots figcaption")
        page.evaluate("location.hash = '#form=ward_duer&kd=1&ks=1&alpha_x=0.5&alpha_y=0.5'")
        page.wait("document.querySelector('#plots figcaption').textContent.includes('reflects more light')")
        page.evaluate("location.hash = '#form=matt_2&w000=0&w111=-0.5'")
        page.wait("document.querySelector('#plots figure:last-child figcaption').textContent.includes('values below 0 are drawn at 0')")
        assert page.evaluate("document.querySelector('#plots svg').getAttribute('aria-label')").startswith("No albedo is known at 19 angles")
        page.evaluate("location.hash = '#form=ward&kd=-3'")
        page.wait("document.getElementById('link_fault').textContent !== ''")
        page.evaluate("history.back()")
        page.wait("document.getElementById('link_fault').textContent === ''")
        assert not page.console, page.console


def check_settings(browser, address, tables):
    """Fits two chosen forms with a tolerance that is not met. Channels of other names than r, g, b keep them in the catalogue."""
    with opened(browser, address) as page:
        page.evaluate("""(() => {
          document.querySelector('input[name=models][value=chosen]').click();
          document.querySelectorAll('#forms input').forEach(box => { box.checked = ['phong', 'ward'].includes(box.value); });
          document.getElementById('tolerance').value = '0.1';
        })()""")
        drop(page, ("phong_sparse.csv", (tables / "phong_sparse.csv").read_text()))
        wait_for_states(page, "fitted, outside the tolerance")
        command = text_of(page, ".pane pre")
        assert command == "brdf study phong_sparse.csv --form phong,ward --tolerance 0.001 --output studied", command
        page.evaluate("document.querySelector('input[name=models][value=all]').click(); document.getElementById('tolerance').value = ''")
        rows = "".join(f"{t},0,{o},{phi},0.1,0.2,0.3\n" for t in (10, 50) for o in (0, 20, 40, 60) for phi in (0, 180))
        drop(page, ("named.csv", "theta_i,phi_i,theta_o,phi_o,b,g,r\n" + rows))
        wait_for_states(page, "fitted, outside the tolerance", "fitted")
        show_in_catalogue(page)
        page.wait("location.hash.startsWith('#material=')")
        assert not page.console, page.console


def check_keyboard(browser, address):
    """Fits an example, shows its material and moves a slider with keys alone."""
    with opened(browser, address) as page:
        tab_to(page, "#files")
        tab_to(page, "[data-example='phong_sparse.csv']")
        page.key("Enter")
        wait_for_states(page, "fitted")
        tab_to(page, ".pane .command button")
        tab_to(page, ".pane .downloads a")
        tab_to(page, ".pane > .fields button")
        page.key("Enter")
        page.wait("document.querySelectorAll('#plots svg').length === 2")
        link = page.evaluate("location.hash")
        tab_to(page, "#sliders input[type='range']")
        page.key("ArrowRight")
        page.wait(f"location.hash !== {json.dumps(link)}")
        assert not page.console, page.console


def check_cancel(browser, address, large):
    """Cancels a fit: the next table is fitted by a new worker, and the catalogue waits and then answers."""
    with opened(browser, address) as page:
        drop(page, ("large.csv", large), ("small.csv", pathlib.Path(sys.argv[3], "phong_sparse.csv").read_text()))
        page.wait("!document.getElementById('cancel').hidden")
        page.evaluate("document.getElementById('channels').click()")
        page.wait("document.getElementById('material_state').textContent.includes('wait')")
        page.evaluate("document.getElementById('cancel').click()")
        assert page.evaluate("document.activeElement.id") == "files"
        wait_for_states(page, "cancelled", "fitted")
        page.wait("document.querySelectorAll('#plots figure:first-child .curve').length === 3")
        assert text_of(page, "#material_state") == "" and not page.console, page.console


def check_too_large(browser, address):
    """A file beyond the memory of the page is refused before it is read, with its size."""
    with opened(browser, address) as page:
        page.evaluate("""(() => { const part = new Blob([new Uint8Array(2 ** 26)]), data = new DataTransfer();
          data.items.add(new File(Array(16).fill(part), "huge.csv"));
          document.body.dispatchEvent(new DragEvent("drop", {dataTransfer: data, bubbles: true, cancelable: true})); })()""")
        wait_for_states(page, "refused")
        assert "has 1073741824 bytes, more than the memory" in text_of(page, "#refusal"), text_of(page, "#refusal")


def check_without_program(browser, built, folder):
    """A server that lacks a part of the program: a table that waits and a table that comes later are refused with the reason."""
    lacking = folder / "lacking"
    shutil.rmtree(lacking, ignore_errors=True)
    shutil.copytree(built / "site", lacking, ignore=shutil.ignore_patterns("brdf.wasm"))
    server = Server(lacking)
    with browser.open(server.address + "index.html") as page:
        drop(page, ("early.csv", "text"))
        wait_for_states(page, "refused")
        drop(page, ("late.csv", "text"))
        wait_for_states(page, "refused", "refused")
        assert "brdf.wasm: the server answers 404" in text_of(page, "#queue li:last-child .refused"), text_of(page, "#queue")
    server.close()


def check_answers(browser, address, large):
    """Requires that no task blocks the page for longer than MOST_BLOCKED while a large table is read, fitted and shown."""
    with opened(browser, address) as page:
        page.evaluate(f"""window.large = new File([{json.dumps(large)}], "large.csv"); window.tasks = [];
          new PerformanceObserver(list => tasks.push(...list.getEntries().map(e => e.duration))).observe({{type: "longtask"}});
          setTimeout(() => {{ const end = performance.now() + 150; while (performance.now() < end); }}, 50); 0""")
        page.wait("tasks.length > 0 && tasks[0] > 140")  # the observer sees a task that blocks
        page.evaluate("""tasks.length = 0; (() => { const data = new DataTransfer(); data.items.add(large);
          document.body.dispatchEvent(new DragEvent("drop", {dataTransfer: data, bubbles: true, cancelable: true})); })()""")
        begin = time.monotonic()
        wait_for_states(page, "fitted")
        seconds = time.monotonic() - begin
        time.sleep(3)  # the report is drawn
        longest = page.evaluate("Math.max(0, ...tasks)")
        assert longest <= MOST_BLOCKED, f"the page was blocked for {longest} ms"
        blocked = f"blocked for at most {longest:.0f} ms" if longest else "never blocked for 50 ms"  # the observer's threshold
        print(f"{large.count(chr(10)) - 1} rows in {seconds:.1f} s; the page was {blocked}")


def check_silence(browser, address, server, tables):
    """Requires that fits send no request, and that the browser refuses a request of the page and of a worker."""
    with browser.open("about:blank") as page:
        page.ask("Network.enable")
        page.ask("Page.navigate", url=address)
        page.wait("document.getElementById('version')?.textContent.startsWith('brdf ') ?? false")
        known, asked = len(page.requests), len(server.asked) if server else 0
        assert known >= (9 if server else 1), page.requests
        drop(page, ("small.csv", (tables / "phong_sparse.csv").read_text()))
        page.wait("!document.getElementById('cancel').hidden")
        page.evaluate("document.getElementById('cancel').click()")
        drop(page, ("again.csv", (tables / "phong_sparse.csv").read_text()))
        wait_for_states(page, "cancelled", "fitted")
        page.wait("document.querySelectorAll('#plots svg').length === 2")
        sent = [url for url in page.requests[known:] if not url.startswith(("blob:", "data:", "about:"))]
        assert not sent and not page.console, (sent, page.console)
        to = (server.address if server else address) + "?sent"
        attempt = f"fetch({json.dumps(to)}).then(() => 'sent', () => 'refused')"
        assert page.evaluate(attempt) == "refused"
        worker = f"{attempt}.then(answer => postMessage(answer))"
        assert page.evaluate(f"""new Promise(done => {{ const worker = new Worker(URL.createObjectURL(new Blob([{json.dumps(worker)}])));
          worker.onmessage = event => done(event.data); }})""") == "refused"
        assert any("Content Security Policy" in text for text in page.console), page.console
        assert server is None or len(server.asked) == asked, server.asked[asked:]


def main():
    chromium, built, tables, npm, folder = sys.argv[1], *map(pathlib.Path, sys.argv[2:6])
    if not ((built / "brdf.html").exists() and (built / "site/index.html").exists()):
        print(f"skipped: {built} has no page; `cmake --preset wasm && cmake --build --preset wasm` builds it")
        sys.exit(77)
    if not (npm / "axe-core").exists():
        sys.exit(f"no {npm}/axe-core: tools/setup wasm installs it")
    folder.mkdir(parents=True, exist_ok=True)
    large, server = large_table(), Server(built / "site")
    with Browser(chromium, *SOFTWARE, server="127.0.0.1") as browser:
        for kind, address in (("disk", (built / "brdf.html").resolve().as_uri()), ("server", server.address + "index.html")):
            check_tables(browser, address, tables, folder)
            check_catalogue(browser, address)
            check_slider_ends(browser, address)
            check_settings(browser, address, tables)
            check_keyboard(browser, address)
            check_cancel(browser, address, large)
            check_silence(browser, address, server if kind == "server" else None, tables)
            print(f"from the {kind}: tables, catalogue, sliders, settings, keyboard, cancel and silence")
        single = (built / "brdf.html").resolve().as_uri()
        check_answers(browser, single, large)
        check_too_large(browser, single)
        check_without_program(browser, built, folder)
        check_look(browser, single, npm, folder)
    server.close()


if __name__ == "__main__":
    main()
