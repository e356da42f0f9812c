#include "fit/assess/verdict.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/highlight.h"

namespace brdf::fit {
namespace {

constexpr double kNegligible = 1e-7;  // share of a lobe in the model below which the lobe is absent

}  // namespace

NormalEquations drop_negligible_lobes(const SampleStream& stream, Minimum& m, Besides* besides) {
  const Model& model = stream.model();
  const NormalEquations n = stream.normal_equations(m.p, besides);
  bool dropped = false;
  for (std::size_t k = model.shape_slots(); k < model.size(); ++k) {
    const Slot& slot = model.slots()[k];
    if (slot.low != 0 || m.p[k] == 0) continue;
    double all = 0;
    for (std::size_t i = model.shape_slots(); i < model.size(); ++i)
      if (model.slots()[i].group == slot.group || slot.group == kEveryGroup)
        all += m.p[i] * m.p[i] * n.hessian(i, i);
    if (m.p[k] * m.p[k] * n.hessian(k, k) <= kNegligible * kNegligible * all) {
      m.p[k] = 0;
      m.at_bound[k] = -1;
      dropped = true;
    }
  }
  if (besides && dropped) stream.values(m.p, besides->values);
  return n;
}

Verdict verdict_of(const Minimum& m, const Uncertainty& u, const Misfit& misfit) {
  if (m.termination != Termination::converged || !std::isfinite(m.cost)) return Verdict::diverged;
  const auto any = [&](Status s) {
    return std::ranges::any_of(u.estimates, [&](const Estimate& e) { return e.status == s; });
  };
  // If the form deviates systematically from the surface, no further direction would determine the
  // parameters.
  if (misfit.misfit) return Verdict::misfit;
  if (u.singular && !u.determined()) return Verdict::not_identifiable;
  if (any(Status::unidentified)) return u.determined() ? Verdict::determined : Verdict::not_identifiable;
  if (any(Status::at_bound) || u.sum_at_bound) return Verdict::at_bound;
  return Verdict::converged;
}

Misfit judge(const FitData& data, const std::vector<std::vector<double>>& values,
             std::optional<double> noise) {
  const Misfit misfit = judge_misfit(data, values, noise);
  return misfit.misfit ? misfit : judge_highlight(data, values, noise);
}

}  // namespace brdf::fit
