// What a fit says: JSON, and a table for people.
#pragma once

#include <iosfwd>

#include "fit/assess/result.h"
#include "fit/model/options.h"
#include "io/files/json.h"
#include "io/samples/samples.h"

namespace brdf::fit {

// "7.4", "110": without a power of ten.
std::string times_text(double factor);

// "residual 7.4 times the scatter; worst at theta_h 0 to 2, ...".
std::string in_words(const LackOfFit& lack);

// "also off at theta_h 0 to 2, ... (31 rows, 12 % of what was minimised): 0.91 times; ..."; empty where
// nothing else is.
std::string others_in_words(const LackOfFit& lack);

// "alpha over wavelength: ln(alpha) = (-1.6 +- 0.02) + (0.1 +- 0.01) x, x = 1000 nm/wavelength".
std::string in_words(const SmoothCurve& curve);

// "a second lobe: ward+ward, left out 2.1e-05, lower by 1.3e-05 +- 2.1e-06 (p 0.0002, best of 2): kept".
std::string in_words(const Step& step);

// "recommended: ward, which is simpler and no worse on the rows left out"; empty where that is the first
// form.
std::string recommendation(const FitResult& result);

// What the values scatter by, of each channel where they differ, or that it is not known.
std::string scatter_text(const FitResult& result);
// What the data sheet of the samples says against them, a clause each, worst first; empty where it has
// nothing to say.
std::vector<std::string> sheet_in_words(const FitResult& result);

// The shape of `brdf fit --json`.
io::Json to_json(const FitResult& result, const io::SampleTable& table, const FitOptions& options);
// The `fit` block of a material file: provenance and statistics of this one fit.
io::Json material_block(const FormFit& fit, const FitResult& result, const io::SampleTable& table,
                        const FitOptions& options);
// How text is laid out: `columns` characters in a line (0: as many as it needs), with a terminal's colours or
// without.
struct TextStyle {
  int columns = 0;
  bool colours = false;
};
// Ranking, and the parameters of the form at the top.
void print(std::ostream& out, const FitResult& result, const io::SampleTable& table,
           const FitOptions& options, const TextStyle& style = {});

}  // namespace brdf::fit
