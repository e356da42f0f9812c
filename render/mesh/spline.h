// The natural cubic spline. Its continuous curvature lets highlights run along a surface without a break.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <vector>

namespace brdf::render {

// Interpolates points of any dimension, parametrised by the chord length between them.
template <class V>
class NaturalSpline {
 public:
  explicit NaturalSpline(std::vector<V> points) : points_(std::move(points)), bend_(points_.size(), V(0)) {
    // `bend_` contains the second derivatives, the solution of a tridiagonal system. Until the back
    // substitution, `share` and `bend_` hold the eliminated coefficients.
    const std::size_t count = points_.size();
    for (std::size_t k = 0; k + 1 < count; ++k) span_.push_back(glm::distance(points_[k], points_[k + 1]));
    std::vector<float> share(count, 0);
    for (std::size_t k = 1; k + 1 < count; ++k) {
      const V turn = (points_[k + 1] - points_[k]) / span_[k] - (points_[k] - points_[k - 1]) / span_[k - 1];
      const float pivot = 2 * (span_[k - 1] + span_[k]) - span_[k - 1] * share[k - 1];
      share[k] = span_[k] / pivot;
      bend_[k] = (6.0f * turn - span_[k - 1] * bend_[k - 1]) / pivot;
    }
    for (std::size_t k = count - 1; k-- > 1;) bend_[k] -= share[k] * bend_[k + 1];
  }

  std::size_t pieces() const { return span_.size(); }
  // Returns the point at the share t of piece k.
  V at(std::size_t k, float t) const {
    const float u = 1 - t, square = span_[k] * span_[k] / 6;
    return u * points_[k] + t * points_[k + 1] +
           square * ((u * u * u - u) * bend_[k] + (t * t * t - t) * bend_[k + 1]);
  }
  V slope(std::size_t k, float t) const {
    const float u = 1 - t, square = span_[k] * span_[k] / 6;
    return points_[k + 1] - points_[k] +
           square * ((1 - 3 * u * u) * bend_[k] + (3 * t * t - 1) * bend_[k + 1]);
  }
  // Returns the point at `place`, from 0 to pieces().
  V at(float place) const {
    const auto k = std::min(std::size_t(std::max(place, 0.0f)), pieces() - 1);
    return at(k, place - float(k));
  }

 private:
  std::vector<V> points_, bend_;
  std::vector<float> span_;
};

}  // namespace brdf::render
