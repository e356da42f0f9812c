// One unknown of the solver.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/names.h"
#include "brdf/parameter.h"

namespace brdf::fit {

inline constexpr std::size_t kNoSlot = std::size_t(-1);
inline constexpr std::size_t kEveryGroup = std::size_t(-1);  // group of a slot that all channels share

// The smallest value at which a parameter on the square scale is evaluated. The scale divides the
// parameter's own derivative by the parameter; at this value the derivative is still exact.
inline constexpr double kSquareFloor = 1e-6;

enum class Scale { identity, log, log1p, square };

struct Slot {
  // linear: an unknown in which the weights of the lobes are linear. weight: a weight or f0 itself, or its
  // share of the remainder after the preceding weights. normal: a component of the surface's normal, in the
  // frame of the directions.
  enum class Kind { shape, tangent, normal, linear, weight } kind;
  std::size_t term = 0;
  std::vector<std::size_t> members;  // shape parameters that the slot sets (two if the widths are tied)
  std::size_t group = 0;             // shape: number of the set of shapes; else the channel; or kEveryGroup
  Role role = Role::other;           // of the first member
  Scale scale = Scale::identity;
  double min = 0, max = 0;   // natural
  double low = 0, high = 0;  // on the solver's scale
  double grid_max = 0;       // natural: upper end of the grid of starts
  // For a shape that is smooth over wavelength (smooth.h): the number of this node, and the share of its
  // value in each channel.
  std::size_t node = 0, nodes = 1;
  std::vector<double> share;
  std::string name;  // as reported: alpha, alpha_x, terms[1].sigma

  // Returns whether the slot belongs to group `g`.
  bool in_group(std::size_t g) const { return group == g || group == kEveryGroup; }
  // Returns whether both slots set the same parameter, possibly of different channels.
  bool same_parameter(const Slot& s) const {
    return kind == s.kind && term == s.term && members == s.members;
  }
  bool same_range(const Slot& s) const { return min == s.min && max == s.max; }
  // Convert between the natural value and the value on the solver's scale.
  double to_solver(double natural) const;
  double to_natural(double u) const;
  double slope(double u) const;  // d natural / d u
};

}  // namespace brdf::fit

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 4> kNames<fit::Scale>{"identity", "ln", "ln1p", "square"};

}  // namespace brdf
