"""The window of `brdf view` on a virtual display: the positions of its parts, and the values of its pixels."""
import os
import time

import pixels


class Window:
    """One run of the window on a desk, at a size and scale."""

    def __init__(self, desk, pictures, width, height, scale, *arguments):
        self.pictures = pictures  # a folder for what is kept, or None
        self.desk, self.width, self.height, self.scale = desk, width, height, scale
        self.panel = int(min(320 * scale, 0.45 * width))
        self.column = 330 * scale if width - self.panel >= 730 * scale else 0  # of the plots, where there is room
        self.viewer = desk.start("--width", str(width), "--height", str(height), "--scale", str(scale), *arguments)
        desk.find_window()

    def picture(self, x, y):
        """Returns a position in the picture next to the panel, from fractions across and down."""
        return self.panel + x * (self.width - self.panel), y * self.height

    def rows(self):
        return self.desk.shown(self.width, self.height)

    def keep(self, name):
        if self.pictures:
            os.makedirs(self.pictures, exist_ok=True)
            pixels.write_png(os.path.join(self.pictures, f"{name}_{self.width}.png"), self.rows())

    def knobs(self):
        """Returns the centres of the knobs of the sliders from top to bottom. Only knobs have this blue in the panel."""
        found = []
        for y, row in enumerate(self.rows()):
            across = [k for k in range(self.panel) if row[k][2] > 150 and row[k][2] > row[k][0] + 70 > 100
                      and row[k][2] > row[k][1] + 40]
            if len(across) < 3:
                continue
            place = (sum(across) / len(across), y)
            if found and y - found[-1][1][1] <= 2:
                found[-1][1] = place
            else:
                found.append([place, place])
        return [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in found if b[1] - a[1] >= 8]

    def strip(self, y):
        """Returns the pixels of the panel at this height."""
        return self.rows()[round(y)][:self.panel]

    def knob(self, y):
        """Waits for the knob of the slider at this height, and returns the knob."""
        found = []

        def look():
            found[:] = [k for k in self.knobs() if abs(k[1] - y) < 8 * self.scale]
            return found

        self.until(look)
        return found[0]

    def intervals(self):
        """Returns, for each slider with a green bar, the distance of the end of the bar from the middle of the knob, at scale 1; 0 if the
        knob covers the end."""
        rows, out = self.rows(), []
        for x, y in self.knobs():
            green = [k for row in rows[round(y):round(y + 14 * self.scale)] for k in range(self.panel)
                     if row[k][1] > 190 > row[k][0] + 40 and row[k][1] > row[k][2] + 50]
            if green:
                out.append(max(min(green) - x, x - max(green), 0) / self.scale)
        return out

    def until(self, what, seconds=120):
        """Waits for a title, or another sign."""
        end = time.time() + seconds
        while not what():
            assert time.time() < end, f"waited for {seconds} s; the title is {self.desk.title()}"
            time.sleep(0.1)

    def plots(self):
        """Returns the column next to the picture: lobes, slice and residuals."""
        return [row[self.width - int(self.column):] for row in self.rows()] if self.column else []

    def differing(self, before):
        """Returns the share of pixels of the column that differ from an earlier column; 0 without a column."""
        pairs = [(a, b) for one, other in zip(self.plots(), before) for a, b in zip(one, other)]
        return sum(max(abs(i - j) for i, j in zip(a, b)) > 20 for a, b in pairs) / len(pairs) if pairs else 0

    def status_colour(self):
        """Returns whether the line below the picture has words in the colour of errors."""
        line = self.rows()[-int(26 * self.scale):]
        return any(r > 200 and g < 170 and b < 170 and r > g + 60 for row in line for r, g, b in row[self.panel:])
