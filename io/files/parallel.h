// Runs independent jobs on a few threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "io/files/error.h"

namespace brdf::io {

inline std::atomic<unsigned> most_threads{8};

// Sets the largest number of threads per process. Called before the work begins if the work is already
// divided among processes or jobs, each of which then takes one processor.
inline void limit_threads(unsigned most) {
  most_threads = most;
}

// Returns the number of threads to use: BRDF_THREADS if the variable is set, otherwise the number of
// processors. The result is at most 8, or the number given to limit_threads(). Throws InputError if
// BRDF_THREADS is not a whole number above 0.
inline unsigned all_processors() {
  const unsigned most = most_threads;
  const char* const wanted = std::getenv("BRDF_THREADS");
  if (!wanted) return std::clamp(std::thread::hardware_concurrency(), 1u, most);
  unsigned number = 0;
  const std::string_view text = wanted;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || stop != text.data() + text.size() || number == 0)
    throw InputError("BRDF_THREADS: '" + std::string(text) + "' must be a whole number above 0");
  return std::min(number, most);
}

// Calls work(k) once for each k in [0, count), on `threads` threads including the calling one. Each call must
// store its result in a place of its own, so that results do not depend on the order. An exception stops the
// work and is rethrown here; of several, the one of the smallest k, because all smaller k have begun.
template <class Work>
void parallel_for(std::size_t count, Work&& work, unsigned threads = all_processors()) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::size_t failed = count;
  std::mutex mutex;
  const auto run = [&] {
    for (std::size_t k = next++; k < count; k = next++) {
      try {
        work(k);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (k < failed) failure = std::current_exception();
        failed = std::min(failed, k);
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t t = 1; t < std::min<std::size_t>(threads, count); ++t) others.emplace_back(run);
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

// Called with the number of finished jobs and the number of all jobs. Calls do not overlap.
using Progress = std::function<void(int done, int total)>;

// Runs job(0), ..., job(count - 1) and passes every result to `consume`. The calls of `consume` do not
// overlap and come in order, so that sums do not depend on the number of threads.
template <class Job, class Consume>
void parallel_in_order(int count, int threads, const Progress& progress, const Job& job,
                       const Consume& consume) {
  std::mutex mutex;
  std::map<int, decltype(job(0))> waiting;
  int consumed = 0, done = 0;
  parallel_for(
      std::size_t(count),
      [&](std::size_t k) {
        auto result = job(int(k));
        const std::lock_guard lock(mutex);
        waiting.emplace(int(k), std::move(result));
        for (auto first = waiting.begin(); first != waiting.end() && first->first == consumed; ++consumed) {
          consume(std::move(first->second));
          first = waiting.erase(first);
        }
        if (progress) progress(++done, count);
      },
      unsigned(std::max(threads, 1)));
}

}  // namespace brdf::io
