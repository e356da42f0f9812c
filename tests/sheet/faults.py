"""Plants faults of measurements into tables, one at a time, and determines whether a table can show a fault.

A table is canonical: theta_i, phi_i, theta_o, phi_o in degrees and one column of f_r for each channel. `FAULTS` is the only
list. For each fault it has the change of the rows, the words of which one must be in the finding of the data check, and the condition
under which the clean table can show the fault.
"""
import collections
import dataclasses
import math
import re
import statistics
from typing import Callable


def cos(degrees):
    return math.cos(math.radians(degrees))


def sin(degrees):
    return math.sin(math.radians(degrees))


@dataclasses.dataclass
class Row:
    theta_i: float
    phi_i: float
    theta_o: float
    phi_o: float
    values: list

    @property
    def turn(self):
        """Degrees between the azimuths of light and viewer, 0 to 180."""
        return abs(math.remainder(self.phi_o - self.phi_i, 360))

    @property
    def is_in_plane(self):
        return self.turn < 1 or self.turn > 179 or self.theta_o == 0

    def with_(self, **changes):
        return dataclasses.replace(self, **changes)

    def scaled(self, factor):
        return self.with_(values=[factor * v for v in self.values])


class Table:
    def __init__(self, comments, channels, rows):
        self.comments, self.channels, self.rows = comments, channels, rows

    @staticmethod
    def read(path):
        lines = [line.strip() for line in path.read_text(encoding="utf-8").splitlines() if line.strip()]
        header, *body = [line for line in lines if not line.startswith("#")]
        names = header.split(",")
        kept = [k for k, name in enumerate(names) if k >= 4 and not name.startswith("sigma_")]
        numbers = [[float(x) for x in line.split(",")] for line in body]
        rows = [Row(*n[:4], [n[k] for k in kept]) for n in numbers]
        return Table([line for line in lines if line.startswith("#")], [names[k] for k in kept], rows)

    def write(self, path, rows=None):
        text = [*self.comments, ",".join(["theta_i", "phi_i", "theta_o", "phi_o", *self.channels])]
        for r in self.rows if rows is None else rows:
            text.append(",".join("%.9g" % x for x in [r.theta_i, r.phi_i, r.theta_o, r.phi_o, *r.values]))
        path.write_text("\n".join(text) + "\n", encoding="utf-8")


class Facts:
    """Properties of a clean table in its darkest channel, in which a highlight is most distinct."""

    def __init__(self, table):
        self.table, self.rows = table, table.rows
        dark = min(range(len(table.channels)), key=lambda c: statistics.median(r.values[c] for r in self.rows))
        self.value = {id(r): r.values[dark] for r in self.rows}
        self.by_light = collections.defaultdict(list)
        for r in self.rows:
            self.by_light[round(r.theta_i, 3)].append(r)
        self.lights = sorted(self.by_light)
        self.middle_light = self.lights[len(self.lights) // 2]
        self.peaks = {light: p for light in self.lights if 15 <= light <= 75 and (p := self._peak(light)) is not None}
        self.contrast = statistics.median([self._contrast(light) for light in self.lights if 15 <= light <= 75] or [1])
        self.pairs = self._pairs()
        self.albedo = max(self._albedo(light, c) for light in self.lights for c in range(len(table.channels)))
        self.longest_run = self._longest_run()

    def of(self, row):
        return self.value[id(row)]

    def _forward(self, light):
        return sorted((r.theta_o, self.of(r)) for r in self.by_light[light] if r.turn > 179)

    def _peak(self, light):
        """Returns the distance between the vertex of the parabola through the logarithms and the mirror direction; None without a highlight."""
        line = self._forward(light)
        if len(line) < 5:
            return None
        at = max(range(len(line)), key=lambda k: line[k][1])
        middle = statistics.median(self.of(r) for r in self.by_light[light])
        if not 0 < at < len(line) - 1 or not line[at][1] > 3 * middle > 0:
            return None
        (a, fa), (b, fb), (c, fc) = line[at - 1:at + 2]
        if min(fa, fc) <= 0 or not a < b < c:
            return None
        left, right = (math.log(fb) - math.log(fa)) / (b - a), (math.log(fc) - math.log(fb)) / (c - b)
        return 0.5 * (a + b) + left * (c - a) / (2 * (left - right)) - light if left > right else None

    def _contrast(self, light):
        middle = statistics.median(self.of(r) for r in self.by_light[light])
        near = [v for theta, v in self._forward(light) if abs(theta - light) <= 10]
        return max(near) / middle if near and middle > 0 else 1

    def _pairs(self):
        """Yields (row, row with light and viewer exchanged, logarithm of the ratio of their values) if the grid has both rows."""
        places = {(round(r.theta_i, 2), round(r.theta_o, 2), round(r.turn, 1)): r for r in self.rows}
        found = []
        for (i, o, turn), row in places.items():
            other = places.get((o, i, turn))
            if i < o and other is not None and min(self.of(row), self.of(other)) > 0:
                found.append((row, other, math.log(self.of(row) / self.of(other))))
        return found

    def gains(self):
        by_light = collections.defaultdict(list)
        for row, other, ratio in self.pairs:
            by_light[round(row.theta_i, 3)].append(ratio)
            by_light[round(other.theta_i, 3)].append(-ratio)
        return {light: statistics.median(x) for light, x in by_light.items() if len(x) >= 6}

    def scatter(self):
        """Returns the standard deviation of the ratios of the pairs."""
        return 1.4826 * statistics.median([abs(ratio) for *_, ratio in self.pairs] or [math.inf])

    def _albedo(self, light, channel):
        """Returns pi times the value below which half of the projected solid angle lies, so that a highlight has no influence."""
        weighed = sorted((r.values[channel], cos(r.theta_o) * sin(r.theta_o)) for r in self.by_light[light])
        half, total = sum(w for _, w in weighed) / 2, 0
        for value, weight in weighed:
            total += weight
            if total >= half > 0:
                return math.pi * value
        return 0

    def _longest_run(self):
        run = longest = 1
        for a, b in zip(self.rows, self.rows[1:]):
            run = run + 1 if a.values == b.values else 1
            longest = max(longest, run)
        return longest


@dataclasses.dataclass
class Fault:
    plant: Callable
    words: re.Pattern
    told: Callable


FAULTS = {}


def fault(name, words, told=lambda facts: True):
    def keep(plant):
        FAULTS[name] = Fault(plant, re.compile(words), told)
        return plant
    return keep


# --- Angles ---------------------------------------------------------------------------------------------------------

def peaks_stand_at_the_mirror(facts):
    near = {light: p for light, p in facts.peaks.items() if light <= 50}
    return len(facts.peaks) >= 3 and len(near) >= 2 and max(map(abs, near.values())) < 0.8


def moved(rows, **offsets):
    out = [r.with_(**{name: getattr(r, name) + by for name, by in offsets.items()}) for r in rows]
    return [r for r in out if r.theta_i <= 90 and r.theta_o <= 90]


@fault("viewer_zero", "zero error", peaks_stand_at_the_mirror)
def _(facts):
    return moved(facts.rows, theta_o=2.2)


@fault("light_zero", "zero error", peaks_stand_at_the_mirror)
def _(facts):
    return moved(facts.rows, theta_i=-1.9)


@fault("light_label", "label", lambda f: len(f.peaks) >= 4 and f.middle_light in f.peaks and
       max(map(abs, f.peaks.values())) < 3)
def _(facts):
    label = facts.middle_light + 9
    return [r.with_(theta_i=label) if round(r.theta_i, 3) == facts.middle_light else r for r in facts.rows]


@fault("exchanged", "exchanged", lambda f: any(r.phi_o > 90 for r in f.rows))
def _(facts):
    return [r.with_(theta_o=r.phi_o, phi_o=r.theta_o) for r in facts.rows]


@fault("radians", "radians")
def _(facts):
    return [r.with_(**{name: math.radians(getattr(r, name)) for name in ("theta_i", "phi_i", "theta_o", "phi_o")})
            for r in facts.rows]


@fault("polar_radians", "radians")
def _(facts):
    return [r.with_(theta_i=math.radians(r.theta_i), theta_o=math.radians(r.theta_o)) for r in facts.rows]


@fault("azimuth", "add 180 degrees", lambda f: f.contrast > 4)
def _(facts):
    return [r.with_(phi_o=(r.phi_o + 180) % 360) for r in facts.rows]


@fault("elevation", "elevations", lambda f: f.contrast > 3 and len({round(r.turn) for r in f.rows}) > 2)
def _(facts):
    return [r.with_(theta_i=90 - r.theta_i, theta_o=90 - r.theta_o) for r in facts.rows]


# --- Scales ---------------------------------------------------------------------------------------------------------

def one_gain_stands_out(factor):
    def told(facts):
        gains = facts.gains()
        return (facts.middle_light in gains and len(gains) >= 3 and
                max(map(abs, gains.values())) < 0.4 * math.log(factor) and facts.scatter() < 1.5 * math.log(factor))
    return told


for amount in (1.18, 1.6):
    @fault(f"gain_{amount}", "the gain differs", one_gain_stands_out(amount))
    def _(facts, amount=amount):
        return [r.scaled(amount) if round(r.theta_i, 3) == facts.middle_light else r for r in facts.rows]


@fault("drift", "drifts", lambda f: len(f.pairs) >= 16 and f.scatter() < 0.12 and
       max(map(abs, f.gains().values()), default=1) < 0.05)
def _(facts):
    last = len(facts.rows) - 1
    return [r.scaled(1 + 0.35 * k / last) for k, r in enumerate(facts.rows)]


def lever(facts):
    return sum(abs(math.log(cos(a.theta_i) / cos(b.theta_i))) > 0.3 for a, b, _ in facts.pairs
               if max(a.theta_i, b.theta_i) < 89) >= 8


@fault("cos_i", r"times cos_i\b(?! cos_o)", lever)
def _(facts):
    return [r.scaled(cos(r.theta_i)) for r in facts.rows]


@fault("cos_o", "times cos_o", lever)
def _(facts):
    return [r.scaled(cos(r.theta_o)) for r in facts.rows]


@fault("both_cosines", "cos_i cos_o", lambda f: f.contrast < 2 and max(f.lights) >= 70 and lever(f))
def _(facts):
    return [r.scaled(cos(r.theta_i) * cos(r.theta_o)) for r in facts.rows]


@fault("reflectance_factor", r"\bBRF\b", lambda f: f.albedo > 0.65)
def _(facts):
    return [r.scaled(math.pi) for r in facts.rows]


@fault("factor_in_plane", r"\bBRF\b", lambda f: f.albedo > 0.65 and sum(r.is_in_plane for r in f.rows) >= 20)
def _(facts):
    return [r.scaled(math.pi) for r in facts.rows if r.is_in_plane]


@fault("percent", "percent|uncalibrated", lambda f: f.albedo > 0.02)
def _(facts):
    return [r.scaled(100 * math.pi) for r in facts.rows]


@fault("counts", "counts")
def _(facts):
    largest = max(max(r.values) for r in facts.rows)
    return [r.with_(values=[float(round(50000 * v / largest)) for v in r.values]) for r in facts.rows]


# --- Rows -----------------------------------------------------------------------------------------------------------

@fault("dark_zeros", "fill value", lambda f: any(r.values[0] < sorted(x.values[0] for x in f.rows)[len(f.rows) // 8]
                                                 for r in f.rows))
def _(facts):
    level = sorted(r.values[0] for r in facts.rows)[len(facts.rows) // 8]
    return [r.scaled(0) if r.values[0] < level else r for r in facts.rows]


def is_beside_the_light(row):
    apart = cos(row.theta_i) * cos(row.theta_o) + sin(row.theta_i) * sin(row.theta_o) * cos(row.turn)
    return apart > cos(9)


@fault("blind_zeros", "fill value", lambda f: sum(map(is_beside_the_light, f.rows)) >= 4)
def _(facts):
    return [r.scaled(0) if is_beside_the_light(r) else r for r in facts.rows]


@fault("sentinel", "fill value", lambda f: len(f.rows) >= 60)
def _(facts):
    return [r.with_(values=[-9.99] * len(r.values)) if k % 23 == 5 else r for k, r in enumerate(facts.rows)]


@fault("stuck", "stuck", lambda f: f.longest_run < 4 and len(f.rows) >= 60)
def _(facts):
    first = len(facts.rows) // 3
    return [r.with_(values=facts.rows[first].values) if first <= k < first + 10 else r for k, r in enumerate(facts.rows)]


@fault("saturated", "saturated", lambda f: f.contrast > 2 and
       sum(v > 0.35 * max(f.value.values()) for v in f.value.values()) >= 5)
def _(facts):
    ceilings = [0.35 * max(r.values[c] for r in facts.rows) for c in range(len(facts.table.channels))]
    return [r.with_(values=[min(v, top) for v, top in zip(r.values, ceilings)]) for r in facts.rows]


@fault("outlier", "far from all neighbours", lambda f: len(f.rows) >= 60 and
       f.rows[len(f.rows) // 4].values[0] > 0.4 * statistics.median(r.values[0] for r in f.rows))
def _(facts):
    return [r.scaled(4) if k == len(facts.rows) // 4 else r for k, r in enumerate(facts.rows)]


@fault("negative", "negative value")
def _(facts):
    at = len(facts.rows) // 2
    return [r.with_(values=[-0.3 * v for v in r.values]) if k == at else r for k, r in enumerate(facts.rows)]


@fault("copied_row", "duplicated")
def _(facts):
    return [*facts.rows, facts.rows[len(facts.rows) // 2]]
