"""A headless Chromium driven over a pipe: pages at any width, light or dark, on paper, with their console.

    with Browser("chromium") as browser:
        page = browser.open(path, width=400, dark=True)     # console messages in page.console
        page.evaluate("document.title")
        page.screenshot(path)

No address outside can be reached, except `server`, an address of this machine. The protocol is Chrome's
DevTools over file descriptors 3 and 4.
"""
import base64
import json
import os
import pathlib
import select
import shutil
import subprocess
import sys
import tempfile
import time

WORDS = ["--headless=new", "--no-sandbox", "--disable-background-networking", "--disable-sync", "--disable-extensions",
         "--no-first-run", "--hide-scrollbars", "--proxy-server=127.0.0.1:9", "--remote-debugging-pipe", "about:blank"]
# WebGL on the processor, the same on every machine.
SOFTWARE = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
SHELL = 'exec "$0" "$@" 3<&$PIPE_IN 4>&$PIPE_OUT'


class Browser:
    def __init__(self, name, *words, patience=120, driver=None, server=None):
        executable = shutil.which(name)
        if not executable:
            sys.exit(f"{name} is not installed: tools/setup test")
        self.patience, self.number, self.rest, self.events = patience, 0, b"", []
        self.profile = tempfile.mkdtemp(prefix="brdf_browser_")
        to_read, self.to_write = os.pipe()
        self.to_listen, to_answer = os.pipe()
        rules = "--host-resolver-rules=MAP * ~NOTFOUND" + (f", EXCLUDE {server}" if server else "")
        gpu = [] if any("gl" in word for word in words) else ["--disable-gpu"]
        # A Vulkan driver that the environment names would take SwiftShader's place.
        variables = {name: value for name, value in os.environ.items() if not name.startswith("VK_")}
        if driver:
            variables["VK_DRIVER_FILES"] = driver
        self.process = subprocess.Popen(
            ["bash", "-c", SHELL, executable, f"--user-data-dir={self.profile}", *gpu, *words, rules, *WORDS],
            pass_fds=(to_read, to_answer), env=variables | {"PIPE_IN": str(to_read), "PIPE_OUT": str(to_answer)},
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(to_answer)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.ask("Browser.close")
            self.process.wait(20)
        except (AssertionError, OSError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        os.close(self.to_write)
        os.close(self.to_listen)
        shutil.rmtree(self.profile, ignore_errors=True)

    def message(self, deadline):
        while b"\0" not in self.rest:
            ready, _, _ = select.select([self.to_listen], [], [], max(0, deadline - time.monotonic()))
            data = os.read(self.to_listen, 1 << 20) if ready else b""
            assert data, "the browser does not answer"
            self.rest += data
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def ask(self, method, session=None, **parameters):
        self.number += 1
        request = {"id": self.number, "method": method, "params": parameters}
        if session:
            request["sessionId"] = session
        data = json.dumps(request).encode() + b"\0"
        while data:
            data = data[os.write(self.to_write, data):]
        deadline = time.monotonic() + self.patience
        while True:
            answer = self.message(deadline)
            if answer.get("id") == self.number:
                assert "error" not in answer, (method, answer["error"])
                return answer["result"]
            self.events.append(answer)

    def open(self, path, width=1280, height=900, dark=False):
        """Opens a page by its file, or by its address (of a file, or at `server`)."""
        address = path if str(path).startswith(("http:", "file:", "about:")) else pathlib.Path(path).resolve().as_uri()
        return Page(self, address, width, height, dark)


class Page:
    """A loaded page in a separate tab."""

    def __init__(self, browser, address, width, height, dark):
        self.browser, self.console, self.requests, self.width, self.height = browser, [], [], width, height
        self.target = browser.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = browser.ask("Target.attachToTarget", targetId=self.target, flatten=True)["sessionId"]
        for domain in ("Runtime", "Log", "Page"):
            self.ask(f"{domain}.enable")
        self.resize(height)
        self.scheme(dark)
        self.ask("Page.navigate", url=address)
        self.wait("document.readyState === 'complete'")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.browser.ask("Target.closeTarget", targetId=self.target)

    def ask(self, method, **parameters):
        answer = self.browser.ask(method, self.session, **parameters)
        self.take_events()
        return answer

    def resize(self, height):
        """Changes the height of the window and waits until the page is drawn."""
        self.ask("Emulation.setDeviceMetricsOverride", width=self.width, height=int(height), deviceScaleFactor=1,
                 mobile=False)
        self.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def take_events(self):
        for event in self.browser.events:
            parameters = event.get("params", {})
            if event.get("sessionId") != self.session:
                continue
            if event["method"] == "Runtime.consoleAPICalled":
                self.console.append(" ".join(str(a.get("value", a.get("description"))) for a in parameters["args"]))
            if event["method"] == "Runtime.exceptionThrown":
                details = parameters["exceptionDetails"]
                self.console.append(details.get("exception", {}).get("description", details["text"]))
            if event["method"] == "Network.requestWillBeSent":  # if the domain Network is enabled
                self.requests.append(parameters["request"]["url"])
            if event["method"] == "Log.entryAdded":
                entry = parameters["entry"]
                self.console.append(f"{entry['text']} {entry.get('url', '')}".strip())
        self.browser.events.clear()

    def scheme(self, dark, media=""):
        """Selects the light or the dark scheme; media "print" shows the page as on paper."""
        self.ask("Emulation.setEmulatedMedia", media=media,
                 features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def evaluate(self, expression):
        """Returns the value of a JavaScript expression; waits for a promise."""
        answer = self.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in answer, answer["exceptionDetails"]
        return answer["result"].get("value")

    def wait(self, expression):
        deadline = time.monotonic() + self.browser.patience
        while not self.evaluate(expression):
            assert time.monotonic() < deadline, f"never true: {expression}"
            time.sleep(0.02)

    def key(self, name, text=""):
        """Presses and releases a key, by its name in KeyboardEvent.key."""
        code = {"Tab": 9, "Enter": 13, "Escape": 27, " ": 32, "ArrowRight": 39, "ArrowDown": 40}.get(name, ord(text[0].upper()) if text else 0)
        text = text or ("\r" if name == "Enter" else "")
        for kind in ("keyDown", "keyUp"):
            self.ask("Input.dispatchKeyEvent", type=kind, key=name, code=name, windowsVirtualKeyCode=code,
                     **({"text": text} if text and kind == "keyDown" else {}))

    def screenshot(self, path, whole=True):
        """Takes a picture of the whole page, or of the part that the window shows."""
        if whole:
            self.resize(min(self.ask("Page.getLayoutMetrics")["cssContentSize"]["height"], 16000))
        data = self.ask("Page.captureScreenshot", format="png")["data"]
        pathlib.Path(path).write_bytes(base64.b64decode(data))
        if whole:
            self.resize(self.height)
