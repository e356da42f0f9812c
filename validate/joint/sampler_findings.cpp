// The outcomes and the sentences of all checks of a sampler.
#include "validate/joint/sampler_judge.h"

#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "validate/joint/statistics.h"

namespace brdf::validate {

void SamplerJudge::conclude_one(Place place, bool looked, const std::string& why_not,
                                const std::string& if_good) {
  Finding& f = findings_[place];
  if (worst_[place].severity >= 0) {
    f.outcome = Outcome::fail;
    f.statement = worst_[place].text;
    f.witness = worst_[place].witness;
    return;
  }
  f.outcome = looked ? Outcome::pass : Outcome::undecided;
  f.statement = looked ? if_good : why_not;
}

std::string SamplerJudge::with_reasons(std::string text) const {
  for (const std::string& why : facts_.missing) text += "; " + why;
  return text;
}

void SamplerJudge::conclude() {
  const std::string cases = std::to_string(cases_.size()) + " cases";
  const std::string no_density = with_reasons(facts_.no_density),
                    no_sampler = with_reasons(facts_.no_sampler);
  const std::string at_level = ", level " + io::short_number(level_, 2) + " each";
  findings_[mass].bound = kMassBound;
  conclude_one(mass, facts_.has_density && mass_unknown_.empty() && done_[mass] > 0,
               mass_unknown_.empty() ? no_density : mass_unknown_, mass_text());
  findings_[match].bound = kSameValue;
  conclude_one(match, compared_[match] > 0,
               !facts_.draws         ? no_sampler
               : !facts_.has_density ? no_density
               : !facts_.gives_pdf   ? facts_.sampler_name + " returns no density to compare"
                                     : "no sample could be compared",
               "the density that " + facts_.sampler_name + " returns equals " + facts_.density_name + " at " +
                   std::to_string(compared_[match]) + " samples" + exceptions_text(match));
  findings_[value].bound = kSameValue;
  conclude_one(value, compared_[value] > 0,
               !facts_.draws           ? no_sampler
               : facts_.values.empty() ? facts_.sampler_name + " returns no value to compare"
               : !facts_.has_eval      ? facts_.no_eval
                                       : "no value could be compared: its quantity needs a density",
               values_text());
  const bool jacobian_looked = decided_ >= 16 && decided_ * 3 >= probes_;
  findings_[jacobian].bound = kJacobianBound;
  conclude_one(jacobian, jacobian_looked,
               !facts_.draws ? no_sampler
               : !has_pdf()
                   ? no_density
                   : "only " + std::to_string(decided_) + " of " + std::to_string(probes_) +
                         " directions could be judged" + (jacobian_why_.empty() ? "" : ": " + jacobian_why_),
               jacobian_text());
  findings_[distribution].bound = -std::log10(level_);
  conclude_one(distribution, done_[distribution] == long(cases_.size()),
               !facts_.draws         ? no_sampler
               : !facts_.has_density ? no_density
               : distribution_why_.empty()
                   ? "only " + std::to_string(done_[distribution]) + " of " + cases + " were examined"
                   : distribution_why_,
               "the samples follow the density in " + cases + " of " + std::to_string(draws()) + " samples" +
                   at_level + "; an error of " + io::percent(power_[distribution], 2) +
                   " in a quarter of the samples would be found");
  findings_[mean].bound = two_sided_quantile(level_);
  conclude_one(mean, done_[mean] > 0 && mean_why_.empty(), facts_.draws ? mean_why_ : no_sampler,
               "the mean of the weights is the albedo in " + cases + at_level + "; a constant error of " +
                   io::percent(power_[mean], 2) + " would be found" + noise_text());
  findings_[support].bound = kLostAlbedo;
  conclude_one(support, done_[support] > 0 && support_unknown_.empty(),
               !facts_.has_density        ? no_density
               : support_unknown_.empty() ? facts_.no_eval
                                          : support_unknown_,
               support_text());
  conclude_one(range, compared_[range] > 0,
               facts_.draws ? std::string("no sample above the horizon was drawn") : no_sampler,
               range_text());
  findings_[single].bound = kFewDraws;
  conclude_one(single, compared_[single] > 0,
               !facts_.draws      ? no_sampler
               : !facts_.in_float ? facts_.sampler_name + " is available in double precision only"
                                  : "no sample above the horizon was drawn",
               single_text());
  if (!facts_.half_unknown.empty() && findings_[single].outcome == Outcome::pass) {
    findings_[single].outcome = Outcome::undecided;
    findings_[single].statement += "; " + facts_.half_unknown;
  }
  if (worst_[mean].severity >= 0 && std::isfinite(worst_[mean].severity) && noise_ > 0)
    findings_[mean].statement += noise_text();
  if (too_many_)
    for (const Place place : {mass, jacobian, distribution, mean})
      if (findings_[place].outcome != Outcome::fail) {
        findings_[place].outcome = Outcome::undecided;
        findings_[place].statement = facts_.sampler_name + " uses more random numbers than are provided (" +
                                     std::to_string(facts_.randoms) + ")";
      }
}

std::string SamplerJudge::exceptions_text(Place place) const {
  if (exceptions_[place] == 0) return "";
  return ", but for " + std::to_string(exceptions_[place]) + " that differ by up to " +
         io::percent(largest_exception_[place]) + ", as much as rounding of the direction changes the value";
}

std::string SamplerJudge::mass_text() const {
  std::string text = (facts_.draws ? "the integral of the density is 1 minus the share of lost samples, in "
                                   : "the density integrates to 1 in ") +
                     std::to_string(cases_.size()) + " cases, by quadrature with an estimated error of " +
                     io::short_number(largest_mass_error_, 2) + " at " +
                     std::to_string(findings_[mass].evaluations) + " directions";
  if (facts_.draws) text += "; a difference of " + io::percent(power_[mass], 2) + " would be found";
  return text;
}

std::string SamplerJudge::support_text() const {
  const std::string dark =
      dark_ == 0 ? "all " + std::to_string(supported_) + " directions"
                 : "all but " + std::to_string(dark_) + " of " + std::to_string(supported_) + " directions";
  return "the density is above 0 at " + dark +
         " with f cos_i above 0, which are spread by the cosine; a hole of " +
         io::percent(least_hole(kFalseAlarm), 2) + " of the projected hemisphere would be found" +
         (findings_[support].value > 0
              ? "; about " + io::percent(findings_[support].value, 2) + " of the albedo has a density of 0"
              : "");
}

std::string SamplerJudge::range_text() const {
  std::string text = "directions have unit length and lie above the horizon, at " +
                     std::to_string(compared_[range]) + " samples and " + std::to_string(combinations_) +
                     " combinations of the random numbers 0, 1/2, 1 - 2^-24 and 1";
  if (exceptions_[range] > 0)
    text += ", but for " + std::to_string(exceptions_[range]) + " with a cosine down to -" +
            io::short_number(largest_exception_[range], 2) + ", which is rounding";
  if (lost_below_ > 0)
    text += "; " + std::to_string(lost_below_) + " samples below the horizon count as lost";
  return text;
}

std::string SamplerJudge::jacobian_text() const {
  std::string text = "the density equals the density of the samples at " +
                     std::to_string(decided_ - exceptions_[jacobian]) + " of " + std::to_string(probes_) +
                     " directions, to " + io::short_number(std::max(largest_ratio_error_, 1e-8), 2);
  if (exceptions_[jacobian] > 0)
    text += ", but differs by up to " + io::percent(largest_exception_[jacobian]) + " at " +
            std::to_string(exceptions_[jacobian]) +
            ", to which other random numbers may lead that were not found";
  return text + "; an error above " + io::percent(kJacobianBound) +
         " at a twentieth of these directions would be found";
}

std::string SamplerJudge::single_text() const {
  std::string text = "float and double agree within 1 % at " +
                     std::to_string(compared_[single] - branches_ - exceptions_[single]) + " of " +
                     std::to_string(compared_[single]) + " samples; ";
  if (exceptions_[single] > 0)
    text += std::to_string(exceptions_[single]) + " differ by up to " +
            io::percent(largest_exception_[single]) + "; ";
  return text + std::to_string(branches_) + " next to a boundary took another branch";
}

std::string SamplerJudge::values_text() const {
  std::string text;
  for (std::size_t k = 0; k < quantities_.of.size(); ++k)  // empty without a sampler
    text += (k ? " and " : "") +
            (facts_.values[k].name.empty() ? "the returned value" : facts_.values[k].name) + " is " +
            std::string(name_of(quantities_.of[k]));
  return text + " at " + std::to_string(compared_[value]) + " comparisons" + exceptions_text(value) +
         (quantities_.announced.empty() ? "" : "; " + quantities_.announced);
}

std::string SamplerJudge::noise_text() const {
  if (!(noise_ > 0)) return "";
  const auto samples = [](double noise) { return io::short_number(std::ceil(noise * noise * 1e4), 3); };
  const std::string beside =
      best_.form.empty()
          ? "; no sampler of the catalogue is comparable, because no parameter has the role of a "
            "width or an exponent"
          : " (" + samples(best_.noise) + " with the sampler of " + best_.form + ")";
  return "; the noise of one sample is up to " + io::percent(noise_, 2) + ", so that a noise of 1 % needs " +
         samples(noise_) + " samples per pixel" + beside + "; largest weight " +
         io::short_number(largest_weight_, 3) + " times the mean";
}

}  // namespace brdf::validate
