// Independent jobs on a few threads.
#pragma once

#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace brdf::micro {

/// Called from any thread, one call at a time, with the number of finished jobs and of all jobs.
using Progress = std::function<void(int done, int total)>;

/// Runs job(0), ..., job(count - 1) on `threads` threads and hands every result to `consume`, one at a time
/// and in order, so that sums do not depend on the number of threads. The first exception ends the work and
/// is thrown here.
template <class Job, class Consume>
void parallel_in_order(int count, int threads, const Progress& progress, const Job& job,
                       const Consume& consume) {
  std::mutex mutex;
  std::exception_ptr error;
  std::map<int, decltype(job(0))> waiting;
  int next = 0, consumed = 0, done = 0;
  const auto take = [&] {
    const std::lock_guard lock(mutex);
    return error ? count : next++;
  };
  const auto hand_over = [&](int index, auto result) {
    const std::lock_guard lock(mutex);
    waiting.emplace(index, std::move(result));
    for (auto first = waiting.begin(); first != waiting.end() && first->first == consumed; ++consumed) {
      consume(std::move(first->second));
      first = waiting.erase(first);
    }
    ++done;
    if (progress) progress(done, count);
  };
  const auto work = [&] {
    try {
      for (int i = take(); i < count; i = take()) hand_over(i, job(i));
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!error) error = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (int t = 1; t < threads; ++t) others.emplace_back(work);
    work();
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace brdf::micro
