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
    const Filled<double> all(*this, p);
    inner_->eval(all.view(), d, out);
  }
  // Values in float are those of the form itself, which computes in float as a device does.
  void eval(const ParameterValues<float>& p, const Directions<float>& d, float* out) const override {
    const Filled<float> all(*this, p);
    inner_->eval(all.view(), d, out);
  }
  using ReflectanceModel::eval_cos;
  void eval_cos(const ParameterValues<float>& p, const Directions<float>& d, float* out) const override {
    const Filled<float> all(*this, p);
    inner_->eval_cos(all.view(), d, out);
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
  // The given values followed by the held ones. The given values may be longer than the table, because a
  // shader has a fixed number of slots.
  template <class T>
  struct Filled {
    Filled(const Held& held, const ParameterValues<T>& p) : channel(p.channel) {
      const std::size_t free = held.info_.weights.size();
      fill(p.weights, free, held.weights_[std::min(p.channel, held.weights_.size() - 1)], weights);
      fill(p.first, free, held.weights_.front(), first);
      fill(p.shape, held.info_.shape.size(), held.shape_, shape);
    }
    static void fill(std::span<const T> given, std::size_t count, const std::vector<double>& held,
                     std::vector<T>& out) {
      out.assign(held.begin(), held.end());
      std::copy_n(given.begin(), std::min(given.size(), count), out.begin());
    }
    ParameterValues<T> view() const { return {weights, first, shape, channel}; }

    std::vector<T> weights, first, shape;
    std::size_t channel;
  };

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

Reflectance with_room(const Reflectance& form) {
  Material material{{"f"}, {make_term(form, 1)}};
  std::vector<double>& weights = material.terms.front().weights.front();
  for (std::size_t k = kMostWeights; k < weights.size(); ++k)
    weights[k] = (k % 2 ? 1.0 : -1.0) * double(k) / 256;
  return with_room(std::move(material)).terms.front().form;
}

}  // namespace brdf::render
