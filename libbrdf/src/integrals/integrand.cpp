#include "libbrdf/src/integrals/integrand.h"
#include "libbrdf/src/integrals/functions.h"

#include <algorithm>
#include <cmath>

namespace brdf::integrals {
namespace {

// Returns the moving direction that has a half vector of this slope together with the normal.
Vec3<double> at_slope(double slope) {
  const double angle = 2 * integrals::atan(slope);
  return {integrals::sin(angle), 0, integrals::cos(angle)};
}

}  // namespace

Integrand::Integrand(const Term& term, std::vector<std::size_t> channels, Fixed fixed)
    : form_(term.form), channels_(std::move(channels)), fixed_(fixed) {
  const auto shape = term.shape_of(channels_.front());
  shape_.assign(shape.begin(), shape.end());
  for (const std::size_t c : channels_) weights_.push_back(term.weights[c]);
  weights_.push_back(term.weights.front());
  columns_ = info(form_).fittable() ? info(form_).lobes.size() : channels_.size();
  look();
}

Integrand::Integrand(const Reflectance& form, std::span<const double> shape, Fixed fixed)
    : form_(form), shape_(shape.begin(), shape.end()), fixed_(fixed), lobes_only_(true) {
  columns_ = info(form_).lobes.size();
  if (columns_ > 0) look();
}

// Returns the sum of the magnitudes of the varying columns, f without the cosine.
double Integrand::sum_at(const Vec3<double>& fixed, const Vec3<double>& moving) const {
  std::vector<double> out(columns_);
  evaluate(fixed, 1, &moving.x, &moving.y, &moving.z, out.data());
  double sum = 0;
  for (std::size_t c = 0; c < columns_; ++c)
    if (constants_.empty() || std::isnan(constants_[c])) sum += std::abs(out[c]);
  return sum / moving.z;
}

// A column with the same value at seven unrelated pairs of directions is treated as constant.
void Integrand::find_constants() {
  constants_.assign(columns_, NAN);
  if (info(form_).outside) return;
  constexpr std::array<std::array<double, 4>, 7> kPairs{{{0, 0, 0, 0},
                                                         {0.3, 0.1, 0.35, 3.2},
                                                         {0.9, 2.0, 0.85, 5.1},
                                                         {1.2, 1.0, 1.21, 4.13},
                                                         {0.6, 4.0, 1.5, 0.5},
                                                         {1.54, 0.2, 1.3, 0.2},
                                                         {0.05, 5.5, 0.7, 2.5}}};
  std::vector<double> first(columns_), out(columns_);
  std::vector<bool> same(columns_, true);
  for (const auto& [theta_f, phi_f, theta_m, phi_m] : kPairs) {
    const Vec3<double> m = direction(radians(theta_m), radians(phi_m));
    evaluate(direction(radians(theta_f), radians(phi_f)), 1, &m.x, &m.y, &m.z, out.data());
    for (std::size_t c = 0; c < columns_; ++c) {
      const double f = out[c] / m.z;
      if (theta_m == 0) first[c] = f;
      same[c] = same[c] && std::abs(f - first[c]) <= 4e-16 * std::abs(first[c]);
    }
  }
  for (std::size_t c = 0; c < columns_; ++c)
    if (same[c]) constants_[c] = first[c];
}

// Returns the slope at which the form has fallen to 1/e of the difference between its peak and its floor,
// at normal incidence.
double Integrand::measured_width() const {
  const Vec3<double> normal{0, 0, 1};
  const double peak = sum_at(normal, normal), floor = sum_at(normal, at_slope(0.999));
  if (!(peak - floor > 1e-3 * peak)) return 1;
  for (double slope = kLeastWidth; slope < 0.999; slope *= 1.2)
    if (sum_at(normal, at_slope(slope)) - floor < std::exp(-1.0) * (peak - floor)) return slope;
  return 1;
}

// Returns true if f cos of some column behaves like sqrt(cos), which means a logarithmic slope of 1/2 near
// the horizon. Columns are tested one by one because another lobe may behave like cos. Both directions are
// within the width of the lobe from grazing, to keep an exponential lobe above 0 there.
bool Integrand::measured_root() const {
  const double z_fixed = 0.25 * std::min(features_.width_x, features_.width_y);
  const auto at = [&](double z) {
    std::vector<double> out(columns_);
    const double x = std::sqrt(1 - z * z), y = 0;
    evaluate({-std::sqrt(1 - z_fixed * z_fixed), 0, z_fixed}, 1, &x, &y, &z, out.data());
    return out;
  };
  const auto low = at(1e-6 * z_fixed), high = at(1e-5 * z_fixed);
  for (std::size_t c = 0; c < low.size(); ++c)
    if (high[c] > 0 && std::abs(std::log10(high[c] / low[c]) - 0.5) < 0.1) return true;
  return false;
}

// Returns true if rotating both directions by a quarter turn, which causes no rounding, changes the value.
bool Integrand::measured_orientation() const {
  for (const auto& [theta_f, phi_f, theta_m, phi_m] :
       {std::array{0.7, 0.4, 0.75, 3.4}, std::array{0.2, 1.2, 0.9, 2.6}, std::array{1.1, 5.9, 1.2, 2.9}}) {
    const Vec3<double> f = direction(radians(theta_f), radians(phi_f)),
                       m = direction(radians(theta_m), radians(phi_m));
    const double here = sum_at(f, m), turned = sum_at({-f.y, f.x, f.z}, {-m.y, m.x, m.z});
    if (std::abs(here - turned) > 1e-9 * std::max(std::abs(here), std::abs(turned))) return true;
  }
  return false;
}

void Integrand::look() {
  find_constants();
  const ReflectanceInfo& f = info(form_);
  const auto value = [&](int parameter) { return shape_[std::size_t(parameter)]; };
  if (const auto [along, across] = f.axes(); across >= 0) {
    const bool exponents = f.shape_index(Role::exponent) == along;
    const auto width = [&](double x) { return exponents ? std::sqrt(2 / (x + 2)) : x; };
    features_.width_x = width(value(along));
    features_.width_y = width(value(across));
  } else if (const int along_only = f.shape_index(Role::width); along_only >= 0) {
    features_.width_x = features_.width_y = value(along_only);
  } else {
    features_.width_x = features_.width_y = measured_width();
  }
  for (double* width : {&features_.width_x, &features_.width_y})
    *width = std::max(*width, kLeastWidth);  // a table may allow 0
  features_.root_at_horizon = measured_root();
  features_.oriented =
      f.all_round || (f.kink == Kink::unplaced && f.axes().across < 0 && measured_orientation());
  features_.is_polynomial = f.basis != nullptr;
  features_.mirror_lobe = f.kink == Kink::mirror_edge;
  // x^n at the edge of a narrow lobe is smooth to a higher order than a rule can resolve.
  features_.kink = features_.mirror_lobe && features_.width_x <= 0.08 ? Kink::none : f.kink;
  const double reach = kReach * std::max(features_.width_x, features_.width_y);
  const Vec3<double> normal{0, 0, 1};
  // Both axes are tested: a power at many times the smaller width is small, too.
  const Vec3<double> x = at_slope(kReach * features_.width_x), y = at_slope(kReach * features_.width_y);
  features_.compact = reach < 0.9 && std::max(sum_at(normal, x), sum_at(normal, {y.y, y.x, y.z})) <
                                         1e-24 * sum_at(normal, normal);
}

std::vector<double> Integrand::combine(std::span<const double> sums) const {
  std::vector<double> columns(sums.begin(), sums.end());
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (!std::isnan(constants_[c])) columns[c] = kPi * constants_[c];
  return weigh(std::move(columns));
}

std::vector<double> Integrand::combine_varying(std::span<const double> sums) const {
  std::vector<double> columns(sums.begin(), sums.end());
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (!std::isnan(constants_[c])) columns[c] = 0;
  return weigh(std::move(columns));
}

std::vector<double> Integrand::constant_outputs() const {
  return combine(std::vector<double>(columns_, 0.0));
}

std::vector<double> Integrand::weigh(std::vector<double> columns) const {
  const std::span<const LobeWeight> lobes = info(form_).lobes;
  if (lobes_only_ || lobes.empty()) return columns;
  std::vector<double> values;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    const std::vector<double> weight = linear_weights(info(form_), weights_[c]);
    double value = 0;
    for (std::size_t k = 0; k < weight.size(); ++k) value += weight[k] * columns[k];
    values.push_back(value);
  }
  return values;
}

void Integrand::evaluate(const Vec3<double>& fixed, std::size_t n, const double* x, const double* y,
                         const double* z, double* out) const {
  // A lobe about the fixed direction is moved to its mirror image, where the rules place their points: the
  // integral is the same.
  const double side = info(form_).about_light ? -1 : 1;
  std::array<double, kBlock> fixed_x, fixed_y, fixed_z;
  std::fill_n(fixed_x.begin(), n, side * fixed.x);
  std::fill_n(fixed_y.begin(), n, side * fixed.y);
  std::fill_n(fixed_z.begin(), n, fixed.z);
  const bool light_fixed = fixed_ == Fixed::light;
  const double* f[] = {fixed_x.data(), fixed_y.data(), fixed_z.data()};
  const Directions<double> pairs = light_fixed ? Directions<double>{f[0], f[1], f[2], x, y, z, n}
                                               : Directions<double>{x, y, z, f[0], f[1], f[2], n};
  if (info(form_).fittable()) {
    form_->lobes(shape_, Partial::none, pairs, {out, n});
  } else {
    // If the light moves, the form itself computes f cos_i. If the viewer moves, f is multiplied by the
    // cosine below.
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      const ParameterValues<double> values{weights_[c], weights_.back(), shape_, channels_[c]};
      if (light_fixed)
        form_->eval(values, pairs, out + c * n);
      else
        form_->eval_cos(values, pairs, out + c * n);
    }
    if (!light_fixed) return;
  }
  for (std::size_t c = 0; c < columns_; ++c)
    for (std::size_t j = 0; j < n; ++j) out[c * n + j] *= z[j];
}

std::vector<std::vector<std::size_t>> groups_of_one_shape(const Term& term) {
  std::vector<std::vector<std::size_t>> groups(term.shape.size() == 1 ? 1 : term.weights.size());
  for (std::size_t c = 0; c < term.weights.size(); ++c) groups[std::min(c, groups.size() - 1)].push_back(c);
  return groups;
}

// Adds several columns together, because an addition waits for the addition before it.
template <std::size_t N>
void NodeSum::add_columns(std::size_t first) {
  std::array<double, N> sum{};
  for (std::size_t j = 0; j < used_; ++j)
    for (std::size_t c = 0; c < N; ++c) sum[c] += weight_[j] * out_[(first + c) * used_ + j];
  for (std::size_t c = 0; c < N; ++c) sums_[first + c] += sum[c];
}

void NodeSum::flush() {
  if (used_ == 0) return;
  integrand_.evaluate(fixed_, used_, x_.data(), y_.data(), z_.data(), out_.data());
  std::size_t c = 0;
  for (; c + 4 <= sums_.size(); c += 4) add_columns<4>(c);
  for (; c + 2 <= sums_.size(); c += 2) add_columns<2>(c);
  for (; c < sums_.size(); ++c) add_columns<1>(c);
  evaluations_ += long(used_);
  used_ = 0;
}

}  // namespace brdf::integrals
