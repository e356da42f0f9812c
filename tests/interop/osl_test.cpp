// OSL's closures are forms of our catalogue. They are compared with the code of OSL's testrender, and
// checked in the written files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "brdf/random.h"
#include "interop/programs.h"
#include "io/material/settings.h"

namespace brdf::interop {
namespace {

using ::testing::HasSubstr;

Exported to_osl(const std::string& form, const std::vector<std::string>& set) {
  return export_to(*find_program("osl"), io::choose_material({.form = form, .set = set}), "thing", false);
}

double value(const Exported& e, const Vec3<double>& wi, const Vec3<double>& wo) {
  double f = 0;
  eval(e.carried, wi, wo, std::span(&f, 1));
  return f;
}

// From src/testrender/shading.cpp: the product of a sample's weight and density includes cos_i.
double oren_nayar(const Vec3<double>& wi, const Vec3<double>& wo, double sigma) {
  const double s = dot(wo, wi) - wi.z * wo.z, s2 = sigma * sigma;
  return (1 - 0.50 * s2 / (s2 + 0.33) + 0.45 * s2 / (s2 + 0.09) * (s > 0 ? s / std::max(wi.z, wo.z) : 0)) *
         wi.z / kPi;
}
double phong_closure(const Vec3<double>& wi, const Vec3<double>& wo, double n) {
  const Vec3<double> r{-wo.x, -wo.y, wo.z};
  const double cos_ri = dot(r, wi);
  return cos_ri > 0 ? (n + 1) / (2 * kPi) * std::pow(cos_ri, n) * wi.z * (n + 2) / (n + 1) : 0;
}
double ward_closure(const Vec3<double>& wi, const Vec3<double>& wo, double ax, double ay) {
  Vec3<double> h = wi + wo;
  h = h * (1 / std::sqrt(dot(h, h)));
  const double x = h.x / ax, y = h.y / ay, e = std::exp(-(x * x + y * y) / (h.z * h.z));
  const double k = dot(h, wi) * h.z * h.z * h.z, pdf = e / (4 * kPi * ax * ay * k);
  return pdf * k * std::sqrt(wi.z / wo.z);
}
double microfacet_closure(const Vec3<double>& wi, const Vec3<double>& wo, double ax, double ay, double eta) {
  Vec3<double> m = wi + wo;
  m = m * (1 / std::sqrt(dot(m, m)));
  const double tan2 = (std::pow(m.x / ax, 2) + std::pow(m.y / ay, 2)) / (m.z * m.z);
  const double d = 1 / (kPi * (1 + tan2) * (1 + tan2)) / (ax * ay * std::pow(m.z, 4));
  const auto lambda = [&](const Vec3<double>& w) {
    const double a2 = w.z * w.z / (std::pow(w.x * ax, 2) + std::pow(w.y * ay, 2));
    return 0.5 * (-1 + std::sqrt(1 + 1 / a2));
  };
  const double c = dot(m, wo), g = std::sqrt(eta * eta - 1 + c * c), a = (g - c) / (g + c),
               b = (c * (g + c) - 1) / (c * (g - c) + 1), fresnel = 0.5 * a * a * (1 + b * b);
  const double g1 = 1 / (1 + lambda(wo)), g2 = 1 / (1 + lambda(wo) + lambda(wi));
  return g1 * d * 0.25 / wo.z * (g2 / g1) * fresnel;
}

TEST(Osl, ItsClosuresAreFormsOfOurs) {
  const Exported clay = to_osl("oren_nayar", {"rho=0.5", "sigma=0.4"}),
                 phong = to_osl("phong", {"kd=0.1", "ks=1.4", "exponent=30"}),
                 ward = to_osl("ward", {"kd=0.1", "ks=0.4", "alpha_x=0.3", "alpha_y=0.1"}),
                 glass = to_osl("cook_torrance_dielectric",
                                {"kd=0.1", "ks=0.9", "eta=1.7", "alpha_x=0.3", "alpha_y=0.1"});
  for (const Exported* e : {&clay, &phong, &ward, &glass}) EXPECT_TRUE(e->loss.none_found()) << e->text;
  Random random(3);
  for (int k = 0; k < 300; ++k) {
    const auto anywhere = [&] {
      return direction(degrees(random.uniform(1, 85)), degrees(random.uniform(0, 360)));
    };
    const Vec3<double> wi = anywhere(), wo = anywhere();
    const double diffuse = 0.1 * wi.z / kPi, unit = 1e-12;
    EXPECT_NEAR(value(clay, wi, wo) * wi.z, 0.5 * oren_nayar(wi, wo, 0.4), unit);
    EXPECT_NEAR(value(phong, wi, wo) * wi.z, diffuse + 1.4 * phong_closure(wi, wo, 30), unit);
    EXPECT_NEAR(value(ward, wi, wo) * wi.z, diffuse + 0.4 * ward_closure(wi, wo, 0.3, 0.1), unit);
    EXPECT_NEAR(value(glass, wi, wo) * wi.z, diffuse + 0.9 * microfacet_closure(wi, wo, 0.3, 0.1, 1.7), unit);
  }
}

TEST(Osl, IsASurfaceWhoseClosuresAreAdded) {
  const std::string text =
      to_osl("cook_torrance_dielectric",
             {"kd=0.3,0.2,0.1", "ks=1.5", "eta=1.5", "alpha_x=0.1", "alpha_y=0.3", "tangent_phi=30"})
          .text;
  EXPECT_THAT(text, HasSubstr("surface thing()\n{\n    vector T = "));
  EXPECT_THAT(text, HasSubstr("radians(120)"));
  EXPECT_THAT(text,
              HasSubstr("    Ci = color(0.3, 0.2, 0.1) * diffuse(N)\n"
                        "       + color(1.5, 1.5, 1.5) * microfacet(\"ggx\", N, T, 0.3, 0.1, 1.5, 0);\n}\n"));
  EXPECT_THAT(to_osl("oren_nayar", {"rho=0.5", "sigma=0.4"}).text,
              HasSubstr("    Ci = color(0.5, 0.5, 0.5) * oren_nayar(N, 0.4);\n"));
  EXPECT_THAT(to_osl("phong", {"kd=0", "ks=0.5", "exponent=30"}).text,
              HasSubstr("    Ci = color(0.5, 0.5, 0.5) * phong(N, 30);\n"));
  EXPECT_THAT(to_osl("ward", {"kd=0", "ks=0.5", "alpha=0.2"}).text, HasSubstr("* ward(N, T, 0.2, 0.2);\n"));
}

}  // namespace
}  // namespace brdf::interop
