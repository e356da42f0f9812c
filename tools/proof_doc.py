#!/usr/bin/env python3
# ctest: prove.document label=prove @brdf@ --check
"""proof_doc.py BRDF [--check]: writes docs/proofs.md from docs/proofs.in.md and `BRDF prove --all`; --check fails if the page is not
current. A form that the page does not know yet is named, and is no failure."""
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def cell(results):
    """Returns the text of one property of one form."""
    verdicts = {r["verdict"] for r in results}
    if len(verdicts) > 1:
        return ", ".join(f"{r['verdict']} ({r['scalar']})" for r in results)
    r = results[0]
    if r["property"] == "reciprocity" and r["verdict"] == "proved":
        return "exact" if r["arithmetic"] == "exact" else "bit for bit"
    if r["property"] == "energy" and r["verdict"] == "proved":
        return f"proved, at most {r['high']:.9g}"
    if r["verdict"] == "refuted":
        bound = f", at most {r['high']:.7g}" if r["property"] == "energy" and r["high"] is not None else ""
        tied = "; proved for equal widths" if "equal widths" in r["statement"] else ""
        growth = ""
        if "growth" in r:
            g = r["growth"]
            power = "" if g["power"] == 1 else f"^{g['power']:g}"
            growth = f"; beyond {g['from']:g} degrees K/cos{power}, K in [{g['low']:.3g}, {g['high']:.3g}]"
        return f"refuted: {r['witness']['value']:.6g}{bound}{tied}{growth}"
    return {"no_method": "-"}.get(r["verdict"], r["verdict"])


def table(results):
    results = [r for r in results if r["property"] != "rounding"]
    properties = list(dict.fromkeys(r["property"] for r in results))
    lines = ["| form | " + " | ".join(properties) + " |", "|---" * (len(properties) + 1) + "|"]
    for form in dict.fromkeys(r["form"] for r in results):
        cells = [cell([r for r in results if r["form"] == form and r["property"] == p]) for p in properties]
        lines.append(f"| `{form}` | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def upwards(bound):
    """Returns two digits, rounded up so that the number is not below the bound."""
    said = f"{bound:.1e}"
    if float(said) < bound:
        mantissa, power = said.split("e")
        said = f"{float(mantissa) + 0.1:.1f}e{power}"
    return f"{float(said):.2g}"


def error(lobe):
    if lobe["beside"] == "nothing":
        return "sampled"
    return upwards(lobe["error"]) + (" p" if lobe["beside"] == "peak" else "")


def rounding(results):
    """Returns the proved errors of each lobe, without forms for which only constants are known."""
    lines = ["| form | double | float |", "|---|---|---|"]
    left_out = []
    for form in dict.fromkeys(r["form"] for r in results):
        of = {r["scalar"]: r["lobes"] for r in results if r["form"] == form and r["property"] == "rounding"}
        if all(lobe["beside"] == "nothing" for lobe in of["double"][-1:]):
            left_out.append(f"`{form}`")
            continue
        cells = [", ".join(error(lobe) for lobe in of[scalar]) for scalar in ("double", "float")]
        lines.append(f"| `{form}` | {cells[0]} | {cells[1]} |")
    return "\n".join(lines) + "\n\nSampled: " + ", ".join(left_out) + "."


def main():
    # No search is limited by time here, so the page is the same on a busy machine.
    done = subprocess.run([sys.argv[1], "prove", "--all", "--seconds", "600", "--json"], capture_output=True, text=True)
    if not done.stdout:
        sys.exit(done.stderr)
    results = json.loads(done.stdout)["results"]
    page = ROOT / "docs/proofs.md"
    if "--check" in sys.argv:
        known = [r for r in results if f"| `{r['form']}` |" in page.read_text()]
        for form in dict.fromkeys(r["form"] for r in results if r not in known):
            print(f"not in docs/proofs.md yet: {form}")
        results = known
    text = (ROOT / "docs/proofs.in.md").read_text().replace("%table%", table(results)).replace("%rounding%", rounding(results))
    if "--check" not in sys.argv:
        page.write_text(text)
    elif page.read_text() != text:
        sys.exit("docs/proofs.md is not current: run tools/proof_doc.py BRDF")


main()
