"""Tests places that cannot be written, streams that are closed, and the commands that the program prints."""
import html
import json
import os
import re
import resource
import shlex
import shutil
import signal
import subprocess
import tempfile
import types

from trial import OF_A_FILE, OLD, is_complete, wrong_files

NOBODY = 65534


def finish(bench, case, folder, **options):
    """Does the same as Bench.start, without faults, with options of Popen."""
    stdout = options.pop("stdout", None)
    with open(os.path.join(folder, "stdout"), "wb") as out:
        process = subprocess.Popen([bench.brdf, *case.words], cwd=folder, stdin=subprocess.DEVNULL,
                                   stdout=out if stdout is None else stdout, stderr=subprocess.PIPE, **options)
    return bench.finish(process, folder)


def one_line(outcome, codes, words):
    """Returns the faults of a refusal."""
    lines = [line for line in outcome.err.splitlines() if line.startswith("brdf: ") or OF_A_FILE.match(line)]
    if outcome.code not in codes or not lines:
        return [f"exit {outcome.code}: {outcome.err.strip()[-200:]}"]
    if not any(word in lines[-1] for word in words):
        return ["does not say what and why: " + lines[-1]]
    return []


def try_small_disk(bench, case, expected, tally):
    """Tests a disk that has room for the old files and one page more. Only the superuser can make such a disk."""
    folder = bench.prepare(case)
    size = sum(-(-os.path.getsize(os.path.join(where, name)) // 4096) * 4096
               for where, _, names in os.walk(folder) for name in names)
    disk = tempfile.mkdtemp(dir=bench.scratch)
    made = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size + 2 * 4096}", "tmpfs", disk], capture_output=True)
    if made.returncode != 0:
        tally.left_out.add("full disks: none can be made here")
        return
    try:
        on_disk = shutil.copytree(folder, os.path.join(disk, "folder"))
        outcome = finish(bench, case, on_disk)
    finally:
        subprocess.run(["umount", disk], check=True)
        shutil.rmtree(folder)
    wrong = wrong_files(case, outcome, expected)
    if not is_complete(case, outcome, expected):
        wrong += one_line(outcome, (3,), ["No space left on device"])
    tally.add(case, "full disk", wrong)


def try_places(bench, case, expected, tally):
    names = [os.path.basename(name) for name in case.outputs] + [".tmp/"]  # or what is made in a folder on the way

    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (1, 1))
    if case.outputs and not case.draws:  # a driver writes files of its own
        outcome = finish(bench, case, bench.prepare(case), preexec_fn=limit)
        tally.add(case, "files may not grow", wrong_files(case, outcome, expected) +
                  one_line(outcome, (3,), names))
    if expected.out:
        with open("/dev/full", "wb") as full:
            outcome = finish(bench, case, bench.prepare(case), stdout=full)
        tally.add(case, "full stdout", wrong_files(case, outcome, expected) +
                  one_line(outcome, (3,), ["standard output: writing broke off: No space left on device"]))
        outcome = finish(bench, case, bench.prepare(case), preexec_fn=lambda: os.close(1))
        tally.add(case, "closed stdout", wrong_files(case, outcome, expected) +
                  one_line(outcome, (3,), ["standard output: writing broke off"]))
        reading, writing = os.pipe()
        os.close(reading)
        outcome = finish(bench, case, bench.prepare(case), stdout=writing)
        os.close(writing)
        broken = [] if outcome.code == -signal.SIGPIPE else [f"broken pipe: exit {outcome.code}: {outcome.err[:200]}"]
        tally.add(case, "broken pipe", wrong_files(case, outcome, expected) + broken)
    if not case.outputs:
        return
    if not case.draws:
        try_small_disk(bench, case, expected, tally)
    folder = bench.prepare(case)
    where = os.path.dirname(os.path.join(folder, case.outputs[0]))
    os.chmod(where if os.path.isdir(where) else folder, 0o555)
    user = {"user": NOBODY, "group": NOBODY, "extra_groups": []} if os.getuid() == 0 else {}
    if user:
        os.chmod(bench.scratch, 0o755)
        for root, _, files in os.walk(folder):
            os.chmod(root, 0o555)
    outcome = finish(bench, case, folder, **user)
    tally.add(case, "read-only folder", wrong_files(case, outcome, expected) + one_line(outcome, (2,), ["denied"]))
    if not case.fresh:
        folder = bench.prepare(case)
        for name in case.outputs:
            os.chmod(os.path.join(folder, name), 0o444)
        outcome = finish(bench, case, folder)
        tally.add(case, "read-only file", wrong_files(case, outcome, expected) + one_line(outcome, (2,), ["is read-only"]))
    # Two at once: both good, the file one of theirs.
    folder = bench.prepare(case)
    both = [subprocess.Popen([bench.brdf, *case.words], cwd=folder, stdin=subprocess.DEVNULL,
                             stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) for _ in range(2)]
    first_code = (both[0].communicate(), both[0].returncode)[1]
    outcome = bench.finish(both[1], folder)
    wrong = wrong_files(case, outcome, expected)
    if {first_code, outcome.code} != {expected.code}:
        wrong.append(f"exits {first_code} and {outcome.code}: {outcome.err.strip()[-200:]}")
    wrong += [name + " was not written" for name in case.outputs if outcome.files.get(name) == OLD]
    tally.add(case, "two at once", wrong)


# Names that a shell would take apart, and one that is not UTF-8.
NAMES = ["m $(touch pwned);touch pwned2; .json", "it's \"quoted\" `touch pwned3`.json", "a\nb|c*.json", "-n.json"]


def commands_in(outcome):
    """Returns every printed command."""
    texts = [outcome.out.decode(errors="surrogateescape")] + \
        [content.decode(errors="surrogateescape") for name, content in sorted(outcome.files.items())
         if name.endswith((".html", ".md"))]
    found = []
    for text in texts:
        found += re.findall(r"^ +\$ (.*)$", text, re.M)
        found += [html.unescape(command) for command in re.findall(r"<pre>(.*?)</pre>", text, re.S)]
        found += [command.replace("\\|", "|") for command in re.findall(r"<br>`+ ?(.*?) ?`+ \|$", text, re.M)]
        in_json = re.findall(r'"command": ("(?:[^"\\]|\\.)*")', text)
        found += [command for command in map(json.loads, in_json) if command.startswith(("brdf ", "printf "))]
    return list(dict.fromkeys(found))


def try_printed_commands(bench, tally, short):
    """Requires that every printed command runs in a folder with only its inputs, and writes only its tables."""
    case = types.SimpleNamespace(name="printed commands")
    sources = [(["validate", "--form", "phong_classic" if short else "ward", "-o", "report.html"], None)]
    for name in NAMES[:2] if short else NAMES:
        path = "./" + name if name.startswith("-") else name
        sources.append((["validate", path, "-o", "report.md"], ("material.json", name)))
        if not short:
            sources.append((["validate", path, "-o", "report.html"], ("material.json", name)))
        sources.append((["validate", path, "-o", "report.html", "--json"], ("samples.csv", name)))
    programs = os.path.join(bench.scratch, "programs")
    os.makedirs(programs, exist_ok=True)
    os.symlink(bench.brdf, os.path.join(programs, "brdf"))
    environment = dict(os.environ, PATH=programs + ":" + os.environ["PATH"])
    # The command in the header of a table must write the same bytes again.
    for words, copied in ((["synth", "--form", "ward", "--set", "alpha=0.2", "--grid", "d $(touch pwned).csv", "--noise",
                            "0.1", "-oa.csv"], "d $(touch pwned).csv"),
                          (["eval", "--form", "ward", "it's d.csv", "-o=a.csv"], "it's d.csv")):
        folder = tempfile.mkdtemp(dir=bench.scratch)
        shutil.copy(os.path.join(bench.inputs, "directions.csv"), os.path.join(folder, copied))
        made = finish(bench, types.SimpleNamespace(words=words), folder).files
        table = made.get("a.csv") or made.get("=a.csv") or b""
        command = re.search(rb"^# command: (.*)$", table, re.M)
        empty = tempfile.mkdtemp(dir=bench.scratch)
        shutil.copy(os.path.join(bench.inputs, "directions.csv"), os.path.join(empty, copied))
        subprocess.run(["bash", "-c", (command[1].decode() if command else "false") + " -o again.csv"], cwd=empty,
                       env=environment, capture_output=True)
        files = {name: open(os.path.join(empty, name), "rb").read() for name in os.listdir(empty)}
        same = table and files.get("again.csv") == table and set(files) == {copied, "again.csv"}
        tally.add(case, shlex.join(words), [] if same else [f"its command makes {sorted(files)}, not the same"])
    for words, copied in sources:
        folder = tempfile.mkdtemp(dir=bench.scratch)
        if copied:
            shutil.copy(os.path.join(bench.inputs, copied[0]), os.path.join(folder, copied[1]))
        outcome = finish(bench, types.SimpleNamespace(words=words), folder)
        printed = commands_in(outcome)
        if outcome.code not in (0, 1) or not printed:
            tally.add(case, " ".join(words), [f"exit {outcome.code}, {len(printed)} commands: {outcome.err[:200]}"])
        for command in printed:
            empty = tempfile.mkdtemp(dir=bench.scratch)
            if copied:
                shutil.copy(os.path.join(bench.inputs, copied[0]), os.path.join(empty, copied[1]))
            if command.startswith("for x in"):  # a sweep of a width: its first step shows that it runs
                command = re.sub(r"^(for x in \S+) .*?;", r"\1;", command)
            shell = subprocess.run(["bash", "-c", command], cwd=empty, env=environment, capture_output=True)
            made = set(os.listdir(empty)) - {"pair.csv", "pairs.csv", "lobes.csv"} - ({copied[1]} if copied else set())
            wrong = [f"made {made}"] if made else []
            if shell.returncode not in (0, 1) or b"brdf: " in shell.stderr:
                wrong.append(f"exit {shell.returncode}: {shell.stderr.decode(errors='replace')[-200:]}")
            tally.add(case, shlex.quote(command[:120]), wrong)
            shutil.rmtree(empty)
    print(f"{case.name:24} {tally.tried[case.name]:6} points", flush=True)
