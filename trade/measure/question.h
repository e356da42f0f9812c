// A question: one quantity, its exact evaluation, the alternatives, and the domain they are compared on.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "trade/ledger/ledger.h"
#include "trade/measure/domain.h"
#include "trade/measure/timing.h"

namespace brdf::trade {

enum class Precision { single_, double_ };

struct Choice {
  std::string name;
  Kernel kernel;
  std::string note = {};
  // f_r at (wi, wo) with this choice inside a whole material, for the picture; empty where there is none.
  Kernel picture = {};
  // Cost is measured in float, as shaders compute; error in double, so that it is the formula's. A choice
  // whose rounding is the question is judged in the precision it costs.
  Precision cost = Precision::single_;
  Precision error = Precision::double_;
  // Judged by another kernel than the one whose cost counts: a factor by the integral it changes.
  Kernel judged = {};
};

struct Question {
  std::string name;
  std::string quantity;  // what the error is of
  Measure measure = Measure::absolute;
  Domain everyday;
  std::vector<Domain> extremes;
  std::vector<Choice> choices;  // the first is the exact one
  Kernel reference = {};        // where the exact choice is itself rounded: more digits
  double floor = 0;             // of |exact|, below which a relative error is not counted
  Unit unit = Unit::evaluation;
  Domain timed = {};                // where costs are measured, if not in the everyday domain
  std::size_t points = 0;           // where kernels are dear: fewer than the default
  std::size_t timed_points = 1024;  // stays in the second-level cache
  std::size_t pixels = 0;           // of the picture, evenly spread; 0: all
};

// Directions of the lit pixels of a picture, one DirectionRow per pixel and light, with irradiance times
// cosine left to the choice: weight is the light's irradiance.
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

// What an infinite or undefined value counts as: a ledger holds finite numbers.
inline constexpr double kNotFinite = 1e30;

// Largest, mean and 99th percentile of the values' distance to the reference's.
Error error_of(std::span<const double> values, std::span<const double> reference, Measure measure,
               double floor, const Domain& domain, const Points& points);

// sum over pixels of |L - L_exact| / sum of L_exact, L = sum over lights of weight f_r cos_i.
double image_error(std::span<const double> f, std::span<const double> exact, const PicturePoints& picture);

// What errors are of, at the rows of columns.
using Values = std::function<std::vector<double>(const Columns<double>&)>;

// Where and how errors are measured.
struct ErrorDomains {
  Domain everyday;
  std::vector<Domain> extremes;
  std::size_t points, extreme_points;
  Measure measure = Measure::relative;
  double floor = 0;
};

// The exact values that choices are judged by.
class Yardstick {
 public:
  // Without a picture, or what is exact in it, there are no image errors.
  Yardstick(ErrorDomains domains, const Values& exact, const PicturePoints* picture,
            const Values& exact_picture);
  // Sets the row's errors and domains. Without values: those of the exact values themselves.
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

// Cost and cost ratio of a call that does `units` of the row's unit, timed among the row's question.
void set_cost(LedgerRow& row, const timing::Timing& timing, double units);

// At most about `count` of the picture's points, evenly spread.
PicturePoints thinned(const PicturePoints& picture, std::size_t count);

std::vector<LedgerRow> measure(const Question& question, const MeasureOptions& options);

}  // namespace brdf::trade
