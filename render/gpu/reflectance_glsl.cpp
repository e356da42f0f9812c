#include "render/gpu/reflectance_glsl.h"

#include "render/gpu/gpu_layout.h"

namespace brdf::render {

std::vector<NumberedReflectance> numbered_catalogue() {
  std::vector<NumberedReflectance> list;
  const std::span<const Reflectance> all = catalogue();
  for (std::size_t k = 0; k < all.size(); ++k)
    if (shader_obstacle(all[k].info()).empty()) list.push_back({int(k), all[k]});
  return list;
}

std::vector<Reflectance> drawable_forms() {
  std::vector<Reflectance> forms;
  for (const NumberedReflectance& entry : numbered_catalogue()) forms.push_back(entry.reflectance);
  return forms;
}

std::string shader_obstacle(const ReflectanceInfo& info) {
  if (!info.has_glsl) return "has no GLSL";
  const std::size_t shape = most_shape(info.weights.size());
  if (info.weights.size() > kMostWeights || info.shape.size() > shape)
    return "has more than " + std::to_string(kMostWeights) + " weights per channel or " +
           std::to_string(shape) + " shape parameters";
  return "";
}

std::string reflectances_glsl(std::span<const NumberedReflectance> list, const GlslOptions& options) {
  std::string text = glsl_kernels(options);
  for (const NumberedReflectance& entry : list) text += entry.reflectance->glsl(options);
  return text + glsl_dispatch("brdf_eval_cos", list);
}

std::string samplers_glsl(std::span<const NumberedReflectance> list, const GlslOptions& options) {
  std::string text;
  for (const NumberedReflectance& entry : list) text += entry.reflectance->glsl_sampler(options);
  return text + glsl_sampler_dispatch(list);
}

std::string proof_glsl(std::span<const NumberedReflectance> list, const GlslOptions& options) {
  return "#version 450\nlayout(local_size_x = " + std::to_string(kProofGroup) + R"glsl() in;
layout(constant_id = 0) const int form = 0;
layout(std430, binding = 0) readonly buffer Configurations { vec4 configuration[]; };
layout(std430, binding = 1) writeonly buffer Results { vec4 result[]; };
layout(push_constant) uniform Push { uint count; };
)glsl" + reflectances_glsl(list, options) +
         glsl_dispatch("brdf_eval", list) + R"(
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  vec3 wi = configuration[6 * i].xyz, wo = configuration[6 * i + 1].xyz;
  vec4 shape = configuration[6 * i + 2];
  vec3 w0 = configuration[6 * i + 3].xyz, w1 = configuration[6 * i + 4].xyz, w2 = configuration[6 * i + 5].xyz;
  result[2 * i] = vec4(brdf_eval(form, wi, wo, shape, w0, w1, w2), 0.0);
  result[2 * i + 1] = vec4(brdf_eval_cos(form, wi, wo, shape, w0, w1, w2), 0.0);
}
)";
}

}  // namespace brdf::render
