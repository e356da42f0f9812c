// The samplers of the catalogue and of the targets under the checks that judge samplers of users.
#include <gtest/gtest.h>

#include "brdf/targets.h"
#include "validate/joint/judge_sampler.h"

namespace brdf::validate {
namespace {

class FormSampler final : public DirectionSampler {
 public:
  FormSampler() {
    facts_.draws = facts_.has_density = true;
    facts_.randoms = 3;
  }
  const SamplerFacts& facts() const override { return facts_; }
  void draw(const Material& at, const Vec3<double>& wo, std::span<const double> u, bool,
            std::span<Draw> out) const override {
    const Term& term = at.terms.front();
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k] = {};
      out[k].wi = term.form->sample(term.shape_of(0), u[3 * k], u[3 * k + 1], u[3 * k + 2], wo);
      out[k].pdf = std::nan("");
      out[k].used = 3;
    }
  }
  void density(const Material& at, const Vec3<double>& wo, std::span<const Vec3<double>> wi, bool,
               std::span<double> out) const override {
    const Term& term = at.terms.front();
    for (std::size_t k = 0; k < wi.size(); ++k) out[k] = term.form->pdf(term.shape_of(0), wi[k], wo);
  }

 private:
  SamplerFacts facts_;
};

void judge_all_of(std::span<const Reflectance> forms) {
  int judged = 0;
  for (const Reflectance& form : forms) {
    if (!form.info().follows_lobe) continue;
    const std::vector<Finding> found = judge_sampler(Subject::form(form), FormSampler(), {}, 1 << 16);
    ++judged;
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_NE(found[k].outcome, Outcome::fail)
          << form.info().name << ", " << kSamplerChecks[k] << ": " << found[k].statement;
    EXPECT_EQ(found[0].outcome, Outcome::pass) << form.info().name << ": " << found[0].statement;
  }
  EXPECT_GT(judged, 0);
}

TEST(CatalogueSamplers, PassTheChecksOfUsers) {
  judge_all_of(catalogue());
}

}  // namespace
}  // namespace brdf::validate
