// Reflectances that are not in the catalogue.
#pragma once

#include "brdf/cosine_lobe.h"
#include "brdf/reflectance_of.h"

namespace brdf::render {

// The lobe's weight first, the diffuse one last.
template <class T>
struct GleamWeights {
  T gleam, ground;
  static constexpr auto fields() {
    return std::array{Field{&GleamWeights::gleam,
                            ParameterInfo{"gleam", 0, 10, 0.4, 1, "", false, "the lobe", Role::specular}},
                      Field{&GleamWeights::ground,
                            ParameterInfo{"ground", 0, 10, 0.3, 1, "", false, "below", Role::diffuse}}};
  }
  constexpr std::array<T, 2> linear() const { return {gleam, ground}; }
  static constexpr GleamWeights from_linear(const std::array<T, 2>& w) { return {w[0], w[1]}; }
};

template <class T>
struct Sharpness {
  T sharpness;
  static constexpr auto fields() {
    return std::array{Field{&Sharpness::sharpness,
                            ParameterInfo{"sharpness", 0, 1e4, 30, 1e3, "", true, "power", Role::exponent}}};
  }
};

// Two of one name: what is compiled for one must not serve the other.
struct gleam : Takes<GleamWeights, Sharpness> {
  static constexpr std::string_view name = "stranger", family = "stranger";
  static constexpr NoViolations violations{};
  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    return {mirror_cosine_power(shape.sharpness, g), S(1 / kPi)};
  }
};
struct glint : Takes<GleamWeights, Sharpness> {
  static constexpr std::string_view name = "stranger", family = "stranger";
  static constexpr NoViolations violations{};
  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    return {half_cosine_power(shape.sharpness, g), S(1 / kPi)};
  }
};

// One value everywhere, the sum of its weights, of which there are many; without GLSL unless it is given some.
class Plain : public ReflectanceModel {
 public:
  explicit Plain(std::size_t weights, std::string glsl = "") : glsl_(std::move(glsl)) {
    table_.assign(weights, ParameterInfo{"part", 0, 1, 0.1, 1, "", false, "a part"});
    info_.name = info_.family = "plain";
    info_.weights = table_;
    info_.has_glsl = !glsl_.empty();
  }
  const ReflectanceInfo& info() const override { return info_; }
  using ReflectanceModel::eval;
  void eval(const ParameterValues<double>& p, const Directions<double>& d, double* out) const override {
    double sum = 0;
    for (const double weight : p.weights) sum += weight;
    for (std::size_t k = 0; k < d.count; ++k) out[k] = d.wi_z[k] > 0 && d.wo_z[k] > 0 ? sum : 0;
  }
  std::string glsl(const GlslOptions&) const override { return glsl_; }

 private:
  std::vector<ParameterInfo> table_;
  ReflectanceInfo info_;
  std::string glsl_;
};

}  // namespace brdf::render
