#!/usr/bin/env python3
# ctest: architecture.needed_headers label=architecture @source@
"""needed_headers.py ROOT: checks that a source that uses a name of the standard library, or a name of another room, includes the name's
header, itself or through headers of the project. Batches of sources and precompiled headers hide missing headers; another compiler, or
another version of the standard library, does not find the name then. Names of the standard library that are not in NAMES are not
looked at."""
import collections
import os
import pathlib
import re
import sys

import rooms

NAMES = {
    "algorithm": "clamp copy_if copy_n count_if fill_n find_if lower_bound max max_element min min_element minmax nth_element remove_if"
                 " replace reverse rotate shuffle sort stable_sort transform unique upper_bound",
    "array": "array",
    "atomic": "atomic",
    "bit": "bit_cast bit_width countl_zero countr_zero popcount",
    "bitset": "bitset",
    "charconv": "from_chars to_chars",
    "chrono": "chrono",
    "cmath": "abs atan2 cbrt ceil copysign cos erf erfc exp floor fma frexp hypot isfinite isnan ldexp log lround nextafter pow sin sqrt"
             " tan",
    "compare": "partial_ordering strong_ordering",
    "complex": "complex",
    "concepts": "floating_point integral same_as",
    "condition_variable": "condition_variable",
    "cstdint": "int16_t int32_t int64_t uint16_t uint32_t uint64_t uint8_t",
    "cstring": "memcmp memcpy memset strerror strlen",
    "deque": "deque",
    "exception": "current_exception exception_ptr rethrow_exception",
    "filesystem": "filesystem",
    "fstream": "ifstream ofstream",
    "functional": "bind_front function greater hash less multiplies plus",
    "future": "async future promise",
    "iomanip": "setfill setprecision setw",
    "iostream": "cerr cout",
    "limits": "numeric_limits",
    "map": "map multimap",
    "memory": "make_shared make_unique shared_ptr unique_ptr weak_ptr",
    "mutex": "call_once lock_guard mutex once_flag scoped_lock unique_lock",
    "numbers": "numbers",
    "numeric": "accumulate gcd inner_product iota lcm midpoint partial_sum reduce transform_reduce",
    "optional": "make_optional nullopt optional",
    "random": "mt19937 mt19937_64 normal_distribution uniform_int_distribution uniform_real_distribution",
    "ranges": "views",
    "regex": "regex smatch",
    "set": "multiset set",
    "source_location": "source_location",
    "span": "span",
    "sstream": "istringstream ostringstream stringstream",
    "stdexcept": "invalid_argument logic_error out_of_range runtime_error",
    "string_view": "string_view",
    "thread": "jthread this_thread thread",
    "tuple": "make_tuple tie tuple",
    "type_traits": "conditional_t decay_t is_floating_point_v is_same_v remove_cvref_t",
    "unordered_map": "unordered_map",
    "unordered_set": "unordered_set",
    "utility": "as_const exchange",
    "variant": "get_if holds_alternative monostate variant visit",
    "vector": "vector",
}
HEADER_OF = {name: header for header, names in NAMES.items() for name in names.split()}
# Other names of std::ranges are algorithms.
OF_RANGES = set("begin data empty end input_range range_value_t size subrange".split())
# Headers that define the names of another header by the standard's own words.
ALSO = {"cmath": {"complex", "cstdlib"}, "string_view": {"string"}}


def included(texts, name, seen):
    """Adds the source and all headers of the project that it includes to `seen`; returns the standard headers that they include."""
    seen.add(name)
    found = set(re.findall(r"^#include <([a-z_]+)>", texts[name], re.M))
    for other in re.findall(r'^#include "([^"]+)"', texts[name], re.M):
        beside = os.path.normpath(os.path.join(os.path.dirname(name), other))
        path = next((path for path in (other, "libbrdf/" + other, beside) if path in texts), None)
        if path is not None and path not in seen:  # the build writes the other headers
            found |= included(texts, path, seen)
    return found


def code_of(text):
    return re.sub(r'R"(\w*)\(.*?\)\1"|//[^\n]*|"(\\.|[^"\\\n])*"', '""', text, flags=re.S)


def used(code):
    """Returns {header: names} for the names of the standard library that a source uses."""
    found = collections.defaultdict(set)
    for ranges, name in re.findall(r"\bstd::(ranges::)?(\w+)", code):
        header = HEADER_OF.get(name)
        if ranges and (name in OF_RANGES or not header):
            header = "ranges" if name in OF_RANGES else "algorithm"
        if header:
            found[header].add(name)
    return found


def faults_of(texts, spaces):
    """Yields a sentence for each header that a source of {path: text} lacks; spaces are the rooms that qualify names."""
    qualified = re.compile(rf"(?<![:\w])({'|'.join(spaces)})::(\w+)")
    codes = {name: code_of(text) for name, text in texts.items()}
    words_of = {name: set(re.findall(r"\w+", code)) for name, code in codes.items()}
    for name, code in sorted(codes.items()):
        seen = set()
        here = included(texts, name, seen)
        for header, words in sorted(used(code).items()):
            if header not in here and not ALSO.get(header, set()) & here:
                yield f"{name}: #include <{header}> is missing for std::{', std::'.join(sorted(words))}"
        declared_here = set(re.findall(r"\w+", qualified.sub("", code)))
        known = declared_here.union(*(words_of[header] for header in seen if header != name))
        for room, word in sorted(set(qualified.findall(code))):
            if word not in known:
                yield f"{name}: no included header has {room}::{word}"


def faults_without(texts, spaces, name, line):
    """Returns the sentences about a source from which a line is removed."""
    assert line in texts[name], (name, line)
    return [fault for fault in faults_of(texts | {name: texts[name].replace(line, "")}, spaces) if fault.startswith(name)]


def main(root):
    spaces = [room.name for room in rooms.read(root) if room.name != "libbrdf"]
    texts = {name: (root / name).read_text() for name in rooms.files(root, "*.h", "*.cpp")}
    assert len(texts) > 1000, len(texts)
    faults = list(faults_of(texts, spaces))
    print("\n".join(faults) or f"{len(texts)} sources include the headers of the names that they use, as far as this check looks")
    # Negative controls: a header of the standard library, of another room, and one that a source's own header includes.
    small = {"io/a.h": "#include <vector>\nstd::vector<int> read();\n",
             "fit/b.cpp": '#include "io/a.h"\n#include <cmath>\nauto c = io::read(); double d = std::sqrt(2.0);  // std::sort\n'}
    assert not list(faults_of(small, spaces))
    assert faults_without(small, spaces, "fit/b.cpp", "#include <cmath>\n") == [
        "fit/b.cpp: #include <cmath> is missing for std::sqrt"]
    assert faults_without(small, spaces, "fit/b.cpp", '#include "io/a.h"\n') == ["fit/b.cpp: no included header has io::read"]
    assert faults_without(small, spaces, "io/a.h", "#include <vector>\n") == [
        "io/a.h: #include <vector> is missing for std::vector"]
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
