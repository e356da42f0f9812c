#!/usr/bin/env python3
"""Writes docs/trade.md from docs/trade.in.md: tables from a ledger and from `brdf recommend`.

    tools/trade_doc.py build/release/brdf data/ledger.json
"""
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = [("recommend_close_up", "glossy_grey_paper"), ("recommend_grazing", "rolled_brass"),
          ("recommend_distant", "article_glass")]
# What a practitioner asks first; the other rows are in the ledger.
TABLES = ["cook_torrance: precision and kernels", "Fresnel of glass", "Fresnel of aluminium", "masking for GGX",
          "masking for Beckmann", "power of a cosine, n = 32", "mirror direction or half vector", "D of GGX in float",
          "cheaper inside cook_torrance", "families for a material of cook_torrance", "one by one or in batches",
          "albedo of GGX", "integrating an albedo", "samples for a fit", "bits of the G-buffer, alpha 0.05",
          "forward or deferred, 1 light", "forward or deferred, 64 lights"]


def figure(x):
    return "-" if x is None else f"{x:.3g}"


def line(cells):
    return "| " + " | ".join(cells) + " |\n"


def header(cells):
    return line(cells) + "|" + "---|" * len(cells) + "\n"


def rows_table(rows):
    text = header(["choice", "ns", "cost", "max", "mean", "p99", "image", "front"])
    for r in rows:
        e = r["error"]
        text += line([r["choice"], figure(r["cost_ns"]), figure(r["cost_ratio"]), figure(e["max"]), figure(e["mean"]),
                      figure(e["p99"]), figure(r["image_error"]),
                      f"dominated by {r['dominated_by']}" if r["dominated_by"] else "yes"])
    return text


def question(ledger, name, keep=lambda r: True):
    rows = [r for r in ledger["rows"] if r["question"] == name]
    if not rows:
        return ""
    e = rows[0]["error"]
    return (f"**{name}** ({e['measure']} error of {rows[0]['error']['of']}; {rows[0]['domain']})\n\n"
            + rows_table([r for r in rows if keep(r)]) + "\n")


def claims(ledger):
    text = header(["claim", "verdict", "evidence", "row"])
    for c in ledger["claims"]:
        text += line([f"{c['claim']} ({c['source']})", c["verdict"], c["evidence"], f"{c['question']}: {c['choice']}"])
    return text


def run(brdf, *arguments):
    done = subprocess.run([brdf, *arguments, "--json"], cwd=ROOT, stdout=subprocess.PIPE, check=False)
    return json.loads(done.stdout)


def recommendations(brdf, ledger):
    text = header(["scene", "reference", "tolerance", "answer", "image error", "ns"])
    for scene, material in SCENES:
        for tolerance in ("0.01", "0.05", "0.2"):
            r = run(brdf, "recommend", "--scene", f"data/scenes/{scene}.json", "--reference",
                    f"data/materials/{material}.json", "--tolerance", tolerance, "--ledger", ledger)
            c = r["chosen"]
            name = "none" if not c else ", ".join(
                filter(None, [c["form"], "two widths" if c["anisotropic"] else None, c["choice"]]))
            text += line([scene, material, tolerance, name, figure(r["rendered_image_error"]),
                          figure(c and c["cost_ns"])])
    return text


def weightings(brdf):
    r = run(brdf, "recommend", "--compare-weightings", "data")
    text = header(["scene", "material", "form", "scene-weighted", "hemisphere-wide"])
    for row in r["rows"]:
        text += line([row["scene"], row["material"], row["form"], figure(row["scene_weighted"]),
                      figure(row["hemisphere_wide"])])
    return text + f"\nImage errors; the scene's weighting is better in {r['better']} of {len(r['rows'])}.\n"


def main():
    brdf, path = str(pathlib.Path(sys.argv[1]).resolve()), str(pathlib.Path(sys.argv[2]).resolve())
    ledger = json.loads(pathlib.Path(path).read_text())
    shading = question(ledger, "where to shade: diffuse") + question(ledger, "where to shade: highlight")
    lookup = question(ledger, "lookup texture in a frame") + question(
        ledger, "lookup texture, alpha 0.3",
        lambda r: "^2" not in r["choice"] or r["choice"].startswith(("32^2", "128^2", "512^2")))
    parts = {"@tables@": "".join(question(ledger, name) for name in TABLES), "@shading@": shading, "@lookup@": lookup,
             "@claims@": claims(ledger), "@recommend@": recommendations(brdf, path), "@weightings@": weightings(brdf)}
    text = (ROOT / "docs/trade.in.md").read_text()
    for key, value in parts.items():
        text = text.replace(key + "\n", value)
    (ROOT / "docs/trade.md").write_text(text)


main()
