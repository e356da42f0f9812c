#include "validate/rounding.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "brdf/material.h"
#include "validate/extremes.h"
#include "validate/pair_search.h"

namespace brdf::validate {
namespace {

constexpr double kBody = 1e-6, kFaint = 1e-12, kTail = 1e-30;  // of the lobe's peak
constexpr double kLeastLobe = 0.01;  // a lobe with f0 is judged as if its F were at least that

template <class To, class From>
std::vector<To> convert(const std::vector<From>& values) {
  return std::vector<To>(values.begin(), values.end());
}

// "kd=0 ks=1": as few digits as give the same T.
template <class T>
void append(std::string& text, std::span<const ParameterInfo> table, const std::vector<T>& values) {
  for (std::size_t k = 0; k < table.size(); ++k) {
    char digits[32];
    const char* end = std::to_chars(digits, digits + sizeof digits, values[k]).ptr;
    text += (text.empty() ? "" : " ") + std::string(table[k].name) + '=' +
            std::string(static_cast<const char*>(digits), end);
  }
}

// |a - b| over the scale.
template <class Truth>
double relative(const Truth& a, const Truth& b, const Truth& scale) {
  using std::abs;
  return a == b ? 0.0 : double(Truth(abs(Truth(a - b)) / scale));
}

template <class T>
double mirror_cosine(const Vec3<T>& wi, const Vec3<T>& wo) {
  return double(wi.z) * double(wo.z) - double(wi.x) * double(wo.x) - double(wi.y) * double(wo.y);
}

}  // namespace

template <class T>
Rounding<T>::Rounding(const Reflectance& form) : form_(form), info_(info(form)) {
  row_.form = info_.name;
  row_.scalar = std::is_same_v<T, float> ? "float" : "double";
  row_.may_be_negative = signed_;
  if (info_.accuracy)
    row_.stated = std::is_same_v<T, float> ? info_.accuracy->in_float : info_.accuracy->in_double;
}

template <class T>
void Rounding<T>::set(const std::vector<std::vector<double>>& weights, const std::vector<double>& shape) {
  weights_.clear();
  truth_weights_.clear();
  for (const auto& w : weights) {
    weights_.push_back(convert<T>(w));
    truth_weights_.push_back(convert<Truth>(weights_.back()));
  }
  for (std::size_t k = 0; f0_ >= 0 && k < weights.size(); ++k) {
    std::vector<Truth> full = truth_weights_[k];
    full[std::size_t(f0_)] = Truth(1);
    truth_weights_.push_back(std::move(full));
  }
  shape_ = convert<T>(shape);
  truth_shape_ = convert<Truth>(shape_);
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
  const auto truths = [&](const Vec3<Truth>& i, const Vec3<Truth>& o) {
    return exact_eval<Truth>(form_, truth_weights_, truth_shape_, i, o, kMinCosine<T>);
  };
  const auto as_it_stands = [](const Vec3<T>& w) { return Vec3<Truth>{Truth(w.x), Truth(w.y), Truth(w.z)}; };
  const std::vector<Truth> unit = truths(exact_direction<Truth>(wi), exact_direction<Truth>(wo));
  std::vector<Truth> stored;
  double worst = 0;
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    const T f = evaluate(wi, wo, k, false);
    count(f);
    count(evaluate(wi, wo, k, true));
    if (!std::isfinite(f)) continue;
    Judged judged = compare(wi, wo, f, unit, k, peaks[k]);
    if (noticeable(judged, judged.error) || exceeds_statement(judged)) {
      if (stored.empty()) stored = truths(as_it_stands(wi), as_it_stands(wo));
      if (due_to_storing(judged, relative(stored[k], unit[k], judged.scale))) {
        judged = compare(wi, wo, f, stored, k, peaks[k]);
        ++row_.as_stored;
      }
    }
    worst = std::max(worst, record(judged, wi, wo, k));
  }
  return worst;
}

template <class T>
bool Rounding<T>::due_to_storing(const Judged& judged, double storing) const {
  if (noticeable(judged, storing)) return noticeable(judged, judged.error);
  return exceeds_statement(judged) && storing > *row_.stated.*judged.band / 4;
}

template <class T>
bool Rounding<T>::exceeds_statement(const Judged& judged) const {
  const double stated = judged.band && row_.stated ? *row_.stated.*judged.band : 0;
  return stated > 0 && judged.error > stated;
}

template <class T>
auto Rounding<T>::compare(const Vec3<T>& wi, const Vec3<T>& wo, T f, const std::vector<Truth>& truths,
                          std::size_t set, double peak) const -> Judged {
  const double size = std::max(std::abs(double(truths[set])), std::abs(double(f))), share = size / peak;
  if (!(share >= kTail && size >= kTiny)) return {};
  const Band band = share >= kBody    ? &Accuracy::Errors::body
                    : share >= kFaint ? &Accuracy::Errors::faint
                                      : &Accuracy::Errors::tail;
  Judged judged{band, numerics_budget(row_.scalar).*band, scale_of(wi, wo, truths, set, peak), 0};
  judged.error = relative(Truth(f), truths[set], judged.scale);
  if (noticeable(judged, judged.error) && info_.kink == Kink::mirror_edge && mirror_cosine(wi, wo) < 0.5) {
    const auto [least, most] = range_at_edge(wi, wo, set);
    judged.error = relative(std::clamp(Truth(f), least, most), Truth(f), judged.scale);
  }
  return judged;
}

template <class T>
double Rounding<T>::record(const Judged& judged, const Vec3<T>& wi, const Vec3<T>& wo, std::size_t set) {
  if (!judged.band) return 0;
  double& largest = row_.errors.*judged.band;
  if (judged.error > largest) {
    largest = judged.error;
    if (judged.band == &Accuracy::Errors::body) row_.where = where(wi, wo, set);
  }
  const double stated = row_.stated ? *row_.stated.*judged.band : 0;
  return judged.error / (stated > 0 ? stated : judged.budget);
}

// The truth with r.o smaller and larger by some ulp, of cosines that are raised already.
template <class T>
auto Rounding<T>::range_at_edge(const Vec3<T>& wi, const Vec3<T>& wo, std::size_t set) const
    -> std::pair<Truth, Truth> {
  const Geometry<Truth> g = geometry(exact_direction<Truth>(wi), exact_direction<Truth>(wo), kMinCosine<T>);
  const Vec3<Truth> towards =
      Vec3<Truth>{-g.wi.x, -g.wi.y, g.wi.z} * Truth(4 * std::numeric_limits<T>::epsilon());
  const auto f = [&](const Vec3<Truth>& view) {
    return exact_eval<Truth>(form_, {&truth_weights_[set], 1}, truth_shape_, g.wi, view, 0)[0];
  };
  return {f(g.wo - towards), f(g.wo + towards)};
}

// What the error is relative to; see NumericsRow.
template <class T>
typename Rounding<T>::Truth Rounding<T>::scale_of(const Vec3<T>& wi, const Vec3<T>& wo,
                                                  const std::vector<Truth>& truths, std::size_t set,
                                                  double peak) const {
  using std::abs;
  const Truth size = abs(truths[set]);
  if (signed_)  // a direct term that changes sign
    return size +
           (diffuse_ >= 0 ? Truth(truth_weights_[set][std::size_t(diffuse_)] / Truth(kPi)) : Truth(peak));
  if (f0_ >= 0) return larger(size, Truth(Truth(kLeastLobe) * abs(truths[weights_.size() + set])));
  return info_.kink == Kink::mirror_edge && mirror_cosine(wi, wo) < 0.5 ? Truth(peak) : size;
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
  } else {  // nearly the light's polar angle, azimuths nearly some quarter turns apart
    const double near = std::pow(1e-7, away), z = std::min(cosine(light) * (1 + near * std::cos(turn)), 1.0);
    c.wo = at_cosine(z, azimuth + std::floor(12 * kind) * kPi / 2 + near * std::sin(turn));
  }
  return c;
}

}  // namespace brdf::validate
