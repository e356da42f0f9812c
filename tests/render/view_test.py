#!/usr/bin/env python3
# ctest: view.under_xvfb label=render,driver timeout=1000 cost=80 needs=brdf_viewer @viewer@ @source@
# ctest: view.soak label=slow timeout=1200 needs=brdf_viewer @viewer@ @source@ 600
"""Drives `brdf view` under Xvfb with xdotool: keys, mouse, resizing, dropped files, screenshots; the validation layers
are on. Then makes the viewer's pictures again from the command line.

Usage: view_test.py BRDF SOURCE_DIR [FRAMES]. Exit code 77 if Xvfb or xdotool is missing.
"""
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time

import pixels
import xdnd
from desk import Desk

brdf, source = sys.argv[1], sys.argv[2]
soak_frames = sys.argv[3] if len(sys.argv) > 3 else "40"
THOROUGH = "BRDF_THOROUGH" in os.environ  # ./test --full
WIDTH, HEIGHT = 280, 210  # of the window: a software driver draws it
folder = tempfile.mkdtemp(prefix="brdf-view-")
desk = Desk(brdf, folder)
state_file, picture, environment, display = desk.state_file, desk.picture, desk.environment, desk.display
x, start, press = desk.x, desk.start, desk.press
saved_state, screenshot = desk.saved_state, desk.screenshot


def settles_to(shot, seconds=60):
    """Waits until the window, with hidden panels, shows the picture of this file, smooth and dithered. 1 pixel in 10,000 may differ
    by one step."""
    wanted = pixels.png(shot)
    width, height = len(wanted[0]), len(wanted)
    end = time.time() + seconds
    while True:
        shown = desk.shown(width, height)
        apart = [max(abs(i - j) for i, j in zip(a, b)) for one, other in zip(shown, wanted) for a, b in zip(one, other)]
        others = sum(step > 0 for step in apart)
        if others <= len(apart) / 10000 and max(apart) <= 1:
            return
        assert time.time() < end, f"{others} pixels of the window are not the picture's"
        time.sleep(0.5)


def picture_size(state):
    camera = state["scene"]["camera"]
    return camera["width"], camera["height"]


def differing(a, b, path="$"):
    """Returns the paths at which two JSON values differ."""
    if isinstance(a, dict) and isinstance(b, dict) and a.keys() == b.keys():
        return [place for key in a for place in differing(a[key], b[key], f"{path}.{key}")]
    return [] if a == b else [f"{path}: {a} {b}"]


def highlight_across(state):
    """Returns the horizontal position of the highlight of the unit sphere in the picture, 0 to 1: of many points, the point with the
    normal that bisects light and viewer best."""
    scene = state["scene"]
    camera, light = scene["camera"], scene["lights"][0]
    minus = lambda a, b: [x - y for x, y in zip(a, b)]
    dot = lambda a, b: sum(x * y for x, y in zip(a, b))
    unit = lambda a: [x / math.sqrt(dot(a, a)) for x in a]
    to_light = unit([-x for x in light["direction"]])
    ahead = unit(minus(camera["target"], camera["position"]))
    up = camera["up"]
    right = unit([ahead[1] * up[2] - ahead[2] * up[1], ahead[2] * up[0] - ahead[0] * up[2], ahead[0] * up[1] - ahead[1] * up[0]])

    def normal(degrees):
        theta, phi = map(math.radians, degrees)
        return [math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)]

    def halves(degrees):
        n = normal(degrees)
        return dot(n, unit([a + b for a, b in zip(unit(minus(camera["position"], n)), to_light)]))

    best = max(((theta, phi) for theta in range(0, 181, 5) for phi in range(0, 360, 5)), key=halves)
    best = max(((best[0] + a / 4, best[1] + b / 4) for a in range(-24, 25) for b in range(-24, 25)), key=halves)
    place = minus(normal(best), camera["position"])
    width = math.tan(math.radians(camera["vertical_fov"]) / 2) * camera["width"] / camera["height"]
    return 0.5 + 0.5 * dot(place, right) / (width * dot(place, ahead))


def form_of(state):
    return state["scene"]["objects"][0]["material"]["form"]


def same_from_the_command_line(shot):
    """Requires that `brdf render --state` writes the bytes of the screenshot."""
    again = os.path.join(folder, "again.png")
    subprocess.run([brdf, "render", "--state", state_file, "--no-labels", "-o", again], check=True,
                   capture_output=True)
    with open(again, "rb") as file:
        return file.read() == shot


try:
    viewer = start("--hard-light", "--width", str(WIDTH), "--height", str(HEIGHT))
    window = desk.find_window("^brdf$")

    # Every form by key: some of them in ./test, all in ./test --full.
    forms = [f["form"] for f in json.loads(subprocess.run([brdf, "models", "--json"], capture_output=True, text=True,
                                                          check=True).stdout)["forms"]]
    seen = {form_of(saved_state())}
    wanted = len(forms) if THOROUGH else 8
    for _ in range(wanted - 1):
        press("n")
        seen.add(form_of(saved_state()))
    assert len(seen) == wanted and seen <= set(forms), seen

    # Dragging turns the camera, the wheel moves the camera, and r resets it.
    home = saved_state()["scene"]["camera"]["position"]
    x("mousemove", "--window", window, 180, HEIGHT // 2, "mousedown", 1)
    for step in range(10):
        x("mousemove", "--window", window, 180 + 8 * step, HEIGHT // 2 + 4 * step)
        time.sleep(0.05)
    x("mouseup", 1)
    time.sleep(0.5)
    turned = saved_state()["scene"]["camera"]["position"]
    assert max(abs(a - b) for a, b in zip(home, turned)) > 0.1, "dragging did not turn"
    distance = sum(v * v for v in turned) ** 0.5
    assert abs(distance - sum(v * v for v in home) ** 0.5) < 1e-3, "orbiting changed the distance"
    x("click", 4)
    time.sleep(0.5)
    zoomed = saved_state()["scene"]["camera"]["position"]
    assert sum(v * v for v in zoomed) ** 0.5 < 0.95 * distance, "the wheel did not zoom"
    press("r")
    assert saved_state()["scene"]["camera"]["position"] == home

    # Pictures differ between the displays, and are the picture alone: the panels are not on them.
    saved_state()
    assert same_from_the_command_line(screenshot()), "the picture beside the panels is another one"
    press("h")
    plain = screenshot()
    shots = [plain]
    for key, name in (("s", "split"), ("d", "difference"), ("g", "gbuffer"), ("b", "flip")):
        press(key)
        assert saved_state()["display"] == name
        shots.append(screenshot())
        if THOROUGH or name in ("split", "flip"):
            assert same_from_the_command_line(shots[-1]), f"brdf render makes another picture of {name}"
    press("b")
    assert screenshot() == plain
    x("mousemove", 1270, 790)  # the pointer is on the screen, too
    settles_to(plain)
    assert len({len(s) for s in shots}) >= 3

    # The line of a split follows the mouse; the camera does not move.
    press("s")
    before = saved_state()
    x("mousemove", "--window", window, round(WIDTH * before["split"]), HEIGHT // 2)
    time.sleep(1)
    x("mousedown", 1)
    time.sleep(1)  # the window asks where the pointer is when it hears of the button
    x("mousemove", "--window", window, 3 * WIDTH // 4, HEIGHT // 2)
    time.sleep(1)
    x("mouseup", 1)
    after = saved_state()
    assert abs(after["split"] - 0.75) < 0.01, (before["split"], after["split"])
    assert after["scene"]["camera"] == before["scene"]["camera"]
    press("s", "h")

    # Shading modes, tone maps, exposure, lobe plot, turntable, probe.
    for _ in range(7):
        press("m")
    press("c", "l", "equal", "minus")
    x("keydown", "shift", "click", 1, "keyup", "shift")
    press("t")
    time.sleep(1)
    press("t", "h")
    assert saved_state()["scene"]["objects"][0]["rotation"][1] != 0, "the turntable stood still"

    # Resizing.
    for width, height in ((350, 250), (180, 280), (WIDTH, HEIGHT)):
        x("windowsize", "--sync", window, width, height)
        end = time.time() + 60
        while (size := picture_size(saved_state())) != (width, height):
            assert time.time() < end, f"the picture has {size} instead of {width} x {height}"
            time.sleep(0.2)

    # A material by its name.
    material = os.path.join(folder, "blue.json")
    with open(material, "w") as file:
        json.dump({"format": "brdf-material", "version": 1, "form": "ward", "channels": ["r", "g", "b"],
                   "weights": {"kd": [0.1, 0.2, 0.6], "ks": [0.3, 0.3, 0.3]},
                   "shape": {"alpha_x": 0.1, "alpha_y": 0.25}}, file)
    press("o")
    time.sleep(3)  # the prompt has to have the keyboard: a frame takes long on a busy machine
    x("type", "--delay", "20", material)
    press("Return")
    time.sleep(1)
    assert form_of(saved_state()) == "ward"

    # Files are dropped on the window. A file that cannot be shown changes nothing, and one line gives the reason.
    def drop(*names):
        xdnd.drop(display, int(window), names)
        time.sleep(0.5)
        return saved_state()

    def damaged(name, text):
        path = os.path.join(folder, name)
        with open(path, "w") as file:
            file.write(text)
        return path

    def without_pictures(state):
        return {key: value for key, value in state.items() if key not in ("samples", "compare_with", "display", "split")}

    state = drop(os.path.join(source, "data/scenes/models/vase.obj"))
    assert form_of(state) == "ward", form_of(state)
    assert state["scene"]["objects"][0]["mesh"].endswith("vase.obj"), state["scene"]["objects"][0]["mesh"]
    bad = {
        damaged("broken.json", "{"): "line 1",
        damaged("broken.obj", "no model"): "cannot be read as a model",
        damaged("broken.csv", "theta_i,phi_i,theta_o,phi_o,fr\n1,2,3,4,x\n"): "line 2",
        damaged("bare.json", json.dumps({
            "format": "brdf-scene", "version": 1,
            "objects": [{"material": {"format": "brdf-material", "version": 1, "form": "lambert",
                                      "channels": ["r", "g", "b"], "weights": {"rho": [0.5, 0.5, 0.5]}},
                         "textures": {"albedo": "absent.png"}}]})): "absent.png: no such texture file",
        os.path.join(folder, "absent with a space.json"): "no such file",
    }
    for name, reason in bad.items():
        changed = differing(drop(name), state)
        assert not changed, f"dropping {name} changed {changed}"
    assert drop(*list(bad)[:2]) == state
    samples = os.path.join(source, "data/synthetic/cook_torrance_metal.csv")
    dropped = drop(samples)
    assert dropped["samples"] == samples and dropped["compare_with"] == "samples" and dropped["display"] == "split"
    across = highlight_across(dropped)
    assert across != 0.5 and abs(dropped["split"] - across) < 0.01, (dropped["split"], across)
    assert dropped["plot"]["theta"] == 40, dropped["plot"]  # the measured light nearest to 45
    dropped["plot"] = state["plot"]
    assert without_pictures(dropped) == without_pictures(state), "dropping samples lost something"
    copper = damaged("copper.json", json.dumps({
        "format": "brdf-material", "version": 1, "form": "phong", "channels": ["r", "g", "b"],
        "weights": {"kd": [0.4, 0.2, 0.1], "ks": [0.3, 0.3, 0.3]}, "shape": {"exponent": 40}}))
    several = drop(copper, list(bad)[0], os.path.join(source, "data/scenes/models/cube.x"))
    assert form_of(several) == "phong" and several["scene"]["objects"][0]["mesh"].endswith("cube.x")
    assert drop(os.path.join(source, "data/scenes/sphere.json"))["scene"]["objects"][0]["mesh"] == "sphere"
    reasons = [*bad.items(), *list(bad.items())[:2], list(bad.items())[0]]
    drop(state_file)
    time.sleep(1)
    state = saved_state()
    # The saved state is restored unchanged.
    press("n")
    x("key", "ctrl+l")
    time.sleep(1)
    assert saved_state() == state, "loading the saved state changed it"
    press("q")
    out = desk.finish(viewer)
    said = out.splitlines()
    assert len(said) == len(reasons), f"messages: {out}"
    for line, (name, reason) in zip(said, reasons):
        about = "absent.png" if "bare" in name else os.path.basename(name)
        assert line.startswith("brdf: ") and reason in line and about in line, f"{name}: {line}"

    # A display without a driver that draws into it.
    bare = subprocess.run([brdf, "view"], env=dict(environment, VK_DRIVER_FILES="/nonexistent"), capture_output=True,
                          text=True)
    assert bare.returncode == 3, f"without a driver: exit code {bare.returncode}: {bare.stderr}"
    assert bare.stderr.startswith("brdf: no Vulkan driver") and bare.stderr.count("\n") == 1, bare.stderr

    # Soak: the turntable on, A and B both drawn in every frame.
    state.update(turntable=True, display="split", compare_with="material")
    with open(state_file, "w") as file:
        json.dump(state, file)
    soak = start("--state", state_file, "--frames", soak_frames, "--width", "320", "--height", "240")
    out = desk.finish(soak)
    assert out == "", f"messages: {out}"
    print("viewer: all good")
finally:
    for process in ("viewer", "soak"):
        if process in globals() and globals()[process].poll() is None:
            globals()[process].kill()
    desk.close()
    shutil.rmtree(folder, ignore_errors=True)
