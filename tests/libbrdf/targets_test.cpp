// Targets against the lines of their sources, transcribed here a second time. The transcription uses
// normalised half vectors, tangents and complex numbers as the renderers' programs do, and no factor of
// libbrdf.
#include "brdf/targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <map>

#include "brdf/directions.h"
#include "brdf/integrals.h"
#include "brdf/material.h"
#include "brdf/random.h"
#include "brdf/targets/three_table.h"
#include "tests/thorough.h"

namespace brdf {
namespace {

// One pair of directions and the parameters of one channel by name, as a renderer's shader receives them.
struct Hit {
  Vec3<double> l, v, h;
  std::map<std::string, double, std::less<>> p;
  double operator[](std::string_view name) const { return p.find(name)->second; }
  double l_h() const { return dot(l, h); }
};

double pow5(double x) {
  return x * x * x * x * x;
}
double pi() {
  return std::acos(-1.0);
}

// bsdf_microfacet.h: bsdf_D, anisotropic. microfacet.h of pbrt and of Mitsuba have the same formula in
// another notation.
double d_of_slopes(const Hit& c) {
  const double x = c.h.x / (c.h.z * c["alpha_x"]), y = c.h.y / (c.h.z * c["alpha_y"]), cos2 = c.h.z * c.h.z;
  const double t = 1 + x * x + y * y;
  return 1 / (pi() * c["alpha_x"] * c["alpha_y"] * cos2 * cos2 * t * t);
}
double alpha_tan2(const Hit& c, const Vec3<double>& w) {
  return (std::pow(c["alpha_x"] * w.x, 2) + std::pow(c["alpha_y"] * w.y, 2)) / (w.z * w.z);
}
// bsdf_microfacet.h: bsdf_G1_from_sqr_alpha_tan_n; Mitsuba's smith_g1.
double g1(const Hit& c, const Vec3<double>& w) {
  return 2 / (1 + std::sqrt(1 + alpha_tan2(c, w)));
}
double separable(const Hit& c) {
  return d_of_slopes(c) * g1(c, c.l) * g1(c, c.v) / (4 * c.l.z * c.v.z);
}
// scattering.h: TrowbridgeReitzDistribution::Lambda and G; also Cycles from 3.5 on.
double lambda(const Hit& c, const Vec3<double>& w) {
  return (std::sqrt(1 + alpha_tan2(c, w)) - 1) / 2;
}
double correlated(const Hit& c) {
  return d_of_slopes(c) / (1 + lambda(c, c.l) + lambda(c, c.v)) / (4 * c.l.z * c.v.z);
}

// bsdf_util.h: fresnel_dielectric_cos.
double cycles_fresnel(double c, double eta) {
  const double g = std::sqrt(eta * eta - 1 + c * c), a = (g - c) / (g + c);
  const double b = (c * (g + c) - 1) / (c * (g - c) + 1);
  return 0.5 * a * a * (1 + b * b);
}
// fresnel.h: fresnel, written with the cosine of the angle of refraction.
double mitsuba_fresnel(double c, double eta) {
  const double cos_t = std::sqrt(1 - (1 - c * c) / (eta * eta));
  const double s = (c - eta * cos_t) / (c + eta * cos_t), p = (cos_t - eta * c) / (cos_t + eta * c);
  return 0.5 * (s * s + p * p);
}
// scattering.h: FrComplex.
double pbrt_fresnel(double c, std::complex<double> eta) {
  const std::complex<double> cos_t = std::sqrt(1.0 - (1 - c * c) / (eta * eta));
  return 0.5 * (std::norm((eta * c - cos_t) / (eta * c + cos_t)) +
                std::norm((c - eta * cos_t) / (c + eta * cos_t)));
}
// fresnel.h: fresnel_conductor.
double mitsuba_conductor(double c, double n, double k) {
  const double cos2 = c * c, sin2 = 1 - cos2, t = n * n - k * k - sin2;
  const double a2b2 = std::sqrt(t * t + 4 * n * n * k * k), a = std::sqrt(0.5 * (a2b2 + t));
  const double rs = (a2b2 + cos2 - 2 * c * a) / (a2b2 + cos2 + 2 * c * a);
  const double u = a2b2 * cos2 + sin2 * sin2, w = 2 * c * a * sin2;
  return 0.5 * (rs + rs * (u - w) / (u + w));
}

// bsdf_principled_diffuse.h (LH2 = L.V + 1); Mitsuba's principled.cpp writes 2 cos_d^2 instead.
double disney_diffuse(const Hit& c) {
  const double fl = pow5(1 - c.l.z), fv = pow5(1 - c.v.z);
  const double roughness = std::pow(c["alpha_x"] * c["alpha_y"], 0.25);
  const double rr = roughness * (dot(c.l, c.v) + 1);
  return (1 - 0.5 * fv) * (1 - 0.5 * fl) + rr * (fl + fv + fl * fv * (rr - 1));
}

double blender_principled(const Hit& c) {
  const double specular = std::pow((c["eta"] - 1) / (c["eta"] + 1), 2) / 0.08;
  const double ior = 2 / (1 - std::sqrt(0.08 * specular)) - 1, m = c["metallic"], base = c["base_color"];
  const double cspec0 = specular * 0.08 * (1 - m) + base * m, f0 = cycles_fresnel(1, ior);
  const double fh = (cycles_fresnel(c.l_h(), ior) - f0) / (1 - f0);
  return base * (1 - m) * disney_diffuse(c) / pi() + (cspec0 * (1 - fh) + fh) * separable(c);
}
double mitsuba_principled(const Hit& c) {
  const double m = c["metallic"], base = c["base_color"], rise = pow5(1 - c.l_h());
  const double f = (1 - m) * mitsuba_fresnel(c.l_h(), c["eta"]) + m * (base * (1 - rise) + rise);
  return base * (1 - m) * disney_diffuse(c) / pi() + f * separable(c);
}
// Specification.adoc, appendix B; KHR_materials_anisotropy writes D and V with vectors.
double gltf(const Hit& c) {
  const double at = c["alpha_x"], ab = c["alpha_y"], a2 = at * ab;
  const double w2 = a2 / (std::pow(ab * c.h.x, 2) + std::pow(at * c.h.y, 2) + std::pow(a2 * c.h.z, 2));
  const auto length = [&](const Vec3<double>& w) { return std::hypot(at * w.x, ab * w.y, w.z); };
  const double free = 0.5 / (c.l.z * length(c.v) + c.v.z * length(c.l));
  const double v = at == ab ? free : std::clamp(free, 0.0, 1.0), lobe = a2 * w2 * w2 / pi() * v;
  const double base = c["base_color"], rise = pow5(1 - c.l_h()), ior = c["eta"];
  const double f0 = std::min(std::pow((1 - ior) / (1 + ior), 2) * c["specular_color"], 1.0);
  const double fr = f0 * c["specular"] + (c["specular"] - f0 * c["specular"]) * rise;
  const double metal = lobe * (base + (1 - base) * rise), dielectric = base / pi() * (1 - fr) + lobe * fr;
  return dielectric * (1 - c["metallic"]) + metal * c["metallic"];
}

// mx_microfacet_diffuse.glsl: mx_oren_nayar_diffuse; the node clamps l.v.
double materialx_diffuse(const Hit& c) {
  const double l_v = std::clamp(dot(c.l, c.v), 1e-8, 1.0), s = l_v - c.l.z * c.v.z;
  const double stinv = s > 0 ? s / std::max(c.l.z, c.v.z) : 0, sigma2 = c["sigma"] * c["sigma"];
  return 1 - 0.5 * (sigma2 / (sigma2 + 0.33)) + 0.45 * sigma2 / (sigma2 + 0.09) * stinv;
}
// mx_microfacet_specular.glsl: mx_ggx_dir_albedo_analytic with F0 = F90 = 1, row by row of its sum.
std::pair<double, double> materialx_ab(double x, double y) {
  const double rows[9][4] = {
      {0.1003, 0.9345, 1, 1},          {-0.6303, -2.323, -1.765, 0.2281}, {9.748, 2.229, 8.263, 15.94},
      {-2.038, -3.748, 11.53, -55.83}, {29.34, 1.424, 28.96, 13.08},      {-8.245, -0.7684, -7.507, 41.26},
      {-26.44, 1.436, -36.11, 54.9},   {19.99, 0.2913, 15.86, 300.2},     {-5.448, 0.6286, 33.37, -285.1}};
  const double terms[9] = {1, x, y, x * y, x * x, y * y, x * x * y, x * y * y, x * x * y * y};
  double r[4] = {};
  for (int k = 0; k < 9; ++k)
    for (int j = 0; j < 4; ++j) r[j] += rows[k][j] * terms[k];
  return {std::clamp(r[0] / r[2], 0.0, 1.0), std::clamp(r[1] / r[3], 0.0, 1.0)};
}
// mx_ggx_energy_compensation of a lobe whose Fresnel term rises from f0 to f90.
double materialx_comp(const Hit& c, double f0, double f90) {
  const auto [a, b] = materialx_ab(c.v.z, std::sqrt(c["alpha_x"] * c["alpha_y"]));
  const double e = a + b, fss = f0 + (f90 - f0) * (1.0 / 21);
  return 1 + fss * (1 - e) / e;
}
// mx_ggx_dir_albedo times the compensation: what a layer leaves out of its base.
double materialx_albedo(const Hit& c, double f0, double f90) {
  const auto [a, b] = materialx_ab(c.v.z, std::sqrt(c["alpha_x"] * c["alpha_y"]));
  return (f0 * a + f90 * b) * materialx_comp(c, f0, f90);
}
// D G/(4 cos_l cos_v) of all lobes; the responses of the nodes include cos_l.
double materialx_dg(const Hit& c) {
  const double alpha = std::sqrt(c["alpha_x"] * c["alpha_y"]), a2 = alpha * alpha;
  const auto length = [&](double n_w) { return std::sqrt(a2 + (1 - a2) * n_w * n_w); };
  const double g2 = 2 * c.l.z * c.v.z / (length(c.l.z) * c.v.z + length(c.v.z) * c.l.z);
  return d_of_slopes(c) * g2 / (4 * c.v.z) / c.l.z;
}
// mx_generalized_schlick_bsdf.glsl
double materialx_schlick_node(const Hit& c, double f0, double f90) {
  return materialx_dg(c) * (f0 + (f90 - f0) * pow5(1 - c.l_h())) * materialx_comp(c, f0, f90);
}
// mx_dielectric_bsdf.glsl, over the base that it leaves.
double materialx_dielectric_over(const Hit& c, double weight, double ior, double base) {
  const double f0 = std::pow((ior - 1) / (ior + 1), 2);
  return weight * materialx_dg(c) * mitsuba_fresnel(c.l_h(), ior) * materialx_comp(c, f0, 1) +
         (1 - weight * materialx_albedo(c, f0, 1)) * base;
}
// mx_artistic_ior.glsl and mx_conductor_bsdf.glsl; the Fresnel term by complex numbers.
double materialx_conductor(const Hit& c, double reflectivity, double edge) {
  const double r = std::clamp(reflectivity, 0.0, 0.99), root = std::sqrt(r);
  const double n_min = (1 - r) / (1 + r), n_max = (1 + root) / (1 - root), n = n_max + edge * (n_min - n_max);
  const double k = std::sqrt(std::max(((n + 1) * (n + 1) * r - (n - 1) * (n - 1)) / (1 - r), 0.0));
  return materialx_dg(c) * pbrt_fresnel(c.l_h(), {n, k}) * materialx_comp(c, r, 1);
}
double materialx(const Hit& c) {
  return c["kd"] * materialx_diffuse(c) / pi() + c["ks"] * materialx_schlick_node(c, c["f0"], 1);
}
// The graphs of libraries/bxdf.
double mix(double bg, double fg, double mix) {
  return fg * mix + bg * (1 - mix);
}
double gltf_pbr(const Hit& c) {
  const double f0 = std::pow((1 - c["eta"]) / (1 + c["eta"]), 2) * c["specular"], f90 = c["specular"];
  const double dielectric =
      materialx_schlick_node(c, f0, f90) + (1 - materialx_albedo(c, f0, f90)) * c["base_color"] / pi();
  return mix(dielectric, materialx_schlick_node(c, c["base_color"], 1), c["metallic"]);
}
// mx_oren_nayar_compensated_diffuse: EON with the albedo of Fujii's form by its closed integral.
double eon(const Hit& c, double rho, double r) {
  const double c1 = 0.5 - 2 / (3 * pi()), c2 = 2.0 / 3 - 28 / (15 * pi());
  const auto albedo = [&](double mu) {
    const double s = std::sqrt(1 - mu * mu),
                 g = s * (std::acos(mu) - s * mu) + 2 * (s / mu * (1 - s * s * s) - s) / 3;
    return (1 + r * g / pi()) / (1 + c1 * r);
  };
  const double s = dot(c.l, c.v) - c.l.z * c.v.z, average = (1 + c2 * r) / (1 + c1 * r);
  const double single = rho / (1 + c1 * r) * (1 + r * (s > 0 ? s / std::max(c.l.z, c.v.z) : s));
  const double multiple = rho * rho * average / (1 - rho * (1 - average)) * (1 - albedo(c.l.z)) *
                          (1 - albedo(c.v.z)) / (1 - average);
  return (single + multiple) / pi();
}
double openpbr(const Hit& c) {
  const double f0 = std::min(c["specular"] * std::pow((c["eta"] - 1) / (c["eta"] + 1), 2), 0.99999);
  const double e = std::sqrt(f0), ior = (1 + e) / (1 - e);
  return mix(materialx_dielectric_over(c, 1, ior, eon(c, c["base_color"], c["diffuse_roughness"])),
             c["specular"] * materialx_schlick_node(c, c["base_color"], 1), c["metallic"]);
}
double standard(const Hit& c) {
  const double base = c["base_color"] * materialx_diffuse(c) / pi();
  return mix(materialx_dielectric_over(c, c["specular"], c["eta"], base),
             materialx_conductor(c, c["base_color"], c["specular"]), c["metallic"]);
}
double usd(const Hit& isotropic) {
  Hit c = isotropic;
  c.p["alpha_x"] = c.p["alpha_y"] = c["alpha"];
  const double colour = c["base_color"], m = c["metallic"], s = mix(1, colour, m);
  const double f0 = mix(s * std::pow((1 - c["eta"]) / (1 + c["eta"]), 2), s, m);
  const double base = (1 - m) * colour / pi();
  return mix(materialx_schlick_node(c, f0, s) + (1 - materialx_albedo(c, f0, s)) * base,
             materialx_conductor(c, colour, colour), m);
}
// The dielectric lobe of disney_principled has color0 = color90 = 1 and the weight 0.08 specular.
double disney(const Hit& c) {
  const double weight = c["f0"], m = c["metallic"];
  const double base = (1 - m) * c["base_color"] * disney_diffuse(c) / pi();
  return mix(weight * materialx_schlick_node(c, 1, 1) + (1 - weight * materialx_albedo(c, 1, 1)) * base,
             materialx_schlick_node(c, c["base_color"], 1), m);
}

// lights_physical_fragment.glsl.js and lights_physical_pars_fragment.glsl.js, with the texture as the
// header stores it.
double three(const Hit& c) {
  const double roughness = std::sqrt(c["alpha_y"]), at = c["alpha_x"], ab = c["alpha_y"], a2 = at * ab;
  const double m = c["metallic"], base = c["base_color"], ior = c["eta"];
  const double specular_color = std::min(std::pow((ior - 1) / (ior + 1), 2), 1.0) * c["specular"];
  const double blended = specular_color + (base - specular_color) * m,
               f90 = c["specular"] + (1 - c["specular"]) * m;
  const double ess = three_white_albedo(c.v.z, roughness), comp = 1 + blended * (1 / ess - 1);
  const double dot_vh = c.l_h(), fresnel = std::exp2((-5.55473 * dot_vh - 6.98316) * dot_vh);
  const auto schlick = [&](double f0) { return f0 * (1 - fresnel) + f90 * fresnel; };
  const auto length = [&](const Vec3<double>& w) {
    return std::sqrt(at * at * w.x * w.x + ab * ab * w.y * w.y + w.z * w.z);
  };
  const double v = 0.5 / (c.l.z * length(c.v) + c.v.z * length(c.l));
  const double w2 = a2 / (std::pow(ab * c.h.x, 2) + std::pow(at * c.h.y, 2) + std::pow(a2 * c.h.z, 2));
  return schlick(blended) * v * a2 * w2 * w2 / pi() * comp +
         base * (1 - m) / pi() * (1 - schlick(specular_color));
}

const std::map<std::string, std::function<double(const Hit&)>> kSources{
    {"blender_glossy", [](const Hit& c) { return c["kd"] / pi() + c["ks"] * separable(c); }},
    {"blender_principled", blender_principled},
    // fresnel_f82tint_color with b = 0 gives F = f0 + (1 - f0)(1 - cos)^5.
    {"blender_metallic",
     [](const Hit& c) {
       return c["kd"] / pi() + c["ks"] * correlated(c) * (c["f0"] + (1 - c["f0"]) * pow5(1 - c.l_h()));
     }},
    {"mitsuba_roughconductor",
     [](const Hit& c) {
       return c["kd"] / pi() + c["ks"] * separable(c) * mitsuba_conductor(c.l_h(), c["n"], c["k"]);
     }},
    {"mitsuba_principled", mitsuba_principled},
    {"pbrt_conductor",
     [](const Hit& c) {
       return c["kd"] / pi() + c["ks"] * correlated(c) * pbrt_fresnel(c.l_h(), {c["n"], c["k"]});
     }},
    {"gltf_metallic_roughness", gltf},
    {"materialx_schlick", materialx},
    {"open_pbr_surface", openpbr},
    {"standard_surface", standard},
    {"materialx_gltf_pbr", gltf_pbr},
    {"usd_preview_surface", usd},
    {"disney_principled", disney},
    {"three_physical", three}};

TEST(Targets, AreWhatTheirSourcesCompute) {
  Random random(7);
  for (const Reflectance& target : targets()) {
    const ReflectanceInfo& info = target.info();
    const auto source = kSources.find(std::string(info.name));
    ASSERT_NE(source, kSources.end()) << info.name << " has no second source";
    double worst = 0;
    for (int trial = 0; trial < 400; ++trial) {
      Material material = make_material(target, {"f"});
      Hit hit;
      const auto set = [&](std::span<const ParameterInfo> table, std::vector<double>& values) {
        for (std::size_t k = 0; k < table.size(); ++k) {
          const double low = std::max(table[k].min, 0.05), high = std::max(table[k].usual_max, low);
          values[k] = table[k].min == table[k].max ? table[k].min : low + random.uniform() * (high - low);
          hit.p[std::string(table[k].name)] = values[k];
        }
      };
      set(info.weights, material.terms[0].weights[0]);
      set(info.shape, material.terms[0].shape[0]);
      hit.l = direction(degrees(85 * random.uniform()), degrees(360 * random.uniform()));
      hit.v = direction(degrees(85 * random.uniform()), degrees(360 * random.uniform()));
      hit.h = hit.l + hit.v;
      hit.h = hit.h * (1 / std::sqrt(dot(hit.h, hit.h)));
      double f = 0;
      eval(material, hit.l, hit.v, std::span(&f, 1));
      const double expected = source->second(hit);
      ASSERT_GT(expected, 0);
      worst = std::max(worst, std::abs(f / expected - 1));
    }
    EXPECT_LT(worst, 1e-10) << info.name;
    EXPECT_GT(worst, 0) << info.name << " is compared with itself";
  }
}

TEST(Targets, AreFoundByNameAndStandInNoListOfForms) {
  for (const Reflectance& target : targets()) {
    EXPECT_EQ(catalogue_index(target), -1);
    ASSERT_TRUE(find_form(target.info().name).has_value());
    EXPECT_TRUE(*find_form(target.info().name) == target);
    EXPECT_TRUE(target.info().fittable()) << target.info().name;
    EXPECT_FALSE(target.info().canonical);
  }
}

// At the centres of texels the table returns the stored texels. The texture was obtained by sampling, so it
// only approximates the albedo: the largest difference is 0.01 to 0.016 in the two most grazing rows and
// 1e-4 to 0.003 elsewhere.
TEST(Targets, ThreesTableIsNearTheAlbedoOfAWhiteLobe) {
  BRDF_LONG_UNDER_SANITIZERS();
  Material white = make_material(*find_form("cook_torrance"), {"f"});
  white.terms[0].weights[0] = {0, 1, 1};
  double grazing = 0, elsewhere = 0;
  for (std::size_t row = 0; row < kThreeSide; ++row)
    for (std::size_t column = 0; column < kThreeSide; ++column) {
      const double cosine = (double(row) + 0.5) / kThreeSide, roughness = (double(column) + 0.5) / kThreeSide;
      white.terms[0].shape[0] = {roughness * roughness, roughness * roughness};
      const double albedo =
          directional_albedo(white, radians(std::acos(cosine)), {}, {.tolerance = 1e-5})[0].value;
      const double table = three_white_albedo(cosine, roughness);
      EXPECT_EQ(table, kThreeAlbedo[row * kThreeSide + column] / 10000.0);
      double& worst = row < 2 ? grazing : elsewhere;
      worst = std::max(worst, std::abs(table - albedo));
    }
  EXPECT_LT(grazing, 0.016);
  EXPECT_GT(grazing, 0.01);
  EXPECT_LT(elsewhere, 0.003);
  EXPECT_GT(elsewhere, 1e-4);
}

// The Metallic BSDF of Blender 4.3 equals the form cook_torrance, bit for bit.
TEST(Targets, OneIsAFormOfOurs) {
  Material ours = make_material(*find_form("cook_torrance"), {"f"});
  Material theirs = make_material(*find_form("blender_metallic"), {"f"});
  ours.terms[0].weights[0] = theirs.terms[0].weights[0] = {0.2, 0.7, 0.4};
  ours.terms[0].shape[0] = theirs.terms[0].shape[0] = {0.1, 0.4};
  const Vec3<double> wi = direction(50_deg, 20_deg), wo = direction(35_deg, 170_deg);
  double a = 0, b = 1;
  eval(ours, wi, wo, std::span(&a, 1));
  eval(theirs, wi, wo, std::span(&b, 1));
  EXPECT_EQ(a, b);
}

}  // namespace
}  // namespace brdf
