#include "shader/entry.h"

#include <algorithm>
#include <glslang/SPIRV/spirv.hpp>
#include <set>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "shader/front/definitions.h"
#include "shader/front/roles.h"

namespace brdf::shader {
namespace {

using spirv::Kind;
using spirv::Module;

// Functions that main() calls do not count as called, so they are still candidates for the reflectance.
bool is_main(const std::string& name) {
  return name == "main" || name == "brdf_own_main" || name == "brdf_main" || name == "mainImage";
}

// Records the directions that arguments, members of structs or global variables hold, according to their
// names.
struct Seen {
  bool light = false, view = false;

  void look(const Module& m, const std::string& name, spirv::Id type) {
    const spirv::Type& t = m.type(type);
    const auto meaning = meaning_of(name, t.kind == Kind::vector && t.count == 3);
    if (!meaning || meaning->kind == Meaning::Kind::white) return;
    for (const Axis axis : {meaning->a, meaning->b}) {
      light = light || axis == Axis::light;
      view = view || axis == Axis::view;
    }
  }
};

// Returns whether the function takes a direction of the light and one of the viewer, or their products with
// the normal. One of the two may be a global variable.
bool takes_directions(const Module& m, const spirv::Function& f, const std::vector<std::string>& free) {
  Seen seen;
  for (std::size_t k = 0; k < f.parameters.size(); ++k) {
    const spirv::Id type = pointee(m, f.parameter_types[k]);
    const std::string name = m.name(f.parameters[k]);
    const auto members = m.member_names.find(type);
    if (members == m.member_names.end()) {
      seen.look(m, name, type);
      continue;
    }
    const spirv::Type& t = m.type(type);
    for (const auto& [place, member] : members->second)
      if (place < t.members.size()) seen.look(m, name + "." + member, t.members[place]);
  }
  if (!seen.light && !seen.view) return false;
  for (const auto& [id, global] : m.globals) {
    if (!global.variable) continue;
    const auto storage = m.type(global.instruction.type).storage;
    const std::string name = m.name(id);
    if (storage == spv::StorageClassUniformConstant || storage == spv::StorageClassInput ||
        std::ranges::find(free, name) != free.end())
      seen.look(m, name, pointee(m, global.instruction.type));
  }
  return seen.light && seen.view;
}

std::string listed(const Module& module, const std::vector<const spirv::Function*>& functions) {
  std::vector<std::string> words;
  for (const spirv::Function* f : functions) words.push_back(signature(module, *f));
  if (words.size() > 12) {
    words.resize(12);
    words.push_back("...");
  }
  return io::joined(words, "; ");
}

// "brdf(L, V, N, kd)", in the syntax of --entry.
std::string entry_words(const Module& module, const spirv::Function& function) {
  std::vector<std::string> words;
  for (const spirv::Id parameter : function.parameters) words.push_back(module.name(parameter));
  return function.name + "(" + io::joined(words) + ")";
}

// The functions that satisfy `is`; all of them if no function does.
template <class Is>
std::vector<const spirv::Function*> those(const std::vector<const spirv::Function*>& of, Is&& is) {
  std::vector<const spirv::Function*> out;
  std::copy_if(of.begin(), of.end(), std::back_inserter(out), is);
  return out.empty() ? of : out;
}

// Chooses among overloads: the one with the arguments that the entry line names, or otherwise the only one
// that takes directions and is not called by another function. `note` receives the signature of the chosen
// one. Throws InputError if the choice is not unique.
const spirv::Function* meant_overload(const Module& module, const Source& source,
                                      const std::vector<const spirv::Function*>& all,
                                      const std::set<spirv::Id>& called, const std::vector<std::string>& free,
                                      std::string& note) {
  if (all.size() == 1) return all[0];
  std::vector<const spirv::Function*> left = all;
  if (source.entry && source.entry->arguments) {
    const std::vector<std::string>& words = *source.entry->arguments;
    left = those(left, [&](const spirv::Function* f) { return f->parameters.size() == words.size(); });
    left = those(left, [&](const spirv::Function* f) {
      for (std::size_t k = 0; k < words.size() && k < f->parameters.size(); ++k)
        if (module.name(f->parameters[k]) != words[k]) return false;
      return true;
    });
    if (left.size() == 1) return left[0];
  }
  left = those(left, [&](const spirv::Function* f) { return !called.contains(f->id); });
  left = those(left, [&](const spirv::Function* f) { return takes_directions(module, *f, free); });
  if (left.size() > 1)
    throw InputError(source.name + ": has " + std::to_string(all.size()) + " functions " + all[0]->name +
                     ": " + listed(module, all) + "; select the reflectance with --entry '" +
                     entry_words(module, *left[0]) + "' or a line `//: entry " +
                     entry_words(module, *left[0]) + "`, or rename it");
  note = "of " + std::to_string(all.size()) + " functions " + all[0]->name + " the reflectance is " +
         signature(module, *left[0]);
  return left[0];
}

bool is_called_brdf(const std::string& function) {
  const std::string name = io::lower_case(function);
  return name.find("brdf") != name.npos || name.find("bsdf") != name.npos || name.find("bxdf") != name.npos;
}

// Throws InputError with the reason if the first function that satisfies `is` was left out.
template <class Is>
void require_compiled(std::span<const LeftOut> left_out, Is&& is) {
  for (const LeftOut& f : left_out)
    if (is(f.name)) throw InputError(f.why);
}

// Throws InputError if a left-out function with the name of a reflectance calls the chosen function: then
// the chosen function is only a part of the reflectance.
void require_whole(std::span<const LeftOut> left_out, const std::string& chosen) {
  for (const LeftOut& out : left_out) {
    if (!is_called_brdf(out.name)) continue;
    const std::vector<Token> tokens = tokens_of(out.text);
    for (std::size_t k = 0; k + 1 < tokens.size(); ++k)
      if (tokens[k].is(chosen) && tokens[k + 1].is("("))
        throw InputError(out.why + "; or use --entry to select a function that is called there: " + chosen);
  }
}

// Functions that sample a direction or compute a density take both directions, but do not return a
// reflectance.
bool is_of_sampling(const std::string& function) {
  const std::string name = io::lower_case(function);
  return name.find("sample") != name.npos || name.find("pdf") != name.npos || name.starts_with("generate");
}

// Lists the undefined macros that the text tests, because one of them may enable the missing function.
std::string asked_for(const Compiled& compiled) {
  if (compiled.asked.empty()) return "";
  return "; the text tests macros that are not defined (" + io::joined(compiled.asked) +
         "): define a macro with --define NAME or NAME=VALUE";
}

constexpr const char* kHelp =
    ": write a function such as `vec3 brdf(vec3 L, vec3 V, vec3 N, float roughness)`, or select a function "
    "with --entry NAME or a line `//: entry NAME(L, V, N, roughness)`, which assigns the arguments";

}  // namespace

spirv::Id pointee(const Module& m, spirv::Id type) {
  const spirv::Type& t = m.type(type);
  return t.kind == Kind::pointer ? t.element : type;
}

std::vector<const spirv::Function*> own_functions(const Module& module) {
  std::vector<const spirv::Function*> out;
  for (const auto& [id, f] : module.functions)
    // An entry point with arguments is that of a SPIR-V file.
    if (id != module.entry && !f.name.empty() && !f.name.starts_with("@") &&
        (!is_main(f.name) || (f.name == "main" && !f.parameters.empty())))
      out.push_back(&f);
  return out;
}

std::set<spirv::Id> called_by_others(const Module& module, bool by_samplers) {
  std::set<spirv::Id> called;
  for (const auto& [id, f] : module.functions) {
    if (is_main(f.name) || (!by_samplers && is_of_sampling(f.name))) continue;
    for (const spirv::Block& b : f.blocks)
      for (const spirv::Instruction& i : b.code)
        if (i.code == spv::OpFunctionCall && !i.words.empty() && i.words[0] != id) called.insert(i.words[0]);
  }
  return called;
}

std::string signature(const Module& module, const spirv::Function& f) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < f.parameters.size(); ++k)
    words.push_back(module.spelled(pointee(module, f.parameter_types[k])) + " " +
                    module.name(f.parameters[k]));
  return module.spelled(f.type) + " " + f.name + "(" + io::joined(words) + ")";
}

std::vector<std::string> free_directions(const Module& module, const Source& source) {
  const std::vector<Token> tokens = tokens_of(source.whole);
  std::set<std::string_view> set;  // names between a type and an assigned value
  for (std::size_t k = 1; k + 1 < tokens.size(); ++k)
    if (is_word(tokens[k - 1].text[0]) && tokens[k + 1].is("=")) set.insert(tokens[k].text);
  std::vector<std::string> out;
  for (const auto& [id, global] : module.globals) {
    if (!global.variable || module.type(global.instruction.type).storage != spv::StorageClassPrivate)
      continue;
    const std::string name = module.name(id);
    const spirv::Type& t = module.type(pointee(module, global.instruction.type));
    const auto meaning = meaning_of(name, t.kind == Kind::vector && t.count == 3);
    if (!meaning || meaning->kind == Meaning::Kind::white) continue;
    if (!set.contains(name)) out.push_back(name);
  }
  return out;
}

Chosen choose_entry(const Module& module, const Source& source, const Compiled& compiled) {
  const std::vector<LeftOut>& left_out = compiled.left_out;
  const std::vector<const spirv::Function*> all = own_functions(module);
  const std::set<spirv::Id> called = called_by_others(module);
  const std::vector<std::string> free = free_directions(module, source);
  const auto named = [&](auto&& is) {
    std::vector<const spirv::Function*> out;
    std::copy_if(all.begin(), all.end(), std::back_inserter(out), is);
    return out;
  };
  const auto with_results = [&](const spirv::Function* f, const std::string& note = "") {
    Results results = results_of(module, *f, source);
    if (!results.several.empty())
      throw InputError(source.name + ": " + signature(module, *f) + " gives several values (" +
                       results.several +
                       "): append a function that calls it and returns the reflectance, and select the new "
                       "function with --entry NAME");
    if (results.parts.empty())
      throw InputError(
          source.name + ": " + signature(module, *f) + " returns " + module.spelled(f->type) +
          "; a reflectance is a float or a vec3: the returned value, a member of it, or an `out` argument");
    return Chosen{f, std::move(results), note};
  };
  if (source.entry) {
    const auto same = named([&](const spirv::Function* f) { return f->name == source.entry->name; });
    if (same.empty())
      require_compiled(left_out, [&](const std::string& name) { return name == source.entry->name; });
    if (same.empty() && is_main(source.entry->name))
      throw InputError(source.name + ": " + source.entry->name +
                       "() has no directions as arguments and returns no reflectance" + kHelp);
    if (same.empty())
      throw InputError(source.name + ": has no function " + source.entry->name +
                       (all.empty() ? "" : " (the file has " + listed(module, all) + ")") +
                       asked_for(compiled));
    std::string note;
    const spirv::Function* const meant = meant_overload(module, source, same, called, free, note);
    return with_results(meant, note);
  }
  const auto gives = [&](const spirv::Function* f) {
    const Results results = results_of(module, *f, source);
    const auto returned = module.type(f->type).kind;
    return !results.parts.empty() && (returned == Kind::number || returned == Kind::vector || results.named);
  };
  require_compiled(left_out, [](const std::string& name) { return io::lower_case(name) == "brdf"; });
  const auto exact = named([&](const spirv::Function* f) {
    const Results results = results_of(module, *f, source);
    return io::lower_case(f->name) == "brdf" && (!results.parts.empty() || !results.several.empty());
  });
  if (!exact.empty()) {
    std::string note;
    const spirv::Function* const meant = meant_overload(module, source, exact, called, free, note);
    return with_results(meant, note);
  }
  // A factor of a reflectance is not a reflectance, whatever its arguments are.
  const auto is_factor = [&](const spirv::Function* f) {
    const std::string name = io::lower_case(f->name);
    const auto has = [&](const char* word) { return name.find(word) != name.npos; };
    return !is_called_brdf(f->name) &&
           (has("geometry") || has("smith") || has("visib") || has("fresnel") || has("distribution") ||
            has("mask") || has("shadow") || has("normal") || name.starts_with("g_") ||
            name.starts_with("v_") || name.starts_with("d_") || f->name.starts_with("F_") ||
            name.starts_with("vis_"));
  };
  const auto draws = [](const spirv::Function* f) {
    return is_of_sampling(f->name) || io::lower_case(f->name).find("albedo") != std::string::npos;
  };
  const auto could_be = [&](const spirv::Function* f) {
    return gives(f) && !draws(f) && takes_directions(module, *f, free);
  };
  auto likely = named(
      [&](const spirv::Function* f) { return could_be(f) && !called.contains(f->id) && !is_factor(f); });
  if (likely.empty())  // another function of the file may call it
    likely = named([&](const spirv::Function* f) { return could_be(f) && is_called_brdf(f->name); });
  if (likely.empty()) {  // its sampler calls it, to return the value with the direction
    const std::set<spirv::Id> parts = called_by_others(module, false);
    likely = named(
        [&](const spirv::Function* f) { return could_be(f) && !parts.contains(f->id) && !is_factor(f); });
  }
  if (likely.empty())  // a shading function of the file calls it
    likely = named([&](const spirv::Function* f) { return could_be(f) && !is_factor(f); });
  if (likely.size() > 1) {
    auto by_name = likely;
    std::erase_if(by_name, [&](const spirv::Function* f) { return !is_called_brdf(f->name); });
    if (by_name.size() == 1) likely = by_name;
  }
  if (likely.size() == 1) require_whole(left_out, likely[0]->name);
  if (likely.size() == 1)
    return with_results(likely[0],
                        "the reflectance is " + signature(module, *likely[0]) +
                            ", according to its name and arguments; --entry NAME selects another function");
  if (likely.size() > 1)
    throw InputError(source.name +
                     ": has several functions that may be the reflectance; select one with --entry NAME or a "
                     "line `//: entry NAME`: " +
                     listed(module, likely));
  require_compiled(left_out, [](const std::string&) { return true; });
  const std::vector<Token> tokens = tokens_of(source.whole);
  const bool has_main =
      std::ranges::any_of(tokens, [](const Token& t) { return t.is("brdf_own_main") || t.is("mainImage"); });
  if (!source.module.empty())
    throw InputError(source.name +
                     ": no function of this module has the name and the arguments of a reflectance: select a "
                     "function and name its arguments by their order, as in --entry 'NAME(L, V, N, "
                     "roughness)', or the inputs of an entry point by their locations, as in --entry "
                     "'main(0=L, 1=V)'; the module has " +
                     (all.empty() ? "no function with arguments" : listed(module, all)));
  std::string what = source.name + ": has ";
  what += has_main ? "main() and no function brdf of directions" : "no function brdf of directions";
  throw InputError(what + kHelp + (all.empty() ? "" : "; the file has " + listed(module, all)) +
                   asked_for(compiled));
}

}  // namespace brdf::shader
