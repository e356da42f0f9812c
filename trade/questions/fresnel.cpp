#include "trade/questions/names.h"
#include "trade/questions/picture.h"
#include "trade/questions/questions.h"

namespace brdf::trade {
namespace {

Domain dielectric(double eta, double least_cos = 0, double most_cos = 1) {
  const double f0 = (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1));
  return make_domain({{"cos_d", least_cos, most_cos}, {"eta", eta, eta}, {"f0", f0, f0}},
                     [](std::span<const double> at) {
                       return FresnelRow<double>{.cosine = at[0], .n = at[1], .f0 = at[2]};
                     });
}

template <class F>
Choice dielectric_choice(std::string name, F f, std::string note) {
  return {std::move(name), kernel(f), std::move(note), on_ball(smith_correlated, f)};
}

Question dielectric_question() {
  return {names::kFresnelOfGlass,
          "F, eta 1.5",
          Measure::absolute,
          dielectric(1.5),
          {dielectric(1.01), dielectric(5), dielectric(1.5, 0, 0.01)},
          {dielectric_choice(names::kExact, exact_dielectric, "Cook and Torrance 1982"),
           dielectric_choice("Schlick", schlick_fresnel, "Schlick 1994"),
           dielectric_choice("spherical Gaussian", gaussian_dielectric,
                             "Karis 2013: an exponential for the power"),
           dielectric_choice("constant f0", constant_dielectric, "no dependence on the angle"),
           dielectric_choice(names::kSlip, slipped_dielectric, "(g-c)(g-c)/(g+c)*(g+c) as coded")}};
}

struct Metal {
  const char* name;
  double n, k;
};
// Values at the sodium line: aluminium Rakic 1995, iron and chromium Johnson and Christy 1974.
constexpr Metal kMetals[] = {{"aluminium", 1.2, 7.26}, {"iron", 2.9, 3.07}, {"chromium", 3.17, 3.3}};

Question metal_question(const Metal& metal) {
  const double f0 = fresnel_conductor(metal.n, metal.k, 1.0);
  const double at82 = fresnel_conductor(metal.n, metal.k, 1.0 / 7), u = 6.0 / 7;
  const double a = (f0 + (1 - f0) * fifth_power(u) - at82) / (fifth_power(u) * u / 7);
  const auto domain = [&](double from, double to) {
    return make_domain(
        {{"cos_d", from, to}, {"n", metal.n, metal.n}, {"k", metal.k, metal.k}, {"f0", f0, f0}, {"a", a, a}},
        [](std::span<const double> at) {
          return FresnelRow<double>{at[0], at[1], at[2], at[3], at[4]};
        });
  };
  Question q{
      std::string("Fresnel of ") + metal.name, "F", Measure::absolute, domain(0, 1), {domain(0, 0.01)}, {}};
  const FresnelRow<double> index{0, metal.n, metal.k, f0, a};
  q.choices = {
      {names::kExact, kernel(exact_conductor), "", on_ball(smith_correlated, exact_conductor, index, 0)},
      {"Schlick", kernel(schlick_fresnel), "f0 exact at normal incidence",
       on_ball(smith_correlated, schlick_fresnel, index, 0)},
      {"Schlick with a dip", kernel(lazanyi_conductor), "Hoffman 2019, fitted at 82 degrees",
       on_ball(smith_correlated, lazanyi_conductor, index, 0)},
      {"for large indices", kernel(simplified_conductor), "sin^2 dropped against n^2 + k^2",
       on_ball(smith_correlated, simplified_conductor, index, 0)}};
  return q;
}

}  // namespace

std::vector<Question> fresnel_questions() {
  std::vector<Question> questions{dielectric_question()};
  for (const Metal& metal : kMetals) questions.push_back(metal_question(metal));
  return questions;
}

}  // namespace brdf::trade
