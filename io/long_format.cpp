#include "io/long_format.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

#include "io/error.h"
#include "io/limits.h"
#include "io/text.h"

namespace brdf::io {
namespace {

using Rows = std::vector<std::size_t>;
// The rows of one pair of directions, by wavelength.
using Pair = std::span<const std::size_t>;

std::vector<double> each_once(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

auto directions_of(const SampleTable& table, std::size_t row) {
  return std::tuple(table.theta_i[row], table.phi_i[row], table.theta_o[row], table.phi_o[row]);
}

// All rows by directions, then by wavelength, then in the file's order.
Rows sorted_rows(const SampleTable& table, const std::vector<double>& wavelengths) {
  Rows rows(table.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(directions_of(table, a), wavelengths[a], a) <
           std::tuple(directions_of(table, b), wavelengths[b], b);
  });
  return rows;
}

std::size_t first_row(Pair pair) {
  return *std::min_element(pair.begin(), pair.end());
}

// In the order of their first rows.
std::vector<Pair> pairs_of(const SampleTable& table, const Rows& sorted) {
  std::vector<Pair> pairs;
  for (auto begin = sorted.begin(); begin != sorted.end();) {
    const auto end = std::find_if(begin, sorted.end(), [&](std::size_t row) {
      return directions_of(table, row) != directions_of(table, *begin);
    });
    pairs.emplace_back(begin, end);
    begin = end;
  }
  std::sort(pairs.begin(), pairs.end(), [](Pair a, Pair b) { return first_row(a) < first_row(b); });
  return pairs;
}

// Each wavelength once, for every pair: memory is asked for only after this.
void check_pair(const SampleTable& table, const std::vector<double>& wavelengths,
                const std::vector<double>& bands, Pair pair) {
  const auto refuse = [&](std::size_t row, const std::string& what) {
    throw InputError(table.where(row) + ": these directions have " + what);
  };
  for (std::size_t k = 0; k < pair.size(); ++k) {
    const double nm = wavelengths[pair[k]];
    if (k > 0 && nm == wavelengths[pair[k - 1]])
      refuse(pair[k], "the wavelength " + to_text(nm) + " nm twice");
    if (nm != bands[k])
      refuse(first_row(pair), "no value at " + to_text(bands[k]) + " nm, which others have");
  }
  if (pair.size() < bands.size())
    refuse(first_row(pair), "no value at " + to_text(bands[pair.size()]) + " nm, which others have");
}

void take_column(const std::vector<double>& narrow, const std::vector<Pair>& pairs, std::size_t band,
                 std::vector<double>& wide) {
  wide.reserve(pairs.size());
  for (const Pair pair : pairs) wide.push_back(narrow[pair[band]]);
}

}  // namespace

SampleTable widened(const SampleTable& narrow, const std::vector<double>& wavelengths) {
  const std::vector<double> bands = each_once(wavelengths);
  if (bands.size() > kMostChannels)
    throw InputError(narrow.name() + ": " + std::to_string(bands.size()) + " wavelengths are more than " +
                     std::to_string(kMostChannels));
  const Rows sorted = sorted_rows(narrow, wavelengths);
  const std::vector<Pair> pairs = pairs_of(narrow, sorted);
  const bool has_values = !narrow.channels.empty();
  if (has_values)
    for (const Pair pair : pairs) check_pair(narrow, wavelengths, bands, pair);

  SampleTable wide;
  wide.metadata = narrow.metadata;
  wide.source = narrow.source;
  wide.warnings = narrow.warnings;
  wide.skipped = narrow.skipped;
  for (const Pair pair : pairs) {
    const std::size_t row = first_row(pair);
    wide.add_directions(narrow.theta_i[row], narrow.phi_i[row], narrow.theta_o[row], narrow.phi_o[row]);
    wide.lines.push_back(narrow.lines[row]);
  }
  if (!has_values) return wide;
  wide.values.resize(bands.size());
  wide.sigma.resize(bands.size());
  for (std::size_t band = 0; band < bands.size(); ++band) {
    wide.channels.push_back(to_text(bands[band]) + "nm");
    take_column(narrow.values[0], pairs, band, wide.values[band]);
    if (narrow.has_sigma(0)) take_column(narrow.sigma[0], pairs, band, wide.sigma[band]);
  }
  wide.warnings.push_back("long format: " + std::to_string(narrow.rows()) + " rows of " +
                          std::to_string(bands.size()) + " wavelengths, " + to_text(bands.front()) + " to " +
                          to_text(bands.back()) + " nm");
  return wide;
}

}  // namespace brdf::io
