#include "shader/half_precision.h"

#include "io/files/error.h"
#include "shader/front/definitions.h"
#include "shader/front/texts.h"

namespace brdf::shader {

std::shared_ptr<Function> set_programs(Function& f, LowerOptions options, const std::set<spirv::Id>& kernels,
                                       const std::function<Program(const LowerOptions&)>& lower) {
  options.by_meaning.clear();
  options.halves = Halves::allowed;
  std::shared_ptr<Function> in_half = std::make_shared<Function>();
  in_half->as_written = lower(options);
  if (first_half(in_half->as_written)) {
    options.halves = Halves::required;
    f.as_written = lower(options);
    f.has_half_types = first_half(f.as_written).has_value();
  } else {
    f.as_written = std::move(in_half->as_written);
    in_half.reset();
  }
  options.halves = Halves::none;
  options.by_meaning = kernels;
  f.as_meant = !kernels.empty() || f.has_half_types ? lower(options) : f.as_written;
  return in_half;
}

double in_half(const Function& function, std::span<const double> values, const Vec3<double>& wi,
               const Vec3<double>& wo, std::size_t component) {
  const auto single = [](const Vec3<double>& w) { return Vec3<float>{float(w.x), float(w.y), float(w.z)}; };
  const std::vector<float> narrow(values.begin(), values.end());
  Runner<float, 1> runner(*function.in_half);
  try {
    return evaluate<float>(*function.in_half, runner, narrow, single(wi), single(wo), component);
  } catch (const EndlessLoop& loop) {
    throw InputError(function.source.name + (loop.line > 0 ? ":" + std::to_string(loop.line) : "") +
                     ": in half precision this loop may not end: it was stopped after " +
                     std::to_string(kMostStepsRun) + " operations in one evaluation");
  }
}

std::string said_of_half(const Function& f, const Function* in_half, const std::string& word) {
  if (in_half != nullptr) {
    const std::uint32_t line = first_half(in_half->as_written).value_or(0);
    const std::string first = line > 0 ? " (the first in line " + std::to_string(line) + ")" : "";
    if (f.has_half_types)
      return "values have 16 bits" + first +
             ": in float they are rounded to half precision, in double they are not rounded";
    return "values may have 16 bits on a device" + first +
           ": they are computed in 32 bits; the check float of brdf validate also rounds them to half "
           "precision";
  }
  if (!f.half_unknown.empty()) return f.half_unknown + ": half precision is not judged";
  if (!word.empty()) return "";  // it has no effect on the value
  const std::string own = narrow_word(f.source.bare, f.source.language);
  if (own.empty() || f.source.whole.find(own) != f.source.whole.npos) return "";
  return own +
         " is not compiled, because the preprocessor leaves it out: half precision is not judged; if a macro "
         "such as GL_ES selects it, define this macro with --define";
}

}  // namespace brdf::shader
