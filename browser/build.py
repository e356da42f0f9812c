#!/usr/bin/env python3
"""Writes the page of the browser in two layouts.

    build.py --module FOLDER --examples FOLDER --output FOLDER

FOLDER of --module has brdf.js and brdf.wasm, the program as WebAssembly. FOLDER of --examples has the tables that EXAMPLES names.
The output has the folder site/, files for any web server, and brdf.html, one file that also works from a disk. The sources are in
browser/page; the colours and the look come from the page of the reports, io/page/html_page.css.
"""
import argparse
import base64
import html
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = ("dom.js", "engine.js", "link.js", "queue.js", "results.js", "plot.js", "catalogue.js", "page.js")  # one scope, in this order
EXAMPLES = {"oren_nayar.csv": "a rough diffuse surface in three channels, with 5 % noise",
            "ward.csv": "a gloss over a diffuse base, without noise",
            "phong_sparse.csv": "26 readings, with 2 % noise"}

# The report in its frame inherits the policy, and its plots are scripts within the page: hence 'unsafe-inline'. The page forbids
# connections when its parts are loaded.
POLICY = ("default-src 'none'; script-src {own}'unsafe-inline' 'wasm-unsafe-eval' blob:; worker-src blob:; connect-src {connect}; "
          "style-src {own}'unsafe-inline'; img-src data: blob:; form-action 'none'; base-uri 'none'")


def read(path):
    if not path.is_file():
        sys.exit(f"build.py: {path}: there is no such file")
    return path.read_bytes()


def style():
    return (read(HERE.parent / "io/page/html_page.css") + read(HERE / "page/page.css")).decode()


def script():
    parts = [f"// {name}\n{read(HERE / 'page' / name).decode()}" for name in SCRIPTS]
    return '(() => {\n"use strict";\n' + "\n".join(parts) + "})();\n"


def examples():
    """Returns a button for each table; the page enables it when the table is loaded."""
    return "\n".join(f'<li><button type="button" disabled data-example="{name}">{name}</button> example: {html.escape(about)}</li>'
                     for name, about in EXAMPLES.items())


def page(**parts):
    template = read(HERE / "page/index.html").decode()
    return re.sub(r"@(\w+)@", lambda m: parts[m[1]], template)


def within_script(name, text):
    """Returns a text as it is written between the tags of a script, which it must not end."""
    if re.search(r"</script|<!--", text, re.I):
        sys.exit(f"build.py: {name} has a text that would end a script of HTML; write <\\/script> in its strings")
    return text


def data(name, text):
    return f'<script type="text/plain" data-part="{name}">{within_script(name, text)}</script>'


def write_site(folder, parts):
    folder.mkdir(parents=True, exist_ok=True)
    text = page(policy=POLICY.format(own="'self' ", connect="'self'"), style='<link rel="stylesheet" href="page.css">', parts="",
                script='<script src="page.js"></script>', examples=examples())
    files = parts | {"index.html": text.encode(), "page.css": style().encode(), "page.js": script().encode()}
    for name, content in files.items():
        (folder / name).write_bytes(content)


def write_single(path, parts):
    held = [data(name, base64.b64encode(content).decode() if name.endswith(".wasm") else content.decode()) for name, content in parts.items()]
    text = page(policy=POLICY.format(own="", connect="'none'"), style=f"<style>\n{style()}</style>", parts="\n".join(held),
                script=f"<script>\n{within_script('page.js', script())}</script>", examples=examples())
    path.write_bytes(text.encode())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("module", "examples", "output"):
        parser.add_argument(f"--{name}", type=pathlib.Path, required=True, metavar="FOLDER")
    options = parser.parse_args()
    parts = {name: read(options.module / name) for name in ("brdf.js", "brdf.wasm")}
    parts["worker.js"] = read(HERE / "page/worker.js")
    parts |= {name: read(options.examples / name) for name in EXAMPLES}
    write_site(options.output / "site", parts)
    write_single(options.output / "brdf.html", parts)


if __name__ == "__main__":
    main()
