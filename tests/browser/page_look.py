"""The look of the page of the room browser: widths, schemes, contrast, and the rules of axe-core."""
import json
import time

from page_driver import drop, opened, wait_for_states

WIDTHS = (390, 1280, 1920)

# Elements beyond the edge of the screen, except within a box that scrolls.
WIDE = """(() => {
  for (const fold of document.querySelectorAll("details")) fold.open = true;
  const wide = [...document.body.querySelectorAll("*")].filter(e => !e.closest(".scroll") && e.getBoundingClientRect().right > innerWidth + 0.5);
  return {wide: wide.map(e => e.outerHTML.slice(0, 100)), scroll: document.scrollingElement.scrollWidth, inner: innerWidth,
    ground: getComputedStyle(document.body).backgroundColor};
})()"""

AXE = """axe.run(document, {iframes: false}).then(({violations, passes}) => ({passed: passes.length, violations: violations.map(v =>
  v.id + ": " + v.help + ": " + v.nodes.map(n => n.html.slice(0, 120)).join(" | "))}))"""


def axe_of(page, npm):
    page.evaluate((npm / "axe-core/axe.min.js").read_text() + "; 0")
    found = page.evaluate(AXE)
    assert found["passed"] > 20, found
    return found["violations"]


def check_probes(page, npm):
    """The probes themselves must find an element beyond the edge and a button without a name."""
    page.evaluate("""document.body.insertAdjacentHTML("beforeend", "<div id='fault' style='width: 5000px'><button></button></div>")""")
    assert any("fault" in text for text in page.evaluate(WIDE)["wide"])
    assert any(text.startswith("button-name") for text in axe_of(page, npm))
    page.evaluate("document.getElementById('fault').remove()")


def check_page(page, npm, path, width):
    found = page.evaluate(WIDE)
    assert found["scroll"] <= width and not found["wide"], (path, found)
    violations = axe_of(page, npm)
    assert not violations, (path, violations)
    page.screenshot(path)
    return found["ground"]


def check_look(browser, address, npm, folder):
    """Checks the page before a fit, with one result, with two results and with a refusal, at each width, light and dark."""
    with opened(browser, address) as page:
        check_probes(page, npm)
    for width in WIDTHS:
        grounds = set()
        for dark in (False, True):
            name = f"page_{width}_{'dark' if dark else 'light'}"
            with opened(browser, address, width=width, dark=dark) as page:
                page.wait("document.querySelectorAll('#plots svg').length === 2")
                grounds.add(check_page(page, npm, folder / f"{name}_empty.png", width))
                page.evaluate("document.querySelectorAll('[data-example]').forEach(button => button.click())")
                wait_for_states(page, "fitted", "fitted", "fitted")
                time.sleep(0.5)
                check_page(page, npm, folder / f"{name}_one.png", width)
                page.evaluate("(right => { right.value = '0'; right.dispatchEvent(new Event('change')); })(document.getElementById('right'))")
                tops = page.evaluate("[...document.querySelectorAll('.pane')].map(p => Math.round(p.getBoundingClientRect().top))")
                assert (tops[0] == tops[1]) == (width >= 900), (width, tops)
                time.sleep(0.5)
                check_page(page, npm, folder / f"{name}_two.png", width)
                drop(page, ("a_file_with_a_rather_long_name_that_is_no_table_of_samples_at_all_" + "x" * 90 + ".csv", "no table\n"))
                page.wait("document.getElementById('refusal').textContent !== ''")
                check_page(page, npm, folder / f"{name}_refused.png", width)
                assert not page.console, page.console
        assert len(grounds) == 2, grounds
    print(f"the look at {json.dumps(WIDTHS)} pixels, light and dark: no element beyond the edge, no finding of axe-core")
