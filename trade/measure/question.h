// A question: one quantity, its exact evaluation, the alternatives, and the domain of the comparison.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "trade/ledger/ledger.h"
#include "trade/measure/domain.h"
#include "trade/measure/timing.h"

namespace brdf::trade {

enum class Precision { single_, double_ };

// One method of evaluating the quantity.
struct Choice {
  std::string name;
  Kernel kernel;
  std::string note = {};
  // f_r at (wi, wo) with this choice inside a whole material, for the picture. Empty if there is no picture.
  Kernel picture = {};
  // Cost is measured in float, as in shaders. The error is measured in double, to obtain the error of the
  // formula. If the rounding of a choice is the subject of the question, its error is measured in the
  // precision of its cost.
  Precision cost = Precision::single_;
  Precision error = Precision::double_;
  // If not empty, this kernel is judged instead of the kernel that is timed: for example, a factor is judged
  // by the integral that it changes.
  Kernel judged = {};
};

struct Question {
  std::string name;
  std::string quantity;  // quantity to which the error refers
  Measure measure = Measure::absolute;
  Domain everyday;
  std::vector<Domain> extremes;
  std::vector<Choice> choices;  // the first is the exact one
  Kernel reference = {};        // a reference with more digits, if the exact choice itself is rounded
  double floor = 0;             // relative errors are not counted if |exact| is below this value
  Unit unit = Unit::evaluation;
  Domain timed = {};                // domain of the cost measurement, if not the everyday domain
  std::size_t points = 0;           // for expensive kernels: fewer points than the default
  std::size_t timed_points = 1024;  // fits in the second-level cache
  std::size_t pixels = 0;           // pixels of the picture, evenly spread; 0: all
};

// Directions of the lit pixels of a picture, one DirectionRow per pixel and light. The weight is the light's
// irradiance. Choices return f_r; image_error() multiplies by the weight and by cos_i.
struct PicturePoints {
  Columns<double> columns;
  std::vector<double> weight;
  std::vector<std::size_t> pixel;  // ascending
  std::size_t count() const { return weight.size(); }
};

struct MeasureOptions {
  std::size_t points = 16384;
  int rounds = 31;
  const PicturePoints* picture = nullptr;
};

// The value that replaces infinite or undefined values, since a ledger holds only finite numbers.
inline constexpr double kNotFinite = 1e30;

// Returns the largest, mean and 99th percentile of the distance between the values and the reference.
Error error_of(std::span<const double> values, std::span<const double> reference, Measure measure,
               double floor, const Domain& domain, const Points& points);

// Returns the sum over pixels of |L - L_exact|, divided by the sum of L_exact. L is the sum over lights of
// weight f_r cos_i.
double image_error(std::span<const double> f, std::span<const double> exact, const PicturePoints& picture);

// Computes the values to be judged, at the rows of the columns.
using Values = std::function<std::vector<double>(const Columns<double>&)>;

// Domains and measure of errors.
struct ErrorDomains {
  Domain everyday;
  std::vector<Domain> extremes;
  std::size_t points, extreme_points;
  Measure measure = Measure::relative;
  double floor = 0;
};

// The exact values by which choices are judged.
class Yardstick {
 public:
  // Without a picture, or without its exact values, there are no image errors.
  Yardstick(ErrorDomains domains, const Values& exact, const PicturePoints* picture,
            const Values& exact_picture);
  // Sets the row's errors and domains. If `values` is empty, judges the exact values themselves.
  void judge(LedgerRow& row, const Values& values, const Values& in_picture) const;
  const Points& points() const { return everyday_.points; }

 private:
  struct Place {
    Domain domain;
    Points points;
    std::vector<double> exact;
  };
  Place place(const Domain& domain, std::size_t count, const Values& exact) const;
  Error error(const Place& place, const Values& values) const;
  ErrorDomains domains_;
  Place everyday_;
  std::vector<Place> extremes_;
  const PicturePoints* picture_;
  std::vector<double> exact_picture_;
};

// Sets cost and cost ratio from the timing of a call that does `units` of the row's unit. The call must have
// been timed together with the other calls of the question.
void set_cost(LedgerRow& row, const timing::Timing& timing, double units);

// Returns at most about `count` of the picture's points, evenly spread.
PicturePoints thinned(const PicturePoints& picture, std::size_t count);

// Measures cost and errors of every choice of a question.
std::vector<LedgerRow> measure(const Question& question, const MeasureOptions& options);

}  // namespace brdf::trade
