#include "shader/front/compile.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <new>
#include <optional>

#include "io/files/error.h"
#include "shader/front/glslang.h"
#include "shader/front/packed.h"

namespace brdf::shader {
namespace {

constexpr std::uint64_t kMemory = 1ull << 30;
constexpr int kSeconds = 4;  // of processor time; a reflectance takes 0.1 s
constexpr std::size_t kLargestAnswer = 1u << 26;

// Limits the resources that a new process may use in addition to the memory that it started with.
void limit_resources() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const std::uint64_t memory = pages * std::uint64_t(sysconf(_SC_PAGESIZE)) + kMemory;
  const auto limit = [](auto what, rlim_t most) {
    const rlimit both{most, most};
    setrlimit(what, &both);
  };
  limit(RLIMIT_AS, memory);
  limit(RLIMIT_CORE, 0);
  for (const int s : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) signal(s, SIG_DFL);
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere >= 0) dup2(nowhere, STDERR_FILENO), dup2(nowhere, STDOUT_FILENO);
}

// Limits the processor time from now on.
void limit_time() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = rlim_t(used.ru_utime.tv_sec + used.ru_stime.tv_sec + kSeconds);
  const rlimit most{seconds, RLIM_INFINITY};
  setrlimit(RLIMIT_CPU, &most);
}

void write_all(int to, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t done = ::write(to, bytes, count);
    if (done <= 0) return;
    bytes += done;
    count -= std::size_t(done);
  }
}

std::string answer_of(const Translated& t) {
  std::string out;
  put(out, t.spirv.empty() ? t.messages : "");
  put(out, t.note);
  std::vector<std::string> left_out;
  for (const LeftOut& f : t.left_out)
    if (!t.spirv.empty() && !f.is_declaration) left_out.insert(left_out.end(), {f.name, f.why, f.text});
  for (const std::vector<std::string>& list : {left_out, t.missing, t.asked, t.unmentioned}) put(out, list);
  put(out, t.whole);
  put(out, t.narrow_word);
  put(out, std::string(t.ignores_narrow ? "1" : ""));
  put(out, std::string(reinterpret_cast<const char*>(t.spirv.data()), t.spirv.size() * sizeof t.spirv[0]));
  return out;
}

constexpr int kOutOfMemory = 3;  // exit codes of the process
constexpr int kThrew = 4;

// Runs `work`, then ends the process. Out of memory and other exceptions end the process with an exit code
// of their own, because the compiler does not handle exceptions.
template <class Work>
[[noreturn]] void run_in_process(Work&& work) {
  limit_resources();
  std::set_new_handler([] { _exit(kOutOfMemory); });
  try {
    work();
  } catch (const std::bad_alloc&) {
    _exit(kOutOfMemory);
  } catch (...) {
    _exit(kThrew);
  }
  _exit(0);
}

// Reads until the end of the stream or until `answer` has `most` bytes. Returns false if the deadline
// passes first.
bool read_until(int from, std::string& answer, std::size_t most) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(2 * kSeconds);
  char part[1 << 16];
  while (answer.size() < most) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now())
            .count();
    pollfd waiting{from, POLLIN, 0};
    const int ready = left > 0 ? poll(&waiting, 1, int(left)) : 0;
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    const ssize_t count = ::read(from, part, std::min(sizeof part, most - answer.size()));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return true;
    answer.append(part, std::size_t(count));
  }
  return true;
}

// How a process without an answer ended.
struct Ending {
  enum class Kind { crashed, slow, large } kind = Kind::crashed;
  std::string how = {};  // details of a crash
};

Ending ending_of(int status, bool in_time) {
  if (!in_time || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)) return {Ending::Kind::slow};
  if (WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemory) return {Ending::Kind::large};
  if (WIFSIGNALED(status))
    return {Ending::Kind::crashed,
            "signal " + std::to_string(WTERMSIG(status)) + ", " + strsignal(WTERMSIG(status))};
  return {Ending::Kind::crashed, "without an answer"};
}

[[noreturn]] void refuse(const Source& source, const Ending& ending) {
  const std::string advice = "; remove the parts of the file that the reflectance does not need";
  if (ending.kind == Ending::Kind::slow)
    throw InputError(source.name + ": the shader compiler needs more than " + std::to_string(kSeconds) +
                     " s for this text" + advice);
  if (ending.kind == Ending::Kind::large)
    throw InputError(source.name + ": the shader compiler needs more than 1 GiB for this text" + advice);
  throw InputError(source.name + ": the shader compiler crashes on this text (" + ending.how + ")" + advice);
}

// Decodes the output of the process; std::nullopt if the output is incomplete.
std::optional<Compiled> compiled_of(const std::string& answer) {
  Taken taken(answer);
  const std::string messages = taken.text(), note = taken.text();
  Compiled out;
  const std::vector<std::string> left_out = taken.list();
  for (std::size_t k = 0; k + 2 < left_out.size(); k += 3)
    out.left_out.push_back({left_out[k], left_out[k + 1], left_out[k + 2]});
  out.missing = taken.list();
  out.asked = taken.list();
  out.unmentioned = taken.list();
  out.whole = taken.text();
  out.narrow_word = taken.text();
  out.ignores_narrow = !taken.text().empty();
  const std::string spirv = taken.text();
  if (!taken.whole()) return std::nullopt;
  if (!messages.empty()) throw InputError(messages);
  out.spirv.resize(spirv.size() / sizeof(std::uint32_t));
  std::memcpy(out.spirv.data(), spirv.data(), out.spirv.size() * sizeof(std::uint32_t));
  if (!note.empty()) out.notes.push_back(note);
  return out;
}

// Compiles with less and less information on source places as long as the compiler crashes. `attempt`
// provides the answer and returns how the process ended.
template <class AttemptWith>
Compiled compile_somehow(const Source& source, AttemptWith&& attempt) {
  Ending first;
  for (const Places places : {Places::scopes, Places::lines, Places::none}) {
    std::string answer;
    const Ending ending = attempt(places, answer);
    if (std::optional<Compiled> compiled = compiled_of(answer)) {
      if (places == Places::none)
        compiled->notes.push_back(
            "the shader compiler crashes when it reports lines of this text, so messages have no line "
            "numbers");
      return *std::move(compiled);
    }
    if (places == Places::scopes) first = ending;
    if (ending.kind != Ending::Kind::crashed) refuse(source, ending);
  }
  refuse(source, first);
}

bool read_sized(int from, std::string& bytes) {
  std::string head;
  std::uint64_t size = 0;
  if (!read_until(from, head, sizeof size) || head.size() != sizeof size) return false;
  std::memcpy(&size, head.data(), sizeof size);
  bytes.clear();
  return size < kLargestAnswer && read_until(from, bytes, size) && bytes.size() == size;
}
void write_sized(int to, const std::string& bytes) {
  std::string sized;
  put(sized, bytes);
  write_all(to, sized.data(), sized.size());
}

std::string question_of(const Source& source, Places places) {
  std::string out;
  const std::string kind{char(source.language), char(source.compute), char(places)};
  for (const std::string& text : {source.name, source.folder.string(), kind, source.text, source.bare})
    put(out, text);
  put(out, source.defines);
  put(out, source.include_folders);
  return out;
}

// Compiles texts until the pipe is closed.
void serve(int from, int to) {
  std::string question;
  const auto waits = [&] {  // without a time limit
    pollfd waiting{from, POLLIN, 0};
    while (poll(&waiting, 1, -1) < 0 && errno == EINTR) {
    }
    return read_sized(from, question);
  };
  while (waits()) {
    Taken taken(question);
    Source source;
    source.name = taken.text();
    source.folder = taken.text();
    const std::string kind = taken.text();
    source.text = taken.text();
    source.bare = taken.text();
    source.defines = taken.list();
    source.include_folders = taken.list();
    if (!taken.whole() || kind.size() != 3) return;
    source.language = Language(kind[0]);
    source.compute = kind[1] != 0;
    limit_time();
    write_sized(to, answer_of(translate(source, Places(kind[2]))));
  }
}

}  // namespace

void Compiler::start() {
  prepare_translation();
  int there[2], back[2];
  if (pipe2(there, O_CLOEXEC) != 0)
    throw EnvironmentError("cannot start the shader compiler: " + std::string(std::strerror(errno)));
  if (pipe2(back, O_CLOEXEC) != 0) {
    close(there[0]), close(there[1]);
    throw EnvironmentError("cannot start the shader compiler: " + std::string(std::strerror(errno)));
  }
  process_ = fork();
  if (process_ == 0) {
    close(there[1]), close(back[0]);
    run_in_process([&] { serve(there[0], back[1]); });
  }
  close(there[0]), close(back[1]);
  to_ = there[1], from_ = back[0];
  if (process_ > 0) return;
  process_ = 0;
  close(to_), close(from_);
  throw EnvironmentError("cannot start the shader compiler: " + std::string(std::strerror(errno)));
}

// Stops the process and returns its status, which is kept if the process had already ended by itself.
int Compiler::stop() {
  if (process_ == 0) return 0;
  close(to_), close(from_);
  kill(process_, SIGKILL);  // a process that has ended keeps its status
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = 0;
  return status;
}

Compiled Compiler::compile(const Source& source) {
  return compile_somehow(source, [&](Places places, std::string& answer) {
    if (process_ == 0) start();
    // A write to a process that has ended must not end this process.
    const auto ignored = signal(SIGPIPE, SIG_IGN);
    write_sized(to_, question_of(source, places));
    signal(SIGPIPE, ignored);
    const auto begin = std::chrono::steady_clock::now();
    if (read_sized(from_, answer)) return Ending{};
    answer.clear();
    const bool in_time = std::chrono::steady_clock::now() - begin < std::chrono::seconds(2 * kSeconds);
    return ending_of(stop(), in_time);
  });
}

Compiled compile(const Source& source, Translate by) {
  prepare_translation();
  return compile_somehow(source, [&](Places places, std::string& answer) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
      throw EnvironmentError("cannot start the shader compiler: " + std::string(std::strerror(errno)));
    const pid_t process = fork();
    if (process < 0) {
      close(ends[0]), close(ends[1]);
      throw EnvironmentError("cannot start the shader compiler: " + std::string(std::strerror(errno)));
    }
    if (process == 0) {
      close(ends[0]);
      run_in_process([&] {
        limit_time();
        const std::string own = answer_of(by(source, places));
        write_all(ends[1], own.data(), own.size());
      });
    }
    close(ends[1]);
    const bool in_time = read_until(ends[0], answer, kLargestAnswer);
    close(ends[0]);
    if (!in_time) kill(process, SIGKILL);
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    if (!in_time) answer.clear();
    return answer.size() < kLargestAnswer ? ending_of(status, in_time) : Ending{Ending::Kind::large};
  });
}

}  // namespace brdf::shader
