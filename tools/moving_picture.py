#!/usr/bin/env python3
"""Makes the moving picture of the README: a page of `brdf study`, then the window of `brdf view`.

    tools/moving_picture.py [--brdf build/release/brdf] [--samples TABLE] [--frames FOLDER] [-o PICTURE]

The samples are studied with one form. The page of the study is shown in Chromium. The window shows the
samples next to the fitted material on a virtual display: the roughness is dragged, the slice and the
residuals show the error, and Ctrl-F fits again. --frames keeps the frames. The picture takes some minutes.
Exit codes: 0 good, 1 the picture is too large, 2 usage, 3 a program or a file is missing (tools/setup test
full).
"""
import argparse
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "tests/render"), str(ROOT / "tests/validate")]
import pixels
from browser import SOFTWARE, Browser
from desk import Desk
from window_screen import Window

WIDTH, HEIGHT = 1060, 640  # the narrowest window with plots beside the picture
FORM = "cook_torrance"
PROGRAMS = ("Xvfb", "xdotool", "chromium", "cwebp", "webpmux")
LARGEST = 1_500_000  # bytes


class Film:
    """Frames with their durations."""

    def __init__(self, folder):
        self.folder, self.frames = folder, []

    def path(self, milliseconds):
        self.frames.append((self.folder / f"frame_{len(self.frames):03}.png", milliseconds))
        return self.frames[-1][0]

    def write(self, path, quality):
        """Writes the animation, each frame as the rectangle of its changes; returns the seconds.

        img2webp leaves pixels unchanged that differ by little, which shows in smooth pictures.
        """
        words, before = [], None
        for frame, milliseconds in self.frames:
            rows = pixels.png(frame.read_bytes())
            left, top, right, bottom = changed(before, rows)
            part = frame.with_suffix(".webp")
            crop = map(str, (left, top, right - left, bottom - top))
            subprocess.run(["cwebp", "-quiet", "-m", "6", "-sharp_yuv", "-q", str(quality), "-crop", *crop,
                            str(frame), "-o", str(part)], check=True)
            words += ["-frame", str(part), f"+{milliseconds}+{left}+{top}+0-b"]
            before = rows
        subprocess.run(["webpmux", *words, "-loop", "0", "-o", str(path)], check=True, capture_output=True)
        return sum(milliseconds for _, milliseconds in self.frames) / 1000


def changed(before, rows):
    """Returns (left, top, right, bottom) of the rectangle of changes; WebP wants even left and top."""
    height, width = len(rows), len(rows[0])
    if before is None:
        return 0, 0, width, height
    lines = [y for y in range(height) if rows[y] != before[y]] or [0]
    columns = [x for x in range(width) if any(rows[y][x] != before[y][x] for y in lines)] or [0]
    return columns[0] & ~1, lines[0] & ~1, columns[-1] + 1, lines[-1] + 1


def glide(page, film, start, end):
    """Scrolls the page, with a frame for each step but the last."""
    for step in range(1, 7):
        share = (1 - math.cos(math.pi * step / 7)) / 2
        page.evaluate(f"scrollTo({{top: {start + share * (end - start)}, behavior: 'instant'}})")
        page.evaluate("new Promise(done => setTimeout(done, 200))")
        page.screenshot(film.path(70), whole=False)
    page.evaluate(f"scrollTo({{top: {end}, behavior: 'instant'}})")
    page.evaluate("new Promise(done => setTimeout(done, 500))")


def show_page(film, page_file):
    """Shows the head of the page with its spheres, then the first plot."""
    with Browser("chromium", *SOFTWARE) as browser, browser.open(page_file, WIDTH, HEIGHT) as page:
        page.wait("document.querySelector('figure.sphere')?.dataset.shown")
        page.screenshot(film.path(2200), whole=False)
        plot = "document.querySelector('canvas[id]')"
        top = page.evaluate(f"{plot}.getBoundingClientRect().top + scrollY - 110")
        glide(page, film, 0, top)
        page.screenshot(film.path(2000), whole=False)


def show_window(film, brdf, folder, material, samples):
    """Drags the roughness away from the fit, then fits again with Ctrl-F."""
    desk = Desk(str(brdf), str(folder), WIDTH, HEIGHT)
    window = None
    try:
        words = (str(material), "--measured", str(samples), "--hard-light")
        window = Window(desk, None, WIDTH, HEIGHT, 1, *words)

        def keep(milliseconds):
            pixels.write_png(film.path(milliseconds), window.rows())

        solved = json.loads(material.read_text(encoding="utf-8"))
        desk.press("s", "l")
        desk.frame = 0.5
        desk.pause(5)
        fitted = window.plots()
        keep(1000)
        # The sliders of the weights come first.
        knob = window.knobs()[sum(len(values) for values in solved["weights"].values())]
        for step in range(5):
            desk.move(knob[0] + 12 * (4 - step), knob[1] + 20 * (4 - step))
            desk.pause(2)
            keep(80)
        desk.x("mousedown", 1)
        for step in range(1, 9):
            desk.move(knob[0] + 2.5 * step, knob[1])
            desk.pause(3)
            keep(120)
        desk.x("mouseup", 1)
        away = (window.panel + 20, HEIGHT - 60)
        desk.move(*away)
        desk.pause(5)
        window.until(lambda: window.differing(fitted) > 0.03)
        keep(1300)
        desk.press("ctrl+f")
        for _ in range(3):
            keep(200)
        window.until(lambda: window.differing(fitted) < 0.01)
        desk.pause(5)
        keep(2400)
        found = desk.saved_state()["scene"]["objects"][0]["material"]
        assert agrees(found, solved), "the fit has not found the material again"
        desk.press("q")
        desk.pause(5)
    finally:
        if window and window.viewer.poll() is None:
            window.viewer.terminate()
            window.viewer.wait()
        desk.close()


def agrees(material, other):
    """Returns whether two materials of one form, with a shape for all channels, agree in the shape to 1 %."""
    return all(abs(material["shape"][name] - value) <= 0.01 * abs(value)
               for name, value in other["shape"].items())


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--brdf", default=str(ROOT / "build/release/brdf"), help="the program")
    parser.add_argument("--samples", default=str(ROOT / "data/synthetic/cook_torrance_metal.csv"),
                        help="the table")
    parser.add_argument("--quality", type=int, default=75, help="of the encoder, 0 to 100")
    parser.add_argument("--frames", help="a folder that keeps the frames")
    parser.add_argument("-o", "--output", default=str(ROOT / "docs/img/product.webp"))
    options = parser.parse_args()
    missing = [name for name in PROGRAMS if not shutil.which(name)]
    missing += [name for name in (options.brdf, options.samples) if not os.path.isfile(name)]
    if missing:
        print(f"tools/moving_picture.py: {missing[0]} is missing", file=sys.stderr)
        return 3
    brdf, samples = os.path.abspath(options.brdf), os.path.abspath(options.samples)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        frames = pathlib.Path(options.frames or folder / "frames")
        frames.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(samples, folder / "metal.csv")
        subprocess.run([brdf, "study", "metal.csv", "--form", FORM, "-o", "metal"], cwd=folder, check=True,
                       stdout=subprocess.DEVNULL)
        film = Film(frames)
        show_page(film, folder / "metal/index.html")
        shutil.copyfile(folder / "metal/material.json", folder / "metal.json")
        show_window(film, brdf, folder, folder / "metal.json", folder / "metal.csv")
        seconds = film.write(options.output, options.quality)
    size = os.path.getsize(options.output)
    print(f"{options.output}: {len(film.frames)} frames, {seconds:.1f} s, {size / 1e6:.2f} MB")
    return int(size > LARGEST)


if __name__ == "__main__":
    sys.exit(main())
