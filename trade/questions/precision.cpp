#include "brdf/forms.h"
#include "brdf/reflectance.h"
#include "trade/approximations/libm.h"
#include "trade/approximations/lobes.h"
#include "trade/questions/picture.h"
#include "trade/questions/questions.h"

namespace brdf::trade {
namespace {

template <class S, class T>
S widened(const T& x) {
  return S(x);
}
template <class T, class S>
T narrowed(const S& x) {
  if constexpr (requires { x.value; })
    return T(x.value);
  else
    return T(x);
}

// A canonical form at kd 0.3, ks 0.5, rho 0.5 and the table's other defaults; column 6 is its width (alpha,
// exponent or sigma). Scalar<T> is what it computes in.
template <class F, template <class> class Scalar>
struct form_kernel {
  template <class T>
  T operator()(const Row<T>& x) const {
    using S = Scalar<T>;
    using Weights = typename F::template Weights<S>;
    using Shape = typename F::template Shape<S>;
    Weights w{};
    for (const auto& field : Weights::fields())
      w.*(field.member) = S(field.info.name == "kd" ? 0.3 : field.info.initial);
    Shape shape{};
    for (const auto& field : Shape::fields()) shape.*(field.member) = widened<S>(x[6]);
    const auto g = geometry(Vec3<S>{widened<S>(x[0]), widened<S>(x[1]), widened<S>(x[2])},
                            Vec3<S>{widened<S>(x[3]), widened<S>(x[4]), widened<S>(x[5])}, 1e-6);
    return narrowed<T>(eval(F{}, w, w, shape, g));
  }
};

template <class T>
using Own = T;
template <class T>
using Extended = Libm<long double>;

// x at the 11 digits and the range of 16-bit floats (Veltkamp's split; below 2^-14 the spacing is 2^-24).
inline float half(float x) {
  const float c = 8193.0f * x;
  const float split = c - (c - x);
  const float tiny = (x + 0.75f) - 0.75f;
  const float rounded = select(square(x) < 3.7252903e-9f, tiny, split);
  return select(65504.0f < x, 65504.0f, rounded);
}

// Directions, width and result as 16-bit floats hold them, as in a G-buffer; the arithmetic is float's.
template <class F>
struct half_kernel {
  template <class T>
  T operator()(Row<T> x) const {
    for (T& value : x) value = T(half(float(value)));
    return T(half(float(form_kernel<F, Own>{}(x))));
  }
};

struct Width {
  const char* name;
  double least, most;  // everyday
  double extreme_low, extreme_high;
  double shown;  // in the picture
  bool peaked;
};

template <class F>
Question form_question(const Width& width) {
  // Directions and one parameter; peaks need points around the half vector.
  const auto domain = [&](double least, double most, double from, double to) {
    const bool log = width.least > 0;
    if (width.peaked && to < 85) {
      Domain d = lobe_domain({width.name, least, most, log}, {"-", 0, 0}, 3, to);
      d.axes.pop_back();
      const auto inputs = d.inputs;
      d.inputs = [inputs](std::span<const double> at, Row<double>& row) {
        return inputs(std::array<double, 5>{at[0], at[1], at[2], at[3], 0}, row);
      };
      return d;
    }
    Domain d = direction_domain({width.name, least, most, log}, {"-", 0, 0}, to);
    d.axes.pop_back();
    d.axes[0].min = d.axes[1].min = from;
    d.inputs = [](std::span<const double> at, Row<double>& row) {
      return direction_row(at[0], at[1], at[2], at[3], 0, row);
    };
    return d;
  };
  Question q{
      std::string(F::name) + ": precision and kernels",
      "f_r",
      Measure::relative,
      domain(width.least, width.most, 0, 80),
      {domain(width.extreme_low, width.extreme_low, 0, 80),
       domain(width.extreme_high, width.extreme_high, 0, 80), domain(width.least, width.most, 85, 89.99)},
      {}};
  const auto add = [&](const char* name, auto k, Precision p, const char* note) {
    q.choices.push_back({name, kernel(k), note, kernel(at_width<decltype(k)>{k, width.shown}), p, p});
  };
  const form_kernel<F, Own> own;
  const form_kernel<F, Libm> libm;
  add("double", own, Precision::double_, "own kernels");
  add("double, C library", libm, Precision::double_, "the library's exp, log, ...: does not vectorise");
  add("float", own, Precision::single_, "directions stored in float");
  add("float, C library", libm, Precision::single_, "directions stored in float");
  add("half storage", half_kernel<F>{}, Precision::single_, "directions, width and result in 16 bits");
  q.reference = kernel(form_kernel<F, Extended>{});
  return q;
}

// --- Elementary functions. Row: x, y -----------------------------------------------------------------------

struct exp_of {
  template <class T>
  static T of(const T& x, const T&) {
    return math::exp(x);
  }
};
struct log_of {
  template <class T>
  static T of(const T& x, const T&) {
    return math::log(x);
  }
};
struct log1p_of {
  template <class T>
  static T of(const T& x, const T&) {
    return math::log1p(x);
  }
};
struct erfcx_of {
  template <class T>
  static T of(const T& x, const T&) {
    return math::erfcx(x);
  }
};
struct angle_of {
  template <class T>
  static T of(const T& x, const T& y) {
    return math::angle(x, y);
  }
};

template <class Function, template <class> class Scalar>
struct elementary {
  template <class T>
  T operator()(const Row<T>& x) const {
    using S = Scalar<T>;
    return narrowed<T>(Function::of(widened<S>(x[0]), widened<S>(x[1])));
  }
};

// A kernel computed in Scalar<T>.
template <class K, template <class> class Scalar>
struct computed_in {
  K kernel;
  template <class T>
  T operator()(const Row<T>& x) const {
    Row<Scalar<T>> row;
    for (std::size_t k = 0; k < kInputs; ++k) row[k] = widened<Scalar<T>>(x[k]);
    return narrowed<T>(kernel(row));
  }
};

// A material whose evaluation calls the function, for the picture: a form, ...
template <class F, template <class> class Scalar>
struct shown_by_form {
  static Kernel at(double width) { return kernel(at_width<form_kernel<F, Scalar>>{{}, width}); }
};
// ... and for log, which no form calls, Phong's lobe by pow.
template <template <class> class Scalar>
struct shown_by_pow {
  static Kernel at(double exponent) {
    return kernel(computed_in<lobe_material<mirror_power<cosine_power>>, Scalar>{{{}, exponent}});
  }
};
struct Pictures {
  Kernel own, libm;
};
template <class F>
Pictures pictures_of(double width) {
  return {shown_by_form<F, Own>::at(width), shown_by_form<F, Libm>::at(width)};
}

// The reference sees the inputs as each choice sees them: rounded
// to float first, so that only the function's own error counts.
template <class Function>
Question elementary_question(const char* name, Domain domain, Domain extreme, const Pictures& pictures) {
  for (Domain* d : {&domain, &extreme})
    d->inputs = [](std::span<const double> at, Row<double>& row) {
      for (std::size_t k = 0; k < at.size(); ++k) row[k] = as_float(at[k]);
      return true;
    };
  Question q{std::string(name) + ": own kernel or C library",
             name,
             Measure::relative,
             std::move(domain),
             {std::move(extreme)},
             {}};
  const auto own = kernel(elementary<Function, Own>{}), libm = kernel(elementary<Function, Libm>{});
  q.choices = {{"C library, double", libm, "", pictures.libm, Precision::double_, Precision::double_},
               {"own, double", own, "vectorises", pictures.own, Precision::double_, Precision::double_},
               {"C library, float", libm, "", pictures.libm, Precision::single_, Precision::single_},
               {"own, float", own, "vectorises", pictures.own, Precision::single_, Precision::single_}};
  q.reference = kernel(elementary<Function, Extended>{});
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
  questions.push_back(elementary_question<exp_of>("exp", {{{"x", -20, 0}}, {}, ""},
                                                  {{{"x", -80, -60}}, {}, "float flushes below -80"},
                                                  pictures_of<ward>(0.3)));
  questions.push_back(elementary_question<log_of>(
      "log", {{{"x", 1e-3, 1, true}}, {}, ""}, {{{"x", 1e-30, 1e-20, true}}, {}, ""},
      Pictures{shown_by_pow<Own>::at(20), shown_by_pow<Libm>::at(20)}));
  questions.push_back(elementary_question<log1p_of>("log1p", {{{"x", 1e-6, 10, true}}, {}, ""},
                                                    {{{"x", 1e-20, 1e-10, true}}, {}, ""},
                                                    pictures_of<blinn_phong>(50)));
  questions.push_back(elementary_question<erfcx_of>(
      "erfcx", {{{"x", 0, 3}}, {}, ""}, {{{"x", 8, 10}}, {}, ""}, pictures_of<cook_torrance_beckmann>(0.3)));
  questions.push_back(elementary_question<angle_of>(
      "angle", {{{"sine", 0.01, 1}, {"cosine", 0.01, 1}}, {}, ""},
      {{{"sine", 1e-8, 1e-6}, {"cosine", 1e-8, 1}}, {}, ""}, pictures_of<oren_nayar_full>(0.5)));
  return questions;
}

}  // namespace brdf::trade
