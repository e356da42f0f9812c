#include "measured/on_sphere.h"

#include "io/colour/channel_colours.h"
#include "io/colour/in_colour.h"
#include "io/files/error.h"
#include "io/files/numbers.h"

namespace brdf::measured {

std::shared_ptr<const MeasuredReflectance> seen_in_colour(const io::SampleTable& table,
                                                          const Material* fitted,
                                                          MeasuredReflectance::Beside beside) {
  const io::SampleTable seen = io::in_colour(table);
  if (!fitted) return std::make_shared<const MeasuredReflectance>(seen, nullptr, beside);
  const Material material = io::in_colour(*fitted);
  return std::make_shared<const MeasuredReflectance>(seen, &material, beside);
}

io::sphere::MeasuredPairs on_sphere(std::shared_ptr<const MeasuredReflectance> measured) {
  const auto colours = io::channel_colours(measured->channels());
  if (!colours) throw InputError("the channels of the samples are not colours");
  return [measured = std::move(measured), of = colours->of](
             const Vec3<double>& wi, const Vec3<double>& wo) -> std::optional<io::sphere::Colour> {
    const std::optional<Seen> seen = measured->measured_at(wi, wo);
    if (!seen) return std::nullopt;
    return io::sphere::Colour{seen->f[of[0]], seen->f[of[1]], seen->f[of[2]]};
  };
}

std::string smoothed_words(const std::optional<double>& scatter) {
  return "smoothed measurements (scatter " +
         (scatter ? io::percent(*scatter, 2) + " removed)" : std::string("not known)"));
}

io::sphere::TableSize table_size(const MeasuredReflectance& measured) {
  return measured.turning() == Turning::isotropic ? io::sphere::kIsotropic : io::sphere::kTurned;
}

}  // namespace brdf::measured
