// The albedo of all terms of a material together, at one channel's parameters.
#pragma once

#include <array>
#include <vector>

#include "prove/check/channel.h"
#include "prove/energy/energy.h"

namespace brdf::prove {

// The directional albedo of all terms, enclosed over views. A view has one turn for every pair of widths by
// which its tangents are stretched; these are of the narrowest facets.
class SumOfAlbedos {
 public:
  explicit SumOfAlbedos(const Channels& terms);
  // False where some term's albedo is not known, and where terms turn about tangents of their own.
  bool known() const { return known_; }
  // Whether it depends on the view's azimuth.
  bool turns() const { return turns_; }
  AlbedoBounds operator()(const Views& views, double accuracy) const;
  // Over all views: turn_from_normal and, where it turns, turn_from_first_axis.
  Domain domain() const;
  static Views views_of(std::span<const Bounds> box);
  // As a certificate can hold them: no end is infinite.
  static Bounds within_range(Bounds b);
  // How exact cells may be asked to be, from coarse to fine.
  static constexpr std::array<double, 4> kAccuracies{8e-3, 2e-3, 5e-4, 1.25e-4};

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
