#include "io/colour/spectrum.h"

#include <algorithm>
#include <cmath>

#include "io/colour/cie_tables.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

// Three functions of the wavelength in nm, linear between equidistant rows.
struct Functions {
  double first, step;
  std::vector<Tristimulus> rows;

  Tristimulus at(double nm) const {
    const double x = std::clamp((nm - first) / step, 0.0, double(rows.size() - 1));
    const std::size_t low = std::min(std::size_t(x), rows.size() - 2);
    const double t = x - double(low);
    Tristimulus value;
    for (std::size_t k = 0; k < 3; ++k) value[k] = (1 - t) * rows[low][k] + t * rows[low + 1][k];
    return value;
  }
};

Functions read_table(std::string_view text) {
  std::vector<double> wavelengths;
  Functions table{};
  std::vector<std::string_view> lines, fields;
  split(text, '\n', lines);
  for (const std::string_view line : lines) {
    split(line, ',', fields);
    double nm;
    Tristimulus values;
    if (fields.size() != 4 || !parse_number(fields[0], nm)) continue;  // a comment, or the header row
    for (std::size_t k = 0; k < 3; ++k) parse_number(fields[k + 1], values[k]);
    wavelengths.push_back(nm);
    table.rows.push_back(values);
  }
  table.first = wavelengths.at(0);
  table.step = wavelengths.at(1) - wavelengths[0];
  return table;
}

const Functions& observer() {
  static const Functions table = read_table(kObserverTable);
  return table;
}

// Returns the multipliers of S1 and S2. The temperature gives the chromaticity, which gives the
// multipliers; they are rounded to three decimals, as the CIE does.
std::array<double, 2> daylight_multipliers(double kelvin) {
  const double t = 1e3 / kelvin;
  const double x = kelvin <= 7000 ? 0.244063 + t * (0.09911 + t * (2.9678 - t * 4.6070))
                                  : 0.237040 + t * (0.24748 + t * (1.9018 - t * 2.0064));
  const double y = -3 * x * x + 2.87 * x - 0.275, below = 0.0241 + 0.2562 * x - 0.7341 * y;
  const auto rounded = [](double m) { return std::round(1e3 * m) / 1e3; };
  return {rounded((-1.3515 - 1.7703 * x + 5.9114 * y) / below),
          rounded((0.0300 - 31.4424 * x + 30.0717 * y) / below)};
}

// The place of a wavelength among others: between two of them, or on the nearest one.
struct Between {
  std::size_t low, high;
  double share;  // weight of `high`
};

Between find(std::span<const double> wavelengths, double nm) {
  const auto above = std::ranges::upper_bound(wavelengths, nm);
  const auto high = std::min(std::size_t(above - wavelengths.begin()), wavelengths.size() - 1);
  const std::size_t low = above == wavelengths.begin() ? 0 : std::size_t(above - wavelengths.begin()) - 1;
  const double gap = wavelengths[high] - wavelengths[low];
  return {low, high, gap > 0 ? (nm - wavelengths[low]) / gap : 0};
}

}  // namespace

std::vector<Tristimulus> xyz_weights(std::span<const double> wavelengths, double kelvin) {
  static const Functions daylight = read_table(kDaylightTable);
  const auto [m1, m2] = daylight_multipliers(kelvin);
  std::vector<Tristimulus> weights(wavelengths.size(), Tristimulus{});
  double white = 0;
  for (std::size_t k = 0; k < observer().rows.size(); ++k) {
    const double nm = observer().first + observer().step * double(k);
    const Tristimulus s = daylight.at(nm);
    const double light = s[0] + m1 * s[1] + m2 * s[2];
    const Between place = find(wavelengths, nm);
    for (std::size_t c = 0; c < 3; ++c) {
      const double part = light * observer().rows[k][c];
      weights[place.low][c] += (1 - place.share) * part;
      weights[place.high][c] += place.share * part;
    }
    white += light * observer().rows[k][1];
  }
  for (Tristimulus& w : weights)
    for (double& value : w) value /= white;
  return weights;
}

std::vector<Tristimulus> srgb_weights(std::span<const double> wavelengths) {
  constexpr double kFromXyz[3][3] = {{3.2404542, -1.5371385, -0.4985314},
                                     {-0.9692660, 1.8760108, 0.0415560},
                                     {0.0556434, -0.2040259, 1.0572252}};
  std::vector<Tristimulus> weights = xyz_weights(wavelengths, kD65);
  Tristimulus white{};
  for (Tristimulus& w : weights) {
    const Tristimulus xyz = w;
    for (std::size_t c = 0; c < 3; ++c) {
      w[c] = kFromXyz[c][0] * xyz[0] + kFromXyz[c][1] * xyz[1] + kFromXyz[c][2] * xyz[2];
      white[c] += w[c];
    }
  }
  for (Tristimulus& w : weights)
    for (std::size_t c = 0; c < 3; ++c) w[c] /= white[c];
  return weights;
}

}  // namespace brdf::io
