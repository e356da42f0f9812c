// The comparisons of single draws: values and densities that belong to the same direction, and ranges.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validate/joint/jacobian.h"
#include "validate/joint/trio.h"

namespace brdf::validate {

// A comparison of many draws: how many were compared, how many differ, and the worst one. A difference that
// the rounding of the direction explains does not count as one, but is kept for the sentence.
struct ComparedDraws {
  long compared = 0, differing = 0, explained = 0;
  double worst = 0, worst_explained = 0;
  Vec3<double> wi{};
  std::vector<double> u = {};

  double share() const { return compared > 0 ? double(differing) / double(compared) : 0; }
  void add(double difference, double bound, const Vec3<double>& at, std::span<const double> numbers);
  void add_explained(double difference);
};

// The quantity of each value that the sampler returns. `announced`: the sentence on a quantity that no name
// and no line of the file states.
struct Quantities {
  std::vector<SampleValue> of = {};
  std::string announced = {};
};
// Chooses between the quantity that eval returns and the weight f cos/pdf, by which one more draws have.
Quantities quantities_of(const Trio& trio, std::uint64_t seed);

struct Pointwise {
  ComparedDraws density;             // returned against density()
  std::vector<DensityRow> returned;  // of differing ones: density() as claimed, the returned one as truth
  ComparedDraws value;
  std::map<SampleValue, long> fits;  // draws at which the first value has this quantity
  long without_cosine = 0;           // draws at which the first value is its quantity divided by cos_i
  ComparedDraws not_finite, length, below;
  ComparedDraws impossible;  // draws at directions with density() 0
  long lost_below = 0;       // draws below the horizon that have no density, or no value
  long examined = 0;         // differences for which rounding was examined
};
// Compares draws of a block and adds them to `out`.
void compare_draws(const Trio& trio, const Quantities& quantities, std::span<const double> u,
                   std::span<const Draw> draws, Pointwise& out);

// Draws with 0, 1/2, 1 - 2^-24 and 1 in every combination of random numbers, in double and float. Returns the
// faults by kind of random number.
struct Edges {
  std::string fault = {};  // empty: no fault
  bool only_at_one = false;
  std::vector<double> u = {};
  int combinations = 0;
};
Edges edges_of(const Trio& trio);

// Compares float with double at the same random numbers. `branches`: draws that take another branch in float.
struct SingleCompared {
  ComparedDraws difference;
  long branches = 0, not_finite = 0;
};
SingleCompared single_of(const Trio& trio, std::size_t count, std::uint64_t seed);

// Relative difference from which two values of the same quantity count as different.
inline constexpr double kSameValue = 1e-5;
// Share of draws that differ between float and double from which sample_float fails; its sentence states how
// many differ.
inline constexpr double kFewDraws = 1e-3;

}  // namespace brdf::validate
