// Shaders for tests, in the styles that users write.
#pragma once

#include <memory>
#include <string>

#include "io/files/error.h"
#include "shader/shader.h"

namespace brdf::shader {

inline std::shared_ptr<const ShaderReflectance> shader_of(const std::string& text,
                                                          const ShaderChoice& choice = {},
                                                          const std::string& name = "test.glsl") {
  return std::make_shared<const ShaderReflectance>(make_function(parse_source(name, text), choice));
}

inline double value_at(const std::shared_ptr<const ShaderReflectance>& shader, double theta_i, double phi_i,
                       double theta_o, double phi_o, std::size_t channel = 0) {
  const Material m = shader->material(shader);
  std::vector<double> f(m.channels.size());
  eval(m, direction(degrees(theta_i), degrees(phi_i)), direction(degrees(theta_o), degrees(phi_o)), f);
  return f[channel];
}

// Returns the message that refuses the shader, or "accepted".
inline std::string refusal(const std::string& text, const ShaderChoice& choice = {},
                           const std::string& name = "test.glsl") {
  try {
    shader_of(text, choice, name);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

inline const std::string kGgx = R"(#version 330 core
const float PI = 3.14159265359;
float D(float NoH, float a) { float a2 = a * a; float d = NoH * NoH * (a2 - 1.0) + 1.0; return a2 / (PI * d * d); }
float G1(float c, float a) { float a2 = a * a; return 2.0 * c / (c + sqrt(a2 + (1.0 - a2) * c * c)); }
vec3 F(float u, vec3 f0) { return f0 + (vec3(1.0) - f0) * pow(1.0 - u, 5.0); }
//: param roughness 0.05 1 0.5
vec3 brdf(vec3 L, vec3 V, vec3 N, float roughness, vec3 f0, vec3 albedo) {
  vec3 H = normalize(L + V);
  float NoL = max(dot(N, L), 1e-6), NoV = max(dot(N, V), 1e-6), NoH = dot(N, H), a = roughness * roughness;
  return albedo / PI + D(NoH, a) * G1(NoL, a) * G1(NoV, a) * F(dot(L, H), f0) / (4.0 * NoL * NoV);
}
)";

// Returns Fujii's form with the lost energy restored, as in the generated code of a material library. `s`
// is the GLSL expression for the azimuthal part, from which the code subtracts NdotL * NdotV.
inline std::string energy_preserving(const std::string& s) {
  return R"(#define M_PI 3.1415926535897932
#define M_PI_INV (1.0 / M_PI)
//: param roughness 0 1 1
//: color color 1 1 1
//: entry compensated_diffuse(NdotV, NdotL, LdotV, roughness, color)
const float C1 = 0.5 - 2.0 / (3.0 * M_PI);
const float C2 = 2.0 / 3.0 - 28.0 / (15.0 * M_PI);
float square(float x) { return x * x; }
float albedo_of(float c, float roughness) {
  float A = 1.0 / (1.0 + C1 * roughness), B = roughness * A;
  float Si = sqrt(max(0.0, 1.0 - square(c)));
  float G = Si * (acos(clamp(c, -1.0, 1.0)) - Si * c) + 2.0 * ((Si / c) * (1.0 - Si * Si * Si) - Si) / 3.0;
  return A + B * G * M_PI_INV;
}
vec3 compensated_diffuse(float NdotV, float NdotL, float LdotV, float roughness, vec3 color) {
  float s = )" +
         s + R"( - NdotL * NdotV;
  float stinv = s > 0.0 ? s / max(NdotL, NdotV) : s;
  float A = 1.0 / (1.0 + C1 * roughness);
  vec3 lobe = color * A * (1.0 + roughness * stinv);
  float average = A * (1.0 + C2 * roughness);
  vec3 many = color * color * average / (vec3(1.0) - color * max(0.0, 1.0 - average));
  return (lobe + many * max(1e-8, 1.0 - albedo_of(NdotL, roughness)) * max(1e-8, 1.0 - albedo_of(NdotV, roughness)) /
          max(1e-8, 1.0 - average)) * M_PI_INV;
}
)";
}

}  // namespace brdf::shader
