// Materials at one channel's parameters, and the albedo of all their terms together.
#pragma once

#include <span>
#include <vector>

#include "brdf/material.h"
#include "prove/scalar/energy.h"

namespace brdf::prove {

struct Channel {
  const Term& term;
  std::size_t index;

  std::span<const double> shape() const { return term.shape_of(index); }
  std::span<const double> weights() const { return term.weights[index]; }
};
// A material's terms.
using Channels = std::vector<Channel>;

// False of other programs' models.
bool is_of_catalogue(const Channel& c);

// The directional albedo of all terms, enclosed over views. A view has one turn for every pair of widths by which its tangents
// are stretched; these are of the narrowest facets.
class SumOfAlbedos {
 public:
  explicit SumOfAlbedos(const Channels& terms);
  // False where some term's albedo is not known.
  bool known() const { return known_; }
  // Whether it depends on the view's azimuth.
  bool turns() const { return turns_; }
  AlbedoBounds operator()(const Views& views, double accuracy) const;

 private:
  struct Part {
    const EnergyMethod* method;
    std::vector<Bounds> shape, weights;
    std::array<double, 2> stretch{1, 1};  // beyond the narrowest
  };
  std::vector<Part> parts_;
  bool known_ = true, turns_ = false;
};

}  // namespace brdf::prove
