# ctest: validate.html label=validate @brdf@
"""The HTML report is well-formed, refers to nothing outside itself, states the verdict first and has plots with
data, each with its command: html_test.py EXECUTABLE"""
import base64
import os
import re
import subprocess
import sys
import tempfile

from html_report import Document, charts_of, make_reports, plots_of

OUTSIDE = re.compile(r"(?:https?|ftp|file|wss?):|^//", re.IGNORECASE)
REFERENCES = {"src", "href", "srcset", "action", "data", "poster", "background", "formaction", "xlink:href"}


def check_self_contained(text, document):
    assert not re.search(r"\bhttps?://", text), "the report holds an address"
    for tag, attributes in document.elements:
        for name, value in attributes.items():
            if name in REFERENCES:
                assert value.startswith("data:") and not OUTSIDE.search(value), f"<{tag} {name}={value[:60]}>"
    for k in document.places("style"):
        assert not re.search(r"@import|url\(", document.texts[k]), "the style loads something"
    own = document.texts[document.places("script")[-1]]
    assert not re.search(r"fetch\(|import\(|XMLHttpRequest|WebSocket", own), "the script loads something"


def check_verdict_first(document):
    verdict, = document.places("p", "verdict")
    heading = document.places("h1")[0]
    assert verdict == heading + 1, "something stands between the title and the verdict"
    assert re.search(r"\d+ passed.*\d+ failed", document.texts[verdict]), document.texts[verdict]
    first_plot = min(charts_of(document))
    words = [document.texts[k] for k in document.places("td") if k < first_plot]
    for outcomes in (("pass",), ("known violation", "not applicable")):
        assert any(word.startswith(outcomes) for word in words), words


def check_plots(text, document):
    plots = plots_of(text)
    ids = [document.elements[k][1]["id"] for k in charts_of(document)]
    assert ids == [f"plot{k}" for k in range(len(plots))], ids
    for plot in plots:
        assert plot["title"] and plot["x_label"] and plot["y_label"] and plot["series"], plot["title"]
        for series in plot["series"]:
            points = [(x, y) for x, y in zip(series["x"], series["y"]) if x is not None and y is not None]
            assert len(points) >= 2 and len(series["x"]) == len(series["y"]), (plot["title"], series["label"])
            for low, y, high in zip(series.get("low", []), series["y"], series.get("high", [])):
                assert low <= y <= high, plot["title"]
    assert any("low" in s for p in plots for s in p["series"]), "no plot has a band"
    figures = [k for k in document.places("figure")] + [len(document.elements)]
    for k in charts_of(document):  # folded, in the figure
        rest = [tag for tag, _ in document.elements[k:next(f for f in figures if f > k)]]
        assert "details" in rest and "pre" in rest, f"{document.elements[k][1]['id']} lacks its command"
    for k in document.places("img"):
        png = base64.b64decode(document.elements[k][1]["src"].split(",", 1)[1], validate=True)
        assert png.startswith(b"\x89PNG\r\n\x1a\n") and len(png) > 200, "a picture without a picture"
    return len(plots)


def check_commands(executable, folder, document):
    """Requires that every command in the report runs."""
    environment = dict(os.environ, PATH=f"{os.path.dirname(os.path.abspath(executable))}:{os.environ['PATH']}")
    commands = [document.texts[k] for k in document.places("pre")]
    for command in commands:
        run = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, capture_output=True, text=True,
                             check=False)
        assert run.returncode == 0 and run.stdout, (command, run.stderr)
    return len(commands)


def check_the_checks():
    """Tests that the checks refuse faulty pages, so that a pass is evidence."""
    for broken in ("<p><b></p></b>", "<div>", "<img src='a' src='b'>"):
        try:
            Document(broken)
        except AssertionError:
            continue
        sys.exit(f"accepted as well-formed: {broken}")
    for outside in ("<img src='http://a/b'>", "<img src='picture.png'>", "<a href='//a'></a>"):
        try:
            check_self_contained("", Document(outside + "<script></script>"))
        except AssertionError:
            continue
        sys.exit(f"accepted as self-contained: {outside}")


def main():
    check_the_checks()
    with tempfile.TemporaryDirectory() as folder:
        for path, least in zip(make_reports(sys.argv[1], folder), (8, 2)):
            text = path.read_text(encoding="utf-8")
            document = Document(text)
            check_self_contained(text, document)
            check_verdict_first(document)
            count = check_plots(text, document)
            assert count >= least, f"{path.name}: {count} plots"
            commands = check_commands(sys.argv[1], folder, document)
            print(f"{path.name}: well-formed, self-contained, verdict first, {count} plots with data, "
                  f"{commands} commands that run")


main()
