// Which directions an instrument should measure next.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "brdf/names.h"
#include "fit/design/expected.h"
#include "fit/fit.h"
#include "fit/samples.h"

namespace brdf::fit {

// The purpose of the further rows.
enum class Aim {
  automatic,   // forms if the two best forms are within a standard error of each other, otherwise prediction
  prediction,  // the least expected error of the model over the hemisphere
  forms        // the two best forms are distinguished
};

}  // namespace brdf::fit

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 3> kNames<fit::Aim>{"auto", "prediction", "forms"};

}  // namespace brdf

namespace brdf::fit {

struct NextOptions {
  std::size_t rows = 16;
  Aim aim = Aim::automatic;
  std::optional<double> noise;  // relative standard deviation of a reading; std::nullopt: from the samples
  // Standard deviation of the error of the model, relative; std::nullopt: from the residuals.
  std::optional<double> model_error;

  static constexpr std::size_t kMostRows = 1000, kMostDirections = 20000;
  static constexpr double kLeastNoise = 1e-6;
};

struct NextRow {
  std::size_t row = 0;                                    // index in the table of directions
  double theta_i = 0, phi_i = 0, theta_o = 0, phi_o = 0;  // degrees, as in that table
  bool for_parameters = false;  // chosen to determine the parameters, with Aim::prediction
  // The share by which the row lowers the criterion of its choice: for parameters, the geometric mean of
  // their standard errors; for prediction, the root of the mean variance of ln f over the hemisphere if the
  // error of the form is interpolated between the rows. For forms: the expected rise of the logarithm of the
  // likelihood ratio.
  double gain = 0;
  double error = 0;  // the expected error of the form, refitted to the rows up to this one
  // For forms: ln of the first form over the second one, which is refitted in first order to the first one at
  // the rows up to this one; the largest by size over the channels.
  double difference = 0;
};

// What a number of rows is expected to reach: the relative error over the hemisphere, or the logarithm of the
// likelihood ratio of two forms. `random`: mean over as many rows at random.
struct NextForecast {
  std::size_t rows = 0;
  double chosen = 0, random = 0;
};

struct NextWidth {
  ExpectedWidth now, after;
  double random = 0;  // the error after as many rows at random, mean over the draws
  bool random_determined = true;
};

struct NextDirections {
  std::string form, rival;  // rival: of Aim::forms
  Aim aim = Aim::prediction;
  std::size_t measured = 0, parameters = 0;
  std::size_t reach = 0, already_measured = 0, beyond_max_theta = 0, dark = 0;  // numbers of directions
  bool reach_has_values = false;
  NoiseAndError known;
  std::vector<NextRow> rows;
  std::vector<NextWidth> widths;
  double error_now = 0;  // expected relative error over the hemisphere
  std::vector<NextForecast> errors, ratios;
  std::size_t draws = 0;
  std::uint64_t seed = 1;
  // For prediction: number of rows after which no number of further rows lowers the expected error of the
  // refitted form by kLeastGain for each of them; std::nullopt if the rows that were examined show no such
  // number.
  std::optional<std::size_t> worthwhile;
  // For forms: number of rows that are expected to make the likelihood ratio kDecisive; std::nullopt if this
  // number exceeds `examined`.
  std::optional<std::size_t> decisive;
  std::size_t examined = 0;

  // Returns whether every direction that can be chosen was examined.
  bool is_exhausted() const { return examined + already_measured + beyond_max_theta + dark >= reach; }
  std::vector<std::string> findings;  // about limits of the choice, one sentence each

  static constexpr double kLeastGain = 0.01, kDecisive = 1000;
};

// The models of a choice, and its options with the aim that the models imply.
struct NextModels {
  std::vector<std::vector<Reflectance>> models;  // empty for "auto"
  NextOptions next;
};
// Returns the models of models_of() (fit/choice.h). If the text is a list and no aim is given, the aim is to
// distinguish the forms. Throws InputError as models_of() does, and for an option out of range.
NextModels next_models(const std::string& forms, NextOptions next);

// Fits the models to the samples and chooses rows of `reach`, a table of directions, one after another; each
// choice counts on the earlier ones. Values of that table are not used. A direction is chosen once, and not
// at all if it was measured or lies beyond options.max_theta. The choice is deterministic; the rows at random
// are drawn with options.seed. If `models` is empty, a model is built step by step (fit/stepwise.h). Throws
// InputError if the samples are too few for the model, if nothing can be chosen, or if an option is not
// valid.
// Example:
//     // #include "brdf/io/formats/read.h"
//     const auto samples = brdf::fit::arranged(brdf::io::read_samples("in_plane.csv"), {});
//     const auto reach = brdf::io::read_directions("paint.csv");
//     const auto next = next_directions(samples, reach, {{*brdf::find_form("lambert")}}, {},
//                                       {.rows = 4, .noise = 0.01, .model_error = {}});
//     for (const brdf::fit::NextRow& row : next.rows)
//       std::printf("%g %g %g %g\n", row.theta_i, row.phi_i, row.theta_o, row.phi_o);
NextDirections next_directions(const Samples& samples, const io::SampleTable& reach,
                               std::vector<std::vector<Reflectance>> models, const FitOptions& options,
                               const NextOptions& next, const Progress& progress = {});

}  // namespace brdf::fit
