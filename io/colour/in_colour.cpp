#include "io/colour/in_colour.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/colour/spectrum.h"
#include "io/columns/wavelengths.h"
#include "io/files/error.h"

namespace brdf::io {
namespace {

std::vector<double> wavelengths_of(const std::vector<std::string>& channels) {
  std::vector<double> wavelengths;
  for (const std::string& channel : channels)
    if (const auto nm = wavelength_of(channel)) wavelengths.push_back(*nm);
  return wavelengths;
}

// Returns the contribution of each channel to red, green and blue, in the order of the channels.
std::vector<Tristimulus> channel_weights(const std::vector<std::string>& channels) {
  const std::vector<double> wavelengths = wavelengths_of(channels);
  std::vector<std::size_t> order(channels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return wavelengths[a] < wavelengths[b]; });
  std::vector<double> ascending;
  for (const std::size_t c : order) ascending.push_back(wavelengths[c]);
  const std::vector<Tristimulus> sorted = srgb_weights(ascending);
  std::vector<Tristimulus> weights(channels.size());
  for (std::size_t k = 0; k < order.size(); ++k) weights[order[k]] = sorted[k];
  return weights;
}

const std::vector<std::string> kRgb{"r", "g", "b"};

// One colour of a term: sums over the bands, weighted by `share`.
class ColourOf {
 public:
  ColourOf(const Term& term, const std::vector<Tristimulus>& weights, std::size_t colour)
      : term_(term), about_(info(term.form)) {
    for (const Tristimulus& w : weights) share_.push_back(w[colour]);
  }

  std::vector<double> weights() const {
    std::vector<double> sums;
    for (std::size_t k = 0; k < about_.weights.size(); ++k) {
      const bool divides = about_.weights[k].role == Role::f0;
      sums.push_back(limited(divides ? divided(k) : sum(k), about_.weights[k]));
    }
    return sums;
  }

  std::vector<double> shape() const {
    std::vector<double> mean(about_.shape.size(), 0.0);
    double total = 0;
    for (std::size_t band = 0; band < share_.size(); ++band) {
      const double count = std::abs(share_[band]);
      for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += count * term_.shape_of(band)[k];
      total += count;
    }
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] = limited(mean[k] / total, about_.shape[k]);
    return mean;
  }

 private:
  static double limited(double value, const ParameterInfo& parameter) {
    return std::clamp(value, parameter.min, parameter.max);
  }

  double sum(std::size_t weight) const {
    double total = 0;
    for (std::size_t band = 0; band < share_.size(); ++band)
      total += share_[band] * term_.weights[band][weight];
    return total;
  }

  // Returns the f0 for which f0 times its weight equals the sum of the products of the bands.
  double divided(std::size_t f0) const {
    const auto weight = std::size_t(weight_of_f0(about_.lobes));
    double products = 0;
    for (std::size_t band = 0; band < share_.size(); ++band)
      products += share_[band] * term_.weights[band][weight] * term_.weights[band][f0];
    const double whole = sum(weight);
    return whole > 0 ? products / whole : 0;
  }

  const Term& term_;
  const ReflectanceInfo& about_;
  std::vector<double> share_;
};

}  // namespace

bool is_spectrum(const std::vector<std::string>& channels) {
  std::vector<double> seen = wavelengths_of(channels);
  if (seen.size() != channels.size()) return false;
  std::erase_if(seen, [](double nm) { return nm < 380 || nm > 780; });
  if (seen.size() < 4) return false;
  const auto [low, high] = std::minmax_element(seen.begin(), seen.end());
  return *low <= 480 && *high >= 620;
}

SampleTable in_colour(SampleTable table) {
  if (!is_spectrum(table.channels)) return table;
  const std::vector<Tristimulus> weights = channel_weights(table.channels);
  bool has_sigma = true;
  for (std::size_t c = 0; c < table.channels.size(); ++c) has_sigma = has_sigma && table.has_sigma(c);
  std::vector<std::vector<double>> values(3, std::vector<double>(table.rows(), 0.0)), sigma(3);
  for (std::size_t colour = 0; colour < 3; ++colour) {
    if (has_sigma) sigma[colour].assign(table.rows(), 0.0);
    for (std::size_t c = 0; c < weights.size(); ++c) {
      for (std::size_t row = 0; row < table.rows(); ++row) {
        values[colour][row] += weights[c][colour] * table.values[c][row];
        if (has_sigma) sigma[colour][row] += std::pow(weights[c][colour] * table.sigma[c][row], 2);
      }
    }
    for (double& s : sigma[colour]) s = std::sqrt(s);
  }
  table.channels = kRgb;
  table.values = std::move(values);
  table.sigma = std::move(sigma);
  return table;
}

Material in_colour(const Material& material) {
  if (!is_spectrum(material.channels)) return material;
  const std::vector<Tristimulus> weights = channel_weights(material.channels);
  Material out{kRgb, {}};
  for (const Term& term : material.terms) {
    if (info(term.form).mixes_channels || !info(term.form).fittable())
      throw InputError(std::string(info(term.form).name) +
                       ": a spectrum of this form cannot be shown in colour");
    Term seen{term.form, {}, {}, term.tangent_phi};
    if (term.shape.size() <= 1) seen.shape = term.shape;
    for (std::size_t colour = 0; colour < 3; ++colour) {
      const ColourOf sums(term, weights, colour);
      seen.weights.push_back(sums.weights());
      if (term.shape.size() > 1) seen.shape.push_back(sums.shape());
    }
    out.terms.push_back(std::move(seen));
  }
  return out;
}

}  // namespace brdf::io
