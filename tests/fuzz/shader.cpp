// A shader's text through the front end and the interpreter (the name in its first line, after //, says the language), and SPIR-V
// that no compiler wrote through the rest.
#include <cmath>
#include <cstring>

#include "io/error.h"
#include "shader/entry.h"
#include "shader/program/lower.h"
#include "shader/shader.h"
#include "tests/fuzz/fuzz.h"

namespace brdf::fuzz {
namespace {

// Runs to its end, or says that it has none.
template <class T>
void run_once(const shader::Program& program) {
  shader::Bank<T, 4> bank(program);
  try {
    shader::run<T, 4>(program, bank, 4, 5000);
  } catch (const shader::EndlessLoop&) {
  }
}

const Registered text("shader", [](std::string_view input) {
  const std::string_view first = input.substr(0, input.find('\n'));
  const std::string name = first.find("hlsl") != first.npos ? "fuzz.hlsl" : "fuzz.glsl";
  const auto shader = std::make_shared<const shader::ShaderReflectance>(
      shader::make_function(shader::parse_source(name, std::string(input))));
  const Material m = shader->material(shader);
  std::vector<double> f(m.channels.size());
  eval(m, direction(degrees(30), {}), direction(degrees(40), degrees(170)), f);
  require(shader->info().weights.size() + shader->info().shape.size() == shader->function().parameters.size(),
          "every parameter is in a table");
});

const Registered spirv("spirv", [](std::string_view input) {
  std::vector<std::uint32_t> words(input.size() / 4);
  std::memcpy(words.data(), input.data(), words.size() * 4);
  const shader::spirv::Module module = shader::spirv::parse(words);
  for (const auto& [id, function] : module.functions) {
    shader::Program program;
    try {
      program = shader::lower(module, function, {.most_steps = 2000});
    } catch (const InputError&) {
      continue;
    }
    run_once<float>(program);
    run_once<double>(program);
  }
});

}  // namespace
}  // namespace brdf::fuzz
