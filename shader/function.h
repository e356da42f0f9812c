// A shader's reflectance as a function of directions and parameters, in any scalar.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brdf/geometry.h"
#include "brdf/parameter.h"
#include "shader/choice.h"
#include "shader/front/compile.h"
#include "shader/front/roles.h"
#include "shader/front/source.h"
#include "shader/program/program.h"
#include "shader/run/machine.h"

namespace brdf::shader {

// A parameter of the function: a number, or a colour of three.
struct Parameter {
  std::string name, doc;
  double min = 0, max = 1;
  std::array<double, 3> initial{0.5, 0.5, 0.5};
  bool log_scale = false, colour = false;
  Role role = Role::other;
  std::size_t first = 0;  // of its one or three values
  bool boolean = false, whole = false;
  bool declared = false;  // the file or the command line says its range
};

// What fills a slot before a run.
struct Binding {
  enum class From { coordinate, product, value, one, zero } from = From::zero;
  std::uint32_t slot = 0;
  bool integer = false, boolean = false;
  Axis a = Axis::normal, b = Axis::normal;
  int component = 0;      // of a coordinate
  std::size_t value = 0;  // of a parameter
};

// How the value of one step depends on a turn of light and viewer together about the normal.
enum class Turning : std::uint8_t {
  still,    // it does not change
  partial,  // it is a sum of coordinates across the normal, or of their products, and changes
  closes,   // it is a sum of such products that does not change, as Lx Vx + Ly Vy or Lx Vy - Ly Vx
  pairs,  // the same of one such product and its like along the other axis: a product of two lengths at most
  squares,  // the same of squares alone, each of a coordinate, or a sum of two, times what does not change: no term
            // cancels another, so that its rounding error is relative to the sum
};

// What the flattened program shows of such turns (shader/symmetry.h).
struct Symmetry {
  // In exact arithmetic the result is the same after every turn. Where this is false, nothing is known.
  bool isotropic = false;
  // It is also the same where the azimuth between light and viewer has the other sign.
  bool mirrored = false;
  std::uint32_t line =
      0;  // of the source, where the argument fails; 0: it does not fail, or the line is unknown
  std::vector<std::vector<Turning>> steps = {};  // of each step of each stretch; empty unless isotropic
  // The result stays when both directions are reflected at the plane of the tangent, and at that of the
  // bitangent.
  bool reflects = false;
  // Operations from the coordinates to a closing step, at most. Rounding changes the closing sum by at most
  // about that many units of the sum of the absolute values of its terms.
  int depth = 0;
};

struct Function {
  Source source;
  std::string entry;   // its signature
  Program as_written;  // for float
  Program as_meant;    // for other scalars: the library's kernels are what they stand for
  std::vector<Binding> bindings, bindings_as_meant;
  std::deque<Parameter> parameters;
  std::size_t values = 0;  // of all parameters
  Returns returns = Returns::f;
  std::vector<std::string> notes;
  std::vector<std::string> unread;  // parameters that are declared and on which the value does not depend
  std::vector<std::string>
      asked_macros;                // that #if, #ifdef or #ifndef of the text ask for and that nothing defines
  std::optional<double> constant;  // its value, where that depends on nothing that it is given
  bool zero_where_asked = false;   // it is 0 at all of many places chosen at random (of a ShaderReflectance)
  bool oriented = false;           // reads the tangent
  Symmetry symmetry, symmetry_as_meant;

  template <class T>
  const Program& program() const {
    return std::is_same_v<T, float> ? as_written : as_meant;
  }
  template <class T>
  const std::vector<Binding>& bound() const {
    return std::is_same_v<T, float> ? bindings : bindings_as_meant;
  }
  template <class T>
  const Symmetry& turning() const {
    return std::is_same_v<T, float> ? symmetry : symmetry_as_meant;
  }
  // Nothing shows that the value stays when light and viewer turn together: the light has to be turned, too.
  bool may_turn() const { return !symmetry.isotropic || !symmetry_as_meant.isotropic; }
  // Nothing shows that half of the azimuths stands for all: neither the sign of the azimuth between light and
  // viewer nor both reflections of an anisotropic function.
  bool all_round() const { return needs_all(symmetry) || needs_all(symmetry_as_meant); }
  // Whether light or viewer is among what it is given, by itself, in a product or in the half vector.
  bool is_given(Axis axis) const;
  std::vector<double> defaults() const;
  static bool needs_all(const Symmetry& s) { return !s.reflects && !(s.isotropic && s.mirrored); }
  std::uint64_t number = 0;  // of this function, for caches: no two share one
};

// Compiles and flattens. Throws InputError.
Function make_function(const ShaderChoice& choice);
Function make_function(Source source, const ShaderChoice& choice = {});
Function make_function(Source source, const ShaderChoice& choice, Compiler& compiler);

// What to do where an argument's meaning is open.
std::string entry_advice(const Function& function);

// What is said of a function that is 0 or does not depend on all that the file declares, with the macros that
// may be the reason; empty: nothing.
std::string said_of_unread(const Function& function);

// What an integer or a truth that is bound to a parameter of value v holds.
inline std::uint32_t integer_of(const Binding& b, double v) {
  return b.boolean ? std::uint32_t(v >= 0.5) : detail::to_integer(std::floor(v + 0.5), Op::to_signed);
}

// A function's bank for runs of W directions, filled by its parameters' values.
template <class T, int W>
class Runner {
 public:
  using Lanes = std::array<std::array<T, W>, 3>;  // of a vector's coordinates
  explicit Runner(const Function& function)
      : number_(function.number), program_(&function.template program<T>()), bank_(*program_) {}
  std::uint64_t number() const { return number_; }

  void set_values(const Function& function, std::span<const T> values) {
    for (const Binding& b : function.template bound<T>()) {
      if (b.from != Binding::From::value) continue;
      const T& value = values[b.value];
      if (!b.integer) {
        bank_.set(b.slot, value);
        continue;
      }
      bank_.set_integer(b.slot, integer_of(b, Functions<T>::value(value)));
    }
  }
  // Of all lanes.
  void set_directions(const Function& function, const Lanes& wi, const Lanes& wo) {
    const T one = Functions<T>::number(1), zero = Functions<T>::number(0);
    Lanes half;
    bool has_half = false;
    const auto axis = [&](Axis a) -> const Lanes& {
      if (a != Axis::half) return a == Axis::light ? wi : wo;
      if (!std::exchange(has_half, true))
        for (std::size_t l = 0; l < W; ++l) {
          const T x = wi[0][l] + wo[0][l], y = wi[1][l] + wo[1][l], z = wi[2][l] + wo[2][l];
          const T length = Functions<T>::sqrt(x * x + y * y + z * z);
          half[0][l] = x / length, half[1][l] = y / length, half[2][l] = z / length;
        }
      return half;
    };
    // Which coordinate an axis of the frame is; -1 of the others.
    const auto frame = [](Axis a) {
      return a == Axis::tangent ? 0 : a == Axis::bitangent ? 1 : a == Axis::normal ? 2 : -1;
    };
    for (const Binding& b : function.template bound<T>()) {
      if (b.from == Binding::From::value) continue;
      if (b.integer) {
        bank_.set_integer(b.slot, b.from == Binding::From::one);
        continue;
      }
      T* const out = bank_.number(b.slot);
      if (b.from == Binding::From::coordinate && frame(b.a) < 0) {
        std::copy_n(axis(b.a)[std::size_t(b.component)].begin(), W, out);
      } else if (b.from == Binding::From::product && (frame(b.a) < 0 || frame(b.b) < 0)) {
        // The product with an axis of the frame is a coordinate.
        const bool first = frame(b.a) >= 0, second = frame(b.b) >= 0;
        if (first || second) {
          std::copy_n(axis(first ? b.b : b.a)[std::size_t(frame(first ? b.a : b.b))].begin(), W, out);
        } else {
          const Lanes &x = axis(b.a), &y = axis(b.b);
          for (std::size_t l = 0; l < W; ++l)
            out[l] = x[0][l] * y[0][l] + x[1][l] * y[1][l] + x[2][l] * y[2][l];
        }
        // Unit vectors: what rounding adds to 1 is not the shader's.
        for (std::size_t l = 0; l < W; ++l)
          out[l] = detail::pick(one < out[l], one, detail::pick(out[l] < -one, -one, out[l]));
      } else {
        const bool is_one = b.from == Binding::From::one ||
                            (b.from == Binding::From::coordinate && frame(b.a) == b.component) ||
                            (b.from == Binding::From::product && b.a == b.b);
        std::fill_n(out, W, is_one ? one : zero);
      }
    }
  }
  static Lanes lanes_of(const Vec3<T>& w)
    requires(W == 1)
  {
    return {{{w.x}, {w.y}, {w.z}}};
  }
  // Throws EndlessLoop, with what the runner was given.
  void run(int lanes, std::span<const T> values, const Lanes& wi, const Lanes& wo) {
    try {
      shader::run<T, W>(*program_, bank_, lanes);
    } catch (EndlessLoop& loop) {
      for (const T& v : values) loop.values.push_back(Functions<T>::value(v));
      for (std::size_t k = 0; k < 3; ++k) {
        loop.wi[k] = Functions<T>::value(wi[k][std::size_t(loop.lane)]);
        loop.wo[k] = Functions<T>::value(wo[k][std::size_t(loop.lane)]);
      }
      throw;
    }
  }
  // What the function returned; `component` of a colour.
  const T& result(int lane, std::size_t component) const {
    return bank_.number(program_->results[std::min(component, program_->results.size() - 1)])[lane];
  }
  Bank<T, W>& bank() { return bank_; }

 private:
  std::uint64_t number_;
  const Program* program_;
  Bank<T, W> bank_;
};

// f_r (or f_r cos_i) of what the function returned.
template <class T>
T reflectance_of_returned(Returns returns, const T& value, const T& cos_i, const T& cos_o,
                          bool times_cosine) {
  const T least = Functions<T>::number(kMinCosine<T>), i = at_least(cos_i, least), o = at_least(cos_o, least);
  if (returns == Returns::f) return times_cosine ? value * i : value;
  if (returns == Returns::f_cos_i) return times_cosine ? value : value / i;
  return times_cosine ? value / o * i : value / o;
}

// f_r at one pair of unit directions, 1/sr; 0 below the horizon. `values`: of all parameters in order, a
// colour's three together. Throws EndlessLoop.
template <class T>
T evaluate(const Function& function, Runner<T, 1>& runner, std::span<const T> values, const Vec3<T>& wi,
           const Vec3<T>& wo, std::size_t component) {
  const auto i = runner.lanes_of(wi), o = runner.lanes_of(wo);
  runner.set_values(function, values);
  runner.set_directions(function, i, o);
  runner.run(1, values, i, o);
  return reflectance_of_returned<T>(function.returns, runner.result(0, component), wi.z, wo.z, false);
}

}  // namespace brdf::shader
