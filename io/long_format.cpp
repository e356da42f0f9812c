#include "io/long_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "io/error.h"
#include "io/limits.h"
#include "io/text.h"

namespace brdf::io {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<double> each_once(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

}  // namespace

SampleTable widened(SampleTable narrow, const std::vector<double>& wavelengths) {
  const std::vector<double> bands = each_once(wavelengths);
  const auto refuse = [&](std::size_t row, const std::string& what) {
    throw InputError(narrow.where(row) + ": " + what);
  };
  if (bands.size() > kMostChannels)
    throw InputError(narrow.name() + ": " + std::to_string(bands.size()) + " wavelengths are more than " +
                     std::to_string(kMostChannels));
  const bool has_values = !narrow.channels.empty(), has_sigma = narrow.has_sigma(0);
  SampleTable wide;
  wide.metadata = narrow.metadata;
  wide.source = narrow.source;
  wide.warnings = narrow.warnings;
  wide.skipped = narrow.skipped;
  if (has_values)
    for (const double nm : bands) wide.channels.push_back(to_text(nm) + "nm");
  wide.values.resize(wide.channels.size());
  wide.sigma.resize(wide.channels.size());

  std::map<std::array<double, 4>, std::size_t> pairs;
  std::vector<std::size_t> first;  // row of `narrow` that a pair came from
  for (std::size_t k = 0; k < narrow.rows(); ++k) {
    const std::array directions{narrow.theta_i[k], narrow.phi_i[k], narrow.theta_o[k], narrow.phi_o[k]};
    const auto [place, is_new] = pairs.emplace(directions, wide.rows());
    if (is_new) {
      wide.add_directions(directions[0], directions[1], directions[2], directions[3]);
      wide.lines.push_back(narrow.lines[k]);
      first.push_back(k);
      for (auto& column : wide.values) column.push_back(kNone);
      if (has_sigma)
        for (auto& column : wide.sigma) column.push_back(kNone);
    }
    if (!has_values) continue;
    const auto band = static_cast<std::size_t>(std::lower_bound(bands.begin(), bands.end(), wavelengths[k]) -
                                               bands.begin());
    double& value = wide.values[band][place->second];
    if (!std::isnan(value))
      refuse(k, "these directions have the wavelength " + to_text(wavelengths[k]) + " nm twice");
    value = narrow.values[0][k];
    if (has_sigma) wide.sigma[band][place->second] = narrow.sigma[0][k];
  }
  for (std::size_t c = 0; c < wide.values.size(); ++c)
    for (std::size_t k = 0; k < wide.rows(); ++k)
      if (std::isnan(wide.values[c][k]))
        refuse(first[k], "these directions have no value at " + to_text(bands[c]) + " nm, which others have");
  if (has_values)
    wide.warnings.push_back("long format: " + std::to_string(narrow.rows()) + " rows of " +
                            std::to_string(bands.size()) + " wavelengths, " + to_text(bands.front()) +
                            " to " + to_text(bands.back()) + " nm");
  return wide;
}

}  // namespace brdf::io
