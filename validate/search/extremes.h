// The fixed grid of parameters and directions on which accuracy is measured.
#pragma once

#include <vector>

#include "brdf/reflectance.h"

namespace brdf::validate {

struct ParameterGrid {
  std::vector<std::vector<double>> weights;  // in table order
  std::vector<std::vector<double>> shapes;
};

// Returns the ends of every range, the default, and the values at which formulas are known to break: 1:1000
// anisotropy, an index of refraction close to 1, f0 = 0 and f0 = 1. The weights of the lobe alone come
// first, because the diffuse term would hide the lobe's error. The weights with all terms together come
// last.
ParameterGrid extreme_parameters(const Reflectance& form);

// Returns weights at which only the lobe of a form is visible: diffuse weights at their minimum if there
// are other terms, all other weights (including f0) at 1.
std::vector<double> lobe_alone(const ReflectanceInfo& form);

// Returns light directions: the normal, ordinary angles, 89.9 and 89.99 degrees, exact grazing.
std::vector<Vec3<double>> extreme_lights();

// Returns view directions for one light: the mirror direction and points on the lobe out to its tail; the
// normal, ordinary angles and exact grazing at several azimuths; wo = wi; and (-wi.x, -wi.y, 0), which is
// -wi for a light at exact grazing. `width_x`, `width_y`: widths of the lobe, in slopes of the half vector.
std::vector<Vec3<double>> extreme_views(const Vec3<double>& wi, double width_x, double width_y);

// The lobe's widths at the given shape parameters; 0.3 if the form has no width or exponent.
struct LobeWidth {
  double x, y;
};
LobeWidth lobe_width(const ReflectanceInfo& form, const std::vector<double>& shape);

// Returns the representable vector within a few ulps of w (a thousand if only one component is free) whose
// length is 1 to within a hundredth of an ulp. A vector that is merely rounded is off by half an ulp in
// length. Treating it as the unit vector that it represents moves a lobe of width alpha by eps/alpha, which
// is an error of the input.
template <class T>
Vec3<T> nearly_unit(const Vec3<double>& w);

}  // namespace brdf::validate
