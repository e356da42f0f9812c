#include "tests/fuzz/mutate.h"

#include <algorithm>
#include <cstring>
#include <random>
#include <vector>

namespace brdf::fuzz {
namespace {

using Engine = std::minstd_rand;

std::size_t below(Engine& engine, std::size_t count) {
  return count == 0 ? 0 : engine() % count;
}

enum class Kind { blank, word, number, sign, end };

struct Token {
  Kind kind;
  std::string text;
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

// Splits a text into tokens. Statements end with semicolons and braces, or at the ends of lines.
std::vector<Token> tokens_of(std::string_view text, bool by_lines) {
  std::vector<Token> out;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t stop = at + 1;
    Kind kind = Kind::sign;
    const auto run = [&](auto&& belongs) {
      while (stop < text.size() && belongs(text[stop])) ++stop;
    };
    if (is_letter(text[at])) {
      kind = Kind::word;
      run([](char c) { return is_letter(c) || is_digit(c); });
    } else if (is_digit(text[at])) {
      kind = Kind::number;
      run([](char c) { return is_digit(c) || c == '.' || c == 'e'; });
    } else if (by_lines && text[at] == '\n') {
      kind = Kind::end;
    } else if (text[at] == ' ' || text[at] == '\n' || text[at] == '\t') {
      kind = Kind::blank;
      run([&](char c) { return c == ' ' || (c == '\n' && !by_lines) || c == '\t'; });
    } else if (!by_lines && (text[at] == ';' || text[at] == '{' || text[at] == '}')) {
      kind = Kind::end;
    }
    out.push_back({kind, std::string(text.substr(at, stop - at))});
    at = stop;
  }
  return out;
}

std::string text_of(const std::vector<Token>& tokens) {
  std::string out;
  for (const Token& t : tokens) out += t.text;
  return out;
}

// Returns the statement that contains a token, including its end.
std::pair<std::size_t, std::size_t> statement(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t begin = at, stop = at;
  while (begin > 0 && tokens[begin - 1].kind != Kind::end) --begin;
  while (stop < tokens.size() && tokens[stop].kind != Kind::end) ++stop;
  return {begin, std::min(stop + 1, tokens.size())};
}

void change(std::vector<Token>& tokens, Engine& engine) {
  constexpr const char* kNumbers[] = {"0",     "1",  "0.0", "1.0",  "0.5",   "2.0",        "1e30",  "1e-30",
                                      "1e-40", "7u", "-1",  "64.0", "1e300", "16777217.0", "200000"};
  constexpr const char* kSigns[] = {"+", "-", "*", "/", "<", ">", "%", "&", "|", "^"};
  const std::size_t at = below(engine, tokens.size());
  Token& token = tokens[at];
  const std::size_t how = below(engine, 8);
  if (how == 0 || how == 1) {  // repeat or remove a statement
    const auto [begin, stop] = statement(tokens, at);
    const std::vector<Token> copy(tokens.begin() + long(begin), tokens.begin() + long(stop));
    if (how == 0)
      tokens.insert(tokens.begin() + long(statement(tokens, below(engine, tokens.size())).first),
                    copy.begin(), copy.end());
    else
      tokens.erase(tokens.begin() + long(begin), tokens.begin() + long(stop));
    return;
  }
  if (token.kind == Kind::number && how < 5) {
    token.text = kNumbers[below(engine, std::size(kNumbers))];
  } else if (token.kind == Kind::sign && how < 4 && token.text != "(" && token.text != ")") {
    token.text = kSigns[below(engine, std::size(kSigns))];
  } else {  // another token of its kind
    for (int k = 0; k < 20; ++k) {
      const Token& other = tokens[below(engine, tokens.size())];
      if (other.kind != token.kind || other.text == token.text) continue;
      token.text = std::string(other.text);
      return;
    }
  }
}

}  // namespace

bool is_text(std::string_view bytes) {
  return std::ranges::all_of(bytes, [](unsigned char c) { return c >= ' ' || (c >= '\t' && c <= '\r'); });
}

std::string mutate_text(std::string_view text, std::uint32_t seed) {
  Engine engine(seed);
  std::vector<Token> tokens = tokens_of(text, below(engine, 2) == 0);
  for (std::size_t k = 1 + below(engine, 4); k > 0 && !tokens.empty(); --k) change(tokens, engine);
  return text_of(tokens);
}

std::string mutate_bytes(std::string_view bytes, std::uint32_t seed) {
  constexpr std::size_t kLongest = 64;  // length of a run
  Engine engine(seed);
  std::string out(bytes);
  for (std::size_t k = 1 + below(engine, 4); k > 0 && !out.empty(); --k) {
    const std::size_t at = below(engine, out.size()), from = below(engine, out.size());
    const std::size_t length = 1 + below(engine, std::min(kLongest, out.size() - from));
    switch (below(engine, 5)) {
      case 0:
        out[at] = char(engine());
        break;
      case 1:
        out[at] = char(out[at] ^ (1 << below(engine, 8)));
        break;
      case 2:
        out.insert(at, out.substr(from, length));
        break;
      case 3:
        out.erase(from, length);
        break;
      default:
        out.replace(at, std::min(length, out.size() - at), out.substr(from, length));
    }
  }
  return out;
}

std::string mutate_spirv(std::string_view bytes, std::uint32_t seed) {
  Engine engine(seed);
  std::vector<std::uint32_t> words(bytes.size() / 4);
  if (words.empty()) return std::string(bytes);
  std::memcpy(words.data(), bytes.data(), words.size() * 4);
  std::vector<std::vector<std::uint32_t>> code;
  for (std::size_t at = 5; at < words.size();) {
    const std::size_t length = std::clamp<std::size_t>(words[at] >> 16, 1, words.size() - at);
    code.emplace_back(words.begin() + long(at), words.begin() + long(at + length));
    at += length;
  }
  for (std::size_t k = 1 + below(engine, 4); k > 0 && !code.empty(); --k) {
    auto& one = code[below(engine, code.size())];
    const auto& other = code[below(engine, code.size())];
    const std::size_t place = below(engine, one.size()), from = below(engine, other.size());
    switch (below(engine, 8)) {
      case 0:
        code.insert(code.begin() + long(below(engine, code.size())), std::vector(other));
        break;
      case 1:
        code.erase(code.begin() + (&one - code.data()));
        break;
      case 2:
        std::swap(code[below(engine, code.size())], code[below(engine, code.size())]);
        break;
      case 3:  // another operation on the same operands
        one[0] = (one[0] & 0xffff0000) | (other[0] & 0xffff);
        break;
      case 4:
        if (place > 0) one[place] = std::uint32_t(engine());
        break;
      case 5:
        if (place > 0) one[place] += below(engine, 2) ? 1u : ~0u;
        break;
      default:
        if (place > 0 && from > 0) one[place] = other[from];
    }
  }
  std::string out(bytes.substr(0, std::min<std::size_t>(bytes.size(), 20)));
  for (const auto& i : code) out.append(reinterpret_cast<const char*>(i.data()), i.size() * 4);
  return out;
}

}  // namespace brdf::fuzz
