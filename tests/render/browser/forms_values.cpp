// Writes as JSON to stdout the data with which a page evaluates every form of the catalogue in WebGL 2 and
// compares the results: shaders in GLSL ES, configurations, and the float values of the library for them.
#include <iostream>

#include "brdf/trace.h"
#include "io/files/base64.h"
#include "io/files/json.h"
#include "render/gpu/held.h"
#include "render/proof/shader_proof.h"

namespace {

using namespace brdf;

constexpr std::size_t kSide = 64;     // of the target: 4096 pairs of directions per form
constexpr std::size_t kOneSet = 256;  // pairs that share their parameters, and therefore a peak

template <class T>
std::string packed(const std::vector<T>& rows) {
  return io::base64({reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(T)});
}

std::string shader_of(const Reflectance& form) {
  const NumberedReflectance only{0, form};
  const GlslOptions es{.dialect = GlslDialect::es};
  return "#version 300 es\nprecision highp float;\nprecision highp int;\n" + glsl_kernels(es) +
         form->glsl(es) + glsl_dispatch("brdf_eval", {&only, 1}) +
         glsl_dispatch("brdf_eval_cos", {&only, 1}) + R"glsl(
uniform highp sampler2D rows;  // six texels of a configuration beside each other
layout(location = 0) out vec4 f;
layout(location = 1) out vec4 f_cos;
vec4 row(int k) { return texelFetch(rows, ivec2(6 * int(gl_FragCoord.x) + k, int(gl_FragCoord.y)), 0); }
void main() {
  vec3 wi = row(0).xyz, wo = row(1).xyz, w0 = row(3).xyz, w1 = row(4).xyz, w2 = row(5).xyz;
  f = vec4(brdf_eval(0, wi, wo, row(2), w0, w1, w2), 1.0);
  f_cos = vec4(brdf_eval_cos(0, wi, wo, row(2), w0, w1, w2), 1.0);
}
)glsl";
}

io::Json entry(const Reflectance& form) {
  auto rows = render::random_configurations(form, kSide * kSide, 7);
  std::vector<render::ProofValues> values;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].shape = rows[k - k % kOneSet].shape;
    rows[k].weights = rows[k - k % kOneSet].weights;
    values.push_back(render::library_values(form, rows[k]));
  }
  return {{"name", info(form).name},
          {"shader", shader_of(form)},
          {"rows", packed(rows)},
          {"values", packed(values)}};
}

}  // namespace

int main() {
  io::Json forms = io::Json::array();
  for (const Reflectance& form : catalogue())
    if (info(form).has_glsl) forms.push_back(entry(render::with_room(form)));
  std::cout << io::to_line({{"side", kSide}, {"one_set", kOneSet}, {"forms", forms}}) << '\n';
}
