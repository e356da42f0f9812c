// Passes the text of a shader through the front end and the interpreter, and SPIR-V that no compiler wrote
// through the later stages. The name in the first line of the text, after //, gives the language. Both
// kinds of input are changed by words as well as by bytes: most changes of bytes give a text that no
// compiler accepts, so that the checker, the flattening and the interpreter would receive few inputs.
#include <cmath>
#include <cstring>
#include <functional>

#include "io/files/error.h"
#include "shader/entry.h"
#include "shader/program/lower.h"
#include "shader/shader.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/mutate.h"

namespace brdf::fuzz {
namespace {

// Runs the program to its end, or until an endless loop is detected.
template <class T>
void run_once(const shader::Program& program) {
  shader::Bank<T, 4> bank(program);
  try {
    shader::run<T, 4>(program, bank, 4, 2000);
  } catch (const shader::EndlessLoop&) {
  }
}

// Runs the function at its defaults in every lane, or until an endless loop is detected.
template <class T, int W>
void run_function(const shader::Function& f) {
  shader::Runner<T, W> runner(f);
  std::vector<T> values;
  for (const double v : f.defaults()) values.push_back(shader::Functions<T>::number(v));
  runner.set_values(f, values);
  typename shader::Runner<T, W>::Lanes wi, wo;
  for (std::size_t l = 0; l < W; ++l) {
    const Vec3<double> i = direction(degrees(5.0 * double(l)), {}),
                       o = direction(degrees(40), degrees(11.0 * double(l)));
    wi[0][l] = T(i.x), wi[1][l] = T(i.y), wi[2][l] = T(i.z);
    wo[0][l] = T(o.x), wo[1][l] = T(o.y), wo[2][l] = T(o.z);
  }
  runner.set_directions(f, wi, wo);
  constexpr std::size_t kMostSteps = 5000;  // a later limit makes endless loops more expensive
  try {
    shader::run<T, W>(f.program<T>(), runner.bank(), W, kMostSteps);
  } catch (const shader::EndlessLoop&) {
  }
}

// Makes a reflectance of the function. Its tables take a thousand evaluations, so that only one text of
// sixteen is used.
void make_reflectance(shader::Function f) {
  const auto shader = std::make_shared<const shader::ShaderReflectance>(std::move(f));
  const Material m = shader->material(shader);
  std::vector<double> value(m.channels.size());
  eval(m, direction(degrees(30), {}), direction(degrees(40), degrees(170)), value);
  require(shader->info().weights.size() + shader->info().shape.size() == shader->function().parameters.size(),
          "every parameter is in a table");
}

const Registered text(
    "shader",
    [](std::string_view input) {
      const std::string_view first = input.substr(0, input.find('\n'));
      const std::string name = first.find("hlsl") != first.npos ? "fuzz.hlsl" : "fuzz.glsl";
      static shader::Compiler compiler;
      shader::Function f =
          shader::make_function(shader::parse_source(name, std::string(input)), {}, compiler);
      run_function<float, shader::kLanes>(f);
      run_function<double, 1>(f);
      run_function<Dual<double, 2>, shader::kLanes>(f);
      if (std::hash<std::string_view>{}(input) % 16 == 0) make_reflectance(std::move(f));
    },
    mutate_text);

const Registered spirv(
    "spirv",
    [](std::string_view input) {
      std::vector<std::uint32_t> words(input.size() / 4);
      if (words.empty()) return;
      std::memcpy(words.data(), input.data(), words.size() * 4);
      shader::spirv::Module module = shader::spirv::parse(words);
      shader::spirv::name_all(module);
      shader::spirv::give_arguments(module);
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
    },
    mutate_spirv);

}  // namespace
}  // namespace brdf::fuzz
