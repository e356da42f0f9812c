// The fixed grid of parameters and directions on which accuracy is measured.
#pragma once

#include <vector>

#include "brdf/reflectance.h"

namespace brdf::validate {

struct ParameterGrid {
  std::vector<std::vector<double>> weights;  // in table order
  std::vector<std::vector<double>> shapes;
};

// The ends of every range, the default, and the values at which formulas are known to break: 1:1000
// anisotropy, an index of refraction next to 1, f0 0 and 1. Weights: the lobe alone comes first (the diffuse
// term would hide its error), all terms together last.
ParameterGrid extreme_parameters(const Reflectance& form);

// Weights at which a form shows its lobe: nothing diffuse where there is something else, all others (f0 too)
// at 1.
std::vector<double> lobe_alone(const ReflectanceInfo& form);

// Light directions: the normal, ordinary angles, 89.9 and 89.99 degrees, exact grazing.
std::vector<Vec3<double>> extreme_lights();

// View directions for one of them: the mirror direction and points on the lobe out to its tail, and the
// hemisphere with the normal, exact grazing, wo = wi and wo = -wi. `width_x`, `width_y`: of the lobe, in
// slopes of the half vector.
std::vector<Vec3<double>> extreme_views(const Vec3<double>& wi, double width_x, double width_y);

// The lobe's widths at these shape parameters; 0.3 where it has none.
struct LobeWidth {
  double x, y;
};
LobeWidth lobe_width(const ReflectanceInfo& form, const std::vector<double>& shape);

// The representable vector within a few ulps of w (a thousand where only one component is free) whose length
// is 1 to a hundredth of an ulp. A stored direction is otherwise off by half an ulp in length, and taking it
// as the unit vector it stands for moves a lobe of width alpha by eps/alpha: an error of the input.
template <class T>
Vec3<T> nearly_unit(const Vec3<double>& w);

}  // namespace brdf::validate
