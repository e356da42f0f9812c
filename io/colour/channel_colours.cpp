#include "io/colour/channel_colours.h"

#include <algorithm>
#include <cmath>

#include "io/colour/in_colour.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

constexpr std::array<std::array<std::string_view, 2>, 3> kColours{
    {{"r", "red"}, {"g", "green"}, {"b", "blue"}}};
constexpr std::array kPrimaries{611.0, 549.0, 464.0};  // nm

using Three = std::array<std::size_t, 3>;

// Returns std::nullopt unless every colour is the name of exactly one channel.
std::optional<Three> by_name(const std::vector<std::string>& channels) {
  Three found{};
  std::array<int, 3> times{};
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const std::string name = lower_case(channels[c]);
    for (std::size_t k = 0; k < 3; ++k)
      if (name == kColours[k][0] || name == kColours[k][1]) {
        found[k] = c;
        ++times[k];
      }
  }
  return times == std::array{1, 1, 1} ? std::optional(found) : std::nullopt;
}

std::optional<Three> by_wavelength(const std::vector<std::string>& channels) {
  std::vector<std::pair<double, std::size_t>> known;
  for (std::size_t c = 0; c < channels.size(); ++c)
    if (const auto nm = wavelength_of(channels[c])) known.emplace_back(*nm, c);
  std::sort(known.rbegin(), known.rend());
  Three found{};
  for (std::size_t k = 0; k < 3 && known.size() >= 3; ++k) {
    const auto distance = [&](const auto& entry) { return std::abs(entry.first - kPrimaries[k]); };
    const auto nearest = known.size() == 3
                             ? known.begin() + std::ptrdiff_t(k)
                             : std::ranges::min_element(known, [&](const auto& a, const auto& b) {
                                 return distance(a) < distance(b);
                               });
    found[k] = nearest->second;
  }
  const auto nm = [&](std::size_t k) { return *wavelength_of(channels[found[k]]); };
  if (known.size() < 3 || !(nm(0) > nm(1) && nm(1) > nm(2))) return std::nullopt;
  return found;
}

}  // namespace

std::optional<ChannelColours> channel_colours(const std::vector<std::string>& channels) {
  using By = ChannelColours::By;
  if (channels.size() == 1) return ChannelColours{{0, 0, 0}, By::grey, ""};
  ChannelColours out{{0, 1, 2}, By::position, ""};
  if (const auto named = by_name(channels))
    out = {*named, By::name, ""};
  else if (const auto sorted = by_wavelength(channels))
    out = {*sorted, is_spectrum(channels) ? By::spectrum : By::wavelength, ""};
  else if (channels.size() != 3)
    return std::nullopt;
  if (out.by == By::name && channels.size() == 3) return out;
  if (out.by == By::spectrum) {
    out.note = std::to_string(channels.size()) + " bands are converted to a colour (CIE 1931, D65)";
    return out;
  }
  std::vector<std::string> names;
  for (const std::size_t c : out.of) names.push_back(printable(channels[c]));
  out.note = "channels " + joined(names) + " are used as red, green, blue";
  if (out.by == By::wavelength) out.note += " by their wavelengths";
  if (out.by == By::position) out.note += " by their position, because their names contain no colour";
  if (channels.size() > 3) out.note += "; the other " + std::to_string(channels.size() - 3) + " are left out";
  return out;
}

void require_red_first(const Term& term, const ChannelColours& colours) {
  if (info(term.form).mixes_channels && colours.of[0] != 0)
    throw InputError(std::string(info(term.form).name) +
                     " combines channels by their order: the first channel must be red");
}

}  // namespace brdf::io
