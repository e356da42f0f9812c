// Times alternatives against each other within one run. Uses the standard library only, since benchmarks
// include this header, too.
//
// The speed of a machine drifts (frequency, other processes). Alternatives are therefore run in turn, round
// after round, and compared by the lower quartile of their rounds: the minimum would reward luck, and the
// median would include the load by other processes. The cost of an alternative relative to the first one is
// computed from pairs: its run divided by the runs of the first one just before and after, in the median
// over the rounds. Slow drifts cancel within a pair.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#ifdef __linux__
#include <sched.h>
#endif

namespace brdf::timing {

// Seconds per call: quartiles over the rounds.
struct Timing {
  double lower = 0, median = 0, upper = 0;
  int rounds = 0;
  double best = 0;          // minimum over all rounds
  double ratio = 1;         // to the first call, median of the pairs
  double ratio_spread = 0;  // interquartile range of the pairs divided by their median
  // Returns the interquartile range divided by the lower quartile. A small value means a reliable figure.
  double spread() const { return lower > 0 ? (upper - lower) / lower : 0; }
};

// wall: elapsed time, which includes waiting. thread: processor time of the calling thread, which other
// processes do not lengthen; for work on one thread. process: processor time of all threads of the program.
enum class Clock { wall, thread, process };

struct Options {
  int rounds = 21;
  Clock clock = Clock::wall;
  // A round repeats the call until it lasts this long, which is far above the resolution of the clock.
  double least_seconds = 2e-4;
  std::size_t neighbours = 1;             // calls between two runs of the first one; use more for long calls
  std::function<void()> between = [] {};  // called after each round (progress)
};

// Keeps the calling thread on its current processor, if the system permits, to avoid cold caches within a
// round.
class Pinned {
 public:
#ifdef __linux__
  Pinned() {
    if (sched_getaffinity(0, sizeof before_, &before_) != 0) return;
    cpu_set_t here;
    CPU_ZERO(&here);
    CPU_SET(std::size_t(std::max(0, sched_getcpu())), &here);
    pinned_ = sched_setaffinity(0, sizeof here, &here) == 0;
  }
  ~Pinned() {
    if (pinned_) sched_setaffinity(0, sizeof before_, &before_);
  }
#else
  Pinned() {}
#endif
  Pinned(const Pinned&) = delete;
  Pinned& operator=(const Pinned&) = delete;

 private:
#ifdef __linux__
  cpu_set_t before_;
  bool pinned_ = false;
#endif
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

// Interpolates linearly between the order statistics of sorted values.
inline double quantile(std::span<const double> sorted, double q) {
  const double at = q * double(sorted.size() - 1);
  const auto below = std::size_t(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - double(below)) * (sorted[above] - sorted[below]);
}

// Returns the number of repeats for which a call lasts `least_seconds`. The calls made here also warm the
// caches.
inline long repeats_for(const std::function<void()>& call, double least_seconds, Clock clock) {
  long repeats = 1;
  while (true) {
    const double t = seconds_of(call, repeats, clock);
    if (t >= least_seconds) return repeats;
    const double factor = t > 0 ? std::clamp(1.2 * least_seconds / t, 2.0, 100.0) : 100.0;
    repeats = long(std::ceil(double(repeats) * factor));
  }
}

// One round: every call once (with its repeats), and the first call again after each group of `neighbours`
// others, unless one group holds all others. Each round starts with the next of the others, which prevents a
// call from always following the same neighbour.
struct Round {
  std::vector<double> seconds, ratios;  // by call
};
inline Round run_round(std::span<const std::function<void()>> calls, std::span<const long> repeats, int turn,
                       const Options& options) {
  const std::size_t others = calls.size() - 1, group = std::max<std::size_t>(1, options.neighbours);
  const auto run = [&](std::size_t k) {
    return seconds_of(calls[k], repeats[k], options.clock) / double(repeats[k]);
  };
  Round round{std::vector<double>(calls.size()), std::vector<double>(calls.size(), 1.0)};
  double before = round.seconds[0] = run(0);
  for (std::size_t at = 0; at < others; at += group) {
    const std::size_t end = std::min(at + group, others);
    const auto call = [&](std::size_t k) { return 1 + (k + std::size_t(turn)) % others; };
    for (std::size_t k = at; k < end; ++k) round.seconds[call(k)] = run(call(k));
    const double after = group > others ? before : run(0);
    for (std::size_t k = at; k < end; ++k)
      round.ratios[call(k)] = round.seconds[call(k)] / (0.5 * (before + after));
    before = after;
  }
  return round;
}

// Returns one timing per call. Ratios are relative to the first call. With Clock::thread the thread is
// pinned.
inline std::vector<Timing> interleaved(std::span<const std::function<void()>> calls,
                                       const Options& options = {}) {
  const std::optional<Pinned> pinned =
      options.clock == Clock::thread ? std::optional<Pinned>(std::in_place) : std::nullopt;
  std::vector<long> repeats;
  for (const auto& call : calls) repeats.push_back(repeats_for(call, options.least_seconds, options.clock));
  std::vector<std::vector<double>> seconds(calls.size()), ratios(calls.size());
  for (int turn = 0; turn < options.rounds; ++turn) {
    const Round round = run_round(calls, repeats, turn, options);
    for (std::size_t k = 0; k < calls.size(); ++k) {
      seconds[k].push_back(round.seconds[k]);
      ratios[k].push_back(round.ratios[k]);
    }
    options.between();
  }
  std::vector<Timing> timings;
  for (std::size_t k = 0; k < calls.size(); ++k) {
    std::vector<double>&s = seconds[k], &r = ratios[k];
    std::ranges::sort(s);
    std::ranges::sort(r);
    const double median = quantile(r, 0.5);
    timings.push_back({quantile(s, 0.25), quantile(s, 0.5), quantile(s, 0.75), int(s.size()), s.front(),
                       median, (quantile(r, 0.75) - quantile(r, 0.25)) / median});
  }
  return timings;
}

}  // namespace brdf::timing
