#include "shader/front/compile.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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
  limit(RLIMIT_CPU, kSeconds);
  limit(RLIMIT_CORE, 0);
  for (const int s : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) signal(s, SIG_DFL);
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere >= 0) dup2(nowhere, STDERR_FILENO), dup2(nowhere, STDOUT_FILENO);
}

void write_all(int to, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t done = ::write(to, bytes, count);
    if (done <= 0) return;
    bytes += done;
    count -= std::size_t(done);
  }
}

// 'S' with the note and the words, or 'E' with the messages.
[[noreturn]] void child(const Source& source, int to) {
  limit_resources();
  try {
    const Translated t = translate(source);
    std::string answer(1, t.spirv.empty() ? 'E' : 'S');
    answer += (t.spirv.empty() ? t.messages : t.note) + '\0';
    answer.append(reinterpret_cast<const char*>(t.spirv.data()), t.spirv.size() * sizeof t.spirv[0]);
    write_all(to, answer.data(), answer.size());
  } catch (...) {  // out of memory: an empty answer says so
  }
  _exit(0);
}

// All that comes before the end or the deadline; false where that passes first.
bool read_all(int from, std::string& answer) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(2 * kSeconds);
  char part[1 << 16];
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now())
            .count();
    pollfd waiting{from, POLLIN, 0};
    const int ready = left > 0 ? poll(&waiting, 1, int(left)) : 0;
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    const ssize_t count = ::read(from, part, sizeof part);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return true;
    answer.append(part, std::size_t(count));
    if (answer.size() > kLargestAnswer) return false;
  }
}

}  // namespace

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
  const bool ended = read_all(ends[0], answer);
  close(ends[0]);
  if (!ended) kill(process, SIGKILL);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  const std::size_t stop = answer.find('\0');
  if (!ended || answer.empty() || stop == answer.npos)
    throw InputError(source.name + ": the shader compiler needs more than " + std::to_string(kSeconds) +
                     " s or 1 GiB for this text, or fails on it");
  if (answer[0] == 'E') throw InputError(answer.substr(1, stop - 1));
  Compiled out;
  out.spirv.resize((answer.size() - stop - 1) / sizeof(std::uint32_t));
  std::memcpy(out.spirv.data(), answer.data() + stop + 1, out.spirv.size() * sizeof(std::uint32_t));
  if (stop > 1) out.notes.push_back(answer.substr(1, stop - 1));
  return out;
}

}  // namespace brdf::shader
