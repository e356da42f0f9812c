#include "io/columns/value_names.h"

#include <algorithm>
#include <string_view>

#include "io/columns/angle_names.h"
#include "io/columns/plain_names.h"
#include "io/files/text.h"

namespace brdf::io {

std::optional<std::string> deviation_of(const std::string& name) {
  if (name.starts_with(kSigmaPrefix)) return name.substr(kSigmaPrefix.size());
  constexpr std::string_view kWords[] = {"standard deviation",
                                         "standard uncertainty",
                                         "standard error",
                                         "uncertainty",
                                         "sigma",
                                         "stdev",
                                         "stddev",
                                         "std dev",
                                         "std",
                                         "sd",
                                         "unc",
                                         "error",
                                         "err",
                                         "u"};
  std::string lower = lower_case(name);
  std::ranges::replace_if(
      lower, [](char c) { return c == '_' || c == '-'; }, ' ');
  for (const std::string_view word : kWords) {
    const std::size_t size = word.size();
    if (lower == word && size > 1) return "";
    if (lower.size() <= size + 1) continue;
    if (lower.starts_with(word) && (lower[size] == ' ' || lower[size] == '(')) {
      std::string rest(trimmed(std::string_view(name).substr(size + 1)));
      if (lower[size] == '(' && rest.ends_with(')')) rest.pop_back();
      return lower.ends_with("(k=1)") ? "" : rest;
    }
    if (lower.ends_with(word) && lower[lower.size() - size - 1] == ' ')
      return std::string(trimmed(std::string_view(name).substr(0, name.size() - size - 1)));
  }
  return std::nullopt;
}

std::string mueller_element(const std::string& name) {
  std::string key = plain_spelling(name.substr(0, name.find('/')));
  for (const char* prefix : {"mueller", "fr", "f", "m"})
    if (key.starts_with(prefix)) {
      key.erase(0, std::string_view(prefix).size());
      const bool is_place = key.size() == 2 && key.find_first_not_of("1234") == key.npos;
      return is_place ? key : "";
    }
  return "";
}

}  // namespace brdf::io
