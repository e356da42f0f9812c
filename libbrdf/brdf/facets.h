// Distributions of microfacets and their masking. A form names both: using Facets = Facets<GgxSlopes,
// SmithGgx>.
#pragma once

#include <algorithm>

#include "brdf/facts.h"
#include "brdf/microfacet.h"
#include "brdf/parameter.h"

namespace brdf {

// --- Slope densities P22 = D cos_h^4 of h = (p, q, 1), computed with the D of the forms ------------------

template <auto kD>
struct SlopesOf {
  static double density(const Roughness<double>& a, const Vec3<double>& h) {
    Geometry<double> g{};
    g.h = h;
    g.h2 = dot(h, h);
    const auto d = kD(a, g);
    return d.num / (d.den * square(g.h2));
  }
};
struct GgxSlopes : SlopesOf<d_ggx<double, double>> {
  static constexpr double far = 1e9;
};
struct BeckmannSlopes : SlopesOf<d_beckmann<double, double>> {
  static constexpr double far = 9;
};

// --- Masking G1 of the viewer o for a facet h. Only that of V-cavities depends on the facet --------------

struct PerViewer {
  double value;
  double operator()(const Vec3<double>&) const { return value; }
};
struct SmithGgx : PerViewer {
  SmithGgx(const Roughness<double>& a, const Vec3<double>& o)
      : PerViewer{2 * o.z / (o.z + stretched_length(a, o))} {}
};
struct SmithBeckmann : PerViewer {
  SmithBeckmann(const Roughness<double>& a, const Vec3<double>& o)
      : PerViewer{o.z / (o.z + cos_lambda_beckmann(a, o))} {}
};
struct SchlickGgx : PerViewer {
  SchlickGgx(const Roughness<double>& a, const Vec3<double>& o) : PerViewer{of(k_schlick_ggx(a), o.z)} {}
  static double of(double k, double z) { return z / (z * (1 - k) + k); }
};
struct VCavities {
  Vec3<double> o;
  VCavities(const Roughness<double>&, const Vec3<double>& viewer) : o(viewer) {}
  double operator()(const Vec3<double>& h) const { return std::min(1.0, 2 * o.z / dot(o, h)); }
};

// A distribution together with its masking. The widths are the first parameters of the shape's table.
template <class Slopes, class Masking>
struct Facets {
  static Roughness<double> widths(std::span<const double> shape) { return {shape[0], shape[1]}; }
  static void slopes(std::span<const double> shape, std::size_t count, const Vec3<double>* h, double* out) {
    const Roughness<double> a = widths(shape);
    for (std::size_t k = 0; k < count; ++k) out[k] = Slopes::density(a, h[k]);
  }
  static void masking(std::span<const double> shape, const Vec3<double>& o, std::size_t count,
                      const Vec3<double>* h, double* out) {
    const Masking g1(widths(shape), o);
    for (std::size_t k = 0; k < count; ++k) out[k] = g1(h[k]);
  }
  static constexpr FacetFacts facts{Slopes::far, slopes, masking};
};

}  // namespace brdf
