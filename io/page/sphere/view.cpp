#include "io/page/sphere/view.h"

#include <cmath>

#include "io/colour/channel_colours.h"
#include "io/colour/in_colour.h"
#include "io/files/error.h"

namespace brdf::io::sphere {
namespace {

Vec3<double> towards(Angle turn, Angle tilt) {
  const double c = std::cos(tilt.radians());
  return {std::sin(turn.radians()) * c, std::sin(tilt.radians()), std::cos(turn.radians()) * c};
}

}  // namespace

FittedPairs fitted_pairs(const Material& given) {
  const Material material = in_colour(given);
  const std::optional<ChannelColours> colours = channel_colours(material.channels);
  if (!colours) throw InputError("the channels of the material cannot be converted to a colour");
  return [material, of = colours->of](const Vec3<double>& wi, const Vec3<double>& wo) {
    std::vector<double> f(material.channels.size());
    eval(material, wi, wo, f);
    return Colour{f[of[0]], f[of[1]], f[of[2]]};
  };
}

View view_from(Angle turn, Angle tilt, Angle light_turn, Angle light_tilt) {
  View view;
  view.light = towards(light_turn, light_tilt);
  view.towards = towards(turn, tilt);
  view.right = towards(turn + degrees(90), {});
  view.up = cross(view.towards, view.right);
  return view;
}

View first_view() {
  return view_from({}, {}, degrees(-35), degrees(30));
}

Frame frame_at(const View& view, double x, double y) {
  const double z = std::sqrt(std::fmax(0.0, 1 - x * x - y * y));
  const Vec3<double> n = view.right * x + view.up * y + view.towards * z;
  Vec3<double> t = cross(Vec3<double>{0, 1, 0}, n);
  const double length = std::sqrt(dot(t, t));
  t = length > 1e-6 ? t * (1 / length) : Vec3<double>{1, 0, 0};
  return {n, t, cross(n, t)};
}

Pair pair_at(const View& view, double x, double y) {
  const Frame f = frame_at(view, x, y);
  const auto local = [&](const Vec3<double>& w) {
    return Vec3<double>{dot(w, f.tangent), dot(w, f.bitangent), dot(w, f.normal)};
  };
  return {local(view.light), local(view.towards)};
}

}  // namespace brdf::io::sphere
