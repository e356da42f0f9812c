"""A headless Firefox driven by WebDriver BiDi over a socket of this machine: pages with their console and their requests, as
tests/validate/browser.py has them for Chromium. Nothing outside of this machine can be reached."""
import itertools
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import websocket

SETTINGS = {
    "network.proxy.type": 1, "network.proxy.http": "127.0.0.1", "network.proxy.http_port": 9, "network.proxy.ssl": "127.0.0.1",
    "network.proxy.ssl_port": 9, "network.proxy.no_proxies_on": "127.0.0.1", "browser.download.folderList": 2,
    "browser.download.always_ask_before_handling_new_types": False, "browser.shell.checkDefaultBrowser": False,
    "datareporting.policy.dataSubmissionEnabled": False, "app.update.enabled": False, "remote.active-protocols": 1,
}


class Firefox:
    def __init__(self, name, saved, patience=300):
        executable = shutil.which(name)
        if not executable:
            sys.exit(f"{name} is not installed: tools/setup wasm")
        self.patience, self.numbers, self.events = patience, itertools.count(1), []
        self.profile = tempfile.mkdtemp(prefix="brdf_browser_")
        settings = SETTINGS | {"browser.download.dir": str(saved)}
        pathlib.Path(self.profile, "user.js").write_text(
            "".join(f"user_pref({json.dumps(key)}, {json.dumps(value)});\n" for key, value in settings.items()))
        self.log = pathlib.Path(self.profile, "log")
        with self.log.open("w") as log:
            self.process = subprocess.Popen([executable, "--headless", "--no-remote", "--profile", self.profile,
                                             "--remote-debugging-port", "0", "about:blank"], stdout=log, stderr=log)
        self.socket = websocket.create_connection(self.address() + "/session", timeout=patience, suppress_origin=True)
        self.version = self.ask("session.new", capabilities={})["capabilities"]["browserVersion"]
        self.ask("session.subscribe", events=["log.entryAdded", "network.beforeRequestSent"])

    def address(self):
        deadline = time.monotonic() + 60
        while not (found := re.search(r"WebDriver BiDi listening on (ws://\S+)", self.log.read_text())):
            assert self.process.poll() is None and time.monotonic() < deadline, self.log.read_text()
            time.sleep(0.1)
        return found[1]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.ask("browser.close")
            self.process.wait(20)
        except (AssertionError, OSError, websocket.WebSocketException, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        shutil.rmtree(self.profile, ignore_errors=True)

    def ask(self, method, **parameters):
        number = next(self.numbers)
        self.socket.send(json.dumps({"id": number, "method": method, "params": parameters}))
        while True:
            answer = json.loads(self.socket.recv())
            if answer.get("id") == number:
                assert answer["type"] == "success", (method, answer)
                return answer["result"]
            self.events.append(answer)

    def open(self, address):
        return FirefoxPage(self, str(address))


class FirefoxPage:
    """A loaded page in a separate tab."""

    def __init__(self, browser, address):
        self.browser, self.console, self.requests = browser, [], []
        self.context = browser.ask("browsingContext.create", type="tab")["context"]
        browser.ask("browsingContext.navigate", context=self.context, url=address, wait="complete")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.browser.ask("browsingContext.close", context=self.context)

    def evaluate(self, expression):
        """Returns the value of a JavaScript expression, which is passed on as JSON; waits for a promise."""
        answer = self.browser.ask("script.evaluate", expression=f"(async () => JSON.stringify(await ({expression})) ?? 'null')()",
                                  target={"context": self.context}, awaitPromise=True, resultOwnership="none", userActivation=True)
        self.take_events()
        assert answer["type"] == "success", answer["exceptionDetails"]
        return json.loads(answer["result"]["value"])

    def take_events(self):
        for event in self.browser.events:
            parameters = event.get("params", {})
            if event.get("method") == "log.entryAdded":
                self.console.append(str(parameters["text"]))
            if event.get("method") == "network.beforeRequestSent":
                self.requests.append(parameters["request"]["url"])
        self.browser.events.clear()

    def wait(self, expression):
        deadline = time.monotonic() + self.browser.patience
        while not self.evaluate(expression):
            assert time.monotonic() < deadline, f"never true: {expression}"
            time.sleep(0.05)
