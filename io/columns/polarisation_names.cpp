#include "io/columns/polarisation_names.h"

#include <algorithm>
#include <functional>
#include <map>
#include <vector>

#include "io/columns/angle_names.h"
#include "io/columns/units.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

using P = Polarisation;

// Returns the words of a name in order.
std::vector<std::string_view> words_of(std::string_view name) {
  constexpr std::string_view kBetween = " \t_-()[]";
  std::vector<std::string_view> words;
  for (std::size_t begin; (begin = name.find_first_not_of(kBetween)) != name.npos;) {
    const std::size_t end = std::min(name.find_first_of(kBetween, begin), name.size());
    words.push_back(name.substr(begin, end - begin));
    name.remove_prefix(end);
  }
  return words;
}

bool only_says_so(const std::string& word) {
  return word == "pol" || word == "polarised" || word == "polarized" || word == "polarisation" ||
         word == "polarization";
}

std::optional<P> one_word(const std::string& word) {
  static const std::map<std::string, P, std::less<>> kWords{
      {"s", P::s},    {"te", P::s},        {"perpendicular", P::s},
      {"spol", P::s}, {"senkrecht", P::s}, {"p", P::p},
      {"tm", P::p},   {"ppol", P::p},      {"parallel", P::p},
      {"ss", P::ss},  {"sp", P::sp},       {"ps", P::ps},
      {"pp", P::pp}};
  const auto found = kWords.find(word);
  if (found == kWords.end()) return std::nullopt;
  return found->second;
}

struct Words {
  std::optional<P> of;
  std::vector<std::string_view> rest;
};

// Separates the polarisation from the other words. Returns std::nullopt if two words are polarisations.
std::optional<Words> understood(std::string_view name) {
  Words out;
  for (const std::string_view word : words_of(name)) {
    const std::string key = lower_case(word);
    const std::optional<P> of = one_word(key);
    if (of && out.of) return std::nullopt;
    if (of)
      out.of = of;
    else if (!only_says_so(key))
      out.rest.push_back(word);
  }
  return out;
}

}  // namespace

std::optional<Polarisation> polarisation_named(std::string_view word) {
  const std::optional<Words> words = understood(word);
  return words && words->rest.empty() ? words->of : std::nullopt;
}

PolarisedName polarised_name(std::string_view channel) {
  const std::optional<Words> words = understood(channel);
  if (!words || !words->of) return {std::string(channel), std::nullopt};
  std::string name;
  for (const std::string_view word : words->rest) (name += name.empty() ? "" : "_") += word;
  return {name.empty() ? "fr" : name, words->of};
}

bool is_polarisation_name(std::string_view name) {
  const std::string key = plain_spelling(name);
  return key == "polarisation" || key == "polarization";
}

}  // namespace brdf::io
