#!/usr/bin/env python3
# ctest: window.by_hand label=window timeout=3000 needs=brdf_viewer,plain @viewer@ @source@
# ctest: window.at_random label=render timeout=3000 needs=brdf_viewer,sanitized @viewer@ @source@ --only random --actions 300
"""Uses the window as a hand would, at three sizes, and checks saved states, titles and pixels; then draws actions from the
list of all commands that the window registers, undoes them all, and compares with the first state byte for byte.

Usage: window_test.py BRDF SOURCE_DIR [--actions N] [--seed S] [--pictures FOLDER]
Exit code 77 where Xvfb or xdotool is missing.
"""
import argparse
import json
import os
import random
import shutil
import subprocess
import tempfile
import time

import pixels
import xdnd
from desk import Desk
from window_screen import Window

parser = argparse.ArgumentParser()
parser.add_argument("brdf")
parser.add_argument("source")
parser.add_argument("--actions", type=int, default=1000)
parser.add_argument("--seed", type=int, default=22)
parser.add_argument("--pictures", help="a folder to keep pictures of the window in")
parser.add_argument("--only", choices=("hand", "random"))
parser.add_argument("--size", choices=("1280x720x1", "800x600x1", "1920x1080x2"), help="width, height, scale: this one only")
options = parser.parse_args()
brdf, source = os.path.abspath(options.brdf), os.path.abspath(options.source)
SAMPLES = os.path.join(source, "data/synthetic/cook_torrance_metal.csv")


def run(*arguments):
    return subprocess.run([brdf, *arguments], check=True, capture_output=True, text=True).stdout


def material_of(state):
    return state["scene"]["objects"][state["selected"]]["material"]


def by_hand(desk, folder, width, height, scale):
    """Runs a session at the window once; the window must end without being killed."""
    fitted = os.path.join(folder, "fitted.json")
    if not os.path.exists(fitted):
        run("fit", SAMPLES, "--form", "cook_torrance", "-o", fitted)
    w = Window(desk, options.pictures, width, height, scale, fitted, "--hard-light")
    assert desk.title() == "fitted.json - brdf", desk.title()
    first = desk.saved_state()
    size = first["scene"]["camera"]
    assert size["width"] <= width - w.panel and size["height"] < height, "the picture lies under the panels"
    w.keep("start")

    # 1. Nothing is lost. Esc closes an open list and nothing else.
    desk.press("o")
    desk.pause()
    w.keep("open")
    desk.press("Escape", "Escape")
    assert w.viewer.poll() is None, "Esc has ended the program"
    assert desk.saved_state() == first
    # A slider: dragged, undone, done again.
    knobs = w.knobs()
    assert len(knobs) >= 3, f"sliders: {knobs}"
    end = (knobs[0][0] + 60 * scale, knobs[0][1])
    desk.drag(knobs[0], end)
    dragged = desk.saved_state()
    assert material_of(dragged) != material_of(first), "the slider did nothing"
    desk.press("ctrl+z")
    assert desk.saved_state() == first, "undo"
    w.until(lambda: desk.title() == "fitted.json - brdf")
    desk.press("ctrl+y")
    assert desk.saved_state() == dragged, "redo"
    # Ctrl-click enters a number beyond the end of the slider, which must be kept.
    desk.move(*w.knob(knobs[0][1]))
    desk.pause()
    slider = w.strip(knobs[0][1])
    desk.x("keydown", "ctrl", "click", 1, "keyup", "ctrl")
    w.until(lambda: w.strip(knobs[0][1]) != slider)  # a text line
    desk.pause()
    desk.x("key", "ctrl+a")
    desk.pause()
    desk.x("type", "2.178")
    desk.pause()
    still = [k[1] for k in w.knobs() if k[1] > knobs[0][1] + 8 * scale]
    assert still == [k[1] for k in knobs[1:]], f"sliders have moved while a number is typed: {still}, {knobs}"
    desk.x("key", "Return")
    desk.pause()
    w.until(lambda: 2.178 in [v for row in material_of(desk.saved_state())["weights"].values() for v in row])
    # Right-click offers default and the file's value: the second entry.
    desk.click(*w.picture(0.1, 0.1))  # nothing is there
    desk.pause()
    menu = w.knob(knobs[0][1])
    desk.click(*menu, button=3)
    desk.pause(5)
    w.keep("offer")
    desk.click(menu[0] + 20 * scale, menu[1] + (8 + 21 * 1.5) * scale)
    back = desk.saved_state()
    assert material_of(back) == material_of(first), "the file's value was not offered"
    # Once round the families each keeps its values.
    families = {f["family"] for f in json.loads(run("models", "--json"))["forms"]}
    desk.press(*["shift+n"] * len(families))
    assert material_of(desk.saved_state()) == material_of(first), "a family has lost its values"
    desk.press("n")
    changed = desk.saved_state()
    desk.press("ctrl+r")
    assert desk.saved_state() == first, "revert"
    desk.press("ctrl+z")
    assert desk.saved_state() == changed, "undoing the revert"
    # The material is saved under a name, and opened again; Tab completes.
    mine = os.path.join(folder, f"mine_{width}.json")
    desk.press("ctrl+shift+s")
    desk.pause()
    desk.x("key", "ctrl+a")
    desk.pause()
    desk.x("type", "--delay", "20", mine)
    desk.press("Return")
    w.until(lambda: os.path.exists(mine))
    with open(mine) as file:
        assert json.load(file)["form"] == material_of(changed)["form"]
    run("export", "--material", mine, "--to", "glsl")
    desk.press("o")
    desk.pause()
    desk.x("type", "--delay", "20", os.path.join(folder, f"mine_{width}"))  # other sizes have files of their own
    desk.press("Tab", "Return")
    w.until(lambda: desk.title() == f"mine_{width}.json - brdf")
    # A saved state holds a material for the other verbs.
    assert json.loads(run("validate", desk.state_file, "--json")), "validate of a state"

    # 2. Everything is seen: an error in red, the name in the title, help.
    assert not w.status_colour()
    xdnd.drop(desk.display, int(desk.window), [os.path.join(folder, "absent.json")])
    w.until(w.status_colour)
    w.keep("error")
    desk.press("r")
    w.until(lambda: not w.status_colour())  # the error ends with the next action
    plain = w.rows()
    desk.press("question")
    desk.pause()
    assert w.rows() != plain, "no help"
    w.keep("help")
    desk.press("Escape")
    assert w.viewer.poll() is None
    desk.move(*w.picture(0.5, 0.5))
    before = w.rows()
    desk.x("keydown", "shift", "click", 1, "keyup", "shift")
    desk.pause()
    assert w.rows() != before, "no probe"
    w.keep("probe")
    desk.press("Escape")

    # 4. Light by hand.
    unlit = desk.saved_state()["scene"]
    desk.drag(w.picture(0.5, 0.5), w.picture(0.7, 0.5), keys=("ctrl",))
    lit = desk.saved_state()["scene"]
    assert lit["lights"] != unlit["lights"] and lit["camera"] == unlit["camera"]
    desk.press("shift+l", "Left")
    followed = desk.saved_state()["scene"]
    assert followed["lights"] != lit["lights"] and followed["camera"] != lit["camera"]
    for key in "456123":
        desk.press(key)
        scene = desk.saved_state()["scene"]
        assert ("environment" in scene) == (key in "456"), key
    desk.press("shift+l", "2")

    # 5. Hand and solver: the samples next to the material, which is spoiled and then fitted from there.
    xdnd.drop(desk.display, int(desk.window), [fitted])
    w.until(lambda: desk.title() == "fitted.json - brdf")
    solved = material_of(desk.saved_state())
    xdnd.drop(desk.display, int(desk.window), [SAMPLES])
    desk.pause()
    desk.press("s", "l")
    desk.pause()
    w.keep("beside")
    if not w.column:  # the plots hide the sliders
        desk.press("l")
        desk.pause()
    plots = w.plots()
    spoiled = w.knobs()
    desk.drag(spoiled[-2], (spoiled[-2][0] + 25 * scale, spoiled[-2][1]))
    assert material_of(desk.saved_state()) != solved
    w.keep("spoiled")
    if w.column:  # lobes, slice and residuals have followed the slider
        w.until(lambda: w.differing(plots) > 0.02)
    desk.press("ctrl+f")
    w.until(lambda: far(material_of(desk.saved_state()), solved) < 1e-3)
    w.until(lambda: w.differing(plots) < 0.01)
    w.keep("fitted")
    w.until(lambda: len(w.intervals()) >= 3 and max(w.intervals()) < 3)  # what was found lies in its interval
    desk.press("ctrl+z")
    assert far(material_of(desk.saved_state()), solved) > 1e-3, "the fit cannot be undone"
    if w.column:
        desk.press("l")

    # 3. Layout: the panels follow the window, objects are selected by a click, the car is framed without its floor.
    xdnd.drop(desk.display, int(desk.window), [os.path.join(source, "data/scenes/material_balls.json")])
    w.until(lambda: desk.title() == "material_balls.json - brdf")
    desk.press("f")
    desk.saved_state()
    if options.pictures:
        time.sleep(20)  # until there is less noise
    w.keep("objects")
    assert not w.intervals(), "the intervals of another material"
    desk.click(*w.picture(0.5, 0.5))
    desk.click(*w.picture(0.2, 0.3))
    desk.click(*w.picture(0.8, 0.6))
    desk.press("shift+f", "g")
    desk.saved_state()
    desk.pause()
    w.keep("targets")
    desk.press("g", "ctrl+z")
    # Leaving leave the window; asks if there are unsaved changes.
    xdnd.drop(desk.display, int(desk.window), [mine])
    w.until(lambda: desk.title() == f"mine_{width}.json - brdf")
    desk.press("n")
    w.until(lambda: desk.title().startswith("* "))
    desk.press("q")
    desk.pause(6)
    assert w.viewer.poll() is None, "left without asking"
    w.keep("leave")
    desk.press("Escape")
    assert w.viewer.poll() is None
    desk.press("q")
    desk.pause()
    desk.press("x")
    out = desk.finish(w.viewer)
    assert out.count("\n") == 1 and "absent.json: no such file" in out, out


def far(a, b):
    """Returns the largest relative difference between the numbers of two materials."""
    if a["form"] != b["form"]:
        return 1
    pairs = [(u, v) for k in a["weights"] for u, v in zip(a["weights"][k], b["weights"][k])]
    pairs += [(a["shape"][k], b["shape"][k]) for k in a["shape"] if not isinstance(a["shape"][k], list)]
    return max(abs(u - v) / max(abs(v), 1e-3) for u, v in pairs)


def at_random(desk, folder):
    """Actions from the list of commands; then everything is undone."""
    commands = json.loads(run("view", "--commands"))
    print("without undo: " + "; ".join(f"{c['name']} ({c['why_not']})" for c in commands if not c["undo"]))
    width, height = 480, 360  # small, and few samples: what is drawn is not looked at
    w = Window(desk, options.pictures, width, height, 1, "--hard-light", "--samples", "16")
    first = desk.written_by("ctrl+s", desk.state_file)
    draw = random.Random(options.seed)
    files = [SAMPLES, os.path.join(source, "data/materials/copper.json"), os.path.join(source, "data/scenes/sphere.json"),
             os.path.join(source, "data/scenes/models/cube.x"), os.path.join(folder, "absent.json")]
    done, size = {}, [width, height]

    def place():
        return draw.randrange(5, size[0] - 5), draw.randrange(5, size[1] - 5)

    def to_a_place():
        return ["mousemove", "--window", desk.window, *place()]

    def held(words, keys):
        """Holds the key before the plus during the action."""
        key = keys.split("+")[0]
        return ["keydown", key, *words, "keyup", key] if "+" in keys else words

    def wait():
        """Waits until all input has arrived: open prompts are closed and the state is saved."""
        desk.x("key", "--delay", "20", "Escape", "Escape", "Escape")
        return desk.written_by("ctrl+s", desk.state_file, 300)

    def act(command):
        keys = command["keys"]
        done[command["name"]] = done.get(command["name"], 0) + 1
        if keys in ("drag", "right drag", "ctrl+drag"):
            button = 3 if keys == "right drag" else 1
            way = [word for _ in range(4) for word in (*to_a_place(), "sleep", 0.03)]
            desk.x(*to_a_place(), *held(["mousedown", button, "sleep", 0.03, *way, "mouseup", button], keys), "key", "Escape")
        elif keys in ("click", "shift+click"):
            desk.x(*to_a_place(), "sleep", 0.05, *held(["click", 1], keys), "key", "Escape")
        elif keys == "wheel":
            desk.x(*to_a_place(), "click", draw.choice((4, 5)), "key", "Escape")
        elif keys == "drop":
            xdnd.drop(desk.display, int(desk.window), [draw.choice(files)], seconds=300)
        else:
            desk.x("key", keys, "key", "Escape")

    # Keys that leave the window are tested separately. Every prompt is closed again, because it would receive the next keys.
    commands = [c for c in commands if c["name"] != "leave"]
    begun = time.time()
    for k in range(options.actions):
        act(draw.choice(commands))
        if draw.random() < 0.03:
            size = [draw.randrange(200, 640), draw.randrange(150, 480)]
            desk.x("windowsize", desk.window, *size)
        if k % 20 == 19:
            wait()
        if k % 100 == 99:
            print(f"{k + 1} actions in {time.time() - begun:.0f} s", flush=True)
        assert w.viewer.poll() is None, f"ended after {k + 1} actions"
    wait()
    acted = time.time() - begun
    desk.x("windowsize", "--sync", desk.window, width, height)
    desk.pause()
    steps, end = 0, time.time() + 1800
    while True:  # the first state is the one before which there is nothing
        desk.x("key", "--delay", "10", *["ctrl+z"] * 20)
        steps += 20
        now = desk.written_by("ctrl+s", desk.state_file, 300)
        if now == first:
            break
        assert time.time() < end and steps < 40 * options.actions, f"{steps} steps back do not lead to the first state"
    desk.press("q")
    desk.pause()
    out = desk.finish(w.viewer)
    refused = ("absent.json: no such file", "an environment needs the shading", "there are no samples: open samples first",
               "cannot be fitted, because the form is not linear")
    assert all(any(words in line for words in refused) for line in out.splitlines()), out
    print(f"{options.actions} actions of {len(done)} of {len(commands)} commands in {acted:.0f} s, undone by at most {steps} steps "
          f"in {time.time() - begun - acted:.0f} s")


folder = tempfile.mkdtemp(prefix="brdf-window-")
desk = Desk(brdf, folder, 2000, 1200)
try:
    if options.only != "random":
        for size in [options.size] if options.size else ["1280x720x1", "800x600x1", "1920x1080x2"]:
            width, height, scale = map(int, size.split("x"))
            by_hand(desk, folder, width, height, scale)
            print(f"{width} x {height} at {scale}: good")
    if options.only != "hand":
        at_random(desk, folder)
except Exception:
    if options.pictures and desk.window:
        pixels.write_png(os.path.join(options.pictures, "failed.png"), desk.shown(1280, 720))
    raise
finally:
    desk.close()
    shutil.rmtree(folder, ignore_errors=True)
