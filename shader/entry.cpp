#include "shader/entry.h"

#include <algorithm>
#include <glslang/SPIRV/spirv.hpp>
#include <set>

#include "io/error.h"
#include "io/numbers.h"
#include "io/text.h"
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

std::string spelled(const Module& m, spirv::Id type) {
  const spirv::Type& t = m.type(type);
  switch (t.kind) {
    case Kind::nothing:
      return "void";
    case Kind::boolean:
      return "bool";
    case Kind::integer:
      return t.is_signed ? "int" : "uint";
    case Kind::number:
      return "float";
    case Kind::vector:
      return "vec" + std::to_string(t.count);
    case Kind::matrix:
      return "mat" + std::to_string(t.count);
    case Kind::structure:
      return m.name(type);
    default:
      return "...";
  }
}

// Functions of the file's own, by name, without what the program adds.
std::vector<const Function*> own_functions(const Module& module) {
  std::vector<const Function*> out;
  for (const auto& [id, f] : module.functions)
    if (id != module.entry && !f.name.empty() && !f.name.starts_with("@") && f.name != "main" &&
        f.name != "brdf_own_main" && f.name != "brdf_main")
      out.push_back(&f);
  return out;
}

std::set<spirv::Id> called_by_others(const Module& module) {
  std::set<spirv::Id> called;
  for (const auto& [id, f] : module.functions)
    for (const spirv::Block& b : f.blocks)
      for (const spirv::Instruction& i : b.code)
        if (i.code == spv::OpFunctionCall && !i.words.empty() && i.words[0] != id) called.insert(i.words[0]);
  return called;
}

// A float, a vec3 or a vec4; or nothing, with a last argument for it.
bool returns_reflectance(const Module& m, const Function& f) {
  const auto is = [&](spirv::Id type) {
    const spirv::Type& t = m.type(type);
    return t.kind == Kind::number ||
           (t.kind == Kind::vector && t.count >= 3 && m.type(t.element).kind == Kind::number);
  };
  if (m.type(f.type).kind != Kind::nothing) return is(f.type);
  return !f.parameter_types.empty() && m.type(f.parameter_types.back()).kind == Kind::pointer &&
         is(pointee(m, f.parameter_types.back()));
}

// Takes a direction of light and one of view, or their products with the normal.
bool takes_directions(const Module& m, const Function& f) {
  bool light = false, view = false;
  const auto look = [&](const std::string& name, spirv::Id type) {
    const spirv::Type& t = m.type(type);
    const auto meaning = meaning_of(name, t.kind == Kind::vector && t.count == 3);
    if (!meaning || meaning->kind == Meaning::Kind::white) return;
    for (const Axis axis : {meaning->a, meaning->b}) {
      light = light || axis == Axis::light;
      view = view || axis == Axis::view;
    }
  };
  for (std::size_t k = 0; k < f.parameters.size(); ++k) {
    const spirv::Id type = pointee(m, f.parameter_types[k]);
    const std::string name = m.name(f.parameters[k]);
    const auto members = m.member_names.find(type);
    if (members == m.member_names.end()) {
      look(name, type);
      continue;
    }
    const spirv::Type& t = m.type(type);
    for (const auto& [place, member] : members->second)
      if (place < t.members.size()) look(name + "." + member, t.members[place]);
  }
  return light && view;
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

constexpr const char* kHelp =
    ": put it into a function such as `vec3 brdf(vec3 L, vec3 V, vec3 N, float roughness)`, or name one with "
    "--entry NAME or a line "
    "`//: entry NAME(L, V, N, roughness)` whose words say what each argument is";

}  // namespace

std::string signature(const Module& module, const Function& f) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < f.parameters.size(); ++k)
    words.push_back(spelled(module, pointee(module, f.parameter_types[k])) + " " +
                    module.name(f.parameters[k]));
  return spelled(module, f.type) + " " + f.name + "(" + io::joined(words) + ")";
}

Chosen choose_entry(const Module& module, const Source& source) {
  const std::vector<const Function*> all = own_functions(module);
  const std::set<spirv::Id> called = called_by_others(module);
  const auto named = [&](auto&& is) {
    std::vector<const Function*> out;
    std::copy_if(all.begin(), all.end(), std::back_inserter(out), is);
    return out;
  };
  if (source.entry) {
    const auto same = named([&](const Function* f) { return f->name == source.entry->name; });
    if (same.empty())
      throw InputError(source.name + ": has no function " + source.entry->name +
                       (all.empty() ? "" : " (it has " + listed(module, all) + ")"));
    return {outermost(same, called)};
  }
  const auto exact = named([&](const Function* f) {
    return io::lower_case(f->name) == "brdf" && returns_reflectance(module, *f);
  });
  if (!exact.empty()) return {outermost(exact, called)};
  const auto is_called_brdf = [](const Function* f) {
    const std::string name = io::lower_case(f->name);
    return name.find("brdf") != name.npos || name.find("bsdf") != name.npos;
  };
  // A factor of one is none, whatever it takes.
  const auto is_factor = [&](const Function* f) {
    const std::string name = io::lower_case(f->name);
    const auto has = [&](const char* word) { return name.find(word) != name.npos; };
    return !is_called_brdf(f) &&
           (has("geometry") || has("smith") || has("visib") || has("fresnel") || has("distribution") ||
            has("mask") || has("shadow") || name.starts_with("g_") || name.starts_with("v_") ||
            name.starts_with("d_") || name.starts_with("f_"));
  };
  auto likely = named([&](const Function* f) {
    return returns_reflectance(module, *f) && takes_directions(module, *f) && !called.contains(f->id) &&
           !is_factor(f);
  });
  if (likely.empty())  // main() may call it
    likely = named([&](const Function* f) {
      return returns_reflectance(module, *f) && takes_directions(module, *f) && is_called_brdf(f);
    });
  if (likely.size() > 1) {
    auto by_name = likely;
    std::erase_if(by_name, [&](const Function* f) { return !is_called_brdf(f); });
    if (by_name.size() == 1) likely = by_name;
  }
  if (likely.size() == 1)
    return {likely[0], "the reflectance is " + signature(module, *likely[0]) +
                           ", by its name and arguments; --entry NAME takes another"};
  if (likely.size() > 1)
    throw InputError(source.name +
                     ": has several functions that could be the reflectance; say which with --entry NAME or "
                     "a line `//: entry NAME`: " +
                     listed(module, likely));
  const bool has_main = without_comments(source.text).find("main") != std::string::npos;
  std::string what = source.name + ": has ";
  what += has_main ? "main() and no function brdf of directions" : "no function brdf of directions";
  throw InputError(what + kHelp + (all.empty() ? "" : "; the file has " + listed(module, all)));
}

}  // namespace brdf::shader
