#include "validate/joint/catalogue_noise.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace brdf::validate {
namespace {

// The subject's shape in the order of a form's table; std::nullopt if a role is missing.
std::optional<std::vector<double>> shape_by_roles(const ReflectanceInfo& form, const Trio& trio) {
  const Term& term = trio.at().at.terms.front();
  const ReflectanceInfo& subject = info(term.form);
  std::vector<double> out;
  for (const ParameterInfo& p : form.shape) {
    if (p.role == Role::other) return std::nullopt;
    int k = subject.shape_index(p.role);
    for (const auto& [along, across] : kAxisRoles)
      if (k < 0 && p.role == across) k = subject.shape_index(along);
    if (k < 0) return std::nullopt;
    out.push_back(std::clamp(term.shape[0][std::size_t(k)], p.min, p.max));
  }
  return out.empty() ? std::nullopt : std::optional(out);
}

}  // namespace

CatalogueNoise least_noise_of_catalogue(const Trio& trio, std::size_t channel, double truth,
                                        std::uint64_t seed) {
  constexpr std::size_t kCount = 1 << 13;
  CatalogueNoise best;
  for (const Reflectance& form : catalogue()) {
    if (!form.info().follows_lobe || trio.at().at.terms.size() != 1) continue;
    const auto shape = shape_by_roles(form.info(), trio);
    if (!shape) continue;
    Random random(seed);
    std::vector<Vec3<double>> wi(kCount);
    std::vector<double> density(kCount);
    for (std::size_t k = 0; k < kCount; ++k) {
      const double u1 = random.uniform(), u2 = random.uniform(), u3 = random.uniform();
      wi[k] = form->sample(*shape, u1, u2, u3, trio.at().wo);
      density[k] = form->pdf(*shape, wi[k], trio.at().wo);
    }
    const std::vector<double> f = trio.f(wi, true);
    double sum2 = 0;
    for (std::size_t k = 0; k < kCount; ++k) {
      const double weight = wi[k].z > 0 && density[k] > 0 ? f[channel * kCount + k] / density[k] : 0;
      sum2 += weight * weight;
    }
    const double noise = std::sqrt(std::max(sum2 / double(kCount) - truth * truth, 0.0)) / truth;
    if (best.form.empty() || noise < best.noise) best = {std::string(form.info().name), noise};
  }
  return best;
}

}  // namespace brdf::validate
