#!/usr/bin/env python3
"""Writes docs/trade.md from docs/trade.in.md, with the pictures in docs/trade: every table and every number from a
ledger, from `brdf recommend` and from `brdf render`.

    build/release/brdf trade -o data/ledger.json && tools/trade_doc.py      # on an idle machine
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = [("recommend_close_up", "glossy_grey_paper"), ("recommend_grazing", "rolled_brass"),
          ("recommend_distant", "article_glass")]
# The most frequent questions of practitioners; the other rows are in the ledger.
TABLES = ["cook_torrance: precision and kernels", "Fresnel of glass", "Fresnel of aluminium", "masking for GGX",
          "masking for Beckmann", "power of a cosine, n = 32", "mirror direction or half vector", "D of GGX in float",
          "cheaper inside cook_torrance", "families for a material of cook_torrance", "one by one or in batches",
          "a family in the shader", "albedo of GGX", "integrating an albedo", "samples for a fit",
          "bits of the G-buffer, alpha 0.05", "forward or deferred, 1 light", "forward or deferred, 64 lights"]
LOW_SPHERE, LOOKUP = "data/scenes/low_sphere.json", "data/scenes/car_lookup.json"
PICTURES = {"flat": [LOW_SPHERE, "--shading", "flat"],
            "gouraud": [LOW_SPHERE, "--shading", "gouraud"],
            "phong": [LOW_SPHERE, "--shading", "phong"],
            "phong_ascoded": [LOW_SPHERE, "--shading", "phong", "--as-coded"],
            "phong_blinn": [LOW_SPHERE, "--shading", "phong_blinn"],
            "phong_blinn_pervertex": [LOW_SPHERE, "--shading", "phong_blinn", "--per-vertex"],
            "lookup_pixel": [LOOKUP],
            "lookup_vertex": [LOOKUP, "--per-vertex"],
            "lookup_slip": [LOOKUP, "--as-coded"]}


def figure(x):
    return "-" if x is None else f"{x:.3g}"


def line(cells):
    return "| " + " | ".join(cells) + " |\n"


def header(cells):
    return line(cells) + "|" + "---|" * len(cells) + "\n"


def time(ns):
    for limit, unit, scale in ((1e3, "ns", 1), (1e6, "us", 1e3), (1e9, "ms", 1e6)):
        if ns < limit:
            return f"{ns / scale:.3g} {unit}"
    return f"{ns / 1e9:.3g} s"


class Ledger:
    def __init__(self, path):
        self.path = path
        self.json = json.loads(pathlib.Path(path).read_text())

    def rows(self, question):
        found = [r for r in self.json["rows"] if r["question"] == question]
        if not found:
            sys.exit(f"{self.path} has no question '{question}'")
        return found

    def row(self, question, choice):
        for r in self.rows(question):
            if r["choice"] == choice:
                return r
        sys.exit(f"{self.path} has no row '{question}: {choice}'")

    def value(self, question, choice, field):
        r = self.row(question, choice)
        return r[field] if field in r else r["error"][field]


def table(ledger, name, keep=lambda r: True):
    rows = [r for r in ledger.rows(name) if keep(r)]
    e = rows[0]["error"]
    text = f"**{name}** ({e['measure']} error of {e['of']}; {rows[0]['domain']})\n\n"
    text += header(["choice", "time", "cost", "max", "mean", "p99", "image", "front"])
    for r in rows:
        e = r["error"]
        text += line([r["choice"], time(r["cost_ns"]), figure(r["cost_ratio"]), figure(e["max"]), figure(e["mean"]),
                      figure(e["p99"]), figure(r["image_error"]),
                      f"dominated by {r['dominated_by']}" if r["dominated_by"] else "yes"])
    return text + "\n"


def fronts(ledger):
    text = header(["question", "its front, cheapest first: cost, mean error, image error"])
    for name in TABLES:
        rows = sorted((r for r in ledger.rows(name) if not r["dominated_by"]), key=lambda r: r["cost_ratio"])
        text += line([name, "; ".join(f"**{r['choice']}** {figure(r['cost_ratio'])}, {figure(r['error']['mean'])}, "
                                      f"{figure(r['image_error'])}" for r in rows)])
    return text


def some_textures(row):
    """Selects the smallest lookup texture, and the texture of the article's size in every depth."""
    choice = row["choice"]
    return "^2" not in choice or "8 bit" in choice and choice.startswith(("32^2", "128^2")) or choice.startswith("512^2")


def claims(ledger):
    text = header(["claim", "verdict", "evidence", "row"])
    for c in ledger.json["claims"]:
        text += line([f"{c['claim']} ({c['source']})", c["verdict"], c["evidence"], f"{c['question']}: {c['choice']}"])
    return text


def run(brdf, *arguments, codes=(0, 1)):
    done = subprocess.run([brdf, *arguments], cwd=ROOT, stdout=subprocess.PIPE, check=False)
    if done.returncode not in codes:
        sys.exit(f"brdf {' '.join(arguments)}: exit code {done.returncode}")
    return done.stdout


def recommendations(brdf, ledger):
    text = header(["scene", "reference", "tolerance", "answer", "image error", "ns"])
    for scene, material in SCENES:
        for tolerance in ("0.01", "0.05", "0.2"):
            r = json.loads(run(brdf, "recommend", "--scene", f"data/scenes/{scene}.json", "--reference",
                               f"data/materials/{material}.json", "--tolerance", tolerance, "--ledger", ledger.path,
                               "--json"))
            c = r["chosen"]
            name = "none" if not c else ", ".join(
                filter(None, [c["form"], "two widths" if c["anisotropic"] else None, c["choice"]]))
            text += line([scene, material, tolerance, name, figure(r["rendered_image_error"]),
                          figure(c and c["cost_ns"])])
    return text


def weightings(brdf):
    r = json.loads(run(brdf, "recommend", "--compare-weightings", "data", "--json"))
    text = header(["scene", "material", "form", "scene-weighted", "hemisphere-wide"])
    for row in r["rows"]:
        text += line([row["scene"], row["material"], row["form"], figure(row["scene_weighted"]),
                      figure(row["hemisphere_wide"])])
    return text + f"\nImage errors; the scene's weighting is better in {r['better']} of {len(r['rows'])}.\n"


def machine(ledger):
    m = ledger.json["machine"]
    kind = "brdf trade --quick" if ledger.json["quick"] else "brdf trade"
    return f"`{kind}`, {m['processor']}, {m['threads']} threads, {m['compiler']}, `{m['flags'].strip()}`"


def filled(text, ledger):
    """Replaces {{question | choice | field}} by a number of the ledger, and {{one // another}} by a quotient."""
    def value(cell):
        return ledger.value(*(part.strip() for part in cell.split("|")))

    def number(match):
        cells = match.group(1).split(" // ")
        return figure(value(cells[0]) / value(cells[1]) if len(cells) == 2 else value(cells[0]))

    return re.sub(r"\{\{([^}]*)\}\}", number, text.replace("{{machine}}", machine(ledger)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--brdf", type=pathlib.Path, default=ROOT / "build/release/brdf", help="the program")
    parser.add_argument("--ledger", type=pathlib.Path, default=ROOT / "data/ledger.json")
    options = parser.parse_args()
    brdf, ledger = str(options.brdf.resolve()), Ledger(str(options.ledger.resolve()))
    parts = {"@fronts@": fronts(ledger), "@tables@": "".join(table(ledger, name) for name in TABLES),
             "@shading@": table(ledger, "where to shade: diffuse") + table(ledger, "where to shade: highlight"),
             "@lookup@": table(ledger, "lookup texture in a frame", some_textures)
                         + table(ledger, "lookup texture, alpha 0.3", some_textures)
                         + table(ledger, "lookup texture, alpha 0.05",
                                 lambda r: some_textures(r) and ("scaled" in r["choice"] or "16" in r["choice"]
                                                                 or "^2" not in r["choice"])),
             "@claims@": claims(ledger), "@recommend@": recommendations(brdf, ledger), "@weightings@": weightings(brdf)}
    text = filled((ROOT / "docs/trade.in.md").read_text(), ledger)
    for key, value in parts.items():
        text = text.replace(key + "\n", value.rstrip("\n") + "\n")
    for name, (scene, *options) in PICTURES.items():
        run(brdf, "render", "--scene", scene, *options, "-o", f"docs/trade/{name}.png", codes=(0,))
    (ROOT / "docs/trade.md").write_text(text)


main()
