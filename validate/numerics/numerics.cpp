#include "validate/numerics/numerics.h"

#include <cmath>

#include "validate/numerics/rounding.h"
#include "validate/search/extremes.h"
#include "validate/search/search.h"

namespace brdf::validate {
namespace {

template <class T>
void visit_grid(const Reflectance& form, Rounding<T>& rounding) {
  const ParameterGrid grid = extreme_parameters(form);
  for (const auto& shape : grid.shapes) {
    rounding.set(grid.weights, shape);
    const LobeWidth width = lobe_width(info(form), shape);
    for (const Vec3<double>& wi : extreme_lights()) {
      const std::vector<Vec3<double>> views = extreme_views(wi, width.x, width.y);
      const std::vector<double> peaks = rounding.peaks(wi, views);
      for (const Vec3<double>& wo : views) rounding.judge(wi, wo, peaks);
    }
  }
}

template <class T>
void search(const Reflectance& form, Rounding<T>& rounding, const NumericsOptions& options) {
  const ReflectanceInfo& f = info(form);
  const auto error = [&](std::span<const double> point) {
    const RoundingCase c = rounding_case(f, point, kMinCosine<T> / 2);
    rounding.set({c.weights}, c.shape);
    const LobeWidth width = lobe_width(f, c.shape);
    return rounding.judge(c.wi, c.wo, rounding.peaks(c.wi, extreme_views(c.wi, width.x, width.y)));
  };
  maximise_rough(error, rounding_dimensions(f), options.evaluations, options.seed);
}

bool within(const Accuracy::Errors& errors, const Accuracy::Errors& limits) {
  return errors.body <= limits.body && errors.faint <= limits.faint && errors.tail <= limits.tail;
}

template <class T>
NumericsRow measure(const Reflectance& form, const NumericsOptions& options) {
  Rounding<T> rounding(form);
  visit_grid(form, rounding);
  search(form, rounding, options);
  return rounding.row();
}

}  // namespace

std::vector<NumericsRow> measure_numerics(const Reflectance& form, const NumericsOptions& options) {
  if (catalogue_index(form) < 0) return {};
  return {measure<float>(form, options), measure<double>(form, options)};
}

Accuracy::Errors numerics_budget(const std::string& scalar) {
  return scalar == "float" ? Accuracy::Errors{5e-6, 1e-5, 5e-5} : Accuracy::Errors{1e-14, 2e-14, 5e-14};
}

bool meets_budget(const NumericsRow& row) {
  return within(row.errors, numerics_budget(row.scalar)) && row.nan == 0 && row.inf == 0 &&
         (row.negative == 0 || row.may_be_negative);
}

bool meets_statement(const NumericsRow& row) {
  return !row.stated || within(row.errors, *row.stated);
}

}  // namespace brdf::validate
