# ctest: python.documents label=python,style timeout=1200 module @source@
"""Tests that the examples of docs/python.md and of the README print the shown output. Usage: documents_test.py SOURCE

The examples run in a scratch folder with the `data` of the source, so that their files do not remain.
"""
import doctest
import os
import pathlib
import sys
import tempfile

SOURCE = pathlib.Path(sys.argv[1]).resolve()


def main():
    tried = failed = 0
    for name in ("docs/python.md", "README.md"):
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            os.symlink(SOURCE / "data", "data")
            result = doctest.testfile(str(SOURCE / name), module_relative=False,
                                      optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS)
            os.chdir(SOURCE)
        print(f"{name}: {result.attempted} examples, {result.failed} differ from what is shown")
        tried, failed = tried + result.attempted, failed + result.failed
        assert result.attempted > 0, name
    sys.exit(failed > 0)


main()
