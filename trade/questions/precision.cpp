#include "brdf/forms.h"
#include "trade/questions/form_kernel.h"
#include "trade/questions/picture.h"
#include "trade/questions/questions.h"

namespace brdf::trade {
namespace {

// Rounds x to the 11 digits and the range of 16-bit floats (Veltkamp's split; below 2^-14 the spacing is
// 2^-24).
inline float half(float x) {
  const float c = 8193.0f * x;
  const float split = c - (c - x);
  const float tiny = (x + 0.75f) - 0.75f;
  const float rounded = select(square(x) < 3.7252903e-9f, tiny, split);
  return select(65504.0f < x, 65504.0f, rounded);
}

// Directions, width and result rounded to 16-bit floats, as in a G-buffer; the arithmetic uses float.
template <class F>
struct half_kernel {
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    const auto numbers = fields_of(x);
    const auto halves = row_from<DirectionRow, T>([&](std::size_t k) { return T(half(float(numbers[k]))); });
    return T(half(float(form_kernel<F>{}(halves))));
  }
};

struct Width {
  const char* name;
  double least, most;  // everyday range
  double extreme_low, extreme_high;
  double shown;  // in the picture
  bool peaked;
};

template <class F>
Question form_question(const Width& width) {
  // Returns directions and one parameter. Peaks need points around the half vector.
  const auto domain = [&](double least, double most, double from, double to) {
    const bool log = width.least > 0;
    const Axis axis{width.name, least, most, log};
    return width.peaked && to < 85 ? lobe_domain(axis, 3, to) : directions(axis, to, from);
  };
  Question q{
      std::string(F::name) + ": precision and kernels",
      "f_r",
      Measure::relative,
      domain(width.least, width.most, 0, 80),
      {domain(width.extreme_low, width.extreme_low, 0, 80),
       domain(width.extreme_high, width.extreme_high, 0, 80), domain(width.least, width.most, 85, 89.99)},
      {}};
  const auto add = [&](const char* name, const Kernel& k, Precision p, const char* note) {
    q.choices.push_back({name, k, note, fixed_at(k, width.shown), p, p});
  };
  const Kernel own = kernel(form_kernel<F, Own>{}), libm = kernel(form_kernel<F, Libm>{});
  add("double", own, Precision::double_, "own kernels");
  add("double, C library", libm, Precision::double_, "the library's exp, log, ...: does not vectorise");
  add("float", own, Precision::single_, "directions stored in float");
  add("float, C library", libm, Precision::single_, "directions stored in float");
  add("half storage", kernel(half_kernel<F>{}), Precision::single_,
      "directions, width and result in 16 bits");
  q.reference = scalar_kernel(form_kernel<F, Extended>{});
  return q;
}

// --- Elementary functions ----------------------------------------------------------------------------------

constexpr auto exp_of = []<class T>(const T& x, const T&) { return math::exp(x); };
constexpr auto log_of = []<class T>(const T& x, const T&) { return math::log(x); };
constexpr auto log1p_of = []<class T>(const T& x, const T&) { return math::log1p(x); };
constexpr auto erfcx_of = []<class T>(const T& x, const T&) { return math::erfcx(x); };
constexpr auto angle_of = []<class T>(const T& x, const T& y) { return math::angle(x, y); };

template <auto function, template <class> class Scalar>
struct elementary {
  template <class T>
  T operator()(const ArgumentRow<T>& row) const {
    using S = Scalar<T>;
    return narrowed<T>(function(S(row.x), S(row.y)));
  }
};

// A kernel computed in Scalar<T>.
template <class K, template <class> class Scalar>
struct computed_in {
  K kernel;
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    using S = Scalar<T>;
    const auto numbers = fields_of(x);
    return narrowed<T>(kernel(row_from<DirectionRow, S>([&](std::size_t k) { return S(numbers[k]); })));
  }
};

// A material with an evaluation that calls the function, for the picture: a form.
template <class F, template <class> class Scalar>
struct shown_by_form {
  static Kernel at(double width) { return fixed_at(kernel(form_kernel<F, Scalar>{}), width); }
};
// Answers the same question for log, which no form calls: Phong's lobe by pow.
template <template <class> class Scalar>
struct shown_by_pow {
  static Kernel at(double exponent) {
    return untimed_kernel(
        computed_in<lobe_material<mirror_power<decltype(cosine_power)>>, Scalar>{{{}, exponent}});
  }
};
struct Pictures {
  Kernel own, libm;
};
template <class F>
Pictures pictures_of(double width) {
  return {shown_by_form<F, Own>::at(width), shown_by_form<F, Libm>::at(width)};
}

Domain arguments(std::vector<Axis> axes, std::string note = {}) {
  return make_domain(
      std::move(axes),
      [](std::span<const double> at) {
        return ArgumentRow<double>{at[0], at.size() > 1 ? at[1] : 0};
      },
      std::move(note));
}

// The arguments are rounded to float first: the reference then has the same arguments as the choices.
template <auto function>
Question elementary_question(const char* name, const Domain& domain, const Domain& extreme,
                             const Pictures& pictures) {
  Question q{std::string(name) + ": own kernel or C library",
             name,
             Measure::relative,
             stored_in_float(domain),
             {stored_in_float(extreme)},
             {}};
  const auto own = kernel(elementary<function, Own>{}), libm = kernel(elementary<function, Libm>{});
  q.choices = {{"C library, double", libm, "", pictures.libm, Precision::double_, Precision::double_},
               {"own, double", own, "vectorises", pictures.own, Precision::double_, Precision::double_},
               {"C library, float", libm, "", pictures.libm, Precision::single_, Precision::single_},
               {"own, float", own, "vectorises", pictures.own, Precision::single_, Precision::single_}};
  q.reference = scalar_kernel(elementary<function, Extended>{});
  q.floor = 1e-30;
  return q;
}

}  // namespace

std::vector<Question> precision_questions() {
  std::vector<Question> questions;
  const Width alpha{"alpha", 0.05, 1, 1e-4, 1, 0.3, true};
  const Width exponent{"exponent", 5, 1000, 1, 1e6, 50, false};
  questions.push_back(form_question<cook_torrance>(alpha));
  questions.push_back(form_question<cook_torrance_beckmann>(alpha));
  questions.push_back(form_question<ward>(alpha));
  questions.push_back(form_question<blinn_phong>(exponent));
  questions.push_back(form_question<phong>(exponent));
  questions.push_back(form_question<oren_nayar>({"sigma", 0, 1, 0, 1.5, 0.5, false}));
  questions.push_back(elementary_question<exp_of>("exp", arguments({{"x", -20, 0}}),
                                                  arguments({{"x", -80, -60}}, "float flushes below -80"),
                                                  pictures_of<ward>(0.3)));
  questions.push_back(elementary_question<log_of>(
      "log", arguments({{"x", 1e-3, 1, true}}), arguments({{"x", 1e-30, 1e-20, true}}),
      Pictures{shown_by_pow<Own>::at(20), shown_by_pow<Libm>::at(20)}));
  questions.push_back(elementary_question<log1p_of>("log1p", arguments({{"x", 1e-6, 10, true}}),
                                                    arguments({{"x", 1e-20, 1e-10, true}}),
                                                    pictures_of<blinn_phong>(50)));
  questions.push_back(elementary_question<erfcx_of>("erfcx", arguments({{"x", 0, 3}}),
                                                    arguments({{"x", 8, 10}}),
                                                    pictures_of<cook_torrance_beckmann>(0.3)));
  questions.push_back(elementary_question<angle_of>(
      "angle", arguments({{"sine", 0.01, 1}, {"cosine", 0.01, 1}}),
      arguments({{"sine", 1e-8, 1e-6}, {"cosine", 1e-8, 1}}), pictures_of<oren_nayar_full>(0.5)));
  return questions;
}

}  // namespace brdf::trade
