// The first screen of a page about a fit: the origin of the measurements, a tolerance set by the reader, the
// energy, and the next step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/assess/result.h"
#include "fit/model/options.h"
#include "io/page/html_report.h"
#include "io/samples/samples.h"

namespace brdf::fit {

// Returns the material, instrument, date and operator according to the header of the table (with an empty
// value for a fact that the header does not state), the channels, and the rows and angles of incidence.
std::vector<io::Fact> facts_of(const io::SampleTable& table);

// The relative errors of the fitted values, sampled at equal steps of probability.
struct ErrorQuantiles {
  static constexpr int kSteps = 200;
  // kSteps + 1 errors in rising order, from the smallest to the largest; the middle one is the median error
  // (fitted). Empty if no measurement is above 0.
  std::vector<double> errors;
};
// Computes the errors |fitted - measured|/measured of all fitted measurements above 0, in all channels.
ErrorQuantiles error_quantiles(const FormFit& fit, const io::SampleTable& table, const FitOptions& options);

// Parses a tolerance: "5%" or "0.05". Throws InputError unless it is above 0 and at most 100 %.
double tolerance_of(const std::string& text);
// Returns whether the median error (fitted) is at most the tolerance, a fraction. False if it is unknown.
bool is_within(const FormFit& fit, double tolerance);
// Returns the judgement in one sentence, which names the tolerance and the median error (fitted).
std::string tolerance_sentence(const FormFit& fit, double tolerance);

// Returns the facts about energy conservation: of the fitted material, and of the measurements if their own
// check is undecided and names no fault. Empty if nothing is known, or if a finding of the fit reports it.
std::vector<io::Remark> energy_remarks(const FitResult& result);

// Returns the measurement or fit that would help most; empty if nothing is in doubt.
std::string next_step(const FitResult& result);

// Adds the facts, the verdict with its remarks, the box with the tolerance, the energy, and the next step
// with the command that shows the result; an empty command is left out.
void add_first_screen(io::HtmlReport& report, const FitResult& result, const io::SampleTable& table,
                      const FitOptions& options, std::optional<double> tolerance,
                      const std::string& command = {});

}  // namespace brdf::fit
