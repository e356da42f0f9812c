#include "validate/joint/catalogue_sampler.h"

namespace brdf::validate {
namespace {

class CatalogueSampler final : public DirectionSampler {
 public:
  explicit CatalogueSampler(Reflectance form) : form_(std::move(form)) {
    facts_.draws = facts_.has_density = true;
    facts_.in_float = false;
    facts_.randoms = 3;
    facts_.eval_name = form_->info().name;
  }
  const SamplerFacts& facts() const override { return facts_; }

  void draw(const Material& at, const Vec3<double>& wo, std::span<const double> u, bool,
            std::span<Draw> out) const override {
    for (std::size_t k = 0; k < out.size(); ++k) {
      const double* const own = u.data() + 3 * k;
      out[k].wi = form_->sample(at.terms.front().shape[0], own[0], own[1], own[2], wo);
      out[k].pdf = std::nan("");
      out[k].used = 3;
    }
  }
  void density(const Material& at, const Vec3<double>& wo, std::span<const Vec3<double>> wi, bool,
               std::span<double> out) const override {
    for (std::size_t k = 0; k < wi.size(); ++k) out[k] = form_->pdf(at.terms.front().shape[0], wi[k], wo);
  }

 private:
  Reflectance form_;
  SamplerFacts facts_;
};

}  // namespace

std::shared_ptr<const DirectionSampler> catalogue_sampler(const Reflectance& form) {
  return std::make_shared<CatalogueSampler>(form);
}

}  // namespace brdf::validate
