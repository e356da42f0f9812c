"""The page of the room browser as a person uses it, and a web server that keeps a list of its requests."""
import functools
import http.server
import json
import pathlib
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "validate"))
from browser import SOFTWARE, Browser  # noqa: F401 (for the tests)

READY = "document.getElementById('version').textContent.startsWith('brdf ')"
STATES = "[...document.querySelectorAll('#queue .state')].map(s => s.textContent)"


class Server:
    """Serves a folder at 127.0.0.1; `asked` has the path of every request."""

    def __init__(self, folder):
        self.asked = asked = []

        class Handler(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *_):
                asked.append(self.path)

        handler = functools.partial(Handler, directory=str(folder))
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        self.address = f"http://127.0.0.1:{self.server.server_port}/"
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def close(self):
        self.server.shutdown()
        self.server.server_close()


def opened(browser, address, **look):
    """Opens the page and waits until the program is loaded."""
    page = browser.open(address, **look)
    page.wait(READY)
    return page


def drop(page, *files):
    """Drops files (name, text) on the page, as a person does with a mouse."""
    page.evaluate(f"""(() => {{
      const data = new DataTransfer();
      for (const [name, text] of {json.dumps(files)}) data.items.add(new File([text], name));
      const send = kind => document.body.dispatchEvent(new DragEvent(kind, {{dataTransfer: data, bubbles: true, cancelable: true}}));
      const taken = !send("dragover");
      send("drop");
      if (!taken) throw new Error("the page does not take files");
    }})()""")


def choose(page, *paths):
    """Chooses files in the file input."""
    root = page.ask("DOM.getDocument")["root"]["nodeId"]
    node = page.ask("DOM.querySelector", nodeId=root, selector="#files")["nodeId"]
    page.ask("DOM.setFileInputFiles", nodeId=node, files=[str(p.resolve()) for p in paths])


def text_of(page, selector):
    return page.evaluate(f"document.querySelector({json.dumps(selector)})?.innerText ?? ''")


def states(page):
    return page.evaluate(STATES)


def wait_for_states(page, *wanted):
    page.wait(f"JSON.stringify({STATES}) === JSON.stringify({json.dumps(wanted)})")


def tab_to(page, selector, most=400):
    """Presses Tab until an element has the focus, which must be visible at each stop."""
    for _ in range(most):
        page.key("Tab")
        stop = page.evaluate(f"""(() => {{ const e = document.activeElement, s = getComputedStyle(e);
          return {{there: e.matches({json.dumps(selector)}), seen: e.matches("body, iframe, :focus-visible") && (e.matches("body, iframe") || s.outlineStyle !== "none"),
                  name: e.outerHTML.slice(0, 100)}}; }})()""")
        assert stop["seen"], f"the focus cannot be seen on {stop['name']}"
        if stop["there"]:
            return
    raise AssertionError(f"Tab does not reach {selector}")


def frame_value(browser, page, expression):
    """Returns the value of an expression within the first report that is loaded; a report is a page of its own for the browser."""
    deadline = time.monotonic() + 20
    while time.monotonic() < deadline:
        for target in browser.ask("Target.getTargets", filter=[{"type": "iframe", "exclude": False}])["targetInfos"]:
            session = browser.ask("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
            answer = browser.ask("Runtime.evaluate", session, expression=f"document.readyState === 'complete' && ({expression})", returnByValue=True, awaitPromise=True)
            if answer["result"].get("value"):
                return answer["result"]["value"]
        time.sleep(0.2)
    raise AssertionError(f"never true in a report: {expression}")


def large_table(rows=100_000):
    """Returns a table of a gloss over a diffuse base, rows in a grid of 25 by 40 directions and azimuths."""
    lines = ["theta_i,phi_i,theta_o,phi_o,fr"]
    for k in range(rows):
        theta_i, theta_o, phi = 3 * (k % 25), 2 * (k // 25 % 40), 180 * (k // 1000) / max(1, rows // 1000)
        off = (theta_i - theta_o) ** 2 + (theta_o * phi / 60) ** 2
        lines.append(f"{theta_i},180,{theta_o},{phi:.4f},{0.06 + 0.9 * 2.718281828 ** (-off / 300):.9f}")
    return "\n".join(lines) + "\n"
