#include "shader/results.h"

#include <algorithm>
#include <array>

#include "io/files/numbers.h"
#include "io/files/text.h"
#include "shader/front/definitions.h"

namespace brdf::shader {
namespace {

using spirv::Kind;
using spirv::Module;

void add_leaves(const Module& m, spirv::Id type, const std::string& name, int argument, std::size_t first,
                std::vector<Leaf>& out, bool truths = false) {
  const spirv::Type& t = m.type(type);
  if (t.kind == Kind::number) out.push_back({name, {argument, first, 1}});
  if (t.kind == Kind::boolean && truths) out.push_back({name, {argument, first, 1}, true});
  if (t.kind == Kind::vector && t.count >= 3 && m.type(t.element).kind == Kind::number)
    out.push_back({name, {argument, first, 3}, false, t.count == 4});
  if (t.kind != Kind::structure) return;
  const auto names = m.member_names.find(type);
  for (std::size_t k = 0; k < t.members.size(); ++k) {
    if (m.type(t.members[k]).kind == Kind::opaque) return;
    std::string member = std::to_string(k);
    if (names != m.member_names.end())
      if (const auto found = names->second.find(std::uint32_t(k)); found != names->second.end())
        member = found->second;
    add_leaves(m, t.members[k], name.empty() ? member : name + "." + member, argument, first, out, truths);
    first += m.scalars(t.members[k]);
  }
}

// The text between the brackets after `name`, split at commas, for each place at which a body follows.
std::vector<std::vector<std::string>> definitions(const std::string& text, const std::string& name) {
  std::vector<std::vector<std::string>> out;
  for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
    std::size_t open = at + name.size();
    if ((at > 0 && is_word(text[at - 1])) || (open < text.size() && is_word(text[open]))) continue;
    open = text.find_first_not_of(" \t\n", open);
    if (open == text.npos || text[open] != '(') continue;
    const std::size_t close = text.find(')', open);
    if (close == text.npos) break;
    const std::size_t body = text.find_first_not_of(" \t\n", close + 1);
    if (body == text.npos || text[body] != '{') continue;
    std::vector<std::string_view> fields;
    const std::string inner = text.substr(open + 1, close - open - 1);
    io::split(inner, ',', fields);
    out.emplace_back(fields.begin(), fields.end());
  }
  return out;
}

// Arguments that the text declares as `out` or `inout`, and the subset that is `inout`.
struct Written {
  std::set<int> all, accumulated;
};
Written declared_out(const Module& m, const spirv::Function& f, const std::string& text) {
  for (const std::vector<std::string>& fields : definitions(text, f.name)) {
    if (fields.size() != f.parameters.size()) continue;
    Written out;
    bool same = true;
    for (std::size_t k = 0; k < fields.size() && same; ++k) {
      std::string spaced = fields[k];
      std::ranges::replace(spaced, '\n', ' ');
      std::vector<std::string_view> words;
      io::split_blanks(spaced, words);
      same = std::ranges::find(words, m.name(f.parameters[k])) != words.end();
      for (const std::string_view word : words) {
        if (word == "out" || word == "inout") out.all.insert(int(k));
        if (word == "inout") out.accumulated.insert(int(k));
      }
    }
    if (same) return out;
  }
  return {};
}

template <std::size_t N>
bool has_any(const std::string& name, const std::array<std::string_view, N>& words) {
  return std::ranges::any_of(words, [&](auto word) { return name.find(word) != name.npos; });
}

std::string last_of(const std::string& name) {
  return io::lower_case(name.substr(name.rfind('.') + 1));
}

constexpr std::array<std::string_view, 11> kOther{"indirect", "ambient", "transmi", "throughput",
                                                  "pdf",      "emissi",  "normal",  "weight",
                                                  "halfway",  "albedo",  "dir_"};
constexpr std::array<std::string_view, 8> kLobes{"diff", "spec",  "coat",       "sheen",
                                                 "fuzz", "retro", "subsurface", "sss"};
// Names of numbers that belong to a lobe but are not its value.
constexpr std::array<std::string_view, 13> kOfLobes{"rough", "power", "expon",  "occl",  "f90",
                                                    "f0",    "ior",   "factor", "stren", "shin",
                                                    "gloss", "level", "prob"};
constexpr std::array<std::string_view, 14> kValues{"f",        "fr",          "brdf",     "bsdf",  "bxdf",
                                                   "result",   "value",       "response", "color", "colour",
                                                   "radiance", "reflectance", "eval",     "rgb"};

std::vector<std::string> names_of(const std::vector<Leaf>& leaves) {
  std::vector<std::string> out;
  for (const Leaf& l : leaves) out.push_back(l.name);
  return out;
}

bool is_lobe(const Leaf& l) {
  return has_any(io::lower_case(l.name), kLobes);
}
bool is_value(const Leaf& l) {
  return std::ranges::find(kValues, last_of(l.name)) != kValues.end();
}

// Selects the values that are the reflectance: the only value, the value with a telling name, or all lobes
// together. A value that is not a lobe by its name, among values that are lobes, makes the choice
// ambiguous; the caller reports this.
void choose_leaves(std::vector<Leaf> leaves, const std::string& function, Results& out) {
  const std::vector<std::string> all = names_of(leaves);
  const auto keep = [&](auto&& is) {
    std::vector<Leaf> kept;
    std::copy_if(leaves.begin(), leaves.end(), std::back_inserter(kept), is);
    if (!kept.empty()) leaves = std::move(kept);
  };
  keep([](const Leaf& l) { return !has_any(io::lower_case(l.name), kOther); });
  // A number next to colours is one of their parameters, unless its name identifies a lobe.
  const bool colours = std::ranges::any_of(leaves, [](const Leaf& l) { return l.part.count == 3; });
  if (colours)
    keep([](const Leaf& l) {
      return l.part.count == 3 || (is_lobe(l) && !has_any(io::lower_case(l.name), kOfLobes));
    });
  out.named = std::ranges::any_of(leaves, [](const Leaf& l) { return is_lobe(l) || is_value(l); });
  const bool parts = std::ranges::any_of(leaves, is_lobe);
  if (leaves.size() > 1 && !parts) keep(is_value);
  if (leaves.size() > 1 && !std::ranges::all_of(leaves, is_lobe)) {
    out.several = io::joined(names_of(leaves));
    return;
  }
  for (const Leaf& l : leaves) out.parts.push_back(l.part);
  const std::vector<std::string> names = names_of(leaves);
  if (all.size() < 2 || names.empty()) return;
  std::vector<std::string> others;
  for (const std::string& name : all)
    if (std::ranges::find(names, name) == names.end()) others.push_back(name);
  out.note = "the reflectance is " + io::joined(names, " + ") + " of the results of " + function +
             (others.empty() ? "" : ", without " + io::joined(others));
}

}  // namespace

Given given_values(const Module& m, const spirv::Function& f, const Source& source) {
  Given out;
  if (m.type(f.type).kind != Kind::nothing) add_leaves(m, f.type, "", -1, 0, out.values, true);
  Written declared = declared_out(m, f, source.whole);
  out.accumulated = std::move(declared.accumulated);
  for (const int k : declared.all) {
    const spirv::Id type = f.parameter_types[std::size_t(k)];
    if (m.type(type).kind != Kind::pointer) continue;
    out.written.insert(k);
    add_leaves(m, m.type(type).element, m.name(f.parameters[std::size_t(k)]), k, 0, out.values, true);
  }
  return out;
}

Results results_of(const Module& m, const spirv::Function& f, const Source& source) {
  Results out;
  std::vector<Leaf> leaves;
  const spirv::Type& returned = m.type(f.type);
  const Written declared = declared_out(m, f, source.whole);
  out.written = declared.all;
  out.accumulated = declared.accumulated;
  if (returned.kind != Kind::nothing) {
    add_leaves(m, f.type, "", -1, 0, leaves);
    if (returned.kind != Kind::structure && !leaves.empty()) {
      out.parts = {leaves[0].part};
      std::vector<Leaf> beside;
      for (const int k : out.written) {
        const spirv::Id type = f.parameter_types[std::size_t(k)];
        if (m.type(type).kind == Kind::pointer)
          add_leaves(m, m.type(type).element, m.name(f.parameters[std::size_t(k)]), k, 0, beside);
      }
      std::erase_if(beside, [](const Leaf& l) { return !is_lobe(l) && !is_value(l); });
      if (!beside.empty())
        out.note = "the reflectance is the value returned by " + f.name + ", without " +
                   io::joined(names_of(beside));
      return out;
    }
  }
  if (returned.kind == Kind::nothing && out.written.empty() && !f.parameters.empty())
    out.written.insert(int(f.parameters.size()) - 1);
  std::erase_if(out.written,
                [&](int k) { return m.type(f.parameter_types[std::size_t(k)]).kind != Kind::pointer; });
  if (returned.kind == Kind::nothing)
    for (const int k : out.written)
      add_leaves(m, m.type(f.parameter_types[std::size_t(k)]).element, m.name(f.parameters[std::size_t(k)]),
                 k, 0, leaves);
  choose_leaves(std::move(leaves), f.name, out);
  return out;
}

}  // namespace brdf::shader
