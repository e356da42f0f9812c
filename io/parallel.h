// Independent jobs on a few threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace brdf::io {

// As many as BRDF_THREADS says, else as there are processors; at most eight.
inline unsigned all_processors() {
  const char* wanted = std::getenv("BRDF_THREADS");
  const int number = wanted ? std::atoi(wanted) : 0;
  return std::clamp(number > 0 ? unsigned(number) : std::thread::hardware_concurrency(), 1u, 8u);
}

// Calls work(k) for k in [0, count), each once, on `threads` threads of which this is one. Results must go to places of
// their own, so that they do not depend on the order. The first exception ends the work and is thrown here.
template <class Work>
void parallel_for(std::size_t count, Work&& work, unsigned threads = all_processors()) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&] {
    for (std::size_t k = next++; k < count; k = next++) {
      try {
        work(k);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
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

// Called one at a time with the number of finished jobs and of all jobs.
using Progress = std::function<void(int done, int total)>;

// Runs job(0), ..., job(count - 1) and hands every result to `consume`, one at a time and in order, so that sums do not
// depend on the number of threads.
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
