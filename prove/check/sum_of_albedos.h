// The albedo of all terms of a material together, at the parameters of one channel.
#pragma once

#include <array>
#include <vector>

#include "prove/check/channel.h"
#include "prove/energy/energy.h"

namespace brdf::prove {

// The directional albedo of all terms, enclosed over views. A view has one turn for every pair of
// roughnesses by which its tangents are stretched; the turns here refer to the narrowest facets.
class SumOfAlbedos {
 public:
  explicit SumOfAlbedos(const Channels& terms);
  // Returns false if the albedo of some term is unknown, or if two terms with unequal roughnesses have
  // different tangents.
  bool known() const { return known_; }
  // Returns whether the albedo depends on the view's azimuth.
  bool turns() const { return turns_; }
  // Encloses the albedo over these views. accuracy: of the cells.
  AlbedoBounds operator()(const Views& views, double accuracy) const;
  // Returns the domain of all views: turn_from_normal and, if turns() is true, turn_from_first_axis.
  Domain domain() const;
  // Returns the views of a box of domain().
  static Views views_of(std::span<const Bounds> box);
  // Returns bounds with finite ends, which a certificate can hold.
  static Bounds within_range(Bounds b);
  // The accuracies that can be requested of the cells, from coarse to fine.
  static constexpr std::array<double, 4> kAccuracies{8e-3, 2e-3, 5e-4, 1.25e-4};

 private:
  struct Part {
    const EnergyMethod* method;
    std::vector<Bounds> shape, weights;
    std::array<double, 2> stretch{1, 1};  // relative to the narrowest
  };
  std::vector<Part> parts_;
  bool known_ = true, turns_ = false;
};

}  // namespace brdf::prove
