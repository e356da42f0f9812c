#include "interop/cosine_transform.h"

#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "brdf/directions.h"
#include "brdf/samplers.h"
#include "interop/lookup_table.h"
#include "io/files/numbers.h"
#include "io/files/parallel.h"

namespace brdf::interop {
namespace {

constexpr double kSmallestAlpha = 1e-4;
const double kSmallestCosine = std::cos(degrees(89.9).radians());
constexpr std::size_t kRings = 48;

// Nodes over the half of the sphere with positive y, for lobes that are symmetric about the plane of
// incidence; weights refer to the whole sphere. Two proposals share the work by the balance heuristic
// (Veach 1995): mirrored visible normals of GGX, which cover the lobe, and a cosine, which covers the rest.
struct Nodes {
  std::vector<Vec3<double>> wi;
  std::vector<double> weights;  // sr
};

double density_of_mirrored(double alpha, const Vec3<double>& wo, const Vec3<double>& wi) {
  const Vec3<double> h = normalised(wi + wo);
  if (h.z <= 0 || dot(h, wo) <= 0) return 0;
  const double a2 = alpha * alpha, bend = 1 + (a2 - 1) * h.z * h.z;
  const double stretched = std::sqrt(a2 * (wo.x * wo.x + wo.y * wo.y) + wo.z * wo.z);
  return a2 / (kPi * bend * bend) / (2 * (wo.z + stretched));
}

Nodes nodes_of(double alpha, const Vec3<double>& wo, std::size_t rings) {
  Nodes nodes;
  const std::size_t coarse = std::max<std::size_t>(rings / 2, 2), half = rings / 2, quarter = coarse / 2;
  const auto middle = [](std::size_t k, std::size_t n) { return (double(k) + 0.5) / double(n); };
  const auto add = [&](Vec3<double> wi) {
    wi.y = std::abs(wi.y);
    nodes.wi.push_back(wi);
  };
  for (std::size_t r = 0; r < rings; ++r)
    for (std::size_t t = 0; t < half; ++t) {
      const double turn = 0.75 + 0.5 * middle(t, half);
      const Vec3<double> h = sample_visible_ggx(Roughness<double>{alpha, alpha}, middle(r, rings), turn, wo);
      add(h * (2 * dot(h, wo)) - wo);
    }
  const double mirrored = double(nodes.wi.size());
  for (std::size_t r = 0; r < coarse; ++r)
    for (std::size_t t = 0; t < quarter; ++t) add(sample_cosine(middle(r, coarse), 0.5 * middle(t, quarter)));
  const double covering = double(nodes.wi.size()) - mirrored;
  for (const Vec3<double>& wi : nodes.wi)
    nodes.weights.push_back(
        1 / (mirrored * density_of_mirrored(alpha, wo, wi) + covering * std::max(wi.z, 0.0) / kPi));
  return nodes;
}

// The density of a lobe at nodes.
struct LobeNodes {
  Nodes nodes;
  std::vector<double> density;  // 1/sr; its sum with the weights is 1
  double albedo = 0;
};

LobeNodes lobe_at(const TableFunction& function, double cosine, double alpha, std::size_t rings) {
  const double z = std::max(cosine, kSmallestCosine), held = std::max(alpha, kSmallestAlpha);
  // A viewer at the very normal would give the proposal another plane of symmetry.
  const Vec3<double> wo{std::max(std::sqrt(std::max(0.0, 1 - z * z)), 1e-12), 0, z};
  LobeNodes lobe{nodes_of(function.has_roughness() ? held : 1, wo, rings), {}};
  DirectionArrays<double> pairs(lobe.nodes.wi.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) pairs.set(k, lobe.nodes.wi[k], wo);
  lobe.density.resize(pairs.size());
  eval_cos_batch(function.at_alpha(held), 0, pairs.view(), lobe.density.data());
  for (std::size_t k = 0; k < pairs.size(); ++k) lobe.albedo += lobe.nodes.weights[k] * lobe.density[k];
  if (lobe.albedo > 0)
    for (double& d : lobe.density) d /= lobe.albedo;
  return lobe;
}

// The inverse matrix as a turn of the lobe's axis, a skew and two widths: tilt in radians, logarithm of the
// width's ratio, skew in widths, logarithm of the width.
using Unknowns = Eigen::Vector4d;

template <class T>
struct Inverse {
  T x, y, z, w;
};

template <class T>
Inverse<T> inverse_of(const T* p) {
  using std::cos, std::exp, std::sin;
  const T c = cos(p[0]), s = sin(p[0]), ratio = exp(p[1]), width = exp(p[3]), skew = p[2] * width;
  return {ratio * c + skew * s, width * s, skew * c - ratio * s, width * c};
}

template <class T>
T density_of(const Inverse<T>& m, const Vec3<double>& wi) {
  const T a = m.x * wi.x + m.z * wi.z, c = m.y * wi.x + m.w * wi.z;
  if (c <= T(0)) return T(0);
  const T length2 = a * a + T(wi.y * wi.y) + c * c;
  return c * (m.x * m.w - m.z * m.y) / (T(kPi) * length2 * length2);
}

// Residuals: difference of the densities at a node over the density of the nodes.
struct DensityDifference {
  const LobeNodes* lobe;

  int NumResiduals() const { return int(lobe->density.size()); }
  template <class T>
  bool operator()(const T* p, T* residuals) const {
    const Inverse<T> inverse = inverse_of(p);
    const double scale = std::sqrt(double(lobe->density.size()));
    for (std::size_t k = 0; k < lobe->density.size(); ++k)
      residuals[k] =
          (density_of(inverse, lobe->nodes.wi[k]) - lobe->density[k]) * (scale * lobe->nodes.weights[k]);
    return true;
  }
};

struct Fitted {
  Unknowns unknowns;
  double cost = 0;
};

Fitted fitted(const LobeNodes& lobe, const Unknowns& start) {
  const DensityDifference difference{&lobe};
  const ceres::TinySolverAutoDiffFunction<DensityDifference, Eigen::Dynamic, 4> function(difference);
  ceres::TinySolver<ceres::TinySolverAutoDiffFunction<DensityDifference, Eigen::Dynamic, 4>> solver;
  Fitted out{start};
  solver.Solve(function, &out.unknowns);
  out.cost = solver.summary.final_cost;
  return out;
}

CosineTransform transform_of(const Unknowns& unknowns) {
  const Inverse<double> m = inverse_of(unknowns.data());
  return {m.x, m.y, m.z, m.w};
}

// The densities are both 1 in all, so that half of their difference's integral is 1 minus their common part.
double misplaced(const LobeNodes& lobe, const CosineTransform& transform) {
  double common = 0;
  for (std::size_t k = 0; k < lobe.density.size(); ++k)
    common += lobe.nodes.weights[k] * std::min(transform.density(lobe.nodes.wi[k]), lobe.density[k]);
  return std::max(0.0, 1 - common);
}

// One row of the table, from the widest lobe to the narrowest, because a wide lobe has one minimum and its
// solution is near that of the next.
void fit_row(CosineTable& table, const TableFunction& function, std::size_t row, std::span<double> shares) {
  const double v = double(row) / double(table.side - 1), cosine = 1 - v * v;
  std::optional<Unknowns> before;
  for (std::size_t k = table.side; k-- > 0;) {
    const double u = double(k) / double(table.side - 1), alpha = u * u;
    const LobeNodes lobe = lobe_at(function, cosine, alpha, kRings);
    Vec3<double> mean{};
    for (std::size_t n = 0; n < lobe.density.size(); ++n)
      mean = mean + lobe.nodes.wi[n] * (lobe.nodes.weights[n] * lobe.density[n]);
    const double width = function.has_roughness() ? std::max(alpha, kSmallestAlpha) : 1;
    Fitted best = fitted(lobe, Unknowns(std::atan2(mean.x, mean.z), 0, 0, std::log(width)));
    if (before)
      if (const Fitted other = fitted(lobe, *before); other.cost < best.cost) best = other;
    before = best.unknowns;
    const std::size_t texel = row * table.side + k;
    table.transforms[texel] = transform_of(best.unknowns);
    shares[texel] = misplaced(lobe, table.transforms[texel]);
  }
}

CosineTransform mean_of(std::span<const CosineTransform> four) {
  CosineTransform out{0, 0, 0, 0};
  for (const CosineTransform& m : four)
    out = {out.x + m.x / 4, out.y + m.y / 4, out.z + m.z / 4, out.w + m.w / 4};
  return out;
}

// Returns the median, and the largest with its place; `first` is the place of the first value in texels.
double summarised(std::vector<double> shares, std::size_t columns, double first, std::size_t side,
                  AtPlace& largest) {
  const std::size_t worst = std::size_t(std::ranges::max_element(shares) - shares.begin());
  const double u = (double(worst % columns) + first) / double(side - 1),
               v = (double(worst / columns) + first) / double(side - 1);
  largest = {shares[worst], 1 - v * v, u};
  std::ranges::nth_element(shares, shares.begin() + std::ptrdiff_t(shares.size() / 2));
  return shares[shares.size() / 2];
}

void set_albedos(CosineTable& table, const TableFunction& function) {
  std::vector<double> bounds(table.transforms.size());
  std::vector<char> converged(bounds.size(), 1);
  io::parallel_for(bounds.size(), [&](std::size_t k) {
    const double u = double(k % table.side) / double(table.side - 1),
                 v = double(k / table.side) / double(table.side - 1);
    const TableFunction::Values at = function.directional(1 - v * v, u * u);
    const bool splits = at.values.size() > 1;
    table.white[k] = at.values[splits ? 1 : 0];
    table.bias[k] = splits ? at.values[0] : 0;
    bounds[k] = at.bound;
    converged[k] = char(at.converged);
  });
  table.albedo_bound = *std::ranges::max_element(bounds);
  table.not_converged = std::size_t(std::ranges::count(converged, 0));
}

}  // namespace

double CosineTransform::density(const Vec3<double>& wi) const {
  return density_of(Inverse<double>{x, y, z, w}, wi);
}

CosineTable cosine_table(const Material& material, std::size_t side) {
  const TableFunction function(material, TableKind::dfg, true);
  CosineTable table{side, std::vector<CosineTransform>(side * side), std::vector<double>(side * side),
                    std::vector<double>(side * side), function.lobe_name()};
  std::vector<double> shares(side * side), between((side - 1) * (side - 1));
  io::parallel_for(side, [&](std::size_t row) { fit_row(table, function, row, shares); });
  io::parallel_for(between.size(), [&](std::size_t k) {
    const std::size_t i = k % (side - 1), j = k / (side - 1), texel = j * side + i;
    const std::array four{table.transforms[texel], table.transforms[texel + 1],
                          table.transforms[texel + side], table.transforms[texel + side + 1]};
    const double u = (double(i) + 0.5) / double(side - 1), v = (double(j) + 0.5) / double(side - 1);
    between[k] = misplaced(lobe_at(function, 1 - v * v, u * u, kRings), mean_of(four));
  });
  set_albedos(table, function);
  table.misplaced_median = summarised(std::move(shares), side, 0, side, table.misplaced);
  table.between_median = summarised(std::move(between), side - 1, 0.5, side, table.between);
  return table;
}

double misplaced_share(const Material& material, const CosineTransform& transform, double cosine,
                       double alpha, std::size_t rings) {
  const TableFunction function(material, TableKind::dfg, true);
  return misplaced(lobe_at(function, cosine, alpha, rings), transform);
}

std::vector<std::string> sentences(const CosineTable& table) {
  const std::string side = std::to_string(table.side);
  const auto at = [](const AtPlace& place) {
    return io::short_number(place.value, 2) + " at cos(theta) " + io::short_number(place.cosine, 3) +
           ", roughness " + io::short_number(place.roughness, 3);
  };
  return {
      side + " x " + side + " texels of linearly transformed cosines (Heitz et al. 2016); " + table.content,
      "x: roughness = sqrt(alpha); y: sqrt(1 - cos(theta)); 0 and 1 at the outer texels; R, G, B, A: the "
      "inverse matrix with the rows (R, 0, B), (0, 1, 0), (G, 0, A) for a viewer at positive x",
      "albedo = f0 white + (f90 - f0) bias, in the channels albedo.white and albedo.bias, " +
          (table.not_converged > 0 ? "of which the integrals of " + std::to_string(table.not_converged) +
                                         " texels did not converge"
                                   : "integrated within " + io::short_number(table.albedo_bound, 2)) +
          "; the form factor of a clipped sphere, which some programs keep in a second texture, is not "
          "written",
      "share of the reflected light that a texel sends into wrong directions: median " +
          io::short_number(table.misplaced_median, 2) + ", largest " + at(table.misplaced),
      "the same in the middle between texels, read bilinearly: median " +
          io::short_number(table.between_median, 2) + ", largest " + at(table.between)};
}

io::Json to_json(const CosineTable& table) {
  const auto place = [](const AtPlace& p) -> io::Json {
    return {{"largest", p.value}, {"cosine", p.cosine}, {"roughness", p.roughness}};
  };
  io::Json texels = place(table.misplaced), between = place(table.between);
  texels["median"] = table.misplaced_median;
  between["median"] = table.between_median;
  return {{"layout", "ltc"},
          {"width", table.side},
          {"height", table.side},
          {"content", table.content},
          {"albedo_bound", table.not_converged > 0 ? io::Json() : io::Json(table.albedo_bound)},
          {"not_converged", table.not_converged},
          {"misplaced", texels},
          {"misplaced_between_texels", between}};
}

}  // namespace brdf::interop
