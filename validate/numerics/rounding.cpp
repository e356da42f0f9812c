#include "validate/numerics/rounding.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "brdf/material.h"
#include "validate/search/extremes.h"
#include "validate/search/pair_search.h"

namespace brdf::validate {
namespace {

constexpr double kNearRecord = 0.95;  // of the largest error so far

template <class To, class From>
std::vector<To> convert(const std::vector<From>& values) {
  return std::vector<To>(values.begin(), values.end());
}

// Appends "kd=0 ks=1" with the fewest digits that give the same T.
template <class T>
void append(std::string& text, std::span<const ParameterInfo> table, const std::vector<T>& values) {
  for (std::size_t k = 0; k < table.size(); ++k) {
    char digits[32];
    const char* end = std::to_chars(digits, digits + sizeof digits, values[k]).ptr;
    text += (text.empty() ? "" : " ") + std::string(table[k].name) + '=' +
            std::string(static_cast<const char*>(digits), end);
  }
}

}  // namespace

template <class T>
Rounding<T>::Rounding(const Reflectance& form) : form_(form), info_(info(form)), first_(form), exact_(form) {
  row_.form = info_.name;
  row_.scalar = std::is_same_v<T, float> ? "float" : "double";
  row_.may_be_negative = info_.violates("non_negative");
  row_.stated = stated_accuracy<T>(info_);
}

template <class T>
void Rounding<T>::set(const std::vector<std::vector<double>>& weights, const std::vector<double>& shape) {
  weights_.clear();
  for (const auto& w : weights) weights_.push_back(convert<T>(w));
  shape_ = convert<T>(shape);
  first_.set(weights_, shape_);
  exact_.set(weights_, shape_);
}

template <class T>
std::vector<double> Rounding<T>::peaks(const Vec3<double>& wi, const std::vector<Vec3<double>>& views) const {
  std::vector<std::vector<double>> weights;
  for (const auto& w : weights_) weights.push_back(convert<double>(w));
  const std::vector<double> shape = convert<double>(shape_);
  std::vector<double> peaks(weights.size(), 0.0);
  for (const Vec3<double>& wo : views) {
    const std::vector<double> f = exact_eval<double>(form_, weights, shape, wi, wo, kMinCosine<T>);
    for (std::size_t k = 0; k < f.size(); ++k) peaks[k] = std::max(peaks[k], std::abs(f[k]));
  }
  return peaks;
}

template <class T>
double Rounding<T>::judge(const Vec3<double>& light, const Vec3<double>& view,
                          const std::vector<double>& peaks) {
  const Vec3<T> wi = nearly_unit<T>(light), wo = view == light ? wi : nearly_unit<T>(view);
  std::vector<T> f;
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    f.push_back(evaluate(wi, wo, k, false));
    count(f.back());
    count(evaluate(wi, wo, k, true));
  }
  std::vector<Deviation> deviations = first_.of(wi, wo, f, peaks);
  const bool record =
      std::ranges::any_of(deviations, [&](const Deviation& d) { return perhaps_a_record(d); });
  if (record) deviations = exact_.of(wi, wo, f, peaks);
  double worst = 0;
  for (std::size_t k = 0; k < deviations.size(); ++k) {
    const Deviation& d = deviations[k];
    if (!d.band) continue;
    row_.as_stored += d.as_stored;
    if (record) keep(d, wi, wo, k);
    const double stated = row_.stated ? *row_.stated.*d.band : 0;
    worst = std::max(worst, d.error / (stated > 0 ? stated : numerics_budget(row_.scalar).*d.band));
  }
  return worst;
}

template <class T>
bool Rounding<T>::perhaps_a_record(const Deviation& d) const {
  return d.band && !(d.error < kNearRecord * row_.errors.*d.band);
}

template <class T>
void Rounding<T>::keep(const Deviation& d, const Vec3<T>& wi, const Vec3<T>& wo, std::size_t set) {
  double& largest = row_.errors.*d.band;
  if (!(d.error > largest)) return;
  largest = d.error;
  if (d.band == &Accuracy::Errors::body) row_.where = where(wi, wo, set);
}

template <class T>
T Rounding<T>::evaluate(const Vec3<T>& wi, const Vec3<T>& wo, std::size_t set, bool cosine) const {
  const ParameterValues<T> p{weights_[set], weights_[set], shape_};
  T f;
  if (cosine)
    form_->eval_cos(p, one_pair(wi, wo), &f);
  else
    form_->eval(p, one_pair(wi, wo), &f);
  return f;
}

template <class T>
void Rounding<T>::count(T f) {
  ++row_.count;
  row_.nan += std::isnan(f);
  row_.inf += std::isinf(f);
  row_.negative += f < 0;
}

template <class T>
NumericsRow::Where Rounding<T>::where(const Vec3<T>& wi, const Vec3<T>& wo, std::size_t set) const {
  std::string parameters;
  append(parameters, info_.weights, weights_[set]);
  append(parameters, info_.shape, shape_);
  return {parameters, {wi.x, wi.y, wi.z}, {wo.x, wo.y, wo.z}};
}

template class Rounding<float>;
template class Rounding<double>;

std::size_t rounding_dimensions(const ReflectanceInfo& form) {
  return form.shape.size() + form.weights.size() + 5;
}

RoundingCase rounding_case(const ReflectanceInfo& form, std::span<const double> point, double least_cosine) {
  RoundingCase c;
  std::size_t next = 0;
  for (const ParameterInfo& p : form.shape) c.shape.push_back(parameter_value(p, point[next++], p.max));
  for (const ParameterInfo& p : form.weights)
    c.weights.push_back(parameter_value(p, point[next++], std::min(p.max, 1.0)));
  const double light = point[next++], azimuth = 2 * kPi * point[next++], kind = point[next++],
               away = point[next++], turn = 2 * kPi * point[next++];
  const auto cosine = [&](double x) { return x < 1 ? std::pow(least_cosine, x * x) : 0; };
  c.wi = at_cosine(cosine(light), azimuth);
  if (kind < 1.0 / 3) {
    c.wo = at_cosine(cosine(away), azimuth + turn);
  } else if (kind < 2.0 / 3) {  // by the half vector, in widths of the lobe
    const LobeWidth width = lobe_width(form, c.shape);
    const double x = 8 * away * width.x * std::cos(turn), y = 8 * away * width.y * std::sin(turn),
                 length = std::sqrt(x * x + y * y + 1);
    const Vec3<double> h{x / length, y / length, 1 / length};
    c.wo = h * (2 * dot(c.wi, h)) - c.wi;
    c.wo.z = std::abs(c.wo.z);
  } else {  // close to the light's polar angle, azimuths close to a multiple of a quarter turn apart
    const double near = std::pow(1e-7, away), z = std::min(cosine(light) * (1 + near * std::cos(turn)), 1.0);
    c.wo = at_cosine(z, azimuth + std::floor(12 * kind) * kPi / 2 + near * std::sin(turn));
  }
  return c;
}

}  // namespace brdf::validate
