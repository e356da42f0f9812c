// Measures the time per evaluation in float, in one run: five shaders by the interpreter, on the Vulkan
// driver and compiled natively; then all exported forms by the interpreter, compared with the library's
// compiled batch; then the named shaders.
//   bench_shader [SHADER...]
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>

#include "bench/native_shaders.h"
#include "brdf/random.h"
#include "io/material/glsl.h"
#include "render/gpu/held.h"
#include "render/proof/shader_proof.h"
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

// Returns the best time of several runs, in nanoseconds per evaluation of `count`.
double best_time(std::size_t count, const std::function<void()>& work) {
  double best = HUGE_VAL;
  for (int run = 0; run < 15; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    for (int k = 0; k < 5; ++k) work();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return best / 5 / double(count) * 1e9;
}

double time_of(const Term& term, const DirectionArrays<float>& d) {
  std::vector<float> out(d.size());
  return best_time(d.size(), [&] { eval_batch(term, 0, d.view(), out.data()); });
}

// f_r and f_r cos_i of three channels count as two evaluations.
double driver_time(render::Device& device, const Material& material, const DirectionArrays<float>& d) {
  const Term term = render::with_room(material).terms.front();
  std::vector<render::ProofConfiguration> all(d.size());
  for (std::size_t k = 0; k < d.size(); ++k) {
    const Vec3<float> wi = d.view().wi(k), wo = d.view().wo(k);
    all[k].wi = {wi.x, wi.y, wi.z, 0}, all[k].wo = {wo.x, wo.y, wo.z, 0};
    for (std::size_t j = 0; j < term.shape[0].size(); ++j) all[k].shape[j] = float(term.shape[0][j]);
    for (std::size_t j = 0; j < term.weights[0].size(); ++j)
      all[k].weights[j].fill(float(term.weights[0][j]));
  }
  render::ShaderBatch batch(device, term.form, all);
  return best_time(2 * d.size(), [&] { batch.run(); });
}

void print(const std::string& name, const shader::ShaderReflectance& model, double interpreted,
           double on_driver, double native) {
  std::printf("%-28s %5zu operations %7.1f ns", name.c_str(), model.function().as_written.size(),
              interpreted);
  if (on_driver > 0) std::printf("  driver %7.1f ns", on_driver);
  if (native > 0) std::printf("  compiled %6.2f ns", native);
  std::printf("\n");
}

std::shared_ptr<const shader::ShaderReflectance> exported(const Reflectance& form) {
  const std::string text = io::glsl_source(make_material(form), {.material = false});
  return std::make_shared<const shader::ShaderReflectance>(
      shader::make_function(shader::parse_source("exported.glsl", text)));
}

void five(const DirectionArrays<float>& d) {
  render::Device device;
  std::printf("interpreter, %s (both threads), compiled C++:\n", device.name().c_str());
  const std::string folder = BRDF_SOURCE_DIR "/data/shaders/";
  for (const auto& [file, native] : {std::pair("sound.glsl", &bench::native_sound),
                                     std::pair("clamped_dot.glsl", &bench::native_clamped_dot),
                                     std::pair("wrong_norm.brdf", &bench::native_wrong_norm)}) {
    const auto model = shader::load_shader({folder + file});
    const Material m = model->material(model);
    std::vector<float> out(d.size());
    print(file, *model, time_of(m.terms[0], d), driver_time(device, m, d),
          best_time(d.size(), [&] { native(d.view(), out.data()); }));
  }
  // Two exported forms of the catalogue: the first two with facets.
  int shown = 0;
  for (const Reflectance& form : catalogue()) {
    if (!form.info().facets || shown++ >= 2) continue;
    const auto model = exported(form);
    const Material m = model->material(model);
    print(std::string(form.info().name), *model, time_of(m.terms[0], d), driver_time(device, m, d),
          time_of(make_term(form, 1), d));
  }
}

}  // namespace

int main(int count, char** arguments) {
  five(directions(1 << 12));
  const DirectionArrays<float> d = directions(4096);
  std::printf("all forms:\n");
  for (const Reflectance& form : catalogue()) {
    const auto model = exported(form);
    print(std::string(form.info().name), *model, time_of(model->material(model).terms[0], d), 0,
          time_of(make_term(form, 1), d));
  }
  for (int k = 1; k < count; ++k) {
    const auto model = shader::load_shader({arguments[k]});
    print(arguments[k], *model, time_of(model->material(model).terms[0], d), 0, 0);
  }
}
