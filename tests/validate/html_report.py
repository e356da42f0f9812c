"""What the two tests of the HTML report share: how it is made, and a reader of its elements."""
import html.parser
import json
import pathlib
import re
import subprocess

VOID = {"area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source", "track", "wbr"}
PLOTS = re.compile(r"const plots = (\[.*?\n\]);", re.DOTALL)


class Document(html.parser.HTMLParser):
    """Elements in order as (tag, attributes), text by element; a tag that does not match its end is an error."""

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
    """The canvases of plots; those of spheres have no name."""
    return [k for k in document.places("canvas") if "id" in document.elements[k][1]]


def plots_of(text):
    return json.loads(PLOTS.search(text).group(1))


def make_reports(executable, folder):
    """A report of forms with and without violations and one of a table: their paths."""
    folder = pathlib.Path(folder)
    table = folder / "table.csv"
    run([executable, "synth", "--form", "cook_torrance", "--set", "kd=0.3,0.2,0.1", "--set", "alpha=0.3",
         "--noise", "0.05", "-o", table])
    reports = [folder / "forms.html", folder / "table.html"]
    run([executable, "validate", "--form", "ward_duer", "--form", "cook_torrance_as_printed", "-o", reports[0]])
    run([executable, "validate", table, "-o", reports[1]])
    return reports


def run(words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    assert done.returncode == 0, (words, done.stderr)
    return done
