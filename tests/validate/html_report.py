"""Shared parts of the two tests of the HTML report: the commands that write the reports, and a reader of their elements."""
import html.parser
import json
import pathlib
import re
import struct
import subprocess
import zlib

VOID = {"area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source", "track", "wbr"}
PLOTS = re.compile(r"const plots = (\[.*?\n\]);", re.DOTALL)


class Document(html.parser.HTMLParser):
    """The elements of a page in order as (tag, attributes), with their texts. A tag without its end is an error."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.open, self.elements, self.texts = [], [], []
        self.feed(text)
        self.close()
        assert not self.open, f"never closed: {self.open}"

    def handle_starttag(self, tag, attrs):
        names = [name for name, _ in attrs]
        assert len(names) == len(set(names)), f"<{tag}> repeats an attribute: {names}"
        self.elements.append((tag, dict(attrs)))
        self.texts.append("")
        if tag not in VOID:
            self.open.append((tag, len(self.elements) - 1))

    def handle_endtag(self, tag):
        assert self.open and self.open[-1][0] == tag, f"</{tag}> ends {self.open[-1:]}"
        self.open.pop()

    def handle_data(self, data):
        for _, index in self.open:
            self.texts[index] += data

    def places(self, tag, css_class=None):
        return [k for k, (name, attrs) in enumerate(self.elements)
                if name == tag and (css_class is None or css_class in (attrs.get("class") or "").split())]


def charts_of(document):
    """Returns the canvases of plots; the canvases of spheres have no name."""
    return [k for k in document.places("canvas") if "id" in document.elements[k][1]]


def plots_of(text):
    found = PLOTS.search(text)
    return json.loads(found.group(1)) if found else []


def make_reports(executable, folder):
    """Writes a report of forms with and without violations and a report of a table. Returns the paths of both."""
    folder = pathlib.Path(folder)
    table = folder / "table.csv"
    run([executable, "synth", "--form", "cook_torrance", "--set", "kd=0.3,0.2,0.1", "--set", "alpha=0.3",
         "--noise", "0.05", "-o", table])
    reports = [folder / "forms.html", folder / "table.html"]
    run([executable, "validate", "--form", "phong_unnormalised", "--form", "cook_torrance_as_printed", "-o", reports[0]])
    run([executable, "validate", table, "-o", reports[1]])
    return reports


def write_png(path, size=64):
    """Writes a grey square, for machines that cannot render."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + bytes(3 * [128]) * size for _ in range(size))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def make_pages(executable, folder):
    """Writes the page of every other verb that writes pages, in addition to make_reports(); recommend only if it can render."""
    folder = pathlib.Path(folder)
    yield from make_reports(executable, folder)
    table, spectrum = folder / "table.csv", folder / "spectrum_with_a_long_name_that_no_phone_has_room_for.csv"
    run([executable, "synth", "--form", "ward", "--set", "kd=" + ",".join(str(0.1 + 0.02 * k) for k in range(9)),
         "--noise", "0.02", "-o", spectrum])
    lines = spectrum.read_text(encoding="utf-8").splitlines()
    head = next(k for k, line in enumerate(lines) if not line.startswith("#"))
    lines[head] = "theta_i,phi_i,theta_o,phi_o," + ",".join(f"{400 + 40 * k}nm" for k in range(9))
    spectrum.write_text("\n".join(lines) + "\n", encoding="utf-8")
    run([executable, "fit", table, "--form", "all", "-o", folder / "table.json", "--report", folder / "fit.html"])
    yield folder / "fit.html"
    run([executable, "fit", spectrum, "--form", "auto", "--report", folder / "fit_spectrum.html"])
    yield folder / "fit_spectrum.html"
    run([executable, "fit", table, spectrum, "--form", "ward", "-o", folder / "batch"], allowed=(0, 1))
    yield folder / "batch" / "summary.html"
    write_png(folder / "table.png")
    run([executable, "validate", folder / "table.json", table, "--picture", folder / "table.png", "-o",
         folder / "material.html"], allowed=(0, 1))
    yield folder / "material.html"
    many = json.loads(run([executable, "models", "--json"]).stdout)["forms"][:9]  # more than a matrix has columns
    run([executable, "validate", *(f"--form={form['form']}" for form in many), "-o", folder / "many_forms.html"])
    yield folder / "many_forms.html"
    run([executable, "trade", "--quick", "--only", "Fresnel", "-o", folder / "trade.html"])
    yield folder / "trade.html"
    data = pathlib.Path(__file__).resolve().parents[2] / "data"
    done = run([executable, "recommend", "--scene", data / "scenes" / "recommend_distant.json", "--reference",
                data / "materials" / "rolled_brass.json", "--ledger", data / "ledger.json", "-o", folder / "recommend"],
               allowed=(0, 3))
    if done.returncode == 3:
        print("no renderer here: no page of recommend")
    else:
        (folder / "recommend" / "report.html").rename(folder / "recommend.html")
        yield folder / "recommend.html"


def run(words, allowed=(0,)):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    assert done.returncode in allowed, (words, done.stderr)
    return done
