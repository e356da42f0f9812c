// Each form, evaluated in 50 digits, equals the published equation. The reference is a plain transcription
// that uses angles, normalised half vectors and powers of cosines as the papers print them, and no formula
// of libbrdf.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <functional>
#include <iostream>
#include <map>
#include <random>

#include "brdf/forms.h"
#include "brdf/material.h"
#include "validate/numerics/exact.h"

namespace brdf::validate {
namespace {

using E = Exact;

E pi() {
  return boost::math::constants::pi<E>();
}
E dot_of(const Vec3<E>& a, const Vec3<E>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// The quantities in which the equations are written. Parameters are accessed by name.
struct Case {
  Vec3<E> i, o, h, r;  // h normalised, r the mirror direction of i
  E ni, no, nh, oh, ro;
  std::map<std::string, E, std::less<>> p;
  E operator[](std::string_view name) const { return p.find(name)->second; }
};

Case make_case(const Vec3<E>& i, const Vec3<E>& o) {
  Case c;
  c.i = i;
  c.o = o;
  c.h = i + o;
  c.h = c.h * (1 / sqrt(dot_of(c.h, c.h)));
  c.r = {-i.x, -i.y, i.z};
  c.ni = i.z;
  c.no = o.z;
  c.nh = c.h.z;
  c.oh = dot_of(o, c.h);
  c.ro = dot_of(c.r, o);
  return c;
}

E diffuse(const Case& c) {
  return c["kd"] / pi();
}
E power_or_zero(const E& x, const E& n) {
  return x <= 0 ? E(0) : E(pow(x, n));
}

// --- Oren-Nayar, in angles
struct Angles {
  E a, b, cos_phi;
};
Angles angles(const Case& c) {
  const E ti = acos(c.ni), to = acos(c.no);
  return {ti > to ? ti : to, ti > to ? to : ti, cos(atan2(c.i.y, c.i.x) - atan2(c.o.y, c.o.x))};
}
E oren_nayar_printed(const Case& c) {
  const Angles t = angles(c);
  const E s2 = c["sigma"] * c["sigma"];
  const E a = 1 - E(0.5) * s2 / (s2 + E(0.33)), b = E(0.45) * s2 / (s2 + E(0.09));
  return c["rho"] / pi() * (a + b * (t.cos_phi > 0 ? t.cos_phi : E(0)) * sin(t.a) * tan(t.b));
}
E oren_nayar_full_printed(const Case& c) {
  const Angles t = angles(c);
  const E s2 = c["sigma"] * c["sigma"];
  const E c1 = 1 - E(0.5) * s2 / (s2 + E(0.33));
  E c2 = E(0.45) * s2 / (s2 + E(0.09)) * sin(t.a);
  if (t.cos_phi < 0) c2 = E(0.45) * s2 / (s2 + E(0.09)) * (sin(t.a) - pow(2 * t.b / pi(), 3));
  const E c3 = E(0.125) * s2 / (s2 + E(0.09)) * pow(4 * t.a * t.b / (pi() * pi()), 2);
  const E l1 = c1 + t.cos_phi * c2 * tan(t.b) + (1 - abs(t.cos_phi)) * c3 * tan((t.a + t.b) / 2);
  const E l2 = E(0.17) * s2 / (s2 + E(0.13)) * (1 - t.cos_phi * pow(2 * t.b / pi(), 2));
  return c["rho"] / pi() * l1 + c["rho"] * c["rho"] / pi() * l2;
}
E fujii_albedo(const E& cosine, const E& r) {
  const E t = acos(cosine), s = sin(t);
  const E a = 1 / (1 + (E(1) / 2 - 2 / (3 * pi())) * r);
  const E g = s * (t - s * cosine) + E(2) / 3 * (s / cosine * (1 - s * s * s) - s);
  return a + r * a / pi() * g;
}
E oren_nayar_energy_printed(const Case& c) {
  const E r = c["roughness"], rho = c["rho"];
  const E a = 1 / (1 + (E(1) / 2 - 2 / (3 * pi())) * r);
  const E average = a * (1 + (E(2) / 3 - 28 / (15 * pi())) * r);
  const E s = dot_of(c.i, c.o) - c.ni * c.no;
  const E t = s > 0 ? (c.ni > c.no ? c.ni : c.no) : E(1);
  const E rho_ms = rho * rho * average / (1 - rho * (1 - average));
  return rho / pi() * a * (1 + r * s / t) +
         rho_ms / pi() * (1 - fujii_albedo(c.ni, r)) * (1 - fujii_albedo(c.no, r)) / (1 - average);
}
E oren_nayar_listing(const Case& c) {
  const E s = c["roughness"] * c["roughness"], s2 = s * s;
  const E cosri = dot_of(c.o, c.i) - c.no * c.ni;
  const E c1 = 1 - E(0.5) * s2 / (s2 + E(0.33));
  const E c2 = E(0.45) * s2 / (s2 + E(0.09)) * cosri * (cosri >= 0 ? 1 / (c.ni > c.no ? c.ni : c.no) : E(1));
  return c["albedo"] / pi() * (c1 + c2) * (1 + c["roughness"] / 2);
}

// --- Phong and Blinn-Phong
E blinn_norm(const E& n) {
  return (n + 2) * (n + 4) / (8 * pi() * (pow(E(2), -n / 2) + n));
}
E f0_listing(const Case& c) {
  return E(0.03) + (c["albedo"] - E(0.03)) * c["metallic"];
}
E schlick_listing(const Case& c) {
  const E f0 = f0_listing(c);
  return f0 + (1 - f0) * pow(1 - c.oh, 5);
}

// --- Ward
E slope2(const Case& c) {
  return (pow(c.h.x / c["alpha_x"], 2) + pow(c.h.y / c["alpha_y"], 2)) / (c.nh * c.nh);
}
E ward_lobe(const Case& c) {
  return exp(-slope2(c)) / (4 * pi() * c["alpha_x"] * c["alpha_y"]);
}

// --- Microfacets
E d_ggx(const Case& c, const E& ax, const E& ay) {
  return 1 / (pi() * ax * ay * pow(pow(c.h.x / ax, 2) + pow(c.h.y / ay, 2) + c.nh * c.nh, 2));
}
E d_ggx(const Case& c) {
  return d_ggx(c, c["alpha_x"], c["alpha_y"]);
}
E d_beckmann(const Case& c) {
  return exp(-slope2(c)) / (pi() * c["alpha_x"] * c["alpha_y"] * pow(c.nh, 4));
}
// Returns alpha tan(theta) in the azimuth of the direction.
E alpha_tan(const Case& c, const Vec3<E>& w) {
  return sqrt(pow(c["alpha_x"] * w.x, 2) + pow(c["alpha_y"] * w.y, 2)) / w.z;
}
E lambda_ggx(const Case& c, const Vec3<E>& w) {
  return (sqrt(1 + pow(alpha_tan(c, w), 2)) - 1) / 2;
}
E lambda_beckmann(const Case& c, const Vec3<E>& w) {
  const E a = 1 / alpha_tan(c, w);
  return (boost::math::erf(a) - 1) / 2 + exp(-a * a) / (2 * a * sqrt(pi()));
}
// --- Zernike's radial polynomials, with factorials as printed
E radial(int n, int l, const E& r) {
  const auto factorial = [](int k) { return boost::math::factorial<E>(unsigned(k)); };
  E sum = 0;
  for (int k = 0; k <= (n - l) / 2; ++k)
    sum += (k % 2 ? -1 : 1) * factorial(n - k) /
           (factorial(k) * factorial((n + l) / 2 - k) * factorial((n - l) / 2 - k)) * pow(r, n - 2 * k);
  return sum;
}
E matt_printed(const Case& c) {
  const E ri = sqrt(E(2)) * sin(acos(c.ni) / 2), ro = sqrt(E(2)) * sin(acos(c.no) / 2);
  const E dphi = atan2(c.o.y, c.o.x) - atan2(c.i.y, c.i.x);
  E sum = 0;
  for (const auto& [name, weight] : c.p) {  // w, then the digits of n, m and l
    const int n = name[1] - '0', m = name[2] - '0', l = name[3] - '0';
    sum += weight * (radial(n, l, ri) * radial(m, l, ro) + radial(m, l, ri) * radial(n, l, ro)) / 2 *
           cos(l * dphi);
  }
  return sum / pi();
}

// Ribardiere et al. 2017, with sigma = alpha.
E d_student(const Case& c) {
  const E gamma = c["gamma"];
  return pow(1 + slope2(c) / (gamma - 1), -gamma) / (pi() * c["alpha_x"] * c["alpha_y"] * pow(c.nh, 4));
}
// The slope along the viewer's azimuth has Student's distribution. Lambda is the mean of the slope beyond a
// = cot(theta)/width, divided by a, minus the tail probability.
E lambda_student(const Case& c, const Vec3<E>& w) {
  const E gamma = c["gamma"], half = E(1) / 2, a = 1 / (alpha_tan(c, w) * sqrt(gamma - 1)), far = 1 + a * a;
  const E scale = boost::math::tgamma(E(gamma - half)) / (sqrt(pi()) * boost::math::tgamma(E(gamma - 1)));
  const E beyond = scale * pow(far, 3 * half - gamma) / (2 * gamma - 3);
  return beyond / a - boost::math::ibeta(E(gamma - 1), half, E(1 / far)) / 2;
}
E smith(const E& lambda_i, const E& lambda_o) {
  return 1 / (1 + lambda_i + lambda_o);
}
E v_cavity(const Case& c) {
  const E one = 1, view = 2 * c.nh * c.no / c.oh, light = 2 * c.nh * c.ni / c.oh;
  return std::min({one, view, light});
}
E g_schlick(const E& k, const Case& c) {
  return c.ni / (c.ni * (1 - k) + k) * (c.no / (c.no * (1 - k) + k));
}
E schlick(const Case& c, const E& cosine) {
  return c["f0"] + (1 - c["f0"]) * pow(1 - cosine, 5);
}
E dielectric(const Case& c) {
  const E n = c["eta"], cosine = c.oh, g = sqrt(n * n + cosine * cosine - 1);
  return pow((g - cosine) / (g + cosine), 2) / 2 *
         (1 + pow((cosine * (g + cosine) - 1) / (cosine * (g - cosine) + 1), 2));
}
// Born and Wolf, Principles of Optics, 14.2: N = n + i k, w = a + i b = N times the cosine of the angle
// inside.
E conductor(const Case& c) {
  const E n = c["n"], k = c["k"], cosine = c.oh, re = n * n - k * k, im = 2 * n * k;
  const E inside = re - 1 + cosine * cosine, size = sqrt(inside * inside + im * im);
  const E a = sqrt((size + inside) / 2), b = sqrt((size - inside) / 2);
  const auto share = [](const E& x, const E& y, const E& u, const E& v) {
    return E(((x - u) * (x - u) + (y - v) * (y - v)) / ((x + u) * (x + u) + (y + v) * (y + v)));
  };
  return (share(cosine, 0, a, b) + share(re * cosine, im * cosine, a, b)) / 2;
}
E microfacet(const Case& c, const E& d, const E& f, const E& g, const E& four = 4) {
  return diffuse(c) + c["ks"] * d * f * g / (four * c.ni * c.no);
}
// The lobe seen with the view turned by half a turn about the normal, with a Fresnel reflectance of 1.
E retro_printed(const Case& c, E (*d)(const Case&), E (*lambda)(const Case&, const Vec3<E>&)) {
  Case back = make_case(c.i, {-c.o.x, -c.o.y, c.o.z});
  back.p = c.p;
  const E g = smith(lambda(back, back.i), lambda(back, back.o));
  return c["kr"] * d(back) * g / (4 * c.ni * c.no);
}
E k_direct(const E& a) {
  return (a + 1) * (a + 1) / 8;
}
E cook_torrance_listing(const Case& c) {
  const E alpha = c["roughness"] * c["roughness"];
  const E f = schlick_listing(c);
  const E specular =
      d_ggx(c, alpha, alpha) * g_schlick(k_direct(c["roughness"]), c) * f / (4 * c.no * c.ni + E(0.001));
  const E kd = (1 - f) * (1 - c["metallic"]);
  const E radiance = (kd * c["albedo"] / pi() + specular) * c.ni;
  return pow(radiance / (radiance + 1), 1 / E(2.2)) / c.ni;
}
E ward_listing(const Case& c) {
  const E kd = (1 - schlick_listing(c)) * (1 - c["metallic"]);
  const E lobe = sqrt(c.ni * c.no) *
                 exp(-2 * (pow(c.h.x / c["alpha_x"], 2) + pow(c.h.y / c["alpha_y"], 2)) / (1 + c.nh));
  return (kd * c["albedo"] / pi() + f0_listing(c) * lobe * c.ni) / c.ni;
}

const std::map<std::string, std::function<E(const Case&)>, std::less<>>& textbook() {
  static const std::map<std::string, std::function<E(const Case&)>, std::less<>> equations{
      {"lambert", [](const Case& c) { return E(c["rho"] / pi()); }},
      {"oren_nayar", oren_nayar_printed},
      {"oren_nayar_full", oren_nayar_full_printed},
      {"oren_nayar_energy", oren_nayar_energy_printed},
      {"oren_nayar_as_coded", oren_nayar_listing},
      {"phong",
       [](const Case& c) {
         return E(diffuse(c) +
                  c["ks"] * (c["exponent"] + 2) / (2 * pi()) * power_or_zero(c.ro, c["exponent"]));
       }},
      {"phong_unnormalised",
       [](const Case& c) { return E(diffuse(c) + c["ks"] * power_or_zero(c.ro, c["exponent"])); }},
      {"phong_classic",
       [](const Case& c) {
         return E(diffuse(c) +
                  c["ks"] * (c["exponent"] + 1) / (2 * pi()) * power_or_zero(c.ro, c["exponent"]) / c.ni);
       }},
      {"phong_as_coded",
       [](const Case& c) { return E((c["albedo"] / pi() + pow(c.ni, 15) * f0_listing(c) * c.ni) / c.ni); }},
      {"blinn_phong",
       [](const Case& c) {
         return E(diffuse(c) + c["ks"] * blinn_norm(c["exponent"]) * pow(c.nh, c["exponent"]));
       }},
      {"blinn_phong_n8",
       [](const Case& c) {
         return E(diffuse(c) + c["ks"] * (c["exponent"] + 8) / (8 * pi()) * pow(c.nh, c["exponent"]));
       }},
      {"blinn_phong_unnormalised",
       [](const Case& c) { return E(c["kd"] + c["ks"] * pow(c.nh, c["exponent"])); }},
      {"blinn_phong_as_coded",
       [](const Case& c) { return E((c["albedo"] / pi() + pow(c.nh, 5) * f0_listing(c) * c.ni) / c.ni); }},
      {"ward", [](const Case& c) { return E(diffuse(c) + c["ks"] * ward_lobe(c) / sqrt(c.no * c.ni)); }},
      {"ward_duer", [](const Case& c) { return E(diffuse(c) + c["ks"] * ward_lobe(c) / (c.no * c.ni)); }},
      {"ward_bounded",
       [](const Case& c) {
         const Vec3<E> h = c.i + c.o;
         return E(diffuse(c) + c["ks"] * ward_lobe(c) * 4 * dot_of(h, h) / pow(h.z, 4));
       }},
      {"ward_as_coded", ward_listing},
      {"cook_torrance",
       [](const Case& c) {
         return microfacet(c, d_ggx(c), schlick(c, c.oh), smith(lambda_ggx(c, c.i), lambda_ggx(c, c.o)));
       }},
      {"cook_torrance_beckmann",
       [](const Case& c) {
         return microfacet(c, d_beckmann(c), schlick(c, c.oh),
                           smith(lambda_beckmann(c, c.i), lambda_beckmann(c, c.o)));
       }},
      {"cook_torrance_student",
       [](const Case& c) {
         return microfacet(c, d_student(c), schlick(c, c.oh),
                           smith(lambda_student(c, c.i), lambda_student(c, c.o)));
       }},
      {"cook_torrance_dielectric",
       [](const Case& c) {
         return microfacet(c, d_ggx(c), dielectric(c), smith(lambda_ggx(c, c.i), lambda_ggx(c, c.o)));
       }},
      {"cook_torrance_conductor",
       [](const Case& c) {
         return microfacet(c, d_ggx(c), conductor(c), smith(lambda_ggx(c, c.i), lambda_ggx(c, c.o)));
       }},
      {"cook_torrance_vcavity",
       [](const Case& c) { return microfacet(c, d_beckmann(c), dielectric(c), v_cavity(c)); }},
      {"cook_torrance_1982",
       [](const Case& c) { return microfacet(c, d_beckmann(c), schlick(c, c.oh), v_cavity(c), pi()); }},
      {"cook_torrance_schlick_ggx",
       [](const Case& c) {
         return microfacet(c, d_ggx(c), schlick(c, c.oh),
                           g_schlick(k_direct(sqrt(c["alpha_x"] * c["alpha_y"])), c));
       }},
      {"cook_torrance_as_printed",
       [](const Case& c) {
         return microfacet(c, d_ggx(c), schlick(c, c.no),
                           g_schlick(k_direct(sqrt(c["alpha_x"] * c["alpha_y"])), c));
       }},
      {"cook_torrance_as_coded", cook_torrance_listing},
      {"matt_2", matt_printed},
      {"matt_5", matt_printed},
      {"matt_8", matt_printed},
      {"matt_14", matt_printed},
      {"matt_20", matt_printed},
      {"retro", [](const Case& c) { return retro_printed(c, d_ggx, lambda_ggx); }},
      {"retro_beckmann", [](const Case& c) { return retro_printed(c, d_beckmann, lambda_beckmann); }},
  };
  return equations;
}

// The constants of the forms (1/pi, 8 pi, ...) are doubles, hence 2e-15. The masking of
// cook_torrance_student is a polynomial; the accuracy of this polynomial sets the bound 2e-9.
double tolerance(std::string_view form) {
  // The terms of a basis have both signs, so that their sum may be far smaller than they are.
  if (form.starts_with("matt_")) return 1e-12;
  return form == "cook_torrance_student" ? 2e-9 : 2e-15;
}

// Returns a value inside the usual range of the parameter.
double draw(const ParameterInfo& p, std::mt19937_64& random) {
  const double u = std::uniform_real_distribution<double>(0, 1)(random);
  const double low = p.log_scale ? std::max(p.min, 0.03) : usual_min(p) + 0.01 * (p.usual_max - usual_min(p));
  const double high = p.role == Role::exponent ? 200 : p.usual_max;
  return p.log_scale ? low * std::pow(high / low, u) : low + (high - low) * u;
}

TEST(Textbook, EveryFormIsItsPublishedEquation) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  std::size_t compared = 0, without = 0;
  for (const Reflectance& form : catalogue()) {
    const ReflectanceInfo& f = info(form);
    const auto equation = textbook().find(f.name);
    if (equation == textbook().end()) {
      std::cout << "no second source: " << f.name << '\n';
      ++without;
      continue;
    }
    double worst = 0;
    for (int k = 0; k < 60; ++k) {
      const auto pick = [&] {
        return exact_direction(
            direction(radians(std::acos(0.02 + 0.98 * unit(random))), radians(2 * kPi * unit(random))));
      };
      Case c = make_case(pick(), pick());
      std::vector<E> weights, shape;
      for (const ParameterInfo& p : f.weights) weights.push_back(c.p[std::string(p.name)] = draw(p, random));
      for (const ParameterInfo& p : f.shape) shape.push_back(c.p[std::string(p.name)] = draw(p, random));
      const E ours = exact_eval(form, {&weights, 1}, shape, c.i, c.o, 1e-12)[0];
      const E theirs = equation->second(c);
      ++compared;
      if (ours != theirs) worst = std::max(worst, double(E(abs(ours - theirs) / abs(theirs))));
    }
    EXPECT_LT(worst, tolerance(f.name)) << f.name;
  }
  EXPECT_EQ(compared, 60 * (catalogue().size() - without));
  EXPECT_EQ(textbook().size(), catalogue().size() - without) << "a transcription of no form's";
}

}  // namespace
}  // namespace brdf::validate
