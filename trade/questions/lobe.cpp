#include "trade/approximations/lobes.h"

#include "trade/questions/names.h"
#include "trade/questions/picture.h"
#include "trade/questions/questions.h"

namespace brdf::trade {
namespace {

// A reference with more digits than any choice.
inline constexpr auto long_power = []<class T>(const CosineRow<T>& x) -> T {
  return T(std::pow((long double)(x.cosine), (long double)(x.width)));
};

template <class Power>
Choice power_choice(std::string name, Power power, double n, std::string note) {
  return {std::move(name), kernel(power), std::move(note),
          untimed_kernel(lobe_material<mirror_power<Power>>{{power}, n})};
}

template <int doublings>
Question power_question() {
  static constexpr double n = 1 << doublings;
  const auto at = [](double from, double to) { return cosines({"cos", from, to}, {"n", n, n}); };
  return {"power of a cosine, n = " + std::to_string(1 << doublings),
          "cos^n",
          Measure::absolute,
          at(0, 1),
          {at(0.99, 1), at(0, 0.1)},
          {power_choice("pow, own kernels", cosine_power, n, "exp(n log c)"),
           power_choice("pow of the C library", cosine_power_libm, n, "does not vectorise"),
           power_choice("repeated squaring", squared_power<doublings>, n, "the exponent must be known"),
           power_choice("spherical Gaussian", spherical_gaussian, n, "Wang et al. 2009"),
           power_choice("Schlick's rational", schlick_power, n, "Schlick 1994")},
          scalar_kernel(long_power)};
}

// A large exponent: repeated squaring is impossible, and plain cosines lose digits.
Question large_power_question() {
  Question q{"power of a cosine, n = 1 .. 1e6",
             "cos^n",
             Measure::absolute,
             cosines({"cos", 0.9, 1}, {"n", 1, 1e4, true}),
             {cosines({"1 - cos, log", 0.999999, 1}, {"n", 1e6, 1e6})},
             {}};
  const double shown = 1000;
  q.choices = {power_choice("pow, own kernels", cosine_power, shown, ""),
               power_choice("spherical Gaussian", spherical_gaussian, shown, "Wang et al. 2009"),
               power_choice("Schlick's rational", schlick_power, shown, "Schlick 1994")};
  q.reference = scalar_kernel(long_power);
  return q;
}

Domain exponents(double least, double most, double most_theta = 80) {
  return directions({"n", least, most, true}, most_theta);
}

template <class Lobe>
Choice mirror_choice(std::string name, Lobe lobe, std::string note) {
  return {std::move(name), kernel(lobe), std::move(note), untimed_kernel(lobe_material<Lobe>{lobe, 20})};
}

Question mirror_question() {
  return {
      names::kMirror,
      "Phong's (r.o)^n",
      Measure::absolute,
      exponents(5, 200),
      {exponents(1e6, 1e6), exponents(5, 200, 89.5)},
      {mirror_choice("mirror direction", mirror_lobe, "Phong 1975"),
       mirror_choice("mirror, by differences", mirror_lobe_stable, "accurate at the peak for any n"),
       mirror_choice("half vector, 4 n", half_lobe{4}, "Blinn 1977, made as narrow"),
       mirror_choice(names::kEqualHalfVector, half_lobe{1}, "Blinn 1977, as the documents compare them")}};
}

Question ggx_question() {
  const auto domain = [](double least, double most) {
    return stored_in_float(lobe_domain({"alpha", least, most, true}));
  };
  Question q{"D of GGX in float",
             "D",
             Measure::relative,
             domain(0.01, 1),
             {domain(1e-3, 1e-3), domain(1e-4, 1e-4)},
             {}};
  const auto choice = [](const char* name, auto d, const char* note) {
    return Choice{name, kernel(d), note, untimed_kernel(distribution_material<decltype(d)>{d, 0.01})};
  };
  q.choices = {choice("half vector not normalised", ggx_stable, "this library's"),
               choice("through (n.h)^2 - 1", ggx_naive, "as printed nearly everywhere")};
  for (Choice& c : q.choices) c.error = Precision::single_;
  q.reference = kernel(ggx_stable);
  return q;
}

}  // namespace

std::vector<Question> lobe_questions() {
  return {power_question<3>(), power_question<5>(), large_power_question(), mirror_question(),
          ggx_question()};
}

}  // namespace brdf::trade
