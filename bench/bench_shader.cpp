// Time per evaluation in float: exported forms through the interpreter, beside the library's compiled batch, and other shaders.
//   bench_shader [SHADER...]
#include <chrono>
#include <cmath>
#include <cstdio>

#include "brdf/random.h"
#include "io/glsl.h"
#include "shader/shader.h"

namespace {

using namespace brdf;

DirectionArrays<float> directions(std::size_t count) {
  DirectionArrays<float> d(count);
  Random random(1);
  const auto somewhere = [&] {
    const Vec3<double> w = direction(degrees(80 * random.uniform()), degrees(360 * random.uniform()));
    return Vec3<float>{float(w.x), float(w.y), float(w.z)};
  };
  for (std::size_t k = 0; k < count; ++k) d.set(k, somewhere(), somewhere());
  return d;
}

// The best of some runs, nanoseconds per evaluation.
double time_of(const Term& term, const DirectionArrays<float>& d) {
  std::vector<float> out(d.size());
  double best = HUGE_VAL;
  for (int run = 0; run < 15; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    for (int k = 0; k < 5; ++k) eval_batch(term, 0, d.view(), out.data());
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return best / 5 / double(d.size()) * 1e9;
}

void print(const std::string& name, const shader::ShaderReflectance& model, double interpreted,
           double compiled) {
  std::printf("%-28s %5zu operations %7.1f ns", name.c_str(), model.function().as_written.size(),
              interpreted);
  if (compiled > 0) std::printf("  compiled %6.2f ns", compiled);
  std::printf("\n");
}

}  // namespace

int main(int count, char** arguments) {
  const DirectionArrays<float> d = directions(4096);
  for (const Reflectance& form : catalogue()) {
    const std::string text = io::glsl_source(make_material(form), {.material = false});
    const auto model = std::make_shared<const shader::ShaderReflectance>(
        shader::make_function(shader::parse_source("exported.glsl", text)));
    print(std::string(form.info().name), *model, time_of(model->material(model).terms[0], d),
          time_of(make_term(form, 1), d));
  }
  for (int k = 1; k < count; ++k) {
    const auto model = shader::load_shader({arguments[k]});
    print(arguments[k], *model, time_of(model->material(model).terms[0], d), 0);
  }
}
