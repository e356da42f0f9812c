"""Runs one command once, with or without a fault, and judges its result."""
import bisect
import collections
import hashlib
import json
import os
import re
import shutil
import subprocess
import tempfile

from cases import make_inputs

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
OLD = b"the old content\n"
FILE_KINDS = ["open", "read", "write", "short", "interrupted", "fsync", "close", "rename", "mmap"]
HARMLESS = {"short", "interrupted"}  # calls that a program must go on after
OF_A_FILE = re.compile(r"(\[\d+/\d+\]|brdf collect:) ")
TEMPORARY = re.compile(r"^(.+?\.\d+\.\d+\.tmp)(/|$)")  # a file, or a folder with what is in it
# Foreign code that is linked statically, by mangled names. The templates of the C++ library count as code of their
# users.
FOREIGN = re.compile(r"_ZN[KVRO]*\d+(glslang|spvtools|shaderc|shaderc_util|spv|ceres|google|gflags|ImGui|embree|Assimp)")
STANDARD = re.compile(r"_ZN?[KVRO]*S[abdiost]|_ZN[KVRO]*9__gnu_cxx")
# Foreign templates and headers that end the program if memory is exhausted: destructors that allocate, an object that is
# destroyed before its construction, and CLI11's search for an option by name.
WITHOUT_MEMORY = {
    "nlohmann::json": re.compile(r"^[^(]*nlohmann.*(::destroy\(|::~basic_json\(|::operator\[\]|::push_back\()"),
    "CLI11": re.compile(r"^CLI::Option::check_[ls]?name\("),
}
# The shader compiler runs in a separate process with limited memory; a lack of memory there is reported as a fault of the text.
OF_THE_TEXT = "the shader compiler needs more than"


class Outcome:
    def __init__(self, code, out, err, files):
        self.code, self.out, self.err, self.files = code, out, err, files


class Display:
    """A virtual display."""

    def __init__(self):
        reader, writer = os.pipe()
        # -noreset: a server that begins anew when its last client has left refuses the next one for a moment.
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-nolisten", "tcp", "-noreset"], pass_fds=(writer,),
                                       stderr=subprocess.DEVNULL)
        os.close(writer)
        self.name = ":" + os.read(reader, 16).decode().strip()

    def close(self):
        self.server.terminate()
        self.server.wait()


class Bench:
    def __init__(self, arguments, scratch, display):
        self.brdf = os.path.abspath(arguments.brdf)
        self.library = os.path.abspath(arguments.library)
        self.scratch = scratch
        self.display = display
        self.inputs = os.path.join(scratch, "inputs")
        os.makedirs(self.inputs)
        make_inputs(self.inputs, self.brdf, SOURCE)
        self.foreign = os.path.join(scratch, "foreign")
        self.symbols = self.list_foreign()

    def list_foreign(self):
        """Writes the addresses of foreign code in the program. Returns all functions of the program, to name the entries of stacks."""
        def symbols(*options):
            text = subprocess.run(["nm", *options, "--defined-only", "-n", self.brdf], capture_output=True, text=True)
            return [line.split(" ", 2) for line in text.stdout.splitlines()]
        functions = []
        with open(self.foreign, "w") as file:
            for mangled, plain in zip(symbols(), symbols("-C")):
                if len(mangled) != 3 or mangled[1] not in "tTwWuV":
                    continue
                functions.append((int(mangled[0], 16), plain[2], mangled[2]))
            for (first, plain, mangled), (last, *_) in zip(functions, functions[1:]):
                match = FOREIGN.match(mangled)
                name = "-" if STANDARD.match(mangled) else match.group(1) if match else None
                name = next((who for who, names in WITHOUT_MEMORY.items() if names.search(plain)), name)
                if name and last > first:
                    file.write(f"{first:x} {last:x} {name}\n")
        return functions

    def verbs(self):
        told = subprocess.run([self.brdf, "describe", "json"], capture_output=True, check=True)
        return {verb["name"] for verb in json.loads(told.stdout)["verbs"]}

    def name_at(self, address):
        place = bisect.bisect_right(self.symbols, (address, "\x7f", "")) - 1
        return self.symbols[place][1][:90] if place >= 0 else "?"

    def prepare(self, case):
        folder = tempfile.mkdtemp(dir=self.scratch)
        for name in case.inputs:
            os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
            shutil.copy(os.path.join(self.inputs, name), os.path.join(folder, name))
        for words in case.before:
            subprocess.run([self.brdf, *words], cwd=folder, check=True, capture_output=True)
        for name in [] if case.fresh else [*case.outputs, *case.optional]:
            os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
            with open(os.path.join(folder, name), "wb") as file:
                file.write(OLD)
        return folder

    def environment(self, folder, kind, at, report):
        return dict(os.environ, LD_PRELOAD=self.library, FAULTS_KIND=kind, FAULTS_AT=str(at), FAULTS_FOLDER=folder,
                    FAULTS_REPORT=report, FAULTS_FOREIGN=self.foreign, LC_ALL="C",
                    XDG_STATE_HOME=os.path.join(folder, "state"), DISPLAY=self.display.name if self.display else "")

    def start(self, case, folder, kind="none", at=0, report=""):
        with open(os.path.join(folder, "stdout"), "wb") as out:
            return subprocess.Popen([self.brdf, *case.words], cwd=folder, stdin=subprocess.DEVNULL, stdout=out,
                                    stderr=subprocess.PIPE, env=self.environment(folder, kind, at, report))

    def finish(self, process, folder, timeout=300):
        try:
            err = process.communicate(timeout=timeout)[1].decode(errors="replace")
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            err = "did not end"
        files = {}
        for where, _, names in os.walk(folder):
            for name in names:
                path = os.path.join(where, name)
                with open(path, "rb") as file:
                    files[os.path.relpath(path, folder)] = file.read()
        out = files.pop("stdout", b"").replace(os.fsencode(folder), b"")
        shutil.rmtree(folder, ignore_errors=True)
        return Outcome(process.returncode, out, err, files)

    def run(self, case, kind="none", at=0):
        """Returns the outcome and the report of the preloaded library."""
        folder = self.prepare(case)
        report = folder + ".report"
        outcome = self.finish(self.start(case, folder, kind, at, report), folder)
        told = collections.defaultdict(list)
        if os.path.exists(report):
            for line in open(report):
                word, _, rest = line.rstrip("\n").partition(" ")
                told[word].append(rest)
            os.remove(report)
        return outcome, told


def is_whole(name, content):
    """Returns whether an output that differs from run to run has the end of a complete file of its kind."""
    ends = {".json": b"}\n", ".csv": b"\n", ".html": b"</html>\n", ".png": b"IEND\xaeB`\x82"}
    end = ends.get(os.path.splitext(name)[1])
    if name.endswith(".unit"):  # its first line ends with the hash of what follows
        head, _, rest = content.partition(b"\n")
        return head.endswith(hashlib.sha256(rest).hexdigest().encode())
    return len(content) > len(OLD) and (end is None or content.rstrip(b"\n").endswith(end.rstrip(b"\n")))


def wrong_files(case, outcome, expected, may_leave=0):
    """Returns the faults of the files after a failed call."""
    wrong = []
    left = [name for name in outcome.files if name not in case.inputs and name not in expected.files]
    temporaries = {match[1] for name in left if (match := TEMPORARY.match(name))}
    if len(temporaries) > may_leave or not all(map(TEMPORARY.match, left)):
        wrong.append("left " + ", ".join(left))
    for name in [*case.outputs, *case.optional]:
        content = outcome.files.get(name)
        if content is None:
            wrong += [] if case.fresh else [name + " is gone"]
        elif content != OLD and content != expected.files[name] and (
                (case.same and not case.parts) or not is_whole(name, content)):
            wrong.append(f"{name} is neither old nor new ({len(content)} bytes)")
    for name in case.inputs:
        if outcome.files.get(name) != expected.files[name]:
            wrong.append(name + " was changed")
    return wrong


def is_complete(case, outcome, expected):
    return (outcome.code == expected.code and all(outcome.files.get(n) not in (None, OLD) for n in case.outputs)
            and (not case.same or outcome.out.replace(case.kept, b"") == expected.out))


def judge_sound(case, outcome, expected):
    """Returns the faults of a run without a failed call."""
    wrong = wrong_files(case, outcome, expected)
    if not is_complete(case, outcome, expected):
        wrong.append(f"ended with {outcome.code}: {outcome.err.strip()[:200]}")
    return wrong


def judge(case, outcome, expected, kind, what):
    """Returns the deviations from the rule after a call of this kind has failed."""
    wrong = wrong_files(case, outcome, expected)
    messages = [line for line in outcome.err.splitlines() if line.startswith("brdf: ")]
    if is_complete(case, outcome, expected):
        return wrong
    if kind == "memory" and outcome.code == 2 and OF_THE_TEXT in outcome.err:
        return wrong
    if kind in HARMLESS:
        wrong.append(f"did not go on: exit {outcome.code}: {outcome.err.strip()[:200]}")
    elif outcome.code != 3:
        wrong.append(f"exit {outcome.code}: {outcome.err.strip()[-200:]}")
    else:
        # A batch reports the fault of the file together with the progress of the other files.
        lines = messages or [line for line in outcome.err.splitlines() if OF_A_FILE.match(line)]
        if len(messages) > 1 or not lines:
            wrong.append(f"not one line: {outcome.err.strip()[:200]}")
        names = ["not enough memory"] if kind == "memory" else [os.path.basename(what), "standard output"]
        target = re.sub(r"\.\d+\.\d+\.tmp$", "", names[0])
        if not any(name in line for name in [*names, target] for line in lines):
            wrong.append(f"does not name {target}: {outcome.err.strip()[:200]}")
    return wrong


class Tally:
    def __init__(self):
        self.tried = collections.Counter()
        self.deviations = []
        self.foreign = collections.Counter()
        self.left_out = set()

    def add(self, case, what, wrong):
        self.tried[case.name] += 1
        for text in wrong:
            self.deviations.append(f"{case.name}: {what}: {text}")
            print("DEVIATION", self.deviations[-1], flush=True)
