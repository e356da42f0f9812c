#include "brdf/least_of_matt.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "brdf/matt_basis.h"

namespace brdf {
namespace {

struct Box {
  MattBox<double> at;
  double bound;
  bool operator<(const Box& other) const { return bound > other.bound; }
};

class Search {
 public:
  Search(const MattBasis& basis, std::span<const double> weights) : basis_(basis), weights_(weights) {}

  LeastOfMatt run(double above, long most) {
    double size = 0;
    for (const double w : weights_) size += std::abs(w);
    constexpr double kExact = 1e-6 / kPi;
    std::priority_queue<Box> open;
    open.push(examined({}));
    while (open.top().bound < above && open.top().bound < best_ - kExact * size && boxes_ < most) {
      const MattBox<double> box = open.top().at;
      open.pop();
      // The azimuth counts half, because its range is twice as wide.
      std::size_t cut = 0;
      double widest = 0;
      for (std::size_t d = 0; d < 3; ++d) {
        const double width = (box.high[d] - box.low[d]) / (d == 2 ? 2 : 1);
        if (width > widest) {
          widest = width;
          cut = d;
        }
      }
      const double middle = (box.low[cut] + box.high[cut]) / 2;
      MattBox<double> half = box;
      half.high[cut] = middle;
      open.push(examined(half));
      half = box;
      half.low[cut] = middle;
      open.push(examined(half));
    }
    LeastOfMatt out;
    out.value = best_;
    out.bound = open.top().bound;
    out.boxes = boxes_;
    const auto direction = [](double r, double cosine) {
      const double z = 1 - r * r, s = r * std::sqrt(1 + z);
      return Vec3<double>{s * cosine, s * std::sqrt(std::max(1 - cosine * cosine, 0.0)), z};
    };
    out.wi = direction(place_[0], 1);
    out.wo = direction(place_[1], place_[2]);
    return out;
  }

 private:
  // Bounds f on a box, and notes the values at its corners.
  Box examined(const MattBox<double>& at) {
    ++boxes_;
    const std::size_t last = std::size_t(basis_.order);
    double least = std::numeric_limits<double>::infinity();
    matt_coefficients<double>(
        basis_, weights_, at, [&](double c, std::size_t i, std::size_t j, std::size_t k) {
          const double value = c / kPi;
          least = std::min(least, value);
          const bool corner = (i == 0 || i == last) && (j == 0 || j == last) && (k == 0 || k == last);
          if (!corner || !(value < best_)) return;
          best_ = value;
          place_ = {i ? at.high[0] : at.low[0], j ? at.high[1] : at.low[1], k ? at.high[2] : at.low[2]};
        });
    return {at, least};
  }

  const MattBasis& basis_;
  std::span<const double> weights_;
  long boxes_ = 0;
  double best_ = std::numeric_limits<double>::infinity();
  std::array<double, 3> place_{};
};

}  // namespace

LeastOfMatt least_of_matt(const MattBasis& basis, std::span<const double> weights, double above, long most) {
  return Search(basis, weights).run(above, most);
}

void matt_values(const MattBasis& basis, const Vec3<double>& wi, const Vec3<double>& wo,
                 std::span<double> out) {
  const double zi = std::max(wi.z, 0.0), zo = std::max(wo.z, 0.0), ri = std::sqrt(std::max(1 - zi, 0.0)),
               ro = std::sqrt(std::max(1 - zo, 0.0));
  const double both = ri * ro * std::sqrt((1 + zi) * (1 + zo));
  const double cosine = both > 0 ? std::clamp((wi.x * wo.x + wi.y * wo.y) / both, -1.0, 1.0) : 1;
  MattBox<double> point{{ri, ro, cosine}, {ri, ro, cosine}};
  std::vector<double> one(out.size());
  for (std::size_t k = 0; k < out.size(); ++k) {
    one.assign(out.size(), 0);
    one[k] = 1;
    matt_coefficients<double>(basis, one, point,
                              [&](double c, std::size_t, std::size_t, std::size_t) { out[k] = c / kPi; });
  }
}

void matt_albedos(const MattBasis& basis, double cosine, std::span<double> out) {
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = matt_albedo(basis.indices[k], 1 - cosine);
}

}  // namespace brdf
