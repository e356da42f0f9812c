#include "shader/sampler_of.h"

#include <algorithm>

#include "shader/joint.h"

namespace brdf::shader {
namespace {

class ShaderSampler final : public DirectionSampler {
 public:
  explicit ShaderSampler(std::shared_ptr<const ShaderReflectance> model) : model_(std::move(model)) {
    const Function& f = model_->function();
    const Joint& joint = *f.joint;
    facts_.draws = joint.has_sampler();
    facts_.gives_pdf = joint.has_sampler() && joint.sampler_gives_pdf();
    facts_.has_density = joint.has_density();
    for (const Joint::Value& value : joint.values()) facts_.values.push_back({value.name, value.kind});
    facts_.randoms = joint.randoms();
    facts_.generated = joint.generated();
    if (joint.has_sampler()) facts_.sampler_name = joint.sampler_name();
    if (joint.has_density()) facts_.density_name = joint.density_name();
    if (!joint.pdf_name().empty()) facts_.pdf_name = joint.pdf_name();
    const std::string before = f.entry.substr(0, f.entry.find('('));
    facts_.eval_name = before.substr(before.rfind(' ') + 1);
    facts_.eval_returns = f.returns == Returns::f_cos_i ? SampleValue::f_cos_i : SampleValue::f;
    for (std::size_t k = 0; k < model_->weight_parameters().size(); ++k)
      if (f.parameters[model_->weight_parameters()[k]].colour) facts_.colour_weights.push_back(k);
    facts_.missing = joint.missing();
    facts_.half_unknown = joint.half_unknown().empty() ? f.half_unknown : joint.half_unknown();
  }

  const SamplerFacts& facts() const override { return facts_; }
  void draw(const Material& at, const Vec3<double>& wo, std::span<const double> u, bool single,
            std::span<Draw> out) const override {
    model_->function().joint->draw(values_at(at), wo, u, single, out);
  }
  void density(const Material& at, const Vec3<double>& wo, std::span<const Vec3<double>> wi, bool single,
               std::span<double> out) const override {
    model_->function().joint->density(values_at(at), wo, wi, single, out);
  }

 private:
  // A sampler sees all components of a colour, so each component is the weight of its own channel.
  std::vector<double> values_at(const Material& at) const {
    const Term& term = at.terms.front();
    std::vector<double> values = model_->values_of(term.values(0));
    for (const std::size_t k : facts_.colour_weights)
      for (std::size_t c = 0; c < 3; ++c)
        values[model_->function().parameters[model_->weight_parameters()[k]].first + c] =
            term.weights[std::min(c, term.weights.size() - 1)][k];
    return values;
  }

  std::shared_ptr<const ShaderReflectance> model_;
  SamplerFacts facts_;
};

}  // namespace

std::shared_ptr<const DirectionSampler> sampler_of(std::shared_ptr<const ShaderReflectance> model) {
  if (!model->function().joint) return nullptr;
  return std::make_shared<const ShaderSampler>(std::move(model));
}

}  // namespace brdf::shader
