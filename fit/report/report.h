// Reports of a fit: JSON, and a table for the terminal.
#pragma once

#include <iosfwd>

#include "fit/assess/result.h"
#include "fit/model/options.h"
#include "io/files/json.h"
#include "io/samples/samples.h"

namespace brdf::fit {

// Returns "7.4" or "110": no power of ten.
std::string times_text(double factor);

// Returns "residual 7.4 times the scatter; worst at theta_h 0 to 2, ...".
std::string in_words(const LackOfFit& lack);

// Returns "also off at theta_h 0 to 2, ... (31 rows, 12 % of what was minimised): 0.91 times; ...". Empty
// if there are no other such cells.
std::string others_in_words(const LackOfFit& lack);

// Returns "alpha over wavelength: ln(alpha) = (-1.6 +- 0.02) + (0.1 +- 0.01) x, x = 1000 nm/wavelength".
std::string in_words(const SmoothCurve& curve);

// Returns "a second lobe: ward+ward, left out 2.1e-05, lower by 1.3e-05 +- 2.1e-06 (p 0.0002, best of 2):
// kept".
std::string in_words(const Step& step);

// Returns "recommended: ward, which is simpler and no worse on the rows left out". Empty if the first form
// is the recommended one.
std::string recommendation(const FitResult& result);

// Returns the noise of the values, for each channel if the channels differ, or a statement that it is
// unknown.
std::string scatter_text(const FitResult& result);
// Returns the defects of the samples according to their data sheet, one clause each, worst first. Empty if
// there are no defects.
std::vector<std::string> sheet_in_words(const FitResult& result);

// Returns the JSON of `brdf fit --json`.
io::Json to_json(const FitResult& result, const io::SampleTable& table, const FitOptions& options);
// Returns the `fit` block of a material file: provenance and statistics of this one fit.
io::Json material_block(const FormFit& fit, const FitResult& result, const io::SampleTable& table,
                        const FitOptions& options);
// The layout of text: `columns` characters per line (0: unlimited), with or without the colours of a
// terminal.
struct TextStyle {
  int columns = 0;
  bool colours = false;
};
// Prints the ranking and the parameters of the form at the top.
// Example:
//     // #include "brdf/fit/fit.h"
//     // #include "brdf/io/formats/read.h"
//     const brdf::io::SampleTable table = brdf::io::read_samples("matt.csv");
//     const auto result = brdf::fit::fit(table, {{*brdf::find_form("lambert")}}, {});
//     print(std::cout, result, table, {});
//     std::cout << to_json(result, table, {}).dump(2) << '\n';
void print(std::ostream& out, const FitResult& result, const io::SampleTable& table,
           const FitOptions& options, const TextStyle& style = {});

}  // namespace brdf::fit
