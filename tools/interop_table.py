#!/usr/bin/env python3
# ctest: interop.losses label=interop timeout=900 needs=plain @brdf@ @source@/docs/interop.md
# ctest: style.exported_forms label=style needs=plain --names @brdf@ @source@/docs/interop.md
"""Checks or writes the tables of docs/interop.md: losses of each program for twenty materials, and the export of every form at its
defaults.

    tools/interop_table.py [--update | --names] BRDF docs/interop.md

Without --update the script fails if a table of the document differs (numbers by more than 5 %), or if a refit is worse than the
copied parameters. --names: only the names of the programs and forms are compared, which takes seconds.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

TABLES = ("mitsuba", "pbrt")  # programs that import RGL files
WRITTEN = "written by tools/interop_table.py"
FORMS = {
    "lambert": "--form lambert --set rho=0.6,0.5,0.4",
    "oren_nayar": "--form oren_nayar --set rho=0.6,0.5,0.4 --set sigma=0.4",
    "oren_nayar_energy": "--form oren_nayar_energy --set rho=0.6,0.5,0.4 --set roughness=0.5",
    "phong": "--form phong --set kd=0.3,0.2,0.1 --set ks=0.2 --set exponent=100",
    "blinn_phong": "--form blinn_phong --set kd=0.3,0.2,0.1 --set ks=0.2 --set exponent=100",
    "ward": "--form ward --set kd=0.3,0.2,0.1 --set ks=0.2 --set alpha=0.15",
    "ward_bounded, brushed": "--form ward_bounded --set kd=0.1 --set ks=0.4 --set alpha_x=0.3 --set alpha_y=0.1",
    "ward_duer": "--form ward_duer --set kd=0.3 --set ks=0.2",
    "cook_torrance, metal, alpha 0.1": "--form cook_torrance --set kd=0 --set ks=1 --set f0=0.9,0.6,0.3 --set alpha=0.1",
    "cook_torrance, metal, alpha 0.3": "--form cook_torrance --set kd=0 --set ks=1 --set f0=0.9,0.6,0.3 --set alpha=0.3",
    "cook_torrance, metal, alpha 0.6": "--form cook_torrance --set kd=0 --set ks=1 --set f0=0.9,0.6,0.3 --set alpha=0.6",
    "cook_torrance, brushed metal": "--form cook_torrance --set kd=0 --set ks=1 --set f0=0.9,0.6,0.3 --set alpha_x=0.3"
                                    " --set alpha_y=0.1",
    "cook_torrance, plastic, alpha 0.05": "--form cook_torrance --set kd=0.3,0.2,0.1 --set ks=1 --set f0=0.04 --set alpha=0.05",
    "cook_torrance, plastic, alpha 0.2": "--form cook_torrance --set kd=0.3,0.2,0.1 --set ks=0.5 --set f0=0.04 --set alpha=0.2",
    "cook_torrance, plastic, alpha 0.5": "--form cook_torrance --set kd=0.3,0.2,0.1 --set ks=1 --set f0=0.04 --set alpha=0.5",
    "cook_torrance, coloured ks": "--form cook_torrance --set kd=0.1 --set ks=0.6,0.4,0.2 --set f0=0.5 --set alpha=0.2",
    "cook_torrance_beckmann": "--form cook_torrance_beckmann --set kd=0.2 --set ks=0.8 --set f0=0.3 --set alpha=0.3",
    "cook_torrance_dielectric": "--form cook_torrance_dielectric --set kd=0.3,0.2,0.1 --set ks=1 --set eta=1.5 --set alpha=0.2",
    "cook_torrance_student, gamma 3": "--form cook_torrance_student --set gamma=3 --set kd=0.2 --set ks=0.8 --set f0=0.3 --set alpha=0.2",
    "cook_torrance_conductor, gold": "--form cook_torrance_conductor --set kd=0 --set ks=1 --set n=0.18,0.42,1.37"
                                     " --set k=3.42,2.35,1.77 --set alpha=0.2",
    "cook_torrance_vcavity": "--form cook_torrance_vcavity --set kd=0.3 --set ks=1 --set eta=1.5 --set alpha=0.2",
}


def cell(brdf, words, program, scratch):
    """Returns '<1e-9', 'refitted (copied)' as rms, or '-'; and whether the refit is not worse."""
    run = subprocess.run([brdf, "export", *words.split(), "--to", program, "-o", scratch], text=True, capture_output=True)
    said = run.stderr.strip()
    if run.returncode == 2:
        return "-", True
    if said.endswith(": exact") or ": no difference above 1e-9" in said:
        return "<1e-9", True
    rms = [float(x) for x in re.findall(r"rms ([0-9.e-]+)", said)]
    assert rms, said
    if len(rms) == 2:
        return f"{rms[0]:.2g} ({rms[1]:.2g})", rms[0] <= rms[1]
    # Weights of a copy may exceed the limit of the program's mix.
    return f"{rms[0]:.2g} ({'the copy' if 'copied: ' in said else 'no copy'})", True


def programs_of(brdf, scratch):
    """Returns the values of --to that name a program, as the program itself lists them. The others write a formula or a table."""
    told = json.loads(subprocess.run([brdf, "describe", "json"], check=True, text=True, capture_output=True).stdout)
    options = next(verb["options"] for verb in told["verbs"] if verb["name"] == "export")

    def kind(word):
        words = [brdf, "export", "--form", "lambert", "--to", word, "-o", scratch, "--json"]
        return json.loads(subprocess.run(words, check=True, text=True, capture_output=True).stdout)["kind"]

    return [word for word in next(o["words"] for o in options if o["names"] == ["--to"]) if kind(word) not in ("formula", "table")]


def names_of_forms(brdf):
    models = subprocess.run([brdf, "models", "--json"], check=True, text=True, capture_output=True).stdout
    return [m["form"] for m in json.loads(models)["forms"]]


def check_names(brdf, text, programs):
    """Fails if the document's tables lack a program or a form, or have other ones."""
    for table, names in (("losses", list(FORMS)), ("forms", names_of_forms(brdf))):
        rows = [line.split("|")[1:-1] for line in text.split(f"<!-- {table}: {WRITTEN} -->")[1].split("<!--")[0].strip().splitlines()]
        columns, first = [word.strip() for word in rows[0]], [row[0].strip() for row in rows[2:]]
        if columns[-len(programs):] != programs or first != names:
            sys.exit(f"the table {table} of docs/interop.md has other programs or forms than the program (--update writes it): "
                     f"{sorted({*columns[-len(programs):], *first} ^ {*programs, *names}) or 'another order'}")


def losses(brdf, programs, scratch):
    lines = ["| material | " + " | ".join(programs) + " |", "|---" * (len(programs) + 1) + "|"]
    worse = []
    for name, words in FORMS.items():
        cells = []
        for program in programs:
            text, good = cell(brdf, words, program, scratch)
            cells.append(text)
            if not good:
                worse.append(f"{name} to {program}: {text}")
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines), worse


def forms(brdf, programs, scratch):
    """Returns for every form at its defaults: <1e-9 (no difference was found), the rms of the loss, table (only as an RGL file) or - (no export)."""
    def run(*words):
        return subprocess.run([brdf, *words, "-o", scratch], text=True, capture_output=True)

    lines = ["| form | a shader, `explorer` | rgl | " + " | ".join(programs) + " |", "|---" * (len(programs) + 3) + "|"]
    for form in names_of_forms(brdf):
        words = ("export", "--form", form)
        assert run(*words, "--to", "explorer").returncode == 0, form
        table = "table" if run(*words, "--to", "rgl", "--size", "200K").returncode == 0 else "-"
        cells = []
        for program in programs:
            text = cell(brdf, f"--form {form}", program, scratch)[0]
            cells.append((table if program in TABLES else "-") if text == "-" else text.split(" ")[0])
        lines.append(f"| {form} | exact | {table} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def same(a, b):
    def equal(x, y):
        try:
            return abs(float(x) - float(y)) <= 0.05 * max(abs(float(x)), abs(float(y)))
        except ValueError:
            return x == y
    words = [re.findall(r"[0-9.e-]*[0-9]|[^\s()|]+", text) for text in (a, b)]
    return len(words[0]) == len(words[1]) and all(map(equal, *words))


def main():
    update = "--update" in sys.argv
    brdf, document = [a for a in sys.argv[1:] if not a.startswith("--")]
    path = pathlib.Path(document)
    text, other = path.read_text(), []
    with tempfile.TemporaryDirectory() as folder:
        programs = programs_of(brdf, folder + "/x")
        if "--names" in sys.argv:
            return check_names(brdf, text, programs)
        table, worse = losses(brdf, programs, folder + "/x")
        for name, new in (("losses", table), ("forms", forms(brdf, programs, folder + "/x"))):
            before, rest = text.split(f"<!-- {name}: {WRITTEN} -->")
            old, after = rest.split(f"<!-- end of {name} -->")
            text = f"{before}<!-- {name}: {WRITTEN} -->\n{new}\n<!-- end of {name} -->{after}"
            if not same(old, new):
                other.append(new)
    if update:
        path.write_text(text)
    if worse:
        sys.exit("a refit is worse than copied parameters: " + "; ".join(worse))
    if other and not update:
        sys.exit(f"{document} holds another table than the program makes (--update writes it):\n" + "\n\n".join(other))


main()
