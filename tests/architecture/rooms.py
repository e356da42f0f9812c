#!/usr/bin/env python3
# ctest: architecture.rooms_are_listed label=architecture @source@ --check
"""Reads the list of rooms, cmake/rooms.txt, and checks the tables of the list in documents; lists the tree's files for other checks.

    rooms.py ROOT --check | --update

--check fails if a folder with sources is missing from the list, if the list names a folder that does not exist, or if the tables
of CONTRIBUTING.md and docs/architecture.md differ from the list. --update writes the tables.
"""
import argparse
import collections
import fnmatch
import pathlib
import re
import subprocess
import sys

Shelf = collections.namedtuple("Shelf", "name about")
Room = collections.namedtuple("Room", "line name beside kind about shelves")
BESIDE_SOURCES = ("examples", "tests", "build", "packaging", "tools")  # folders of the root that are no rooms


def files(root, *patterns):
    """Returns the paths, relative to the root, of the tree's files whose names match one of the patterns; also of a copy without its
    history."""
    root = pathlib.Path(root)
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=root, text=True, capture_output=True)
    names = listed.stdout.split("\0")[:-1] or [
        p.relative_to(root).as_posix() for p in root.rglob("*") if "build" not in p.relative_to(root).parts]
    return sorted(n for n in names if any(fnmatch.fnmatch(n, p) for p in patterns or ["*"]) and (root / n).is_file())


def read(root):
    """Returns the rooms in the order of the list."""
    rooms = []
    for row in (pathlib.Path(root) / "cmake/rooms.txt").read_text().splitlines():
        if row.startswith("#") or not row.strip():
            continue
        head, about = row.split(": ", 1)
        if head.startswith(" "):
            rooms[-1].shelves.append(Shelf(head.strip(), about))
            continue
        line, name, kind = head.split()
        name, *beside = name.split("+")
        rooms.append(Room(int(line), name, beside, kind, about, []))
    return rooms


def folders_of(root, room):
    """Returns the folders of a room that contain sources, relative to the room."""
    base = pathlib.Path(root) / room
    return {str(p.parent.relative_to(base)) for p in base.rglob("*") if p.suffix in (".h", ".cpp")}


def faults_of(root, rooms):
    known = {room.name for room in rooms}
    for path in sorted(pathlib.Path(root).iterdir()):
        if path.is_dir() and not path.name.startswith(".") and path.name not in known and path.name not in BESIDE_SOURCES \
                and any(path.rglob("*.cpp")):
            yield f"{path.name}/ has sources and is no room of cmake/rooms.txt"
    for room in rooms:
        there = folders_of(root, room.name)
        if not there:
            continue  # a copy without that room
        listed = {shelf.name for shelf in room.shelves} or {"."}
        yield from (f"{room.name}/{name} has sources and is no shelf of cmake/rooms.txt" for name in sorted(there - listed))
        yield from (f"cmake/rooms.txt: {room.name}/{name} has no sources" for name in sorted(listed - there))


def table(rooms):
    return ["| room | what it is for |", "|---|---|"] + [f"| `{room.name}/` | {room.about} |" for room in rooms]


def shelves(rooms):
    listed = [(room, s) for room in rooms for s in room.shelves if s.name != "."]
    return [f"{len(rooms)} rooms, from the ground up:", "", "| line | room | what it is for |", "|---:|---|---|",
            *(f"| {room.line} | `{room.name}` | {room.about} |" for room in rooms), "",
            f"{len(listed)} shelves, in each room from the ground up:", "", "| shelf | what it is for |", "|---|---|",
            *(f"| `{room.name}/{s.name}` | {s.about} |" for room, s in listed)]


def with_table(text, rows):
    begin, end = "<!-- rooms: written by tests/architecture/rooms.py -->\n", "<!-- end of rooms -->\n"
    pattern = re.compile(re.escape(begin) + ".*?" + re.escape(end), re.S)
    assert pattern.search(text), "no place for the table"
    return pattern.sub(lambda _: begin + "\n" + "\n".join(rows) + "\n\n" + end, text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=pathlib.Path)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--check", action="store_true")
    what.add_argument("--update", action="store_true")
    options = parser.parse_args()
    rooms = read(options.root)
    faults = list(faults_of(options.root, rooms))
    for name, rows in (("CONTRIBUTING.md", table(rooms)), ("docs/architecture.md", shelves(rooms))):
        path = options.root / name
        text = path.read_text()
        new = with_table(text, rows)
        if options.update:
            path.write_text(new)
        elif new != text:
            faults.append(f"{name}: its table of rooms is not that of cmake/rooms.txt: rooms.py . --update writes it")
    print("\n".join(faults) or f"{len(rooms)} rooms")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
