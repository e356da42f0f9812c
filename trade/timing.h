// Timing of alternatives against each other within one run. Standard library only: benchmarks use it too.
//
// A machine's speed drifts (frequency, neighbours), so alternatives are run in turn, round after round, and
// compared by the lower quartile of their rounds: the minimum rewards luck, the median carries the
// neighbours' load.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <span>
#include <vector>

namespace brdf::timing {

// Seconds per call: quartiles over the rounds.
struct Timing {
  double lower = 0, median = 0, upper = 0;
  int rounds = 0;
  double best = 0;  // of all rounds
  // Interquartile range over the lower quartile: how far the figure can be trusted.
  double spread() const { return lower > 0 ? (upper - lower) / lower : 0; }
};

// wall: what a user waits. thread: the processor time of the calling thread, which others on the machine do
// not lengthen; for work on one thread. process: the same for all threads of the program.
enum class Clock { wall, thread, process };

struct Options {
  int rounds = 21;
  Clock clock = Clock::wall;
  double least_seconds =
      2e-4;  // a round repeats the call until it lasts this long: far above the clock's tick
  std::function<void()> between = [] {};  // called after each round (progress)
};

// Keeps a result alive without storing it.
template <class T>
inline void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

inline double seconds_now(Clock clock) {
#ifdef CLOCK_THREAD_CPUTIME_ID
  if (clock != Clock::wall) {
    std::timespec t;
    clock_gettime(clock == Clock::thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
  }
#endif
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

inline double seconds_of(const std::function<void()>& call, long repeats, Clock clock) {
  const double start = seconds_now(clock);
  for (long k = 0; k < repeats; ++k) call();
  return seconds_now(clock) - start;
}

// Linear interpolation between the order statistics of sorted values.
inline double quantile(std::span<const double> sorted, double q) {
  const double at = q * double(sorted.size() - 1);
  const auto below = std::size_t(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - double(below)) * (sorted[above] - sorted[below]);
}

// How often a call must be repeated to last `least_seconds`; the calls made here also warm the caches.
inline long repeats_for(const std::function<void()>& call, double least_seconds, Clock clock) {
  long repeats = 1;
  while (true) {
    const double t = seconds_of(call, repeats, clock);
    if (t >= least_seconds) return repeats;
    const double factor = t > 0 ? std::clamp(1.2 * least_seconds / t, 2.0, 100.0) : 100.0;
    repeats = long(std::ceil(double(repeats) * factor));
  }
}

// One timing per call. Every round runs each call once (with its repeats), starting one further each time, so
// that none always follows the same neighbour.
inline std::vector<Timing> interleaved(std::span<const std::function<void()>> calls,
                                       const Options& options = {}) {
  const std::size_t n = calls.size();
  std::vector<long> repeats;
  for (const auto& call : calls) repeats.push_back(repeats_for(call, options.least_seconds, options.clock));
  std::vector<std::vector<double>> seconds(n);
  for (int round = 0; round < options.rounds; ++round) {
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t turn = (k + std::size_t(round)) % n;
      seconds[turn].push_back(seconds_of(calls[turn], repeats[turn], options.clock) / double(repeats[turn]));
    }
    options.between();
  }
  std::vector<Timing> timings;
  for (auto& s : seconds) {
    std::sort(s.begin(), s.end());
    timings.push_back({quantile(s, 0.25), quantile(s, 0.5), quantile(s, 0.75), int(s.size()), s.front()});
  }
  return timings;
}

}  // namespace brdf::timing
