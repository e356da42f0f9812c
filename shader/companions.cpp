#include "shader/companions.h"

#include <algorithm>
#include <array>
#include <glslang/SPIRV/spirv.hpp>
#include <string_view>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "shader/front/roles.h"

namespace brdf::shader {
namespace {

using spirv::Kind;
using spirv::Module;

template <std::size_t N>
bool holds_any(std::string_view name, const std::array<std::string_view, N>& words) {
  return std::ranges::any_of(words, [&](auto word) { return name.find(word) != name.npos; });
}

// In lower case, without underscores and without the struct of a member function.
std::string plain_name(const std::string& name) {
  std::string out = io::lower_case(name.substr(name.rfind(':') + 1));
  std::erase(out, '_');
  return out;
}

// Erases a word that is a single f, as in f_diffuse, fDiffuse and Sample_f.
std::string without_f(const std::string& name) {
  std::string out;
  const bool joined = name.size() > 1 && name[0] == 'f' && name[1] >= 'A' && name[1] <= 'Z';
  for (std::size_t from = joined ? 1 : 0; from <= name.size();) {
    const std::size_t to = std::min(name.find('_', from), name.size());
    if (const std::string word = name.substr(from, to - from); word != "f" && word != "F") out += word + "_";
    from = to + 1;
  }
  return out;
}

// The rest of a name without the words for its task, which is equal for functions that belong together.
std::string stem_of(const std::string& name) {
  std::string out = plain_name(without_f(name.substr(name.rfind(':') + 1)));
  for (const std::string_view word :
       {"importance", "evaluate", "eval", "sampling", "sample", "generate", "brdf", "bsdf", "bxdf", "pdf",
        "density", "probability", "get", "direction", "dir", "value"})
    for (std::size_t at; (at = out.find(word)) != out.npos;) out.erase(at, word.size());
  return out;
}

std::string last_word_of(const std::string& name) {
  return plain_name(name.substr(name.rfind('.') + 1));
}

bool is_pdf(const Leaf& leaf) {
  constexpr std::array<std::string_view, 2> kWords{"pdf", "density"};
  const std::string word = last_word_of(leaf.name);
  return leaf.part.count == 1 && !leaf.truth && holds_any(word, kWords) && word.find("over") == word.npos;
}

// The density among the results: the one with the name pdf, before those of single lobes such as specularPdf.
std::vector<Leaf>::const_iterator pdf_of(const std::vector<Leaf>& leaves) {
  const auto whole =
      std::ranges::find_if(leaves, [](const Leaf& l) { return is_pdf(l) && last_word_of(l.name) == "pdf"; });
  return whole != leaves.end() ? whole : std::ranges::find_if(leaves, is_pdf);
}

bool is_direction(const Leaf& leaf) {
  if (leaf.part.count != 3) return false;
  const std::string word = last_word_of(leaf.name);
  constexpr std::array<std::string_view, 8> kWords{"dir",     "direction",    "w",         "omega",
                                                   "sampled", "outdirection", "scattered", "next"};
  if (std::ranges::find(kWords, word) != kWords.end() || word.ends_with("dir") || word.ends_with("direction"))
    return true;
  const auto meaning = meaning_of(leaf.name, true);
  return meaning && meaning->kind == Meaning::Kind::vector &&
         (meaning->a == Axis::light || meaning->a == Axis::view);
}

// The quantity that a value's name states. A value "f" may still include the cosine.
std::optional<SampleValue> kind_of(const std::string& name) {
  const std::string word = last_word_of(name);
  constexpr std::array<std::string_view, 6> kWeights{"overpdf",     "weight", "throughput",
                                                     "attenuation", "invpdf", "divpdf"};
  if (holds_any(word, kWeights)) return SampleValue::weight;
  return std::nullopt;
}

bool is_sampled_value(const Leaf& leaf) {
  constexpr std::array<std::string_view, 14> kWords{"f",        "fr",     "brdf", "bsdf",       "bxdf",
                                                    "value",    "result", "eval", "color",      "colour",
                                                    "response", "rgb",    "refl", "reflectance"};
  const std::string word = last_word_of(leaf.name);
  return !leaf.truth && (kind_of(leaf.name) || std::ranges::find(kWords, word) != kWords.end());
}

// Sorts the results of a function into the parts of a sampler. Returns false if no direction is among them.
bool sort_results(const Module& m, const spirv::Function& f, const Source& source, FoundSampler& out) {
  Given given = given_values(m, f, source);
  out.written = std::move(given.written);
  out.accumulated = std::move(given.accumulated);
  std::vector<Leaf>& leaves = given.values;
  const auto returned = [](const Leaf& l) { return l.part.argument < 0 && l.name.empty(); };
  auto direction =
      std::ranges::find_if(leaves, [&](const Leaf& l) { return !returned(l) && is_direction(l); });
  if (direction == leaves.end()) {  // the returned vector, or the only vector that is written
    direction = std::ranges::find_if(leaves, [&](const Leaf& l) { return returned(l) && l.part.count == 3; });
    const auto written = std::ranges::find_if(
        leaves, [&](const Leaf& l) { return !returned(l) && l.part.count == 3 && !is_sampled_value(l); });
    if (written != leaves.end()) return false;  // of an unknown meaning, such as a half vector
  }
  if (direction == leaves.end()) return false;
  out.direction = direction->part;
  out.direction_name = direction->name;
  if (direction->of_four) {
    out.pdf = ResultPart{direction->part.argument, direction->part.first + 3, 1};
    out.pdf_name = "the fourth component";
  }
  leaves.erase(direction);
  if (const auto pdf = pdf_of(leaves); pdf != leaves.end() && !out.pdf) {
    out.pdf = pdf->part;
    out.pdf_name = pdf->name;
  }
  for (const Leaf& leaf : leaves) {
    if (is_pdf(leaf)) continue;
    if (leaf.truth && !out.valid &&
        (returned(leaf) || last_word_of(leaf.name).find("valid") != std::string::npos)) {
      out.valid = leaf.part;
    } else if ((returned(leaf) && !leaf.truth) || is_sampled_value(leaf)) {
      out.values.push_back({leaf.name, leaf.part, kind_of(leaf.name)});
    }
  }
  return true;
}

bool is_state(const Module& m, spirv::Id type) {
  const spirv::Type& t = m.type(type);
  if (t.kind == Kind::integer || t.kind == Kind::boolean) return true;
  if (t.kind == Kind::vector || t.kind == Kind::array) return is_state(m, t.element);
  return t.kind == Kind::structure && !t.members.empty() &&
         std::ranges::all_of(t.members, [&](spirv::Id member) { return is_state(m, member); });
}

bool is_called_random(const std::string& function) {
  constexpr std::array<std::string_view, 16> kWords{
      "rand",  "rnd",        "rng",       "xi",   "next1d", "next2d", "next3d",    "halton",
      "sobol", "hammersley", "uniform01", "hash", "pcg",    "noise",  "nextfloat", "getfloat"};
  return holds_any(plain_name(function), kWords);
}

// The variables that a function stores to: parameters of its own, and variables of the file.
std::set<spirv::Id> stored_by(const spirv::Function& f) {
  std::set<spirv::Id> out;
  std::map<spirv::Id, spirv::Id> base;  // of pointers to parts
  for (const spirv::Block& block : f.blocks)
    for (const spirv::Instruction& i : block.code) {
      const auto root = [&](spirv::Id id) { return base.contains(id) ? base.at(id) : id; };
      if ((i.code == spv::OpAccessChain || i.code == spv::OpInBoundsAccessChain) && !i.words.empty())
        base[i.result] = root(i.words[0]);
      if (i.code == spv::OpStore && !i.words.empty()) out.insert(root(i.words[0]));
    }
  return out;
}

std::vector<spirv::Id> calls_of(const spirv::Function& f) {
  std::vector<spirv::Id> out;
  for (const spirv::Block& block : f.blocks)
    for (const spirv::Instruction& i : block.code)
      if (i.code == spv::OpFunctionCall && !i.words.empty()) out.push_back(i.words[0]);
  return out;
}

// Returns whether a function returns random numbers, if the functions that it calls do not.
bool is_generator(const Module& m, const spirv::Function& f) {
  const spirv::Type& returned = m.type(f.type);
  const bool vector = returned.kind == Kind::vector;
  const Kind kind = vector ? m.type(returned.element).kind : returned.kind;
  const bool named = is_called_random(f.name), integer = kind == Kind::integer;
  if (kind != Kind::number && !(integer && named)) return false;
  const std::set<spirv::Id> stored = stored_by(f);
  bool changes = false;
  for (std::size_t k = 0; k < f.parameters.size(); ++k) {
    const bool stores = stored.contains(f.parameters[k]);
    if (!is_state(m, pointee(m, f.parameter_types[k])) && !(named && stores)) return false;
    changes = changes || stores;
  }
  for (const spirv::Id id : stored) {
    const auto global = m.globals.find(id);
    changes = changes || (global != m.globals.end() && global->second.variable);
  }
  return named || changes;
}

struct Candidate {
  const spirv::Function* function;
  int score;
};

// The candidates with the largest score.
std::vector<const spirv::Function*> best_of(const std::vector<Candidate>& all) {
  int best = 0;
  for (const Candidate& c : all) best = std::max(best, c.score);
  std::vector<const spirv::Function*> out;
  for (const Candidate& c : all)
    if (c.score == best) out.push_back(c.function);
  return out;
}

std::string listed_names(const Module& m, const std::vector<const spirv::Function*>& functions) {
  std::vector<std::string> words;
  for (const spirv::Function* f : functions) words.push_back(signature(m, *f));
  return io::joined(words, "; ");
}

// The function that a line or an option names. Throws InputError if there is no such function, or more than
// one with these arguments.
const spirv::Function* named_function(const Module& m, const Source& source, const EntryLine& line,
                                      const char* option) {
  std::vector<const spirv::Function*> all;
  for (const spirv::Function* f : own_functions(m))
    if (f->name == line.name && (!line.arguments || line.arguments->size() == f->parameters.size()))
      all.push_back(f);
  if (all.size() == 1) return all[0];
  if (all.empty())
    throw InputError(source.name + ": --" + option + " " + line.name + ": the file has no such function (" +
                     listed_names(m, own_functions(m)) + ")");
  throw InputError(source.name + ": --" + option + " " + line.name +
                   ": the file has several: " + listed_names(m, all) + "; rename one");
}

bool takes_axis(const Module& m, const spirv::Function& f, Axis axis) {
  for (std::size_t k = 0; k < f.parameters.size(); ++k) {
    const spirv::Type& t = m.type(pointee(m, f.parameter_types[k]));
    const auto meaning = meaning_of(m.name(f.parameters[k]), t.kind == Kind::vector && t.count == 3);
    if (meaning && meaning->kind != Meaning::Kind::white && (meaning->a == axis || meaning->b == axis))
      return true;
  }
  return false;
}

bool says_brdf(const std::string& name) {
  constexpr std::array<std::string_view, 3> kWords{"brdf", "bsdf", "bxdf"};
  return holds_any(plain_name(name), kWords);
}

// How well a companion's name fits the reflectance: 2 for the same stem, 1 for a function that no other
// function calls and that has the word brdf.
int fit_of(const spirv::Function& f, const spirv::Function& reflectance, const std::set<spirv::Id>& called) {
  if (stem_of(f.name) == stem_of(reflectance.name)) return 4 + (called.contains(f.id) ? 0 : 1);
  return says_brdf(f.name) && !called.contains(f.id) ? 2 : 0;
}

bool is_called_sampler(const std::string& function) {
  const std::string name = plain_name(function);
  return (name.find("sample") != name.npos || name.find("generate") != name.npos) &&
         name.find("pdf") == name.npos && name.find("eval") == name.npos;
}

bool is_called_density(const Module& m, const spirv::Function& f) {
  constexpr std::array<std::string_view, 2> kWords{"pdf", "density"};
  const std::string name = plain_name(f.name);
  return holds_any(name, kWords) && name.find("sample") == name.npos && m.type(f.type).kind == Kind::number;
}

struct Pair {
  const spirv::Function *sampler = nullptr, *density = nullptr;
};

// The only sampler and density of directions that share a stem, such as sampleGGX and pdfGGX, if the name of
// the reflectance has no stem of its own, as brdf: one distribution of samples serves any reflectance.
Pair only_pair(const Module& m, const Source& source, const spirv::Function& reflectance,
               const std::set<spirv::Id>& generators) {
  if (!stem_of(reflectance.name).empty()) return {};
  const std::set<spirv::Id> called = called_by_others(m);
  std::vector<Pair> pairs;
  for (const spirv::Function* f : own_functions(m)) {
    FoundSampler trial;
    if (!is_called_sampler(f->name) || generators.contains(f->id) || called.contains(f->id) ||
        !takes_axis(m, *f, Axis::view) || !sort_results(m, *f, source, trial))
      continue;
    for (const spirv::Function* g : own_functions(m))
      if (is_called_density(m, *g) && stem_of(g->name) == stem_of(f->name) &&
          takes_axis(m, *g, Axis::light) && takes_axis(m, *g, Axis::view))
        pairs.push_back({f, g});
  }
  return pairs.size() == 1 ? pairs[0] : Pair{};
}

}  // namespace

std::set<spirv::Id> generators_of(const Module& m) {
  std::set<spirv::Id> out;
  for (const auto& [id, f] : m.functions)
    if (id != m.entry && is_generator(m, f)) out.insert(id);
  // A function that computes with random numbers, such as a point on a disc, is no generator itself: the
  // generators are the innermost functions that return numbers.
  std::set<spirv::Id> outer;
  for (const spirv::Id id : out) {
    const bool integer = m.type(m.functions.at(id).type).kind == Kind::integer;
    for (const spirv::Id inner : calls_of(m.functions.at(id)))
      if (inner != id && out.contains(inner)) {
        const spirv::Type& t = m.type(m.functions.at(inner).type);
        const bool of_integers =
            t.kind == Kind::integer || (t.kind == Kind::vector && m.type(t.element).kind == Kind::integer);
        if (!of_integers || integer) outer.insert(id);
      }
  }
  for (const spirv::Id id : outer) out.erase(id);
  return out;
}

FoundSampler find_sampler(const Module& m, const Source& source, const spirv::Function& reflectance) {
  FoundSampler out;
  const std::set<spirv::Id> generators = generators_of(m);
  const auto take = [&](const spirv::Function* f) {
    if (!sort_results(m, *f, source, out)) return false;
    out.function = f;
    out.generators = generators;
    return true;
  };
  if (source.sample) {
    const spirv::Function* f = named_function(m, source, *source.sample, "sample");
    if (!take(f))
      throw InputError(source.name + ": " + signature(m, *f) +
                       " returns no direction: a sampler returns a vec3 or writes one as an `out` argument "
                       "or a member of a struct, named L, wi, dir or similar");
    return out;
  }
  const std::set<spirv::Id> called = called_by_others(m);
  std::vector<Candidate> candidates;
  for (const spirv::Function* f : own_functions(m)) {
    if (!is_called_sampler(f->name) || generators.contains(f->id)) continue;
    FoundSampler trial;
    const int fit = fit_of(*f, reflectance, called);
    if (fit == 0 || !sort_results(m, *f, source, trial)) continue;
    candidates.push_back({f, fit + 8 * takes_axis(m, *f, Axis::view)});
  }
  const std::vector<const spirv::Function*> best = best_of(candidates);
  if (best.size() == 1) take(best[0]);
  if (best.empty() && !source.pdf)
    if (const Pair pair = only_pair(m, source, reflectance, generators); pair.sampler) take(pair.sampler);
  if (best.size() > 1)
    out.missing = "several functions may be the sampler (" + listed_names(m, best) +
                  "): select one with --sample NAME or a line `//: sample NAME`";
  return out;
}

FoundDensity find_density(const Module& m, const Source& source, const spirv::Function& reflectance) {
  FoundDensity out;
  const auto take = [&](const spirv::Function* f, bool by_name) {
    Given given = given_values(m, *f, source);
    const auto is_result = [&](const Leaf& l) {
      return is_pdf(l) ||
             (!by_name && l.part.argument < 0 && l.name.empty() && l.part.count == 1 && !l.truth);
    };
    const auto value = std::ranges::find_if(given.values, is_result);
    if (value == given.values.end()) return false;
    out.function = f;
    out.part = value->part;
    out.written = std::move(given.written);
    out.accumulated = std::move(given.accumulated);
    return true;
  };
  if (source.pdf) {
    const spirv::Function* f = named_function(m, source, *source.pdf, "pdf");
    if (!take(f, false))
      throw InputError(source.name + ": " + signature(m, *f) + " returns no number, which a density is");
    return out;
  }
  const std::set<spirv::Id> called = called_by_others(m);
  std::vector<Candidate> candidates;
  for (const spirv::Function* f : own_functions(m)) {
    if (!is_called_density(m, *f)) continue;
    const int fit = fit_of(*f, reflectance, called);
    if (fit == 0) continue;
    candidates.push_back({f, fit + 8 * takes_axis(m, *f, Axis::light) + 8 * takes_axis(m, *f, Axis::view)});
  }
  const std::vector<const spirv::Function*> best = best_of(candidates);
  if (best.size() == 1) take(best[0], false);
  if (best.size() > 1)
    out.missing = "several functions may be the density (" + listed_names(m, best) +
                  "): select one with --pdf NAME or a line `//: pdf NAME`";
  if (best.empty() && !take(&reflectance, true) && !source.sample)
    if (const Pair pair = only_pair(m, source, reflectance, generators_of(m)); pair.density)
      take(pair.density, false);
  return out;
}

}  // namespace brdf::shader
