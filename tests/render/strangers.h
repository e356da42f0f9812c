// Reflectances that are not in the catalogue.
#pragma once

#include "brdf/reflectance.h"

namespace brdf::render {

// Two reflectances with the same name. Code that is compiled for one must not be used for the other.
Reflectance gleam();
Reflectance glint();

// A reflectance with one value everywhere, the sum of its weights, which may be many. It has no GLSL unless
// `glsl` is given.
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
