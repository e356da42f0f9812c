#!/usr/bin/env python3
# ctest: style.links label=style @source@
"""links.py ROOT: every relative link of every document leads to a file, and every fragment to a heading of that file; docs/index.md
links every page of docs."""
import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)\s]+)\)")
CODE = re.compile(r"^```.*?^```|^    .*?$|`[^`]*`", re.M | re.S)


def anchors(document):
    """Returns the fragments of a document's headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.+)$", document.read_text(), re.M)
    return {re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-") for h in headings}


def faults(root):
    found = looked_at = 0
    for document in sorted(root.rglob("*.md")):
        if {"build", "node_modules", ".git"} & set(document.relative_to(root).parts):
            continue
        for link in LINK.findall(CODE.sub("", document.read_text())):
            if re.match(r"[a-z]+:", link):
                continue
            looked_at += 1
            path, _, fragment = link.partition("#")
            target = (document.parent / path) if path else document
            if not target.exists():
                print(f"{document.relative_to(root)}: {link}: there is no such file")
                found += 1
            elif fragment and target.suffix == ".md" and fragment not in anchors(target):
                print(f"{document.relative_to(root)}: {link}: {target.name} has no such heading")
                found += 1
    print(f"{looked_at} links, {found} lead nowhere")
    return found + unlisted(root) or not looked_at


def unlisted(root):
    """Returns the number of pages of docs that the start page does not link. Templates and single decisions are not listed."""
    docs = root / "docs"
    listed = {(docs / link.partition("#")[0]).resolve() for link in LINK.findall((docs / "index.md").read_text())}
    pages = [p for p in docs.rglob("*.md") if not p.name.endswith(".in.md") and p.parent.name not in ("decisions", "api")]
    missing = [p for p in sorted(pages) if p.name != "index.md" and p not in listed]
    for page in missing:
        print(f"docs/index.md: does not link {page.relative_to(root)}")
    return len(missing)


sys.exit(bool(faults(pathlib.Path(sys.argv[1]).resolve())))
