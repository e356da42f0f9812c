#include "shader/in_more_digits.h"

namespace brdf::shader {

double in_more_digits(const Function& function, std::span<const double> values, const Vec3<double>& wi,
                      const Vec3<double>& wo, std::size_t component) {
  using Long = long double;
  const auto unit = [](const Vec3<double>& w) {
    const Long length = std::sqrt(Long(w.x) * w.x + Long(w.y) * w.y + Long(w.z) * w.z);
    return Vec3<Long>{w.x / length, w.y / length, w.z / length};
  };
  Runner<Long, 1> runner(function);
  const std::vector<Long> wide(values.begin(), values.end());
  return double(evaluate<Long>(function, runner, wide, unit(wi), unit(wo), component));
}

}  // namespace brdf::shader
