// GLSL of whole functions, written by tracing.
#include <concepts>
#include <string>
#include <vector>

#include "brdf/trace.h"

namespace brdf {

namespace detail {

std::string glsl_function(std::string_view signature, const std::vector<Traced>& values,
                          std::string_view result, bool precise) {
  std::vector<int> roots;
  for (Traced v : values) roots.push_back(v.node());
  return std::string(signature) + " {\n" + Trace::current().statements(roots, result, precise) + "}\n";
}

}  // namespace detail

namespace {

// The GLSL function of a kernel with these arguments.
template <class Kernel>
std::string kernel_function(const char* name, const GlslOptions& options, Kernel kernel,
                            std::vector<std::string> arguments = {"x"}) {
  Trace trace(options.dialect);
  const Trace::Scope scope(trace);
  std::string signature = std::string("float ") + name + "(";
  for (const std::string& argument : arguments)
    signature += (signature.ends_with('(') ? "float " : ", float ") + argument;
  const auto input = [&](std::size_t k) { return Traced::input(arguments[k]); };
  const Traced value = [&] {
    if constexpr (std::invocable<Kernel, Traced>)
      return kernel(input(0));
    else
      return kernel(input(0), input(1));
  }();
  return detail::glsl_function(signature + ")", {value}, "return %0;", options.marks_precise());
}

}  // namespace

std::string glsl_kernels(const GlslOptions& options) {
  const GlslOptions& p = options;
  const std::string power =
      options.dialect == GlslDialect::es
          ? "uniform highp uint brdf_zero;  // 0, as it is when nobody sets it\n"
            "float brdf_power_of_two(float n) {\n  return uintBitsToFloat(uint(int(n) + 127) << 23u);\n}\n"
          : "";
  return power + kernel_function("brdf_exp", p, [](Traced x) { return kernels::exp(x); }) +
         kernel_function("brdf_log", p, [](Traced x) { return kernels::log(x); }) +
         kernel_function("brdf_log1p", p, [](Traced x, Traced rest) { return kernels::log1p(x, rest); },
                         {"x", "rest"}) +
         kernel_function("brdf_erfcx", p, [](Traced x) { return kernels::erfcx(x); }) +
         kernel_function("brdf_angle", p, [](Traced s, Traced c) { return kernels::angle(s, c); },
                         {"sine", "cosine"});
}

namespace {

// `case` of a switch: the reflectance's own function with these arguments before its shape and weights.
std::string call_of(std::string_view function, const NumberedReflectance& entry, std::string_view arguments,
                    std::size_t weights) {
  const ReflectanceInfo& info = entry.reflectance.info();
  std::string text = "    case " + std::to_string(entry.number) + ": return " + std::string(function) + "_" +
                     std::string(info.name) + "(" + std::string(arguments);
  for (std::size_t k = 0; k < info.shape.size(); ++k) text += ", shape[" + std::to_string(k) + "]";
  for (std::size_t k = 0; k < weights; ++k) text += ", w" + std::to_string(k);
  return text + ");\n";
}

}  // namespace

std::string glsl_dispatch(std::string_view function, std::span<const NumberedReflectance> reflectances) {
  std::string text = "vec3 " + std::string(function) +
                     "(int form, vec3 wi, vec3 wo, vec4 shape, vec3 w0, vec3 w1, vec3 w2) {\n  switch "
                     "(form) {\n";
  for (const NumberedReflectance& entry : reflectances)
    text += call_of(function, entry, "wi, wo", entry.reflectance.info().weights.size());
  return text + "  }\n  return vec3(0.0);\n}\n";
}

std::string glsl_sampler_dispatch(std::span<const NumberedReflectance> reflectances) {
  std::string sample = "vec3 brdf_sample(int form, vec3 u, vec3 wo, vec4 shape) {\n  switch (form) {\n",
              pdf = "float brdf_pdf(int form, vec3 wi, vec3 wo, vec4 shape) {\n  switch (form) {\n";
  for (const NumberedReflectance& entry : reflectances) {
    if (entry.reflectance->glsl_sampler().empty()) continue;
    sample += call_of("brdf_sample", entry, "u, wo", 0);
    pdf += call_of("brdf_pdf", entry, "wi, wo", 0);
  }
  Trace trace;
  const Trace::Scope scope(trace);
  const Vec3<Traced> u = detail::input_vector("u"), wi = sample_cosine(u.x, u.y);
  sample +=
      "  }\n" + trace.statements({wi.x.node(), wi.y.node(), wi.z.node()}, "return vec3(%0, %1, %2);", true);
  return sample + "}\n" + pdf + "  }\n  return max(wi.z, 0.0) * " + detail::float_literal(float(1 / kPi)) +
         ";\n}\n";
}

}  // namespace brdf
