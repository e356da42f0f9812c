#include "io/columns/value_names.h"

#include <algorithm>
#include <string_view>

#include "io/columns/angle_names.h"
#include "io/columns/name_tokens.h"
#include "io/columns/plain_names.h"
#include "io/files/text.h"

namespace brdf::io {

namespace {

bool is_word(const Token& token, std::initializer_list<const char*> words) {
  return token.type == Token::Type::word && std::ranges::find(words, token.text) != words.end();
}

// Removes "relative", "expanded", "(k=2)" and similar words of an uncertainty from its name. Sets the
// facts that the words give.
std::string without_words(const std::string& name, UncertaintyWords& facts) {
  const std::vector<Token> tokens = tokens_of(name);
  std::string rest;
  bool is_expanded = false, has_factor = false;
  std::size_t kept = 0;  // bytes of the name that are copied or removed
  const auto remove = [&](std::size_t first, std::size_t last) {
    rest += name.substr(kept, tokens[first].begin - kept);
    kept = tokens[last].end;
  };
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    const bool is_factor = k + 2 < tokens.size() && tokens[k].text.size() == 1 &&
                           tokens[k].text.front() == 'k' && tokens[k + 1].text == "=" &&
                           tokens[k + 2].type == Token::Type::number;
    if (is_factor) {
      has_factor = parse_number(tokens[k + 2].text, facts.coverage);
      const std::size_t first = k > 0 && is_silent(tokens[k - 1]) ? k - 1 : k;
      k += k + 3 < tokens.size() && is_silent(tokens[k + 3]) ? 3 : 2;
      remove(first, k);
    } else if (is_word(tokens[k], {"relative", "rel"})) {
      facts.is_relative = true;
      const std::size_t first = k;
      k += k + 1 < tokens.size() && tokens[k + 1].text == ".";
      remove(first, k);
    } else if (is_word(tokens[k], {"expanded", "extended"})) {
      is_expanded = true;
      remove(k, k);
    }
  }
  if (is_expanded && !has_factor) facts.coverage = 0;
  return std::string(trimmed(rest + name.substr(kept)));
}

}  // namespace

UncertaintyWords uncertainty_words(const std::string& name) {
  UncertaintyWords facts;
  if (!name.starts_with(kSigmaPrefix)) without_words(name, facts);
  return facts;
}

std::optional<std::string> deviation_of(const std::string& written) {
  if (written.starts_with(kSigmaPrefix)) return written.substr(kSigmaPrefix.size());
  UncertaintyWords facts;
  const std::string name = without_words(written, facts);
  if (name.size() == 1 && (name == "U" || name == "u") && name != written) return "";
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

std::string mueller_place(const std::string& name) {
  std::string key = plain_spelling(name.substr(0, name.find('/')));
  for (const char* prefix : {"mueller", "fr", "f", "m", "s"})
    if (key.starts_with(prefix)) {
      key.erase(0, std::string_view(prefix).size());
      const bool is_place = key.size() == 2 && key.find_first_not_of("01234") == key.npos;
      return is_place ? key : "";
    }
  return "";
}

}  // namespace brdf::io
