#include "io/csv/long_format.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "io/files/error.h"
#include "io/files/limits.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/samples/to_f_r.h"

namespace brdf::io {
namespace {

using Rows = std::vector<std::size_t>;
// The rows of one pair of directions, by band; rows of the same band are in the file's order.
using Pair = std::span<const std::size_t>;

std::vector<Band> each_once(std::vector<Band> bands) {
  std::ranges::sort(bands);
  bands.erase(std::unique(bands.begin(), bands.end()), bands.end());
  return bands;
}

std::size_t first_row(Pair pair) {
  return *std::ranges::min_element(pair);
}

// All rows, ordered by directions, then by band, then in the file's order; and the pairs of directions, in
// the order of their first rows.
struct Sorted {
  Rows rows;
  std::vector<Pair> pairs;
};

// `bands`: all bands, in order. Sorts copies of the angles: a sort of row numbers alone would miss the cache
// at each comparison and takes ten times as long for millions of rows.
Sorted sorted_pairs(const SampleTable& table, const std::vector<Band>& of_rows,
                    const std::vector<Band>& bands) {
  struct Key {
    std::array<double, 4> directions;
    std::uint32_t band, row;
  };
  static_assert(kMostRows <= std::numeric_limits<std::uint32_t>::max());
  std::vector<Key> keys(table.rows());
  for (std::size_t k = 0; k < keys.size(); ++k)
    keys[k] = {{table.theta_i[k], table.phi_i[k], table.theta_o[k], table.phi_o[k]},
               std::uint32_t(std::ranges::lower_bound(bands, of_rows[k]) - bands.begin()),
               std::uint32_t(k)};
  std::ranges::sort(keys, [](const Key& a, const Key& b) {
    return std::tie(a.directions, a.band, a.row) < std::tie(b.directions, b.band, b.row);
  });
  Sorted out;
  out.rows.reserve(keys.size());
  for (const Key& key : keys) out.rows.push_back(key.row);
  std::vector<std::pair<std::size_t, Pair>> pairs;  // each with its first row
  for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
    while (end < keys.size() && keys[end].directions == keys[begin].directions) ++end;
    const Pair pair(out.rows.data() + begin, end - begin);
    pairs.emplace_back(first_row(pair), pair);
  }
  std::ranges::sort(pairs, {}, &std::pair<std::size_t, Pair>::first);
  for (const auto& [first, pair] : pairs) out.pairs.push_back(pair);
  return out;
}

std::string words_of(const Band& band) {
  const std::string nm = band.nm > 0 ? to_text(band.nm) + " nm" : "";
  const std::string polarisation = band.polarisation ? std::string(name_of(*band.polarisation)) : "";
  return nm + (nm.empty() || polarisation.empty() ? "" : ", ") + polarisation;
}

std::string channel_of(const Band& band, const std::string& values) {
  const std::string nm = band.nm > 0 ? to_text(band.nm) + "nm" : "";
  if (!band.polarisation) return nm.empty() ? values : nm;
  const std::string polarisation(name_of(*band.polarisation));
  return nm.empty() ? values + "_" + polarisation : polarisation + "_" + nm;
}

// Returns the number of times that the pair was measured. Throws InputError unless all bands have the same
// number. Memory for the result is allocated only after this check.
std::size_t times_measured(const SampleTable& table, const std::vector<Band>& of_rows,
                           const std::vector<Band>& bands, Pair pair) {
  std::vector<std::size_t> times;
  for (std::size_t k = 0; k < pair.size();) {
    const Band& band = of_rows[pair[k]];
    if (band != bands[times.size()]) break;
    times.push_back(0);
    for (; k < pair.size() && of_rows[pair[k]] == band; ++k) ++times.back();
    if (times.back() != times.front())
      throw InputError(table.where(pair[k - 1]) + ": rows of these directions at " + words_of(band) + ": " +
                       std::to_string(times.back()) + ", at " + words_of(bands.front()) + ": " +
                       std::to_string(times.front()));
  }
  if (times.size() < bands.size())
    throw InputError(table.where(first_row(pair)) + ": these directions have no value at " +
                     words_of(bands[times.size()]) + ", but other directions have one");
  return times.front();
}

// Returns whether a pair has every band, each equally often.
bool has_all_bands(const std::vector<Band>& of_rows, const std::vector<Band>& bands, Pair pair) {
  if (pair.size() % bands.size() != 0) return false;
  const std::size_t times = pair.size() / bands.size();
  for (std::size_t k = 0; k < pair.size(); ++k)
    if (of_rows[pair[k]] != bands[k / times]) return false;
  return true;
}

// Returns the warnings of `narrow` and a sentence on the long format.
std::vector<std::string> warnings_of(const SampleTable& narrow, const std::vector<Band>& bands) {
  const Band &first = bands.front(), &last = bands.back();
  const std::string count = std::to_string(bands.size());
  const std::string what =
      bands.size() == 1     ? "1 band" + (words_of(first).empty() ? "" : ", " + words_of(first))
      : !first.polarisation ? count + " wavelengths, " + to_text(first.nm) + " to " + words_of(last)
                            : count + " bands, " + words_of(first) + " to " + words_of(last);
  std::vector<std::string> warnings = narrow.warnings;
  warnings.push_back("long format: " + plural(narrow.rows(), "row") + " of " + what);
  return warnings;
}

// The rows of a pair, `times` for each band, as rows of all bands.
struct Measured {
  Pair pair;
  std::size_t times;
  std::size_t row(std::size_t band, std::size_t time) const { return pair[band * times + time]; }
};

void take_column(const std::vector<double>& narrow, const std::vector<Measured>& all, std::size_t band,
                 std::vector<double>& wide) {
  for (const Measured& measured : all)
    for (std::size_t t = 0; t < measured.times; ++t) wide.push_back(narrow[measured.row(band, t)]);
}

void add_rows(const SampleTable& narrow, const std::vector<Measured>& all, SampleTable& wide) {
  for (const Measured& measured : all) {
    const std::size_t row = first_row(measured.pair);
    for (std::size_t t = 0; t < measured.times; ++t) {
      wide.add_directions(narrow.theta_i[row], narrow.phi_i[row], narrow.theta_o[row], narrow.phi_o[row]);
      if (!narrow.lines.empty())
        wide.lines.push_back(t == 0 ? narrow.lines[row] : narrow.lines[measured.row(0, t)]);
    }
  }
}

}  // namespace

std::size_t leave_out_incomplete(SampleTable& narrow, std::vector<Band>& of_rows) {
  const std::vector<Band> bands = each_once(of_rows);
  const Sorted sorted = sorted_pairs(narrow, of_rows, bands);
  Rows kept;
  std::size_t incomplete = 0;
  for (const Pair pair : sorted.pairs) {
    if (has_all_bands(of_rows, bands, pair))
      kept.insert(kept.end(), pair.begin(), pair.end());
    else
      ++incomplete;
  }
  if (incomplete == 0) return 0;
  std::sort(kept.begin(), kept.end());
  for (std::size_t k = 0; k < kept.size(); ++k) of_rows[k] = of_rows[kept[k]];
  of_rows.resize(kept.size());
  keep_rows(narrow, kept);
  return incomplete;
}

SampleTable widened(const SampleTable& narrow, const std::vector<Band>& of_rows) {
  const std::vector<Band> bands = each_once(of_rows);
  if (bands.size() > kMostChannels)
    throw InputError(narrow.name() + ": " + std::to_string(bands.size()) +
                     " wavelengths exceed the limit of " + std::to_string(kMostChannels));
  const Sorted sorted = sorted_pairs(narrow, of_rows, bands);
  const bool has_values = !narrow.channels.empty();
  std::vector<Measured> all;
  for (const Pair pair : sorted.pairs)
    all.push_back({pair, has_values ? times_measured(narrow, of_rows, bands, pair) : 1});

  SampleTable wide;
  wide.metadata = narrow.metadata;
  wide.source = narrow.source;
  wide.format = narrow.format;
  wide.warnings = has_values ? warnings_of(narrow, bands) : narrow.warnings;
  wide.skipped = narrow.skipped;
  wide.raw_angles = narrow.raw_angles;
  wide.assumptions = narrow.assumptions;
  add_rows(narrow, all, wide);
  if (!has_values) return wide;
  wide.values.resize(bands.size());
  wide.sigma.resize(bands.size());
  for (std::size_t band = 0; band < bands.size(); ++band) {
    wide.channels.push_back(channel_of(bands[band], narrow.channels[0]));
    take_column(narrow.values[0], all, band, wide.values[band]);
    if (narrow.has_sigma(0)) take_column(narrow.sigma[0], all, band, wide.sigma[band]);
  }
  return wide;
}

}  // namespace brdf::io
