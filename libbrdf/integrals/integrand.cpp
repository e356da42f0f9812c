#include "integrals/integrand.h"

#include <algorithm>
#include <cmath>

namespace brdf::integrals {
namespace {

template <class F>
constexpr bool has_v_cavity() {
  if constexpr (requires { F::v_cavity; })
    return F::v_cavity;
  else
    return false;
}

Kink kink_of(const AnyForm& form, double width) {
  const FormInfo& f = info(form);
  if (std::visit([](auto g) { return has_v_cavity<decltype(g)>(); }, form)) return Kink::v_cavity;
  if (f.family == "oren_nayar") return Kink::azimuth;
  // x^n at the edge of a narrow lobe is smooth to more orders than a rule can see.
  if (f.family == "phong" && width > 0.08) return Kink::mirror_edge;
  return Kink::none;
}

// Directions whose half vector has this slope along one axis, from below the normal's other side.
double sum_at(const Integrand& integrand, const Vec3<double>& fixed, const Vec3<double>& moving) {
  std::vector<double> out(integrand.columns());
  integrand.evaluate(fixed, 1, &moving.x, &moving.y, &moving.z, out.data());
  double sum = 0;
  for (const double v : out) sum += std::abs(v);
  return sum / moving.z;
}

// The slope at which the form has fallen to 1/e of the way from its peak to its floor, at normal incidence.
double measured_width(const Integrand& integrand) {
  const Vec3<double> normal{0, 0, 1};
  const double peak = sum_at(integrand, normal, normal);
  const auto at_slope = [&](double slope) {
    const double angle = 2 * std::atan(slope);
    return sum_at(integrand, normal, {std::sin(angle), 0, std::cos(angle)});
  };
  const double floor = at_slope(0.999);
  if (!(peak - floor > 1e-3 * peak)) return 1;
  for (double slope = 1e-5; slope < 0.999; slope *= 1.2)
    if (at_slope(slope) - floor < std::exp(-1.0) * (peak - floor)) return slope;
  return 1;
}

// f cos of one column goes as sqrt(cos) where its logarithmic slope near the horizon is a half. (A diffuse
// lobe beside it goes as cos, so the columns are looked at one by one.)
bool measured_root(const Integrand& integrand) {
  const Vec3<double> fixed{0, 0.6, 0.8};
  const auto at = [&](double z) {
    std::vector<double> out(integrand.columns());
    const double x = std::sqrt(1 - z * z), y = 0;
    integrand.evaluate(fixed, 1, &x, &y, &z, out.data());
    return out;
  };
  const auto low = at(1e-8), high = at(1e-6);
  for (std::size_t c = 0; c < low.size(); ++c)
    if (high[c] > 0 && std::abs(std::log(low[c] / high[c]) / std::log(1e-2) - 0.5) < 0.1) return true;
  return false;
}

Features features_of(const Integrand& integrand, const AnyForm& form, std::span<const double> shape) {
  Features found;
  const FormInfo& f = info(form);
  if (f.anisotropic()) {
    found.width_x = shape[std::size_t(f.shape_index("alpha_x"))];
    found.width_y = shape[std::size_t(f.shape_index("alpha_y"))];
  } else {
    found.width_x = found.width_y = measured_width(integrand);
  }
  found.root_at_horizon = measured_root(integrand);
  found.kink = kink_of(form, found.width_x);
  return found;
}

}  // namespace

Integrand::Integrand(const Term& term, std::vector<std::size_t> channels, Fixed fixed)
    : form_(term.form), channels_(std::move(channels)), fixed_(fixed) {
  const auto shape = term.shape_of(channels_.front());
  shape_.assign(shape.begin(), shape.end());
  for (const std::size_t c : channels_) weights_.push_back(term.weights[c]);
  weights_.push_back(term.weights.front());
  columns_ = std::visit(
      [&](auto f) -> std::size_t {
        if constexpr (LinearForm<decltype(f)>)
          return lobe_count<decltype(f)>;
        else
          return channels_.size();
      },
      form_);
  features_ = features_of(*this, form_, shape_);
}

Integrand::Integrand(const AnyForm& form, std::span<const double> shape, Fixed fixed)
    : form_(form), shape_(shape.begin(), shape.end()), fixed_(fixed), lobes_only_(true) {
  columns_ = std::visit(
      [](auto f) -> std::size_t {
        if constexpr (LinearForm<decltype(f)>)
          return lobe_count<decltype(f)>;
        else
          return 0;
      },
      form_);
  if (columns_ > 0) features_ = features_of(*this, form_, shape_);
}

std::vector<double> Integrand::combine(std::span<const double> columns) const {
  if (lobes_only_) return {columns.begin(), columns.end()};
  return std::visit(
      [&](auto f) -> std::vector<double> {
        using F = decltype(f);
        if constexpr (LinearForm<F>) {
          std::vector<double> values;
          for (std::size_t c = 0; c < channels_.size(); ++c) {
            const auto weight =
                from_values<typename F::template Weights<double>>(std::span<const double>(weights_[c]))
                    .linear();
            double value = 0;
            for (std::size_t k = 0; k < weight.size(); ++k) value += weight[k] * columns[k];
            values.push_back(value);
          }
          return values;
        } else {
          return {columns.begin(), columns.end()};
        }
      },
      form_);
}

void Integrand::evaluate(const Vec3<double>& fixed, std::size_t n, const double* x, const double* y,
                         const double* z, double* out) const {
  std::visit(
      [&](auto f) {
        using F = decltype(f);
        using Weights = typename F::template Weights<double>;
        const auto shape = from_values<typename F::template Shape<double>>(std::span<const double>(shape_));
        const bool light_fixed = fixed_ == Fixed::light;
        const auto pair = [&](std::size_t j) {
          const Vec3<double> moving{x[j], y[j], z[j]};
          return light_fixed ? geometry(fixed, moving) : geometry(moving, fixed);
        };
        if constexpr (LinearForm<F>) {
          for (std::size_t j = 0; j < n; ++j) {
            const auto lobe = F::lobes(shape, pair(j));
            for (std::size_t k = 0; k < lobe.size(); ++k) out[k * n + j] = lobe[k] * z[j];
          }
        } else {
          const auto first = from_values<Weights>(std::span<const double>(weights_.back()));
          for (std::size_t c = 0; c < channels_.size(); ++c) {
            const auto w = from_values<Weights>(std::span<const double>(weights_[c]));
            for (std::size_t j = 0; j < n; ++j)
              out[c * n + j] = light_fixed ? eval(f, w, first, shape, pair(j)) * z[j]
                                           : eval_cos(f, w, first, shape, pair(j));
          }
        }
      },
      form_);
}

void NodeSum::flush() {
  if (used_ == 0) return;
  integrand_.evaluate(fixed_, used_, x_.data(), y_.data(), z_.data(), out_.data());
  for (std::size_t c = 0; c < sums_.size(); ++c) {
    double sum = 0;
    for (std::size_t j = 0; j < used_; ++j) sum += weight_[j] * out_[c * used_ + j];
    sums_[c] += sum;
  }
  evaluations_ += long(used_);
  used_ = 0;
}

}  // namespace brdf::integrals
