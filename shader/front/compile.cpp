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

#include "io/error.h"
#include "io/text.h"
#include "shader/front/glslang.h"

namespace brdf::shader {
namespace {

constexpr std::uint64_t kMemory = 1ull << 30;
constexpr int kSeconds = 4;  // of the processor; a reflectance takes 0.1
constexpr std::size_t kLargestAnswer = 1u << 26;

// What a fresh process may take on top of what it was born with.
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

// Of the processor, from now on.
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

// 'S' with the note, the functions left out and the words, or 'E' with the messages; texts end with 0, the last with an empty one.
std::string answer_of(const Source& source) {
  const Translated t = translate(source);
  std::string answer(1, t.spirv.empty() ? 'E' : 'S');
  answer += (t.spirv.empty() ? t.messages : t.note) + '\0';
  for (const LeftOut& f : t.left_out)
    if (!t.spirv.empty() && !f.is_declaration) answer += f.name + '\0' + f.why + '\0';
  answer += '\0';
  return answer.append(reinterpret_cast<const char*>(t.spirv.data()), t.spirv.size() * sizeof t.spirv[0]);
}

[[noreturn]] void child(const Source& source, int to) {
  limit_resources();
  limit_time();
  try {
    const std::string answer = answer_of(source);
    write_all(to, answer.data(), answer.size());
  } catch (...) {  // out of memory: an empty answer says so
  }
  _exit(0);
}

// Reads until the deadline: all that comes before the end, or `most` bytes. False where the time passes first.
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

// What the process wrote.
Compiled compiled_of(const Source& source, const std::string& answer) {
  std::size_t at = 1;
  bool whole = !answer.empty();
  const auto text = [&] {
    const std::size_t stop = whole ? answer.find('\0', at) : answer.npos;
    whole = stop != answer.npos;
    const std::string out = whole ? answer.substr(at, stop - at) : "";
    at = stop + 1;
    return out;
  };
  Compiled out;
  const std::string first = text();
  while (whole) {
    const std::string name = text();
    if (name.empty()) break;
    const std::string why = text();
    out.left_out.push_back({name, why});
  }
  if (!whole)
    throw InputError(source.name + ": the shader compiler needs more than " + std::to_string(kSeconds) +
                     " s or 1 GiB for this text, or fails on it");
  if (answer[0] == 'E') throw InputError(first);
  out.spirv.resize((answer.size() - at) / sizeof(std::uint32_t));
  std::memcpy(out.spirv.data(), answer.data() + at, out.spirv.size() * sizeof(std::uint32_t));
  if (!first.empty()) out.notes.push_back(first);
  return out;
}

// A number and as many bytes.
void write_sized(int to, const std::string& bytes) {
  const std::uint64_t size = bytes.size();
  write_all(to, reinterpret_cast<const char*>(&size), sizeof size);
  write_all(to, bytes.data(), bytes.size());
}
bool read_sized(int from, std::string& bytes) {
  std::string head;
  std::uint64_t size = 0;
  if (!read_until(from, head, sizeof size) || head.size() != sizeof size) return false;
  std::memcpy(&size, head.data(), sizeof size);
  bytes.clear();
  return size < kLargestAnswer && read_until(from, bytes, size) && bytes.size() == size;
}

// Until there is nothing more to compile.
[[noreturn]] void serve(int from, int to) {
  limit_resources();
  Source source;
  std::string folder, kind;
  const auto waits = [&] {  // however long
    pollfd waiting{from, POLLIN, 0};
    while (poll(&waiting, 1, -1) < 0 && errno == EINTR) {
    }
    return read_sized(from, source.name) && read_sized(from, folder) && read_sized(from, kind) &&
           read_sized(from, source.text) && kind.size() == 2;
  };
  try {
    while (waits()) {
      source.folder = folder;
      source.language = Language(kind[0]);
      source.compute = kind[1] != 0;
      limit_time();
      write_sized(to, answer_of(source));
    }
  } catch (...) {
  }
  _exit(0);
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
    serve(there[0], back[1]);
  }
  close(there[0]), close(back[1]);
  to_ = there[1], from_ = back[0];
  if (process_ > 0) return;
  process_ = 0;
  close(to_), close(from_);
  throw EnvironmentError("cannot start the shader compiler: " + std::string(std::strerror(errno)));
}

void Compiler::stop() {
  if (process_ == 0) return;
  close(to_), close(from_);
  kill(process_, SIGKILL);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = 0;
}

Compiled Compiler::compile(const Source& source) {
  if (process_ == 0) start();
  // A process that has ended meanwhile must not end this one.
  const auto ignored = signal(SIGPIPE, SIG_IGN);
  for (const std::string& part : {source.name, source.folder.string(),
                                  std::string{char(source.language), char(source.compute)}, source.text})
    write_sized(to_, part);
  signal(SIGPIPE, ignored);
  std::string answer;
  if (!read_sized(from_, answer)) {
    answer.clear();
    stop();
  }
  return compiled_of(source, answer);
}

Compiled compile(const Source& source) {
  prepare_translation();
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
    child(source, ends[1]);
  }
  close(ends[1]);
  std::string answer;
  const bool ended = read_until(ends[0], answer, kLargestAnswer) && answer.size() < kLargestAnswer;
  close(ends[0]);
  if (!ended) kill(process, SIGKILL);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return compiled_of(source, ended ? answer : "");
}

}  // namespace brdf::shader
