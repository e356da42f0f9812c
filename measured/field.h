// Values scattered over places as one smooth field, with what is known of it where.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "measured/coordinates.h"

namespace brdf::measured {

struct Scattered {
  std::vector<Place> places;
  std::vector<double> count;                // how many values a place's mean is of
  std::vector<std::vector<double>> values;  // [channel][place]
};

// How the field varies: the Matern 5/2 correlation (1 + a + a^2/3) exp(-a), a = sqrt(5) d, of the distance d
// over the lengths.
struct Variation {
  Place lengths{1, 1, 1, 1};
  double noise = 0.01;    // variance of a value's noise over the field's own
  double likelihood = 0;  // its logarithm, up to a constant
};

// `count` samples, half of them as far apart as can be, half wherever the samples are: short distances and
// long ones.
std::vector<std::size_t> spread_out(const std::vector<Place>& places, const Place& lengths,
                                    std::size_t count);

// The lengths and the noise under which these values are likeliest, the field's mean being 0 and its variance
// each channel's own (Rasmussen and Williams 2006, section 5.4.1, the variance replaced by its likeliest
// value); no length beyond `longest`, and near it where the values do not tell; noise of at least the
// standard deviation `least_noise`. The time grows with the cube of their number: 0.1 s for 200.
Variation learn_variation(const Scattered& samples, const Place& longest, double least_noise);

// The field's mean given the samples nearest to a place (kriging with a moving neighbourhood; Chiles and
// Delfiner 2012, section 3.6): sums of values by weights. Where no sample is near the weights go to 0.
class Field {
 public:
  static constexpr std::size_t kNeighbours = 32;
  struct Weights {
    std::array<std::uint32_t, kNeighbours> sample;
    std::array<double, kNeighbours> weight;
    std::size_t count = 0;
    // The share of the field's variance that samples without noise, at the nearest places, would leave known:
    // 1 at a sample, 0 far from all.
    double known = 0;
  };

  // `count`: how many values each place's is the mean of.
  Field(const std::vector<Place>& places, std::vector<double> count, const Variation& variation);
  ~Field();
  // No weights (count 0) where less than `least_known` is known, which takes a fifth of the time.
  Weights weights_at(const Place& place, double least_known = 0) const;

 private:
  class Tree;
  Variation variation_;
  std::vector<double> count_;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace brdf::measured
