# ctest: python.surface label=python timeout=1200 module @brdf@
"""Every verb and option of the program has a Python name (python/brdf/names.json), and each name exists.
Usage: surface_test.py BRDF"""
import inspect
import os
import re
import subprocess
import sys
import unittest

import brdf
from brdf.programs import verbs

PROGRAM = sys.argv[1]
NAME = re.compile(r"brdf((?:\.\w+)+)(?:\((\w+)\))?")


def help_of(*words):
    wide = os.environ | {"COLUMNS": "200"}
    return subprocess.run([PROGRAM, *words, "--help"], check=True, capture_output=True, text=True, env=wide).stdout


def verbs_of_program():
    return re.findall(r"^  (\w[\w-]*) ", help_of().partition("\nLook:")[2], re.M)


def options_of(verb):
    """Returns the positional arguments and the long names of options, except --help."""
    options = re.findall(r"^ +(?:-\w,)?(--[\w-]+|(?!REQUIRED)[A-Z]{2,})(?=\s)", help_of(verb), re.M)
    return [o for o in options if o != "--help"]


def found(path):
    """Returns the object of the module that a name such as `.Table.save` refers to."""
    thing = brdf
    for part in path.split(".")[1:]:
        thing = getattr(thing, part)
    return thing


def function_of(entry):
    return found(entry["python"].removeprefix("brdf"))


class Surface(unittest.TestCase):
    def test_every_verb_has_a_function(self):
        listed = verbs_of_program()
        self.assertGreater(len(listed), 10)
        self.assertEqual([verb for verb in listed if verb not in verbs()], [])
        for verb, entry in verbs().items():
            self.assertTrue(callable(function_of(entry)), verb)

    def test_every_option_has_a_name(self):
        for verb, entry in verbs().items():
            if entry["options"] == "keywords":
                kinds = {p.kind for p in inspect.signature(function_of(entry)).parameters.values()}
                self.assertIn(inspect.Parameter.VAR_KEYWORD, kinds, verb)
                continue
            options = options_of(verb)
            self.assertGreater(len(options), 1, verb)
            self.assertEqual(sorted(entry["options"]), sorted(set(options)), verb)

    def test_every_name_exists(self):
        for verb, entry in verbs().items():
            if entry["options"] == "keywords":
                continue
            own = inspect.signature(function_of(entry)).parameters
            for option, name in entry["options"].items():
                with self.subTest(f"{verb} {option}"):
                    match = NAME.fullmatch(name)
                    if match is None:
                        self.assertIn(name, own)
                    elif match[2] is None:
                        self.assertTrue(callable(found(match[1])))
                    else:
                        self.assertIn(match[2], inspect.signature(found(match[1])).parameters)

    def test_what_is_public_is_described(self):
        for name in brdf.__all__:
            thing = getattr(brdf, name)
            if not name.startswith("_"):
                self.assertTrue(inspect.getdoc(thing), name)
            for method, function in inspect.getmembers(thing, inspect.isfunction) if inspect.isclass(thing) else []:
                if not method.startswith("_") and method != "to_dict":
                    self.assertTrue(inspect.getdoc(function), f"{name}.{method}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
