// Compares evaluations with each other and with the machine, all interleaved in one run, best of 7 rounds:
// textbook scalar code, the library's template as scalar code, its batches on one and on two threads
// (elapsed time), and the limit set by the processor's divider and arithmetic units. Usage: bench_eval
// [FORM...]
#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <atomic>
#include <barrier>
#include <cstdio>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "bench/machine.h"
#include "bench/operations.h"
#include "bench/scalar_code.h"
#include "bench/throughput.h"
#include "brdf/facets.h"
#include "brdf/random.h"
#include "trade/measure/timing.h"

namespace brdf::bench {
namespace {

constexpr std::size_t kPairs = 512;  // fits in the first-level cache
constexpr int kRounds = 7;

// Keeps the calling thread on the k-th permitted processor during its lifetime: a thread that another thread
// wakes may otherwise share its processor. Does nothing if the system has no such call.
class OnProcessor {
 public:
#ifdef __linux__
  explicit OnProcessor(int k) {
    sched_getaffinity(0, sizeof allowed_, &allowed_);
    if (CPU_COUNT(&allowed_) <= k) return;
    int cpu = 0;
    for (int left = k; left > 0 || !CPU_ISSET(cpu, &allowed_); ++cpu) left -= CPU_ISSET(cpu, &allowed_) != 0;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(cpu, &one);
    sched_setaffinity(0, sizeof one, &one);
  }
  ~OnProcessor() { sched_setaffinity(0, sizeof allowed_, &allowed_); }

 private:
  cpu_set_t allowed_;
#else
  explicit OnProcessor(int) {}
  ~OnProcessor() = default;
#endif
 public:
  OnProcessor(const OnProcessor&) = delete;
  OnProcessor& operator=(const OnProcessor&) = delete;
};

// Two threads that run a pass over their own output at the same time, `turns` times each.
class Pair {
 public:
  explicit Pair(std::function<void(int)> pass) : pass_(std::move(pass)) {
    const auto once = [&] { pass_(0); };
    turns_ = timing::repeats_for(once, kMeeting, timing::Clock::wall);
  }
  ~Pair() {
    stop_ = true;
    start_.arrive_and_wait();
  }
  // Runs several meetings: in some of them, other programs leave both processors free.
  void operator()() {
    const OnProcessor first(0);
    for (int meeting = 0; meeting < kMeetings; ++meeting) {
      start_.arrive_and_wait();
      turn(0);
      end_.arrive_and_wait();
      const double wall = std::max(end_time_[0], end_time_[1]) - std::min(start_time_[0], start_time_[1]);
      best_ = std::min(best_, wall / double(turns_));
    }
  }
  // Returns the elapsed seconds from the first start to the last end in the best meeting, for one pass of
  // both threads.
  double best() const { return best_; }

 private:
  static constexpr int kMeetings = 8;
  static constexpr double kMeeting = 2e-3;  // s; waking the other thread takes 1 % of this time
  void turn(int thread) {
    start_time_[thread] = timing::seconds_now(timing::Clock::wall);
    for (long k = 0; k < turns_; ++k) pass_(thread);
    end_time_[thread] = timing::seconds_now(timing::Clock::wall);
  }
  void work() {
    const OnProcessor second(1);
    while (true) {
      start_.arrive_and_wait();
      if (stop_) return;
      turn(1);
      end_.arrive_and_wait();
    }
  }
  std::function<void(int)> pass_;
  long turns_ = 1;
  double start_time_[2] = {}, end_time_[2] = {}, best_ = 1e30;
  std::atomic<bool> stop_ = false;
  std::barrier<> start_{2}, end_{2};
  std::jthread other_{[this] { work(); }};
};

template <class T>
DirectionArrays<T> random_directions() {
  Random random(1);
  const auto one = [&] {
    const double theta = 1.4 * random.uniform(), phi = 2 * kPi * random.uniform();
    const Vec3<double> w = direction(radians(theta), radians(phi));
    return Vec3<T>{T(w.x), T(w.y), T(w.z)};
  };
  DirectionArrays<T> directions(kPairs);
  for (std::size_t i = 0; i < kPairs; ++i) directions.set(i, one(), one());
  return directions;
}

// Nanoseconds per evaluation. `textbook` is 0 if there is no textbook code of the form.
struct Row {
  Reflectance form;
  double textbook, scalar, batch, limit, two_threads;
};

template <class T>
Row measure(const Reflectance& form) {
  const ReflectanceInfo& about = info(form);
  const auto arrays = random_directions<T>();
  const Directions<T> d = arrays.view();
  std::vector<T> weights, shape;
  for (const ParameterInfo& p : about.weights) weights.push_back(T(p.initial));
  for (const ParameterInfo& p : about.shape)
    shape.push_back(T(p.role == Role::width_across ? 0.2 : p.initial));
  std::vector<T> out[2] = {std::vector<T>(kPairs), std::vector<T>(kPairs)};
  const ParameterValues<T> values{weights, weights, shape};
  const auto scalar = scalar_template<T>(form);
  const auto by_textbook = textbook<T>(form);
  std::vector<T> a(kThroughputCount), b(kThroughputCount), c(kThroughputCount);
  for (int i = 0; i < kThroughputCount; ++i) a[std::size_t(i)] = b[std::size_t(i)] = T(0.5 + 0.0004 * i);

  Pair pair([&](int thread) { form->eval_cos(values, d, out[thread].data()); });
  const std::vector<std::function<void()>> calls{
      [&] { (by_textbook ? by_textbook : scalar)(weights, shape, d, out[0].data()); },
      [&] { scalar(weights, shape, d, out[0].data()); },
      [&] { form->eval_cos(values, d, out[0].data()); },
      [&] { Throughput<T>::divide(a.data(), b.data(), c.data()); },
      [&] { Throughput<T>::square_root(a.data(), c.data()); },
      [&] { Throughput<T>::fused_multiply_add(a.data(), c.data()); },
      [&] { pair(); }};
  const auto t = timing::interleaved(calls, {.rounds = kRounds});
  const auto ns = [](double seconds, double count) { return 1e9 * seconds / count; };
  const Operations n = operations(form, std::is_same_v<T, double>);
  // The divider processes divisions and roots in turn. One fused multiply-add is two arithmetic operations.
  const double divider =
      n.divides * ns(t[3].best, kThroughputCount) + n.roots * ns(t[4].best, kThroughputCount);
  const double arithmetic = n.arithmetic * ns(t[5].best, 2.0 * kFmaPerValue * kThroughputCount);
  return {form,
          by_textbook ? ns(t[0].best, kPairs) : 0,
          ns(t[1].best, kPairs),
          ns(t[2].best, kPairs),
          std::max(divider, arithmetic),
          ns(pair.best(), 2.0 * kPairs)};
}

void print(const Row& r) {
  std::printf("%-26s", std::string(r.form.info().name).c_str());
  if (r.textbook > 0)
    std::printf("%9.2f", r.textbook);
  else
    std::printf("%9s", "-");
  std::printf("%9.2f%9.3f%9.3f", r.scalar, r.batch, r.limit);
  if (r.textbook > 0)
    std::printf("%10.1f", r.textbook / r.batch);
  else
    std::printf("%10s", "-");
  std::printf("%10.1f%9.0f %%%9.2f\n", r.scalar / r.batch, 100 * r.limit / r.batch, r.batch / r.two_threads);
  std::fflush(stdout);
}

// Returns the row of the first form with these facets, or null.
const Row* find(const std::vector<Row>& rows, const FacetFacts& facets) {
  for (const Row& r : rows)
    if (r.form.info().facets == &facets) return &r;
  return nullptr;
}

void print_goals(const std::vector<Row>& in_double, const std::vector<Row>& in_float) {
  if (const Row *ggx = find(in_double, Facets<GgxSlopes, SmithGgx>::facts),
      *beckmann = find(in_double, Facets<BeckmannSlopes, SmithBeckmann>::facts);
      ggx && beckmann)
    print_goal("Beckmann's facets over GGX's, double", beckmann->batch / ggx->batch, false, 7);
  const double times = __builtin_cpu_supports("avx512vl") ? 6 : 3;
  for (std::size_t k = 0; k < in_double.size(); ++k) {
    const Row &r = in_double[k], &f = in_float[k];
    const std::string name(r.form.info().name);
    const Goals wanted = goals_of(r.form);
    if (wanted.float_over_double == 0) continue;
    print_goal(name + ", float over double", r.batch / f.batch, true, wanted.float_over_double);
    for (const Row* row : {&r, &f}) {
      const bool is_double = row == &r;
      const std::string scalar = is_double ? "double" : "float";
      if (const double share = is_double ? wanted.of_limit_in_double : wanted.of_limit_in_float; share > 0)
        print_goal(name + ", share of the limit, " + scalar, row->limit / row->batch, true, share);
      print_goal(name + ", batch over the scalar template, " + scalar, row->scalar / row->batch, true, times);
      print_goal(name + ", two threads over one, " + scalar, row->batch / row->two_threads, true, 1.9);
    }
  }
}

template <class T>
std::vector<Row> table(const std::vector<Reflectance>& forms) {
  std::printf("\n%s, ns per evaluation of f cos_i\n%-26s%9s%9s%9s%9s%10s%10s%11s%9s\n",
              std::is_same_v<T, double> ? "double" : "float", "form", "textbook", "scalar", "batch", "limit",
              "textbook/", "scalar/", "of limit", "2 threads");
  std::vector<Row> rows;
  for (const Reflectance& form : forms) print(rows.emplace_back(measure<T>(form)));
  return rows;
}

int run(int argc, char** argv) {
  std::vector<Reflectance> forms;
  for (int k = 1; k < argc; ++k) {
    const auto form = find_form(argv[k]);
    if (!form) {
      std::fprintf(stderr, "bench_eval: no form is called '%s' (see brdf models)\n", argv[k]);
      return 2;
    }
    forms.push_back(*form);
  }
  if (forms.empty()) forms.assign(catalogue().begin(), catalogue().end());
  std::printf(
      "bench_eval of brdf %s\n%s\nbest of %d interleaved rounds, %zu pairs, anisotropic where there is a "
      "choice\n",
      BRDF_VERSION, machine().c_str(), kRounds, kPairs);
  const auto in_double = table<double>(forms);
  const auto in_float = table<float>(forms);
  std::printf("\ngoals\n");
  print_goals(in_double, in_float);
  return 0;
}

}  // namespace
}  // namespace brdf::bench

int main(int argc, char** argv) {
  return brdf::bench::run(argc, argv);
}
