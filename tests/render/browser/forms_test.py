# ctest: render.webgl_forms label=browser timeout=600 needs=brdf_render @forms_values@ chromium @here@/webgl_forms
"""Compares the GLSL ES of every form in WebGL 2 of a headless browser with the float values of the library. The values must be equal
bit for bit on SwiftShader, and within rounding on the driver of Mesa, because its compiler rearranges more:
forms_test.py FORMS_VALUES BROWSER FOLDER"""
import glob
import json
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "validate"))
from browser import SOFTWARE, Browser  # noqa: E402

SCRIPT = pathlib.Path(__file__).with_name("forms.js").read_text(encoding="utf-8")
WITHIN = 5e-6  # of the peak, on Mesa


def unguarded(shader):
    """Returns the shader without the guards against the rearrangement of arithmetic by compilers."""
    functions = []
    for text in re.split(r"(?<=\n\}\n)", shader):
        bits = dict(re.findall(r"uint (t\d+) = floatBitsToUint\((t\d+)\);", text))
        for hidden, plain in re.findall(r"uint (t\d+) = (t\d+) \^ brdf_zero;", text):
            text = text.replace(f"uintBitsToFloat({hidden});", f"{bits[plain]};")
        functions.append(text)
    return "".join(functions)


def controls_of(forms):
    """Returns two negative controls that the test must detect: a constant with a wrong last bit, and a formula that compilers may rearrange."""
    wrong = forms[0]["shader"].replace("0.318309873", "0.318309903")
    logarithm = next(f for f in forms if f["shader"].count("brdf_log1p(") > 1)
    assert wrong != forms[0]["shader"] and unguarded(logarithm["shader"]) != logarithm["shader"]
    return [dict(forms[0], name="wrong", shader=wrong),
            dict(logarithm, name="rearranged", shader=unguarded(logarithm["shader"]))]


def result_of(name, path, data, driver=None):
    """Returns the results of the script for the data, on SwiftShader or on the Vulkan driver of that file."""
    path.write_text("<!DOCTYPE html><html><head><meta charset='utf-8'><title>forms</title></head><body><script>\n"
                    f"const data = {json.dumps(data)};\n{SCRIPT}</script></body></html>", encoding="utf-8")
    with Browser(name, *SOFTWARE, patience=280, driver=driver) as browser, browser.open(path) as page:
        result = page.evaluate("document.documentElement.dataset.result")
        assert not page.console and result, page.console
        return json.loads(result)


def report(title, rows):
    print(title)
    for row in rows:
        print(f"  {row['form']:28} {row['differing']:6} of {row['values']} values differ, at most {row['worst']:.2g} "
              "of the peak")


def main():
    values, browser, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    data = json.loads(subprocess.run([values], capture_output=True, check=True, text=True).stdout)
    tested = dict(data, forms=data["forms"] + controls_of(data["forms"]))
    found = result_of(browser, folder / "swiftshader.html", tested)
    assert "SwiftShader" in found["renderer"], found["renderer"]
    rows, (wrong, rearranged) = found["rows"][:-2], found["rows"][-2:]
    report(found["renderer"], found["rows"])
    assert len(rows) == len(data["forms"]) >= 25, len(rows)
    assert all(row["values"] == 6 * data["side"] ** 2 and row["peak"] > 0 for row in rows)
    assert not [row for row in rows if row["differing"]]
    assert wrong["differing"] > 1000 and 0 < wrong["worst"] < 1e-6, wrong
    assert rearranged["worst"] > 1e-4, rearranged

    mesa = glob.glob("/usr/share/vulkan/icd.d/lvp_icd.*json")
    if mesa:
        found = result_of(browser, folder / "mesa.html", tested, mesa[0])
        report(found["renderer"], found["rows"])
        if "llvmpipe" in found["renderer"]:
            assert all(row["worst"] < WITHIN for row in found["rows"][:-1]), found
            assert found["rows"][-1]["worst"] > 1e-4, found["rows"][-1]
    shutil.rmtree(folder)  # some 20 MB a page


main()
