#include "shader/kernels.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "brdf/any_form.h"
#include "io/files/error.h"
#include "io/material/glsl.h"
#include "io/material/shader_texts.h"
#include "shader/front/compile.h"
#include "shader/front/source.h"
#include "shader/program/lower.h"

namespace brdf::shader {
namespace {

struct Flattened {
  Op kernel;
  Program program;
};

// Returns std::nullopt for a function that no reflectance can call: it may be left uncalled.
std::optional<Program> flattened(const spirv::Module& module, const spirv::Function& function) {
  try {
    return lower(module, function);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::vector<Flattened> flattened_kernels(const spirv::Module& module) {
  std::vector<Flattened> out;
  for (const NamedKernel& kernel : kernels_of(module))
    out.push_back({kernel.op, lower(module, *kernel.function)});
  return out;
}

// The kernels of the texts that this version exports, one text for each way of writing them. They are
// compiled once, because a compiler needs a process.
const std::vector<Flattened>& exported_kernels() {
  static const std::vector<Flattened> kernels = [] {
    const Material material = make_material(catalogue().front());
    std::vector<Flattened> out;
    for (const Source& source :
         {parse_source("kernels.glsl", io::glsl_source(material)),
          parse_source("kernels_es.glsl", io::glsl_source(material, {.dialect = GlslDialect::es})),
          parse_source("kernels.hlsl", io::shader_text(material, io::ShaderLanguage::hlsl, true, "kernels"))})
      for (Flattened& kernel : flattened_kernels(spirv::parse(compile(source).spirv, source.name)))
        out.push_back(std::move(kernel));
    return out;
  }();
  return kernels;
}

// Returns whether both programs have the same operations on the same slots. Lines of the source do not count.
bool is_same(const Program& a, const Program& b) {
  const auto same_step = [](const Step& x, const Step& y) {
    return x.op == y.op && x.r == y.r && x.a == y.a && x.b == y.b && x.c == y.c;
  };
  const auto same_stretch = [&](const Stretch& x, const Stretch& y) {
    return std::ranges::equal(x.steps, y.steps, same_step) && x.end == y.end && x.condition == y.condition &&
           std::ranges::equal(x.next, y.next);
  };
  const auto same_constant = [](const auto& x, const auto& y) {  // also if both are not a number
    return x.slot == y.slot && (x.value == y.value || (x.value != x.value && y.value != y.value));
  };
  const auto same_unset = [](const Program::Undefined& x, const Program::Undefined& y) {
    return x.slot == y.slot && x.integer == y.integer;
  };
  const auto same_input = [](const Input& x, const Input& y) {
    return x.slots == y.slots && x.integer == y.integer && x.argument == y.argument;
  };
  return std::ranges::equal(a.stretches, b.stretches, same_stretch) &&
         std::ranges::equal(a.constants, b.constants, same_constant) &&
         std::ranges::equal(a.integer_constants, b.integer_constants, same_constant) &&
         std::ranges::equal(a.inputs, b.inputs, same_input) &&
         std::ranges::equal(a.undefined, b.undefined, same_unset) && a.results == b.results;
}

}  // namespace

std::set<spirv::Id> library_kernels(const spirv::Module& module) {
  std::set<spirv::Id> out;
  for (const NamedKernel& named : kernels_of(module)) {
    const std::optional<Program> program = flattened(module, *named.function);
    if (program && std::ranges::any_of(exported_kernels(), [&](const Flattened& known) {
          return known.kernel == named.op && is_same(known.program, *program);
        }))
      out.insert(named.function->id);
  }
  return out;
}

}  // namespace brdf::shader
