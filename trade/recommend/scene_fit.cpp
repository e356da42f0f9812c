#include "trade/recommend/scene_fit.h"

#include <algorithm>
#include <cmath>

#include "brdf/geometry.h"
#include "fit/fit.h"
#include "io/colour/in_colour.h"
#include "render/compare/measured.h"
#include "trade/measure/domain.h"

namespace brdf::trade {
namespace {

Vec3<double> vec(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}
glm::vec3 vec(const std::array<double, 3>& v) {
  return {float(v[0]), float(v[1]), float(v[2])};
}
double polar(double cosine) {
  return radians(std::acos(std::clamp(cosine, -1.0, 1.0))).degrees();
}

io::SampleTable rgb_table() {
  io::SampleTable table;
  table.set_channels({"r", "g", "b"});
  return table;
}
void add_row(io::SampleTable& table, const Vec3<double>& wi, const Vec3<double>& wo,
             const RgbFunction& reference) {
  table.add_directions(wi, wo);
  const std::array<double, 3> f = reference(wi, wo);
  for (std::size_t c = 0; c < 3; ++c) table.values[c].push_back(f[c]);
}

struct Azimuths {
  double mean, spread;
};
// Returns the mean azimuth modulo 180 degrees, and the largest distance from this mean.
Azimuths azimuths_of(const std::vector<double>& phi) {
  double c = 0, s = 0;
  for (double p : phi) c += std::cos(2 * p), s += std::sin(2 * p);
  const double mean = 0.5 * std::atan2(s, c);
  double spread = 0;
  for (double p : phi) spread = std::max(spread, std::abs(std::remainder(p - mean, kPi)));
  return {radians(mean).degrees(), radians(spread).degrees()};
}

}  // namespace

RgbFunction rgb_function(const Material& given) {
  const Material material = io::in_colour(given);
  const std::array<std::size_t, 3> colours = render::require_colours(material.channels, "the material").of;
  return [material, colours](const Vec3<double>& wi, const Vec3<double>& wo) {
    std::vector<double> f(material.channels.size());
    eval(material, wi, wo, f);
    return std::array<double, 3>{f[colours[0]], f[colours[1]], f[colours[2]]};
  };
}

bool is_isotropic(const RgbFunction& reference) {
  constexpr double kSame = 1e-4;  // relative; interpolated values have single precision
  const Points points = sample(direction_domain(0, 85), 1024);
  double difference = 0, total = 0;
  for (std::size_t k = 0; k < points.count(); ++k) {
    const auto row = row_at<DirectionRow>(points.columns, k);
    const double phi = 1 + double(k);  // radians: all turns differ
    const double c = std::cos(phi), s = std::sin(phi);
    const auto f = reference(row.wi, row.wo), turned = reference(turn(row.wi, c, s), turn(row.wo, c, s));
    for (std::size_t channel = 0; channel < 3; ++channel) {
      difference += std::abs(f[channel] - turned[channel]);
      total += f[channel];
    }
  }
  return difference <= kSame * total;
}

RgbFunction rgb_function(const io::SampleTable& table) {
  const render::Measured measured = render::interpolate(table);
  return [measured](const Vec3<double>& wi, const Vec3<double>& wo) {
    const glm::vec3 f =
        measured({float(wi.x), float(wi.y), float(wi.z)}, {float(wo.x), float(wo.y), float(wo.z)}).f_cos;
    const double c = std::max(wi.z, 1e-6);
    return std::array<double, 3>{f.x / c, f.y / c, f.z / c};
  };
}

SceneView view_of(render::Scene scene) {
  for (render::Object& object : scene.objects) {
    // Arbitrary: only the directions of the scene are used.
    object.material = make_material(catalogue().front());
    object.textures = {};
  }
  SceneView view{render::prepare(std::move(scene)), {}};
  view.points = render::lit_points(view.scene);
  return view;
}

io::SampleTable scene_samples(const SceneView& view, const RgbFunction& reference, std::size_t rows) {
  io::SampleTable table = rgb_table();
  const std::size_t stride = std::max<std::size_t>(1, view.points.size() / rows);
  for (std::size_t k = stride / 2; k < view.points.size(); k += stride) {
    const render::LitPoint& p = view.points[k];
    const double irradiance = double(p.irradiance.x + p.irradiance.y + p.irradiance.z) / 3;
    if (!(irradiance > 0)) continue;
    add_row(table, vec(p.wi), vec(p.wo), reference);
    for (std::vector<double>& sigma : table.sigma) sigma.push_back(1 / (irradiance * double(p.wi.z)));
  }
  return table;
}

io::SampleTable hemisphere_samples(const RgbFunction& reference, std::size_t rows) {
  io::SampleTable table = rgb_table();
  const double least = std::cos(degrees(85).radians());
  const Points points = sample(
      make_domain({{"cos_i", least, 1}, {"cos_o", least, 1}, {"phi_i", -180, 180}, {"phi_o", -180, 180}},
                  [](std::span<const double> at) {
                    return DirectionRow<double>{direction(radians(std::acos(at[0])), degrees(at[2])),
                                                direction(radians(std::acos(at[1])), degrees(at[3]))};
                  }),
      rows);
  for (std::size_t k = 0; k < points.count(); ++k) {
    const auto row = row_at<DirectionRow>(points.columns, k);
    add_row(table, row.wi, row.wo, reference);
  }
  return table;
}

double image_error(const SceneView& view, const RgbFunction& model, const RgbFunction& reference) {
  double difference = 0, total = 0;
  for (std::size_t k = 0; k < view.points.size();) {
    std::array<double, 3> d{}, l{};
    const int x = view.points[k].x, y = view.points[k].y;
    for (; k < view.points.size() && view.points[k].x == x && view.points[k].y == y; ++k) {
      const render::LitPoint& p = view.points[k];
      const Vec3<double> wi = vec(p.wi), wo = vec(p.wo);
      const std::array<double, 3> f = model(wi, wo), g = reference(wi, wo);
      for (std::size_t c = 0; c < 3; ++c) {
        const double w = double(p.irradiance[int(c)]) * wi.z;
        d[c] += w * (f[c] - g[c]);
        l[c] += w * g[c];
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      difference += std::abs(d[c]);
      total += l[c];
    }
  }
  return total > 0 ? difference / total : 0;
}

RenderedPair render_both(const SceneView& view, const RgbFunction& model, const RgbFunction& reference) {
  const auto picture = [&](const RgbFunction& f) {
    const render::Measured measured = [&f](const glm::vec3& wi, const glm::vec3& wo) {
      if (wi.z <= 0 || wo.z <= 0) return render::MeasuredValue(glm::vec3(0));
      return render::MeasuredValue(vec(f(vec(wi), vec(wo))) * wi.z);
    };
    render::ReferenceOptions options;
    options.measured = &measured;
    return render::render_reference(view.scene, options);
  };
  RenderedPair pair{picture(model), picture(reference), 0};
  double difference = 0, total = 0;
  for (std::size_t k = 0; k < view.points.size(); ++k) {
    const render::LitPoint& p = view.points[k];
    if (k > 0 && view.points[k - 1].x == p.x && view.points[k - 1].y == p.y) continue;
    const glm::vec4 a = pair.model.at(p.x, p.y), b = pair.reference.at(p.x, p.y);
    for (int c = 0; c < 3; ++c) {
      difference += std::abs(double(a[c]) - double(b[c]));
      total += double(b[c]);
    }
  }
  pair.image_error = total > 0 ? difference / total : 0;
  return pair;
}

Material fit_to_picture(const Reflectance& form, const io::SampleTable& table, bool anisotropic) {
  fit::FitOptions options;
  options.metric = fit::Metric::cosine_l2;
  options.max_theta = 90;
  options.anisotropic = anisotropic;
  options.cross_validation = options.profiles = false;  // the parameters are used, their intervals are not
  return fit::fit(table, {{form}}, options).ranking.front().material;
}

Coverage coverage_of(const SceneView& view) {
  Coverage coverage;
  std::vector<double> azimuths;
  for (std::size_t k = 0; k < view.points.size(); ++k) {
    const render::LitPoint& p = view.points[k];
    const auto g = geometry(vec(p.wi), vec(p.wo));
    const double theta_h = polar(g.h.z / std::sqrt(g.h2));
    if (k == 0 || view.points[k - 1].x != p.x || view.points[k - 1].y != p.y) ++coverage.pixels;
    coverage.most_theta_i = std::max(coverage.most_theta_i, polar(g.cos_i));
    coverage.most_theta_o = std::max(coverage.most_theta_o, polar(g.cos_o));
    coverage.most_theta_d = std::max(coverage.most_theta_d, polar(g.cos_d));
    coverage.least_theta_h = std::min(coverage.least_theta_h, theta_h);
    coverage.most_theta_h = std::max(coverage.most_theta_h, theta_h);
    if (theta_h > 1) azimuths.push_back(std::atan2(g.h.y, g.h.x));
  }
  if (!azimuths.empty()) {
    const Azimuths a = azimuths_of(azimuths);
    coverage.azimuth_of_h = a.mean;
    coverage.azimuth_spread = a.spread;
  }
  return coverage;
}

}  // namespace brdf::trade
