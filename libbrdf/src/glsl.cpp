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

std::string glsl_dispatch(std::string_view function, std::span<const NumberedReflectance> reflectances) {
  const std::string name(function);
  std::string text = "vec3 " + name +
                     "(int form, vec3 wi, vec3 wo, vec4 shape, vec3 w0, vec3 w1, vec3 w2) {\n  switch "
                     "(form) {\n";
  for (const auto& [number, reflectance] : reflectances) {
    const ReflectanceInfo& info = reflectance.info();
    text +=
        "    case " + std::to_string(number) + ": return " + name + "_" + std::string(info.name) + "(wi, wo";
    for (std::size_t k = 0; k < info.shape.size(); ++k) text += ", shape[" + std::to_string(k) + "]";
    for (std::size_t k = 0; k < info.weights.size(); ++k) text += ", w" + std::to_string(k);
    text += ");\n";
  }
  return text + "  }\n  return vec3(0.0);\n}\n";
}

}  // namespace brdf
