#include "interop/gloss_numbers.h"

#include <algorithm>

#include "brdf/forms.h"
#include "io/files/error.h"
#include "io/files/numbers.h"

namespace brdf::interop {
namespace {

constexpr double kMostIndex = 5, kLeastHazeGloss = 70, kBesideImage = 0.3, kImageError = 1e-5;

std::string size_in_degrees(const RectangularAperture& aperture) {
  return io::short_number(aperture.in_plane.degrees(), 3) + " x " +
         io::short_number(aperture.across.degrees(), 3);
}

// Returns the standard of each number, with the apertures.
const std::array<std::string, 5>& rules() {
  const auto gloss_rule = [](const GlossGeometry& g) {
    return "ISO 2813 and ASTM D523: source " + size_in_degrees(g.source) + ", receptor " +
           size_in_degrees(g.receptor) + " degrees";
  };
  static const std::array<std::string, 5> all{
      gloss_rule(kGloss[0]), gloss_rule(kGloss[1]), gloss_rule(kGloss[2]),
      "ASTM D4039: gloss_60 - gloss_20, for gloss_60 above " + io::short_number(kLeastHazeGloss),
      "100 (1 - R(" + io::short_number(kBesideImage) +
          ")/R(0)) at 30 degrees, the angles of ASTM E430; source and "
          "receptors " +
          size_in_degrees(kImageSpecular.source) + " degrees"};
  return all;
}

constexpr const char* kTooSmooth =
    "the integration did not converge: the lobe is too narrow for it, or it varies too fast";

// The readings of one channel: gloss at 20, 60 and 85 degrees, the image, and the mean of both sides.
struct Readings {
  std::array<GlossReading, 3> gloss;
  GlossReading image, beside;
};

GlossReading mean_of(const GlossReading& a, const GlossReading& b) {
  return {(a.value + b.value) / 2, (a.error_bound + b.error_bound) / 2, a.evaluations + b.evaluations,
          a.converged && b.converged};
}

std::vector<GlossNumber> numbers_from(const Readings& r, const std::string& channel) {
  std::vector<GlossNumber> out;
  const auto add = [&](double value, double bound, bool converged, std::string undecided = "") {
    const std::size_t k = out.size();
    out.push_back({std::string(kGlossNumbers[k]), channel, value, bound, rules()[k],
                   converged ? std::move(undecided) : kTooSmooth});
  };
  for (const GlossReading& gloss : r.gloss) add(gloss.value, gloss.error_bound, gloss.converged);
  const GlossReading &g20 = r.gloss[0], &g60 = r.gloss[1];
  add(g60.value - g20.value, g60.error_bound + g20.error_bound, g60.converged && g20.converged,
      g60.value > kLeastHazeGloss ? ""
                                  : "ASTM D4039 applies to materials with gloss_60 above 70, but it is " +
                                        io::short_number(g60.value));
  const bool dark = !(r.image.value > r.image.error_bound);
  const double ratio = dark ? 0 : r.beside.value / r.image.value;
  add(100 * (1 - ratio),
      dark ? 0 : 100 * (r.beside.error_bound + ratio * r.image.error_bound) / r.image.value,
      r.image.converged && r.beside.converged,
      dark ? "nothing is reflected into the specular direction" : "");
  return out;
}

}  // namespace

std::vector<GlossNumber> gloss_numbers(const Material& material, Angle phi) {
  std::array<std::vector<GlossReading>, 3> at;
  for (std::size_t k = 0; k < at.size(); ++k) at[k] = gloss(material, kGloss[k], phi);
  const auto image = gloss(material, kImageSpecular, phi);
  double brightest = 0;
  for (const GlossReading& reading : image) brightest = std::max(brightest, reading.value);
  const GlossOptions by_image{.floor = kImageError * brightest};
  const auto below = gloss(material, beside_image(-kBesideImage), phi, by_image),
             above = gloss(material, beside_image(kBesideImage), phi, by_image);
  std::vector<GlossNumber> out;
  for (std::size_t c = 0; c < material.channels.size(); ++c)
    for (GlossNumber& number : numbers_from(
             {{at[0][c], at[1][c], at[2][c]}, image[c], mean_of(below[c], above[c])}, material.channels[c]))
      out.push_back(std::move(number));
  return out;
}

std::vector<GlossNumber> gloss_numbers_of_glass(double index) {
  if (!(index >= 1 && index <= kMostIndex))
    throw InputError("index " + io::short_number(index) + ": must lie in the range 1 to 5");
  const auto reading = [&](const GlossGeometry& geometry) { return gloss_of_glass(geometry, index); };
  // The mirror image of the source, 0.14 degrees wide, does not reach the receptors beside it.
  return numbers_from({{reading(kGloss[0]), reading(kGloss[1]), reading(kGloss[2])},
                       reading(kImageSpecular),
                       {0, 0, 0, true}},
                      "");
}

Material dielectric_lobe(double ggx_alpha, double index) {
  if (!(index >= 1 && index <= kMostIndex))
    throw InputError("--index " + io::short_number(index) + ": must lie in the range 1 to 5");
  Material lobe = make_material(cook_torrance_dielectric{}, {"f"});
  lobe.terms[0].weights[0] = {0, 1};
  lobe.terms[0].shape[0] = {ggx_alpha, ggx_alpha, index};
  return lobe;
}

}  // namespace brdf::interop
