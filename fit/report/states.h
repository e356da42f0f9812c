// The state of a fit: one table that maps the findings to the mark, the exit code and the sentence that
// every interface shows.
#pragma once

#include <string>
#include <vector>

#include "fit/assess/result.h"
#include "io/page/html_report.h"

namespace brdf::fit {

// The conditions of a fit. Several can hold at once; the first one that holds is the headline.
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
  // In addition to the headline.
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

// The mark and the exit code of a condition.
struct State {
  Condition condition;
  io::Mark mark;
  bool usable;  // exit code 0
};

// Returns the mark and the exit code of a condition.
const State& state_of(Condition condition);
// Returns the conditions that hold, the headline first.
std::vector<Condition> conditions_of(const FormFit& fit);

// Returns the worst mark of the conditions that hold.
io::Mark mark_of(const FormFit& fit);
// Returns the mark of a form in a ranking: unknown (grey) if its predictions are ten times worse than the
// predictions of the first form.
io::Mark mark_in_ranking(const FormFit& fit, const FormFit& first);
// Returns the state of the fit in one sentence.
std::string verdict_sentence(const FormFit& fit);
// Returns the sentence of a condition in addition to the headline. Empty for other conditions, and if a
// finding already has the sentence.
std::string sentence_of(Condition condition, const FormFit& fit);

}  // namespace brdf::fit
