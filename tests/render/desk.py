"""A virtual display with `brdf view` on it, driven by keys and mouse as a hand would (Xvfb, xdotool)."""
import json
import os
import shutil
import subprocess
import sys
import time

import pixels


class Desk:
    """Provides the program, a display of this size, and a folder for its files. Exits with 77 if a tool is missing."""

    def __init__(self, brdf, folder, width=1280, height=800):
        for tool in ("Xvfb", "xdotool"):
            if not shutil.which(tool):
                print(f"skipped: {tool} is not installed")
                sys.exit(77)
        self.brdf, self.folder = brdf, folder
        self.state_file = os.path.join(folder, "state.json")
        self.picture = os.path.join(folder, "picture.png")
        reader, writer = os.pipe()
        self.server = subprocess.Popen(  # -r: keys do not repeat on a busy machine
            ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp", "-r", "-noreset",
             "-fbdir", folder], pass_fds=(writer,), stderr=subprocess.DEVNULL)
        os.close(writer)
        number = os.read(reader, 16).decode().strip()
        if not number:
            print("skipped: Xvfb does not start")
            sys.exit(77)
        self.display = ":" + number
        self.environment = dict(os.environ, DISPLAY=self.display, XDG_STATE_HOME=folder)
        self.environment.pop("WAYLAND_DISPLAY", None)
        self.window = None
        self.frame = 0.1  # seconds, at most

    def close(self):
        self.server.terminate()
        self.server.wait()

    def x(self, *arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True, capture_output=True,
                              text=True).stdout

    def start(self, *arguments):
        return subprocess.Popen([self.brdf, "view", "--validation", "--save-as", self.state_file, "--screenshot",
                                 self.picture, *arguments], env=self.environment, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True)

    def find_window(self, name="brdf$"):
        """Waits for the window with this title (a regular expression) and gives it the keyboard."""
        self.window = self.x("search", "--sync", "--onlyvisible", "--name", name).split()[0]
        self.x("windowfocus", "--sync", self.window)
        time.sleep(2)
        return self.window

    def pause(self, frames=3):
        """Waits for the duration of so many frames. Machines differ, and a state may be saved only one or two frames later."""
        time.sleep(0.2 + frames * self.frame)

    def title(self):
        return self.x("getwindowname", self.window).rstrip("\n")

    def finish(self, viewer):
        """Requires that the viewer ends with success. Returns its text on the terminal."""
        out, _ = viewer.communicate(timeout=900)
        assert viewer.returncode == 0, f"exit code {viewer.returncode}: {out}"
        return out

    def press(self, *keys):
        for key in keys:
            self.x("key", key)
            time.sleep(0.25)

    def move(self, x, y):
        self.x("mousemove", "--window", self.window, round(x), round(y))

    def click(self, x, y, button=1):
        self.move(x, y)
        self.pause(2)
        self.x("click", button)
        self.pause(2)

    def drag(self, start, end, button=1, keys=()):
        """Drags in ten steps while the keys are held."""
        for key in keys:
            self.x("keydown", key)
        self.move(*start)
        self.pause(2)
        self.x("mousedown", button)
        self.pause(2)
        for step in range(1, 11):
            self.move(start[0] + (end[0] - start[0]) * step / 10, start[1] + (end[1] - start[1]) * step / 10)
            time.sleep(0.03)
        self.pause(2)
        self.x("mouseup", button)
        for key in keys:
            self.x("keyup", key)
        self.pause(2)

    def wait_for(self, path, before, seconds=60):
        """Waits until the file has been written after the time `before`."""
        end = time.time() + seconds
        while time.time() < end:
            if os.path.exists(path) and os.stat(path).st_mtime_ns > before:
                return
            time.sleep(0.05)
        raise AssertionError(f"{path} was not written")

    def written_by(self, key, path, seconds=60):
        """Returns the content of the file that this key writes."""
        before, begun = os.stat(path).st_mtime_ns if os.path.exists(path) else 0, time.time()
        self.x("key", key)
        self.wait_for(path, before, seconds)
        self.frame = time.time() - begun
        with open(path, "rb") as file:
            return file.read()

    def saved_state(self):
        return json.loads(self.written_by("ctrl+s", self.state_file))

    def screenshot(self):
        return self.written_by("p", self.picture)

    def shown(self, width, height):
        """Returns the window's pixels, row by row."""
        place = dict(line.split("=") for line in self.x("getwindowgeometry", "--shell", self.window).split())
        return pixels.screen(os.path.join(self.folder, "Xvfb_screen0"), int(place["X"]), int(place["Y"]), width, height)
