#include "shader/entry.h"

#include <algorithm>
#include <glslang/SPIRV/spirv.hpp>
#include <regex>
#include <set>

#include "io/error.h"
#include "io/numbers.h"
#include "io/text.h"
#include "shader/front/definitions.h"
#include "shader/front/roles.h"

namespace brdf::shader {
namespace {

using spirv::Function;
using spirv::Kind;
using spirv::Module;

spirv::Id pointee(const Module& m, spirv::Id type) {
  const spirv::Type& t = m.type(type);
  return t.kind == Kind::pointer ? t.element : type;
}

// What main() calls is no part of something larger.
bool is_main(const std::string& name) {
  return name == "main" || name == "brdf_own_main" || name == "brdf_main" || name == "mainImage";
}

// Functions of the file's own, by name, without what the program adds.
std::vector<const Function*> own_functions(const Module& module) {
  std::vector<const Function*> out;
  for (const auto& [id, f] : module.functions)
    if (id != module.entry && !f.name.empty() && !f.name.starts_with("@") && !is_main(f.name))
      out.push_back(&f);
  return out;
}

std::set<spirv::Id> called_by_others(const Module& module) {
  std::set<spirv::Id> called;
  for (const auto& [id, f] : module.functions) {
    if (is_main(f.name)) continue;
    for (const spirv::Block& b : f.blocks)
      for (const spirv::Instruction& i : b.code)
        if (i.code == spv::OpFunctionCall && !i.words.empty() && i.words[0] != id) called.insert(i.words[0]);
  }
  return called;
}

// Directions that arguments (and members of structs) or global variables are, by their names.
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

// Takes a direction of light and one of view, or their products with the normal; one of them may be global.
bool takes_directions(const Module& m, const Function& f, const std::vector<std::string>& free) {
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
        std::find(free.begin(), free.end(), name) != free.end())
      seen.look(m, name, pointee(m, global.instruction.type));
  }
  return seen.light && seen.view;
}

std::string listed(const Module& module, const std::vector<const Function*>& functions) {
  std::vector<std::string> words;
  for (const Function* f : functions) words.push_back(signature(module, *f));
  if (words.size() > 12) {
    words.resize(12);
    words.push_back("...");
  }
  return io::joined(words, "; ");
}

// Of overloads the one that the others are called by, else the one with the most arguments.
const Function* outermost(const std::vector<const Function*>& same, const std::set<spirv::Id>& called) {
  return *std::max_element(same.begin(), same.end(), [&](const Function* a, const Function* b) {
    return std::pair(!called.contains(a->id), a->parameters.size()) <
           std::pair(!called.contains(b->id), b->parameters.size());
  });
}

bool is_called_brdf(const std::string& function) {
  const std::string name = io::lower_case(function);
  return name.find("brdf") != name.npos || name.find("bsdf") != name.npos || name.find("bxdf") != name.npos;
}

// Says why the first of those functions is not there.
template <class Is>
void require_compiled(std::span<const LeftOut> left_out, Is&& is) {
  for (const LeftOut& f : left_out)
    if (is(f.name)) throw InputError(f.why);
}

// What a function of the file's that does not compile calls is part of it: a line that says so, where its name is a reflectance's.
void require_whole(const Source& source, std::span<const LeftOut> left_out, const std::string& chosen) {
  const std::string text = without_comments(source.text);
  for (const Definition& d : definitions_of(text)) {
    const auto out =
        std::find_if(left_out.begin(), left_out.end(), [&](const LeftOut& f) { return f.name == d.name; });
    if (out == left_out.end() || !is_called_brdf(d.name)) continue;
    const std::string body = text.substr(d.begin, d.end - d.begin);
    if (std::regex_search(body, std::regex("\\b" + chosen + "\\s*\\(")))
      throw InputError(out->why + "; or take a function that it calls, with --entry " + chosen);
  }
}

constexpr const char* kHelp =
    ": put it into a function such as `vec3 brdf(vec3 L, vec3 V, vec3 N, float roughness)`, or name one with "
    "--entry NAME or a line "
    "`//: entry NAME(L, V, N, roughness)` whose words say what each argument is";

}  // namespace

std::string signature(const Module& module, const Function& f) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < f.parameters.size(); ++k)
    words.push_back(module.spelled(pointee(module, f.parameter_types[k])) + " " +
                    module.name(f.parameters[k]));
  return module.spelled(f.type) + " " + f.name + "(" + io::joined(words) + ")";
}

std::vector<std::string> free_directions(const Module& module, const Source& source) {
  const std::string text = without_comments(source.text);
  std::vector<std::string> out;
  for (const auto& [id, global] : module.globals) {
    if (!global.variable || module.type(global.instruction.type).storage != spv::StorageClassPrivate)
      continue;
    const std::string name = module.name(id);
    const spirv::Type& t = module.type(pointee(module, global.instruction.type));
    const auto meaning = meaning_of(name, t.kind == Kind::vector && t.count == 3);
    if (!meaning || meaning->kind == Meaning::Kind::white) continue;
    if (!std::regex_search(text, std::regex("\\w\\s+" + name + "\\s*="))) out.push_back(name);
  }
  return out;
}

Chosen choose_entry(const Module& module, const Source& source, std::span<const LeftOut> left_out) {
  const std::vector<const Function*> all = own_functions(module);
  const std::set<spirv::Id> called = called_by_others(module);
  const std::vector<std::string> free = free_directions(module, source);
  const auto named = [&](auto&& is) {
    std::vector<const Function*> out;
    std::copy_if(all.begin(), all.end(), std::back_inserter(out), is);
    return out;
  };
  const auto with_results = [&](const Function* f, const std::string& note = "") {
    Results results = results_of(module, *f, source);
    if (!results.several.empty())
      throw InputError(
          source.name + ": " + signature(module, *f) + " gives several values (" + results.several +
          "): put one that calls it and returns the reflectance at the end of the file, and name that with "
          "--entry NAME");
    if (results.parts.empty())
      throw InputError(
          source.name + ": " + signature(module, *f) + " returns " + module.spelled(f->type) +
          "; a reflectance is a float or a vec3, returned, a member of what is returned, or an argument that "
          "is `out`");
    return Chosen{f, std::move(results), note};
  };
  if (source.entry) {
    const auto same = named([&](const Function* f) { return f->name == source.entry->name; });
    if (same.empty())
      require_compiled(left_out, [&](const std::string& name) { return name == source.entry->name; });
    if (same.empty() && is_main(source.entry->name))
      throw InputError(source.name + ": " + source.entry->name +
                       "() takes no directions and returns no reflectance" + kHelp);
    if (same.empty())
      throw InputError(source.name + ": has no function " + source.entry->name +
                       (all.empty() ? "" : " (it has " + listed(module, all) + ")"));
    return with_results(outermost(same, called));
  }
  const auto gives = [&](const Function* f) {
    const Results results = results_of(module, *f, source);
    const auto returned = module.type(f->type).kind;
    return !results.parts.empty() && (returned == Kind::number || returned == Kind::vector || results.named);
  };
  require_compiled(left_out, [](const std::string& name) { return io::lower_case(name) == "brdf"; });
  const auto exact = named([&](const Function* f) {
    return io::lower_case(f->name) == "brdf" && !results_of(module, *f, source).parts.empty();
  });
  if (!exact.empty()) return with_results(outermost(exact, called));
  // A factor of one is none, whatever it takes.
  const auto is_factor = [&](const Function* f) {
    const std::string name = io::lower_case(f->name);
    const auto has = [&](const char* word) { return name.find(word) != name.npos; };
    return !is_called_brdf(f->name) &&
           (has("geometry") || has("smith") || has("visib") || has("fresnel") || has("distribution") ||
            has("mask") || has("shadow") || has("normal") || name.starts_with("g_") ||
            name.starts_with("v_") || name.starts_with("d_") || f->name.starts_with("F_") ||
            name.starts_with("vis_"));
  };
  // Those that draw a direction, or say how densely, know both and are no value.
  const auto draws = [](const Function* f) {
    const std::string name = io::lower_case(f->name);
    return name.find("sample") != name.npos || name.find("pdf") != name.npos ||
           name.find("albedo") != name.npos;
  };
  const auto could_be = [&](const Function* f) {
    return gives(f) && !draws(f) && takes_directions(module, *f, free);
  };
  auto likely =
      named([&](const Function* f) { return could_be(f) && !called.contains(f->id) && !is_factor(f); });
  if (likely.empty())  // one of the file's others may call it
    likely = named([&](const Function* f) { return could_be(f) && is_called_brdf(f->name); });
  if (likely.empty())  // a shading function of the file's calls it
    likely = named([&](const Function* f) { return could_be(f) && !is_factor(f); });
  if (likely.size() > 1) {
    auto by_name = likely;
    std::erase_if(by_name, [&](const Function* f) { return !is_called_brdf(f->name); });
    if (by_name.size() == 1) likely = by_name;
  }
  if (likely.size() == 1) require_whole(source, left_out, likely[0]->name);
  if (likely.size() == 1)
    return with_results(likely[0], "the reflectance is " + signature(module, *likely[0]) +
                                       ", by its name and arguments; --entry NAME takes another");
  if (likely.size() > 1)
    throw InputError(source.name +
                     ": has several functions that could be the reflectance; say which with --entry NAME or "
                     "a line `//: entry NAME`: " +
                     listed(module, likely));
  require_compiled(left_out, [](const std::string&) { return true; });
  const bool has_main = without_comments(source.text).find("main") != std::string::npos;
  std::string what = source.name + ": has ";
  what += has_main ? "main() and no function brdf of directions" : "no function brdf of directions";
  throw InputError(what + kHelp + (all.empty() ? "" : "; the file has " + listed(module, all)));
}

}  // namespace brdf::shader
