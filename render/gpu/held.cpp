#include "render/gpu/held.h"

#include <algorithm>

#include "io/material/glsl.h"
#include "io/material/shader_forms.h"
#include "render/gpu/gpu_layout.h"

namespace brdf::render {
namespace {

class Held final : public ReflectanceModel, public io::StandsFor {
 public:
  explicit Held(const Term& term) : inner_(term.form), shape_(term.shape.front()), weights_(term.weights) {
    const ReflectanceInfo& all = inner_.info();
    info_.name = all.name;
    info_.family = all.family;
    info_.weights = all.weights.first(std::min(all.weights.size(), kMostWeights));
    info_.shape = all.shape.first(std::min(all.shape.size(), most_shape(all.weights.size())));
    info_.channels = all.channels;
    info_.mixes_channels = all.mixes_channels;
    info_.has_glsl = all.has_glsl;
    info_.kink = all.kink;
  }
  const ReflectanceInfo& info() const override { return info_; }
  Term whole(const Term& term) const override {
    Term all{inner_, {}, weights_, term.tangent_phi};
    for (const std::vector<double>& set : term.shape) {
      all.shape.push_back(shape_);
      std::copy_n(set.begin(), std::min(set.size(), shape_.size()), all.shape.back().begin());
    }
    for (std::size_t c = 0; c < all.weights.size(); ++c) {
      const std::vector<double>& set = term.weights[std::min(c, term.weights.size() - 1)];
      std::copy_n(set.begin(), std::min(set.size(), all.weights[c].size()), all.weights[c].begin());
    }
    return all;
  }
  using ReflectanceModel::eval;
  void eval(const ParameterValues<double>& p, const Directions<double>& d, double* out) const override {
    // The given values may be longer than the table, because a shader has a fixed number of slots.
    const auto filled = [](std::span<const double> given, std::size_t count, std::vector<double> all) {
      std::copy_n(given.begin(), std::min(given.size(), count), all.begin());
      return all;
    };
    const std::size_t free = info_.weights.size();
    const std::vector<double> weights =
                                  filled(p.weights, free, weights_[std::min(p.channel, weights_.size() - 1)]),
                              first = filled(p.first, free, weights_.front()),
                              shape = filled(p.shape, info_.shape.size(), shape_);
    inner_->eval({weights, first, shape, p.channel}, d, out);
  }
  std::string glsl(const GlslOptions& options) const override {
    // Renames the functions of the formula, and adds functions with this form's name that call them.
    const std::string name(info_.name), inner = "held_" + name;
    std::string text = inner_->glsl(options);
    std::string arguments = "vec3 wi, vec3 wo", given = "wi, wo";
    const ReflectanceInfo& all = inner_.info();
    for (std::size_t k = 0; k < all.shape.size(); ++k) {
      const std::string word = "s" + std::to_string(k);
      if (k < info_.shape.size()) arguments += ", float " + word;
      given += ", " + (k < info_.shape.size() ? word : io::glsl_number(shape_[k]));
    }
    for (std::size_t k = 0; k < all.weights.size(); ++k) {
      const std::string word = "w" + std::to_string(k);
      if (k < info_.weights.size()) arguments += ", vec3 " + word;
      const auto value = [&](std::size_t c) {
        return io::glsl_number(weights_[std::min(c, weights_.size() - 1)][k]);
      };
      given +=
          ", " +
          (k < info_.weights.size() ? word : "vec3(" + value(0) + ", " + value(1) + ", " + value(2) + ")");
    }
    for (const std::string function : {"brdf_eval_cos_", "brdf_eval_"}) {
      for (std::size_t at = 0; (at = text.find(function + name + "(", at)) != text.npos; at += inner.size())
        text.replace(at + function.size(), name.size(), inner);
    }
    for (const std::string function : {"brdf_eval_", "brdf_eval_cos_"})
      text += "vec3 " + function + name + "(" + arguments + ") {\n  return " + function + inner + "(" +
              given + ");\n}\n";
    return text;
  }

 private:
  Reflectance inner_;
  std::vector<double> shape_;
  std::vector<std::vector<double>> weights_;
  ReflectanceInfo info_;
};

}  // namespace

Material with_room(Material material) {
  for (Term& term : material.terms) {
    const ReflectanceInfo& all = info(term.form);
    const std::size_t shape = most_shape(all.weights.size());
    if (all.weights.size() <= kMostWeights && all.shape.size() <= shape) continue;
    const Reflectance held(std::make_shared<const Held>(term));
    for (std::vector<double>& set : term.weights) set.resize(std::min(set.size(), kMostWeights));
    for (std::vector<double>& set : term.shape) set.resize(std::min(set.size(), shape));
    term.form = held;
  }
  return material;
}

}  // namespace brdf::render
