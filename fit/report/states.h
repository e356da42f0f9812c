// How a fit stands: one table from what was found to the mark, the exit code and the sentence that every face
// shows.
#pragma once

#include <string>
#include <vector>

#include "fit/assess/result.h"
#include "io/page/html_report.h"

namespace brdf::fit {

// What can be said of a fit. Several hold at once; the first that holds makes the headline.
enum class Condition {
  interrupted,
  diverged,
  misfit,
  breaks_energy,
  not_identifiable,
  exact,
  roughly,
  scatter_unknown,
  interpolated,
  describes,
  // Beside the headline.
  determined,
  at_bound,
  breaks_energy_elsewhere,
  interpolates,
  few_lights,
  hidden_highlight,
  few_rows_decide,
  weakly_determined,
  approximate
};

}  // namespace brdf::fit

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 19> kNames<fit::Condition>{"interrupted",
                                                                         "diverged",
                                                                         "misfit",
                                                                         "breaks_energy",
                                                                         "not_identifiable",
                                                                         "exact",
                                                                         "roughly",
                                                                         "scatter_unknown",
                                                                         "interpolated",
                                                                         "describes",
                                                                         "determined",
                                                                         "at_bound",
                                                                         "breaks_energy_elsewhere",
                                                                         "interpolates",
                                                                         "few_lights",
                                                                         "hidden_highlight",
                                                                         "few_rows_decide",
                                                                         "weakly_determined",
                                                                         "approximate"};

}  // namespace brdf

namespace brdf::fit {

struct State {
  Condition condition;
  io::Mark mark;
  bool usable;  // exit code 0
};

// Every condition's mark and exit code.
const State& state_of(Condition condition);
// Those that hold, the headline's first.
std::vector<Condition> conditions_of(const FormFit& fit);

// The worst mark of the conditions that hold.
io::Mark mark_of(const FormFit& fit);
// A form in a ranking: unknown (grey) where it predicts ten times worse than the first.
io::Mark mark_in_ranking(const FormFit& fit, const FormFit& first);
// How the fit stands, in one sentence.
std::string verdict_sentence(const FormFit& fit);
// What a condition beside the headline says; empty for the others, and where a finding says it already.
std::string sentence_of(Condition condition, const FormFit& fit);

}  // namespace brdf::fit
