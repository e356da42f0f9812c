#include "io/angle_names.h"

#include <array>
#include <map>
#include <utility>

#include "io/text.h"

namespace brdf::io {
namespace {

using Quantity = AngleName::Quantity;

constexpr std::array kLight{"i", "in",    "inc",          "incident", "incidence", "incoming",
                            "l", "light", "illumination", "sun",      "solar",     "source"};
constexpr std::array kViewer{"o",          "out",      "outgoing", "r",           "refl",    "reflected",
                             "reflection", "v",        "view",     "viewer",      "viewing", "det",
                             "detector",   "receiver", "observer", "observation", "e",       "exitant",
                             "emergence",  "scatter",  "scattered"};

std::map<std::string, AngleName> all_names() {
  std::map<std::string, AngleName> all;
  // A word and a side in either order, with or without "angle".
  const auto add = [&](const std::string& word, const std::string& side, AngleName said) {
    all[word + side] = all[side + word] = all[side + word + "angle"] = all[word + "angle" + side] = said;
  };
  const auto add_word = [&](const char* word, Quantity quantity) {
    for (const char* side : kLight) add(word, side, {quantity, AngleSide::light});
    for (const char* side : kViewer) add(word, side, {quantity, AngleSide::viewer});
    add(word, "s", {quantity, AngleSide::scatter_or_source});
  };
  for (const char* word : {"theta", "polar", "zenith"}) add_word(word, Quantity::polar);
  for (const char* word : {"elevation", "altitude"}) add_word(word, Quantity::elevation);
  for (const char* word : {"phi", "azimuth", "azim", "az"}) add_word(word, Quantity::azimuth);
  for (const char* name :
       {"incidence", "incident", "incidenceangle", "incidentangle", "angleofincidence", "aoi", "sza"})
    all[name] = {Quantity::polar, AngleSide::light};
  for (const char* name :
       {"emergence", "emergenceangle", "viewingangle", "viewangle", "observationangle", "scatterangle",
        "scatteringangle", "detectorangle", "reflectionangle", "angleofreflection", "vza"})
    all[name] = {Quantity::polar, AngleSide::viewer};
  for (const char* name :
       {"phi", "azimuth", "azimuthangle", "dphi", "deltaphi", "relativephi", "relativeazimuth",
        "relativeazimuthangle", "azimuthdifference", "deltaazimuth", "raa"})
    all[name] = {Quantity::azimuth, AngleSide::none};
  all["saa"] = {Quantity::azimuth, AngleSide::light};
  all["vaa"] = {Quantity::azimuth, AngleSide::viewer};
  return all;
}

}  // namespace

std::string plain_spelling(std::string_view name) {
  std::string text = lower_case(name);
  constexpr std::pair<std::string_view, std::string_view> kGreek[] = {
      {"θ", "theta"}, {"ϑ", "theta"},  {"Θ", "theta"}, {"φ", "phi"},   {"ϕ", "phi"},
      {"Φ", "phi"},   {"λ", "lambda"}, {"Δ", "delta"}, {"σ", "sigma"}, {"ᵢ", "i"}};
  for (const auto& [letter, word] : kGreek)
    for (std::size_t at; (at = text.find(letter)) != text.npos;) text.replace(at, letter.size(), word);
  std::erase_if(text, [](char c) { return c == ' ' || c == '_' || c == '-' || c == '.'; });
  return text;
}

std::optional<AngleName> angle_named(std::string_view name) {
  static const std::map<std::string, AngleName> names = all_names();
  const auto found = names.find(plain_spelling(name));
  if (found == names.end()) return std::nullopt;
  return found->second;
}

}  // namespace brdf::io
