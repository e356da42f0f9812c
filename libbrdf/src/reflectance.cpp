#include "brdf/reflectance.h"

#include <algorithm>
#include <array>

#include "brdf/samplers.h"
#include "brdf/targets.h"

namespace brdf {
namespace {

// Evaluates in double and rounds to float, one block at a time.
template <class Evaluate>
void by_double(const ParameterValues<float>& p, const Directions<float>& d, float* out, Evaluate&& evaluate) {
  constexpr std::size_t kBlock = 256;
  const auto wide = [](std::span<const float> values) {
    return std::vector<double>(values.begin(), values.end());
  };
  const std::vector<double> weights = wide(p.weights), first = wide(p.first), shape = wide(p.shape);
  const bool own = p.first.data() == p.weights.data();
  DirectionArrays<double> block(std::min(kBlock, d.count));
  std::array<double, kBlock> values;
  for (std::size_t start = 0; start < d.count; start += kBlock) {
    const Directions<float> part = d.part(start, std::min(kBlock, d.count - start));
    for (std::size_t k = 0; k < part.count; ++k) {
      const Vec3<float> wi = part.wi(k), wo = part.wo(k);
      block.set(k, {wi.x, wi.y, wi.z}, {wo.x, wo.y, wo.z});
    }
    evaluate(ParameterValues<double>{weights, own ? weights : first, shape, p.channel},
             block.view().part(0, part.count), values.data());
    std::copy_n(values.begin(), part.count, out + start);
  }
}

}  // namespace

bool ReflectanceInfo::violates(std::string_view check) const {
  return std::ranges::any_of(violations, [&](const Violation& v) { return v.check == check; });
}

int ReflectanceInfo::shape_index(std::string_view parameter) const {
  return parameter_index(shape, parameter);
}
int ReflectanceInfo::weight_index(std::string_view parameter) const {
  return parameter_index(weights, parameter);
}
int ReflectanceInfo::shape_index(Role role) const {
  return parameter_index(shape, role);
}
int ReflectanceInfo::weight_index(Role role) const {
  return parameter_index(weights, role);
}

ReflectanceInfo::Axes ReflectanceInfo::axes() const {
  for (const auto& [first, second] : kAxisRoles)
    if (const Axes axes{shape_index(first), shape_index(second)}; axes.along >= 0 && axes.across >= 0)
      return axes;
  return {};
}

std::string_view ReflectanceInfo::tied_name() const {
  const auto [along, across] = axes();
  if (along < 0 || across < 0) return {};
  const std::string_view a = shape[std::size_t(along)].name, b = shape[std::size_t(across)].name;
  std::size_t common = std::size_t(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
  while (common > 0 && a[common - 1] == '_') --common;
  return a.substr(0, common);
}

std::vector<double> linear_weights(const ReflectanceInfo& info, std::span<const double> weights) {
  const int f0 = info.weight_index(Role::f0);
  std::vector<double> linear;
  for (const auto& [weight, factor] : info.lobes) {
    const double fresnel = factor == LobeWeight::Factor::one  ? 1
                           : factor == LobeWeight::Factor::f0 ? weights[std::size_t(f0)]
                                                              : 1 - weights[std::size_t(f0)];
    linear.push_back(weights[weight] * fresnel);
  }
  return linear;
}

void ReflectanceModel::eval_cos(const ParameterValues<double>& p, const Directions<double>& d,
                                double* out) const {
  eval(p, d, out);
  for (std::size_t k = 0; k < d.count; ++k) out[k] *= std::max(d.wi_z[k], 0.0);
}
void ReflectanceModel::eval(const ParameterValues<float>& p, const Directions<float>& d, float* out) const {
  by_double(p, d, out, [&](const auto&... arguments) { eval(arguments...); });
}
void ReflectanceModel::eval_cos(const ParameterValues<float>& p, const Directions<float>& d,
                                float* out) const {
  by_double(p, d, out, [&](const auto&... arguments) { eval_cos(arguments...); });
}
void ReflectanceModel::lobes(std::span<const double>, Partial, const Directions<double>&,
                             const LobeRows&) const {}
void ReflectanceModel::gradient(const ParameterValues<double>& p, const Directions<double>& d,
                                const LobeRows& out) const {
  const std::span<const LobeWeight> table = info().lobes;
  const std::size_t shapes = p.shape.size(), rows = 1 + shapes;
  std::vector<double> lobe_rows(table.size() * rows * d.count);
  lobes(p.shape, Partial::shape, d, {lobe_rows.data(), d.count});
  const auto row = [&](std::size_t k) { return std::span(out.data + k * out.stride, d.count); };
  const auto add = [&](std::size_t to, std::size_t lobe, std::size_t from, double factor) {
    const double* const values = lobe_rows.data() + (lobe * rows + from) * d.count;
    for (std::size_t i = 0; i < d.count; ++i) row(to)[i] += factor * values[i];
  };
  for (std::size_t k = 0; k < rows + p.weights.size(); ++k) std::ranges::fill(row(k), 0);
  const std::vector<double> linear = linear_weights(info(), p.weights);
  const int place = info().weight_index(Role::f0);
  const std::size_t f0_row = rows + std::size_t(std::max(place, 0));
  const double f0 = place < 0 ? 1 : p.weights[std::size_t(place)];
  for (std::size_t l = 0; l < table.size(); ++l) {
    const auto [weight, factor] = table[l];
    for (std::size_t k = 0; k < rows; ++k) add(k, l, k, linear[l]);
    const bool whole = factor == LobeWeight::Factor::one, reflected = factor == LobeWeight::Factor::f0;
    add(rows + weight, l, 0, whole ? 1 : reflected ? f0 : 1 - f0);
    if (!whole) add(f0_row, l, 0, reflected ? p.weights[weight] : -p.weights[weight]);
  }
}
std::vector<ReflectanceModel::TableWeight> ReflectanceModel::weights_of(std::span<const double>) const {
  return {};
}
Vec3<double> ReflectanceModel::sample(std::span<const double>, double u1, double u2, double,
                                      const Vec3<double>&, double) const {
  return sample_cosine(u1, u2);
}
double ReflectanceModel::pdf(std::span<const double>, const Vec3<double>& wi, const Vec3<double>&,
                             double) const {
  return std::max(wi.z, 0.0) / kPi;
}
std::string ReflectanceModel::glsl(const GlslOptions&) const {
  return {};
}
std::string ReflectanceModel::glsl_sampler(const GlslOptions&) const {
  return {};
}

std::optional<Reflectance> find_form(std::string_view name) {
  for (const std::span<const Reflectance> list : {catalogue(), targets()})
    for (const Reflectance& form : list)
      if (form.info().name == name) return form;
  return std::nullopt;
}

std::vector<std::vector<Reflectance>> families(std::span<const Reflectance> forms) {
  std::vector<std::vector<Reflectance>> groups;
  for (const Reflectance& form : forms) {
    const auto same = [&](const std::vector<Reflectance>& g) {
      return g.front().info().family == form.info().family;
    };
    const auto group = std::ranges::find_if(groups, same);
    if (group == groups.end())
      groups.push_back({form});
    else
      group->push_back(form);
  }
  return groups;
}

int catalogue_index(const Reflectance& reflectance) {
  const auto all = catalogue();
  const auto found = std::ranges::find(all, reflectance);
  return found == all.end() ? -1 : int(found - all.begin());
}

}  // namespace brdf
