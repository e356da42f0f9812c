#include "trade/approximations/lobes.h"

#include "trade/questions.h"

namespace brdf::trade {
namespace {

// kd/pi and a normalised cosine lobe, for the picture.
template <class Lobe>
struct lobe_material {
  Lobe lobe;
  double exponent;
  template <class T>
  T operator()(Row<T> x) const {
    x[6] = T(exponent);
    return T(0.3 / kPi) + T(0.5 * (exponent + 2) / (2 * kPi)) * lobe(x);
  }
};
// The same with the mirror cosine given to a function of (c, n).
template <class Power>
struct power_material {
  Power power;
  double exponent;
  template <class T>
  T operator()(const Row<T>& x) const {
    const T c = at_most(at_least(x[2] * x[5] - x[0] * x[3] - x[1] * x[4], T(0)), T(1));
    return T(0.3 / kPi) + T(0.5 * (exponent + 2) / (2 * kPi)) * power(Row<T>{c, T(exponent)});
  }
};

// With more digits than any choice has.
struct long_power {
  template <class T>
  T operator()(const Row<T>& x) const {
    return T(std::pow((long double)(x[0]), (long double)(x[1])));
  }
};

template <class Power>
Choice power_choice(std::string name, Power power, double n, std::string note) {
  return {std::move(name), kernel(power), std::move(note), kernel(power_material<Power>{power, n})};
}

template <int doublings>
Question power_question() {
  const double n = 1 << doublings;
  const auto at = [](double exponent) { return Domain{{{"cos", 0, 1}, {"n", exponent, exponent}}, {}, ""}; };
  Question q{
      "power of a cosine, n = " + std::to_string(1 << doublings), "cos^n", Measure::absolute, at(n), {}, {}};
  q.choices = {power_choice("pow, own kernels", cosine_power{}, n, "exp(n log c)"),
               power_choice("pow of the C library", cosine_power_libm{}, n, "does not vectorise"),
               power_choice("repeated squaring", squared_power<doublings>{}, n, "the exponent must be known"),
               power_choice("spherical Gaussian", spherical_gaussian{}, n, "Wang et al. 2009"),
               power_choice("Schlick's rational", schlick_power{}, n, "Schlick 1994")};
  q.reference = kernel(long_power{});
  return q;
}

// A large exponent: squaring is out, and plain cosines lose digits.
Question large_power_question() {
  Question q{"power of a cosine, n = 1 .. 1e6",
             "cos^n",
             Measure::absolute,
             {{{"cos", 0.9, 1}, {"n", 1, 1e4, true}}, {}, ""},
             {{{{"1 - cos, log", 0.999999, 1}, {"n", 1e6, 1e6}}, {}, ""}},
             {}};
  q.choices = {{"pow, own kernels", kernel(cosine_power{}), ""},
               {"spherical Gaussian", kernel(spherical_gaussian{}), "Wang et al. 2009"},
               {"Schlick's rational", kernel(schlick_power{}), "Schlick 1994"}};
  q.reference = kernel(long_power{});
  return q;
}

Domain exponents(double least, double most, double most_theta = 80) {
  Domain d = direction_domain({"n", least, most, true}, {"-", 0, 0}, most_theta);
  d.axes.pop_back();
  d.inputs = [](std::span<const double> at, Row<double>& row) {
    return direction_row(at[0], at[1], at[2], at[3], 0, row);
  };
  return d;
}

template <class Lobe>
Choice mirror_choice(std::string name, Lobe lobe, std::string note) {
  return {std::move(name), kernel(lobe), std::move(note), kernel(lobe_material<Lobe>{lobe, 20})};
}

Question mirror_question() {
  Question q{"mirror direction or half vector",
             "Phong's (r.o)^n",
             Measure::absolute,
             exponents(5, 200),
             {exponents(1e6, 1e6), exponents(5, 200, 89.5)},
             {}};
  q.choices = {
      mirror_choice("mirror direction", mirror_lobe{}, "Phong 1975"),
      mirror_choice("mirror, by differences", mirror_lobe_stable{}, "accurate at the peak for any n"),
      mirror_choice("half vector, 4 n", half_lobe{4}, "Blinn 1977, made as narrow"),
      mirror_choice("half vector, equal n", half_lobe{1}, "Blinn 1977, as the documents compare them")};
  return q;
}

Question ggx_question() {
  const auto domain = [](double least, double most) {
    Domain d = lobe_domain({"alpha", least, most, true}, {"-", 0, 0});
    d.axes.pop_back();
    const auto inputs = d.inputs;
    d.inputs = [inputs](std::span<const double> at, Row<double>& row) {
      const std::array<double, 5> five{at[0], at[1], at[2], at[3], 0};
      const bool valid = inputs(five, row);
      for (double& value : row) value = double(float(value));  // only the formula's own error counts
      return valid;
    };
    return d;
  };
  Question q{"D of GGX in float",
             "D",
             Measure::relative,
             domain(0.01, 1),
             {domain(1e-3, 1e-3), domain(1e-4, 1e-4)},
             {}};
  q.choices = {{"half vector not normalised", kernel(ggx_stable{}), "this library's"},
               {"through (n.h)^2 - 1", kernel(ggx_naive{}), "as printed nearly everywhere"}};
  for (Choice& choice : q.choices) choice.error = Precision::single_;
  q.reference = kernel(ggx_stable{});
  return q;
}

}  // namespace

std::vector<Question> lobe_questions() {
  return {power_question<3>(), power_question<5>(), large_power_question(), mirror_question(),
          ggx_question()};
}

}  // namespace brdf::trade
