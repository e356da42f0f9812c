#!/usr/bin/env python3
# ctest: architecture.includes_go_downward label=architecture @source@ --check @source@/docs/img/architecture.svg
"""Checks that no include goes upward or in a cycle, and prints the layers of each room.

    includes.py ROOT [--picture FILE | --check FILE]

--picture draws rooms and layers as SVG; --check fails if FILE differs from that picture.

A room is a folder in the project's root; a box is a folder with sources. A header NAME.h next to a folder NAME/ is the
interface of that folder, and the sources in a room's own folder are the interface of the room. No source outside libbrdf
includes the private headers of libbrdf (libbrdf/src). cmake/rooms.txt lists the rooms that each room may include, and the
folders that each folder of a room may include.
"""
import argparse
import collections
import os
import re
import sys
import textwrap

import rooms as listed_rooms

def sources(root, rooms):
    names = {room.name for room in rooms}
    return [f for f in listed_rooms.files(root, "*.h", "*.cpp") if f.split("/")[0] in names]


def box_of(source, boxes):
    face = os.path.splitext(source)[0]
    return face if face in boxes else os.path.dirname(source)


def circle_in(arrows):
    """Returns one cycle of a graph {node: set of nodes}, or None if there is no cycle."""
    state, path = {}, []

    def visit(node):
        state[node] = "open"
        path.append(node)
        for to in sorted(arrows.get(node, ())):
            if state.get(to) == "open":
                return path[path.index(to):] + [to]
            if to not in state and (found := visit(to)):
                return found
        state[node] = "done"
        path.pop()
        return None

    for node in sorted(arrows):
        if node not in state and (found := visit(node)):
            return found
    return None


def floors_of(nodes, arrows):
    floor = {}

    def of(node):
        if node not in floor:
            floor[node] = 1 + max((of(to) for to in arrows.get(node, ())), default=0)
        return floor[node]

    for node in nodes:
        of(node)
    return floor


def svg(stories, lines):
    """Rooms in their lines, the ground below; in each room its floors, the ground floor below."""
    width, text, pad = 880, 16, 6
    parts, y = [], 12
    for line in ([room for room in line if room in stories] for line in reversed(lines)):
        each = (width - 10 * (len(line) + 1)) / len(line)
        wrapped = {}
        for room in line:
            columns = int((each - 2 * pad) / 6.6)
            wrapped[room] = [row for story in reversed(stories[room])
                             for row in textwrap.wrap(", ".join(story), columns, break_on_hyphens=False) + [None]][:-1]
        rows = max(sum(1 if r else 0.4 for r in wrapped[room]) for room in line)
        height = (rows + 1.4) * text + 2 * pad
        for k, room in enumerate(line):
            x = 10 + k * (each + 10)
            parts.append(f'<rect x="{x:.0f}" y="{y:.0f}" width="{each:.0f}" height="{height:.0f}" rx="4"/>')
            parts.append(f'<text class="room" x="{x + pad:.0f}" y="{y + text:.0f}">{room}</text>')
            at = y + 2.2 * text
            for row in wrapped[room]:
                if row:
                    parts.append(f'<text x="{x + pad:.0f}" y="{at:.0f}">{row}</text>')
                    at += text
                else:
                    parts.append(f'<path d="M{x + pad:.0f} {at - 0.55 * text:.0f}h{each - 2 * pad:.0f}"/>')
                    at += 0.4 * text
        y += height + 14
    style = ("rect{fill:#f6f6f3;stroke:#555}text{font:11px monospace;fill:#222}.room{font:bold 13px sans-serif}"
             "path{stroke:#bbb}")
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{y:.0f}"><style>{style}</style>'
            f'<rect style="fill:#fff;stroke:none" width="{width}" height="{y:.0f}"/>\n' + "\n".join(parts) + "\n</svg>\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root")
    parser.add_argument("--picture")
    parser.add_argument("--check")
    options = parser.parse_args()
    root = options.root
    rooms = listed_rooms.read(root)
    lines = [[r.name for r in rooms if r.line == k] for k in sorted({r.line for r in rooms})]
    beside = {(r.name, other) for r in rooms for other in r.beside}
    rank = {f"{r.name}/{s.name}".removesuffix("/."): k for r in rooms for k, s in enumerate(r.shelves)}
    files = sources(root, rooms)
    boxes = {os.path.dirname(f) for f in files}
    line_of = {r.name: r.line for r in rooms}
    by_file, by_box = collections.defaultdict(set), collections.defaultdict(set)
    faults = []
    for source in files:
        text = open(os.path.join(root, source), encoding="utf-8").read()
        for included in re.findall(r'^#include "([^"]+)"', text, re.M):
            target = next((t for t in (included, "libbrdf/" + included) if t in set(files)), None)
            if target is None:
                continue  # written by the build
            by_file[source].add(target)
            room, other = source.split("/")[0], target.split("/")[0]
            if target.startswith("libbrdf/src/") and room != "libbrdf":
                faults.append(f"{source}: {included}: a private header of libbrdf")
            if room == other:
                box, below = box_of(source, boxes), box_of(target, boxes)
                if box != below:
                    by_box[box].add(below)
                    if rank.get(below, -1) > rank.get(box, len(files)):
                        faults.append(f"{source}: {included}: the shelf {below} stands above {box}")
            elif line_of[other] >= line_of[room] and (room, other) not in beside:
                faults.append(f"{source}: {included}: {room} stands beside or below {other}")
    for arrows, what in ((by_file, "files"), (by_box, "folders")):
        if circle := circle_in(arrows):
            faults.append(f"a circle of {what}: {' -> '.join(circle)}")
    if faults:
        print("\n".join(faults))
        print(f"{len(faults)} includes go upward or in a circle")
        return 1
    stories = {}
    for room in (room.name for room in rooms):
        inside = sorted({box_of(f, boxes) for f in files if f.split("/")[0] == room})
        if not inside:
            continue  # a copy without that room
        floor = floors_of(inside, by_box)
        arrows = sum(len(by_box[b]) for b in inside)
        stories[room] = [[b[len(room) + 1:] or room for b in inside if floor[b] == k]
                         for k in range(1, max(floor.values()) + 1)]
        listed = "; ".join(f"{k}: {', '.join(story)}" for k, story in enumerate(stories[room], 1))
        print(f"{room}: {len(inside)} boxes, {len(stories[room])} floors, {arrows} arrows   {listed}")
    print(f"{len(files)} files, {sum(map(len, by_file.values()))} includes: none goes upward or in a circle")
    if options.picture:
        with open(options.picture, "w", encoding="utf-8") as picture:
            picture.write(svg(stories, lines))
    if options.check and open(options.check, encoding="utf-8").read() != svg(stories, lines):
        print(f"{options.check} shows other floors: draw it anew with --picture")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
