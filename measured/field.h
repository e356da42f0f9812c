// Interpolates values at scattered places as one smooth field, and reports how well each place is known.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "measured/coordinates.h"

namespace brdf::measured {

struct Scattered {
  std::vector<Place> places;
  std::vector<double> count;                // number of values averaged at each place
  std::vector<std::vector<double>> values;  // [channel][place]
};

// The variation of the field: the Matern 5/2 correlation (1 + a + a^2/3) exp(-a), a = sqrt(5) d, with the
// distance d in units of the lengths.
struct Variation {
  Place lengths{1, 1, 1, 1};
  double noise = 0.01;    // variance of a value's noise over the variance of the field
  double likelihood = 0;  // log-likelihood, up to a constant
};

// Returns the indices of about `count` samples. Half of them are as far apart as possible; the other half is
// distributed as the samples are. The selection therefore contains short and long distances.
std::vector<std::size_t> spread_out(const std::vector<Place>& places, const Place& lengths,
                                    std::size_t count);

// Returns the lengths and the noise with the highest likelihood for these values. The mean of the field is
// 0 and its variance is estimated per channel (Rasmussen and Williams 2006, section 5.4.1, with the
// variance replaced by its maximum-likelihood value). No length exceeds `longest`; lengths that the values
// do not determine stay near `longest`. The standard deviation of the noise is at least `least_noise`. The
// time grows with the cube of the number of samples: 0.1 s for 200.
Variation learn_variation(const Scattered& samples, const Place& longest, double least_noise);

// The mean of the field given the samples nearest to a place, as sums of values by weights (kriging with a
// moving neighbourhood; Chiles and Delfiner 2012, section 3.6). The weights tend to 0 far from all samples.
class Field {
 public:
  static constexpr std::size_t kNeighbours = 32;
  struct Weights {
    std::array<std::uint32_t, kNeighbours> sample;
    std::array<double, kNeighbours> weight;
    std::size_t count = 0;
    // The share of the field's variance that noise-free samples at the nearest places would explain: 1 at a
    // sample, 0 far from all samples.
    double known = 0;
  };

  // `count`: the number of values averaged at each place.
  Field(const std::vector<Place>& places, std::vector<double> count, const Variation& variation);
  ~Field();
  // Returns the weights of the nearest samples. Returns no weights (count 0) if less than `least_known` is
  // known, which takes a fifth of the time.
  Weights weights_at(const Place& place, double least_known = 0) const;

 private:
  class Tree;
  Variation variation_;
  std::vector<double> count_;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace brdf::measured
