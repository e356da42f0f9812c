#include "fit/report/states.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fit/assess/lack_of_fit.h"
#include "fit/assess/reported.h"
#include "fit/report/plain_words.h"
#include "fit/report/report.h"
#include "io/files/numbers.h"

namespace brdf::fit {
namespace {

using io::Mark;

constexpr std::array kStates{State{Condition::interrupted, Mark::bad, false},
                             State{Condition::diverged, Mark::bad, false},
                             State{Condition::misfit, Mark::bad, false},
                             State{Condition::breaks_energy, Mark::bad, false},
                             State{Condition::not_identifiable, Mark::bad, false},
                             State{Condition::exact, Mark::good, true},
                             State{Condition::roughly, Mark::warn, true},
                             State{Condition::scatter_unknown, Mark::unknown, true},
                             State{Condition::interpolated, Mark::unknown, true},
                             State{Condition::describes, Mark::good, true},
                             State{Condition::determined, Mark::warn, true},
                             State{Condition::at_bound, Mark::warn, true},
                             State{Condition::breaks_energy_elsewhere, Mark::warn, true},
                             State{Condition::interpolates, Mark::warn, true},
                             State{Condition::few_lights, Mark::warn, true},
                             State{Condition::hidden_highlight, Mark::warn, true},
                             State{Condition::few_rows_decide, Mark::warn, true},
                             State{Condition::weakly_determined, Mark::warn, true},
                             State{Condition::approximate, Mark::none, true}};
constexpr bool is_in_order() {
  for (std::size_t k = 0; k < kStates.size(); ++k)
    if (kStates[k].condition != Condition(k)) return false;
  return kStates.size() == kNames<Condition>.size();
}
static_assert(is_in_order());

constexpr double kFarWorse = 10;  // times the held-out error of the first form
constexpr double kRoundingError = 1e-11;

std::string share_of(double error) {
  return error < kRoundingError ? "1e-9 %" : io::percent(error, 2);
}

// Returns whether the residuals are noise only if all that differs between symmetric rows is noise.
bool exceeds_least(const FormFit& f) {
  const double residual = f.lack_of_fit.residual_over_scatter.value_or(0) * f.about.scatter.value_or(0);
  return residual > kBeyond * f.about.least_scatter.value_or(0);
}

Condition headline_of(const FormFit& f) {
  switch (f.verdict) {
    case Verdict::interrupted:
      return Condition::interrupted;
    case Verdict::diverged:
      return Condition::diverged;
    case Verdict::misfit:
      return Condition::misfit;
    case Verdict::breaks_energy:
      return Condition::breaks_energy;
    case Verdict::not_identifiable:
      return Condition::not_identifiable;
    default:
      break;
  }
  if (f.lack_of_fit.exact) return Condition::exact;
  if (f.lack_of_fit.beyond_scatter) return Condition::roughly;
  if (!f.lack_of_fit.judged() || exceeds_least(f)) return Condition::scatter_unknown;
  return f.about.interpolated ? Condition::interpolated : Condition::describes;
}

// Returns "2.0 times what they scatter", or a phrase for a deviation in some directions only.
std::string beyond_in_words(const FormFit& f) {
  const double times = f.lack_of_fit.residual_over_scatter.value_or(kUnknown);
  return times > 1.3 ? times_text(times) + " times the measurement noise"
                     : std::string("larger than the measurement noise in some directions");
}

std::string scatter_in_words(const FormFit& f) {
  return f.about.scatter ? " (" + io::percent(*f.about.scatter, 2) + ")" : "";
}

std::string degrees_of_width(double alpha) {
  // The full width at half of the peak, as the viewer turns.
  return io::short_number(4 * radians(std::atan(alpha * std::sqrt(std::log(2.0)))).degrees(), 2);
}

}  // namespace

const State& state_of(Condition condition) {
  return kStates[std::size_t(condition)];
}

std::vector<Condition> conditions_of(const FormFit& f) {
  std::vector<Condition> out{headline_of(f)};
  const auto add = [&](bool holds, Condition condition) {
    if (holds) out.push_back(condition);
  };
  if (!f.solved()) return out;
  const auto has = [&](Status s) {
    return std::ranges::any_of(f.estimates, [&](const Estimate& e) { return e.status == s; });
  };
  add(f.verdict == Verdict::determined, Condition::determined);
  add(has(Status::at_bound) || f.verdict == Verdict::at_bound, Condition::at_bound);
  add(f.verdict != Verdict::breaks_energy && f.largest_albedo && f.largest_albedo->breaks_energy() &&
          !f.has_free_scale,
      Condition::breaks_energy_elsewhere);
  add(f.left_out && f.about.held_out == HeldOut::interpolation, Condition::interpolates);
  add(f.left_out && f.about.held_out == HeldOut::few, Condition::few_lights);
  add(f.about.hidden_width.has_value(), Condition::hidden_highlight);
  add(!f.few_rows_decide.empty(), Condition::few_rows_decide);
  add(!weakly_determined(f).empty(), Condition::weakly_determined);
  add(f.intervals == IntervalsBy::curvature, Condition::approximate);
  return out;
}

io::Mark mark_of(const FormFit& f) {
  Mark worst = f.findings.empty() ? Mark::good : Mark::warn;
  for (const Condition condition : conditions_of(f)) worst = std::max(worst, state_of(condition).mark);
  return worst;
}

io::Mark mark_in_ranking(const FormFit& f, const FormFit& first) {
  const Mark own = state_of(conditions_of(f).front()).mark;
  if (!usable(f.verdict)) return own;
  const auto error = [](const FormFit& form) {
    return form.left_out ? form.left_out->errors.median : form.median_relative_error;
  };
  return error(f) > kFarWorse * std::max(error(first), kRoundingError) ? Mark::unknown : own;
}

std::string verdict_sentence(const FormFit& f) {
  const std::string error = share_of(f.median_relative_error);
  const std::string typical = ": median error (fitted) " + error;
  std::string how;
  switch (headline_of(f)) {
    case Condition::interrupted:
      return "Interrupted: the best parameters of " + f.form + " so far.";
    case Condition::diverged:
      return f.form + " could not be fitted.";
    case Condition::misfit:
      return f.form + " does not fit the measurements" + typical + ".";
    case Condition::breaks_energy: {
      const LargestAlbedo& a = f.largest_measured_albedo.value();
      return f.form + " violates energy conservation: its directional albedo is " +
             io::percent_to_tenths(a.value) + " at " + io::short_number(a.theta) + " degrees.";
    }
    case Condition::not_identifiable:
      return f.form + " is not identifiable from these measurements.";
    case Condition::exact:
      how = f.form + " fits the measurements to rounding: median error (fitted) at most " + error;
      break;
    case Condition::roughly:
      how = f.form + " fits the measurements only roughly" + typical + "; the residuals are " +
            beyond_in_words(f);
      break;
    case Condition::scatter_unknown:
      how = f.form + " has a median error (fitted) of " + error + "; lack of fit cannot be judged, because " +
            (f.lack_of_fit.judged() ? "symmetric rows differ" + scatter_in_words(f) +
                                          ", by noise or because the sample is not isotropic"
                                    : std::string("the measurement noise is not known"));
      break;
    case Condition::interpolated:
      how = f.form + " has a median error (fitted) of " + error +
            "; lack of fit cannot be judged, because the noise" + scatter_in_words(f) +
            " was estimated on an interpolated grid";
      break;
    default:
      how = f.form + " fits the measurements" + typical + ", consistent with the measurement noise" +
            scatter_in_words(f);
  }
  if (f.verdict == Verdict::at_bound) return how + "; a parameter is at a bound of its range.";
  if (f.verdict == Verdict::determined)
    return how +
           ". The reflectance is well determined at the measured directions only; some parameters are not "
           "identifiable.";
  return how + ".";
}

std::string sentence_of(Condition condition, const FormFit& f) {
  switch (condition) {
    case Condition::breaks_energy_elsewhere: {
      const LargestAlbedo& a = f.largest_albedo.value();
      return "at " + io::short_number(a.theta) +
             " degrees, without measurements nearby, the directional albedo would be " +
             io::percent_to_tenths(a.value) + " (" + a.channel + ")";
    }
    case Condition::interpolates:
      return "all held-out measurements lie between others of the same fixed direction: the held-out error "
             "describes interpolation only, not the prediction of other incidences";
    case Condition::few_lights:
      return "the held-out error and lack of fit rest on only " + std::to_string(f.about.lights) + " " +
             f.about.side;
    case Condition::hidden_highlight:
      return "a highlight narrower than alpha " + io::short_number(*f.about.hidden_width, 2) + " (" +
             degrees_of_width(*f.about.hidden_width) +
             " degrees wide) would lie between the measured directions";
    case Condition::few_rows_decide:
      return f.few_rows_decide;
    case Condition::approximate:
      return "the intervals are approximate: they are derived from the curvature at the minimum";
    default:
      return "";
  }
}

}  // namespace brdf::fit
