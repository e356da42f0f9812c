// Runs a flattened program in any scalar, W pairs of directions at a time.
//
// While all lanes take the same path, a step is one loop over W. When the lanes diverge, the lanes that are
// furthest behind run until they meet the others again, as they do in structured code.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <vector>

#include "brdf/clones.h"
#include "shader/run/step.h"

namespace brdf::shader {

// A loop that does not end: thrown if an evaluation takes more steps than allowed. The caller that filled
// the bank adds the inputs.
struct EndlessLoop {
  std::uint32_t line;
  int lane;
  std::vector<double> values = {};  // of all parameters
  std::array<double, 3> wi = {}, wo = {};
};

constexpr std::size_t kMostStepsRun = 200'000;  // per evaluation
// Directions evaluated together. g++ replaces a loop of up to 16 turns by its turns, which it does not
// vectorise.
constexpr int kLanes = 32;

namespace detail {

template <class T, int W, class Lanes>
[[gnu::always_inline]] inline void run_steps(const Step* steps, std::size_t count, Bank<T, W>& bank,
                                             const Lanes& lanes) {
  for (std::size_t k = 0; k < count; ++k) run_step(steps[k], bank, lanes);
}
template <class B, int N, int W, class Lanes>
[[gnu::always_inline]] inline void run_steps(const Step* steps, std::size_t count, Bank<Dual<B, N>, W>& bank,
                                             const Lanes& lanes) {
  for (std::size_t k = 0; k < count; ++k)
    bank.has_partials(steps[k]) ? run_step(steps[k], bank, lanes) : run_step(steps[k], bank.values(), lanes);
}

template <class T>
inline constexpr bool is_plain = std::floating_point<T>;
template <class B, int N>
inline constexpr bool is_plain<Dual<B, N>> = std::floating_point<B>;

// Runs the steps of a stretch, compiled for each CPU generation if lanes are plain numbers. For other
// scalars g++ does not inline the operations into the clones, and each call between code for two
// generations costs about 100 ns.
template <class T, int W>
BRDF_CLONES void run_clone(const Step* steps, std::size_t count, Bank<T, W>& bank) {
  run_steps(steps, count, bank, AllLanes<W>{});
}
// Runs of plain numbers, one by one and in kLanes, are compiled in shader/evaluate.cpp alone.
void run_numbers(const Step* steps, std::size_t count, Bank<float, 1>& bank);
void run_numbers(const Step* steps, std::size_t count, Bank<double, 1>& bank);
void run_numbers(const Step* steps, std::size_t count, Bank<float, kLanes>& bank);
void run_numbers(const Step* steps, std::size_t count, Bank<double, kLanes>& bank);

template <class T, int W>
void run_all(const Step* steps, std::size_t count, Bank<T, W>& bank) {
  if constexpr ((std::same_as<T, float> || std::same_as<T, double>)&&(W == 1 || W == kLanes))
    run_numbers(steps, count, bank);
  else if constexpr (is_plain<T>)
    run_clone(steps, count, bank);
  else
    run_steps(steps, count, bank, AllLanes<W>{});
}
template <class T, int W>
void run_some(const Step* steps, std::size_t count, Bank<T, W>& bank, const SomeLanes& lanes) {
  run_steps(steps, count, bank, lanes);
}

}  // namespace detail

// Runs the program from its start in the first `lanes` lanes. The inputs must be in the bank; afterwards
// the bank contains the results. Throws EndlessLoop.
template <class T, int W>
void run(const Program& program, Bank<T, W>& bank, int lanes = W, std::size_t most_steps = kMostStepsRun) {
  std::array<std::uint32_t, W> at{};  // each lane's stretch
  std::array<std::uint8_t, W> active{};
  constexpr std::uint32_t kDone = ~0u;
  for (int l = lanes; l < W; ++l) at[std::size_t(l)] = kDone;
  std::size_t taken = 0;
  const std::size_t most = most_steps * std::size_t(std::max(W / 4, 1));  // divergent lanes take turns
  for (;;) {
    const std::uint32_t here = *std::ranges::min_element(at);
    if (here == kDone) return;
    int count = 0;
    for (int l = 0; l < W; ++l)
      if (at[std::size_t(l)] == here) active[std::size_t(count++)] = std::uint8_t(l);
    const Stretch& stretch = program.stretches[here];
    taken += stretch.steps.size() + 1;
    if (taken > most) throw EndlessLoop{stretch.line, active[0], {}, {}, {}};
    // Unused lanes are computed as well; their results are not read.
    if (count == lanes)
      detail::run_all(stretch.steps.data(), stretch.steps.size(), bank);
    else
      detail::run_some(stretch.steps.data(), stretch.steps.size(), bank, SomeLanes{active.data(), count});
    for (int k = 0; k < count; ++k) {
      const std::size_t l = active[std::size_t(k)];
      const bool second = stretch.end == End::branch && bank.integer(stretch.condition)[l] == 0;
      at[l] = stretch.end == End::stop ? kDone : stretch.next[second ? 1 : 0];
    }
  }
}

// Runs one lane step by step. Calls watch(step) after each step, with the step's operands still in the bank
// (unless the step overwrites one), and at_end(stretch) at the end of each stretch. Throws EndlessLoop.
template <class T, class Watch, class AtEnd>
void run_watched(const Program& program, Bank<T, 1>& bank, Watch&& watch, std::size_t most_steps,
                 AtEnd&& at_end) {
  std::size_t taken = 0;
  for (std::uint32_t here = 0;;) {
    const Stretch& stretch = program.stretches[here];
    for (const Step& step : stretch.steps) {
      detail::run_step(step, bank, AllLanes<1>{});
      watch(step);
    }
    at_end(stretch);
    taken += stretch.steps.size() + 1;
    if (taken > most_steps) throw EndlessLoop{stretch.line, 0, {}, {}, {}};
    if (stretch.end == End::stop) return;
    here = stretch.next[stretch.end == End::branch && bank.integer(stretch.condition)[0] == 0 ? 1 : 0];
  }
}

template <class T, class Watch>
void run_watched(const Program& program, Bank<T, 1>& bank, Watch&& watch) {
  run_watched<T>(program, bank, watch, kMostStepsRun, [](const Stretch&) {});
}

}  // namespace brdf::shader
