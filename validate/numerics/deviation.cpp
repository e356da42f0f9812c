#include "validate/numerics/deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "validate/search/pair_search.h"

namespace brdf::validate {
namespace {

constexpr double kBody = 1e-6, kFaint = 1e-12, kTail = 1e-30;  // of the lobe's peak
// A lobe with f0 is judged as if its Fresnel term F were at least this value.
constexpr double kLeastLobe = 0.01;

// |a - b| divided by the scale.
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
std::optional<Accuracy::Errors> stated_accuracy(const ReflectanceInfo& form) {
  if (!form.accuracy) return std::nullopt;
  return std::is_same_v<T, float> ? form.accuracy->in_float : form.accuracy->in_double;
}
template std::optional<Accuracy::Errors> stated_accuracy<float>(const ReflectanceInfo&);
template std::optional<Accuracy::Errors> stated_accuracy<double>(const ReflectanceInfo&);

template <class T, class Truth>
Deviations<T, Truth>::Deviations(const Reflectance& form)
    : form_(form),
      info_(info(form)),
      budget_(numerics_budget(std::is_same_v<T, float> ? "float" : "double")),
      stated_(stated_accuracy<T>(info_)) {}

template <class T, class Truth>
void Deviations<T, Truth>::set(const std::vector<std::vector<T>>& weights, const std::vector<T>& shape) {
  sets_ = weights.size();
  weights_.clear();
  for (const auto& w : weights) weights_.emplace_back(w.begin(), w.end());
  for (std::size_t k = 0; f0_ >= 0 && k < sets_; ++k) {
    std::vector<Truth> full = weights_[k];
    full[std::size_t(f0_)] = Truth(1);
    weights_.push_back(std::move(full));
  }
  shape_.assign(shape.begin(), shape.end());
}

template <class T, class Truth>
std::vector<Truth> Deviations<T, Truth>::truths(const Vec3<Truth>& wi, const Vec3<Truth>& wo) const {
  return exact_eval<Truth>(form_, weights_, shape_, wi, wo, kMinCosine<T>);
}

template <class T, class Truth>
std::vector<Deviation> Deviations<T, Truth>::of(const Vec3<T>& wi, const Vec3<T>& wo, const std::vector<T>& f,
                                                const std::vector<double>& peaks) const {
  const auto as_it_stands = [](const Vec3<T>& w) { return Vec3<Truth>{Truth(w.x), Truth(w.y), Truth(w.z)}; };
  const std::vector<Truth> unit = truths(exact_direction<Truth>(wi), exact_direction<Truth>(wo));
  std::vector<Truth> stored;
  std::vector<Deviation> out(f.size());
  for (std::size_t k = 0; k < f.size(); ++k) {
    if (!std::isfinite(f[k])) continue;
    Judged judged = compare(wi, wo, f[k], unit, k, peaks[k]);
    if (noticeable(judged, judged.deviation.error) || exceeds_statement(judged)) {
      if (stored.empty()) stored = truths(as_it_stands(wi), as_it_stands(wo));
      if (due_to_storing(judged, relative(stored[k], unit[k], judged.scale))) {
        judged = compare(wi, wo, f[k], stored, k, peaks[k]);
        judged.deviation.as_stored = true;
      }
    }
    out[k] = judged.deviation;
  }
  return out;
}

template <class T, class Truth>
bool Deviations<T, Truth>::noticeable(const Judged& judged, double error) const {
  return judged.deviation.band && !(error < budget_.body / 4);
}

template <class T, class Truth>
bool Deviations<T, Truth>::due_to_storing(const Judged& judged, double storing) const {
  if (noticeable(judged, storing)) return noticeable(judged, judged.deviation.error);
  return exceeds_statement(judged) && storing > *stated_.*judged.deviation.band / 4;
}

template <class T, class Truth>
bool Deviations<T, Truth>::exceeds_statement(const Judged& judged) const {
  const double stated = judged.deviation.band && stated_ ? *stated_.*judged.deviation.band : 0;
  return stated > 0 && judged.deviation.error > stated;
}

template <class T, class Truth>
auto Deviations<T, Truth>::compare(const Vec3<T>& wi, const Vec3<T>& wo, T f,
                                   const std::vector<Truth>& truths, std::size_t set, double peak) const
    -> Judged {
  const double size = std::max(std::abs(double(truths[set])), std::abs(double(f))), share = size / peak;
  if (!(share >= kTail && size >= kTiny)) return {};
  const Band band = share >= kBody    ? &Accuracy::Errors::body
                    : share >= kFaint ? &Accuracy::Errors::faint
                                      : &Accuracy::Errors::tail;
  Judged judged{{band, 0}, scale_of(wi, wo, truths, set, peak)};
  double& error = judged.deviation.error;
  error = relative(Truth(f), truths[set], judged.scale);
  if (noticeable(judged, error) && info_.kink == Kink::mirror_edge && mirror_cosine(wi, wo) < 0.5) {
    const auto [least, most] = range_at_edge(wi, wo, set);
    error = relative(std::clamp(Truth(f), least, most), Truth(f), judged.scale);
  }
  return judged;
}

// The range of the truth when r.o changes by 4 ulp in both directions. The cosines have already been raised
// to the minimum.
template <class T, class Truth>
std::pair<Truth, Truth> Deviations<T, Truth>::range_at_edge(const Vec3<T>& wi, const Vec3<T>& wo,
                                                            std::size_t set) const {
  const Geometry<Truth> g = geometry(exact_direction<Truth>(wi), exact_direction<Truth>(wo), kMinCosine<T>);
  const Vec3<Truth> towards =
      Vec3<Truth>{-g.wi.x, -g.wi.y, g.wi.z} * Truth(4 * std::numeric_limits<T>::epsilon());
  const auto f = [&](const Vec3<Truth>& view) {
    return exact_eval<Truth>(form_, {&weights_[set], 1}, shape_, g.wi, view, 0)[0];
  };
  return {f(g.wo - towards), f(g.wo + towards)};
}

// The scale to which the error is relative; see NumericsRow.
template <class T, class Truth>
Truth Deviations<T, Truth>::scale_of(const Vec3<T>& wi, const Vec3<T>& wo, const std::vector<Truth>& truths,
                                     std::size_t set, double peak) const {
  using std::abs;
  const Truth size = abs(truths[set]);
  if (info_.basis) {  // a sum of terms of both signs
    Truth terms = size;
    for (const Truth& w : weights_[set]) terms = terms + abs(w) / Truth(kPi);
    return terms;
  }
  if (signed_)  // a direct term that changes sign
    return size + (diffuse_ >= 0 ? Truth(weights_[set][std::size_t(diffuse_)] / Truth(kPi)) : Truth(peak));
  if (f0_ >= 0) return larger(size, Truth(Truth(kLeastLobe) * abs(truths[sets_ + set])));
  return info_.kink == Kink::mirror_edge && mirror_cosine(wi, wo) < 0.5 ? Truth(peak) : size;
}

template class Deviations<float, double>;
template class Deviations<double, Extended>;
template class Deviations<double, Exact>;

}  // namespace brdf::validate
