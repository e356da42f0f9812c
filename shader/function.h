// A shader's reflectance as a function of directions and parameters, in any scalar type.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstring>
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
#include "shader/program/hoist.h"
#include "shader/program/program.h"
#include "shader/run/machine.h"

namespace brdf::shader {

// A parameter of the function: a number, or a colour of three numbers.
struct Parameter {
  std::string name, doc;
  double min = 0, max = 1;
  std::array<double, 3> initial{0.5, 0.5, 0.5};
  bool log_scale = false, colour = false;
  Role role = Role::other;
  std::size_t first = 0;  // index of the first of its one or three values
  bool boolean = false, whole = false;
  bool declared = false;  // the file or the command line declares its range
};

// The content of a slot before a run.
struct Binding {
  enum class From { coordinate, product, value, one, zero, random } from = From::zero;
  std::uint32_t slot = 0;
  bool integer = false, boolean = false;
  Axis a = Axis::normal, b = Axis::normal;
  int component = 0;      // coordinate of the axis `a`
  std::size_t value = 0;  // index of a parameter's value, or of a random number
};

class Joint;

// How the value of one step depends on a common rotation of light and viewer about the normal.
enum class Turning : std::uint8_t {
  still,    // the value does not change
  partial,  // the value is a sum of coordinates across the normal, or of their products, and changes
  closes,   // the value is a sum of such products and does not change, such as Lx Vx + Ly Vy or Lx Vy - Ly Vx
  // Like `closes`, for one such product and its counterpart along the other axis: at most a product of two
  // lengths.
  pairs,
  // Like `closes`, for squares alone. Each is the square of a coordinate or of a sum of two, times a factor
  // that does not change. No term cancels another, so the rounding error is relative to the sum.
  squares,
};

// Facts about such rotations that the flattened program proves (shader/symmetry.h).
struct Symmetry {
  // In exact arithmetic the result is the same after every rotation. If false, nothing is known.
  bool isotropic = false;
  // The result is also the same if the azimuth between light and viewer changes its sign.
  bool mirrored = false;
  // The line of the source at which the proof fails; 0: the proof does not fail, or the line is unknown.
  std::uint32_t line = 0;
  std::vector<std::vector<Turning>> steps = {};  // of each step of each stretch; empty unless isotropic
  // The result does not change when both directions are reflected at the plane of the tangent, nor when
  // both are reflected at the plane of the bitangent.
  bool reflects = false;
  // The largest number of operations from the coordinates to a closing step. Rounding changes the closing
  // sum by at most about this many units in the last place of the sum of the absolute values of its terms.
  int depth = 0;
};

struct Function {
  Source source;
  std::string entry;   // the signature of the entry function
  Program as_written;  // for float
  // For other scalars: the library's kernels are replaced by the functions that they approximate.
  Program as_meant;
  std::vector<Binding> bindings, bindings_as_meant;
  std::deque<Parameter> parameters;
  std::size_t values = 0;  // number of values of all parameters
  Returns returns = Returns::f;
  std::vector<std::string> notes;
  std::vector<std::string> unread;  // declared parameters on which the value does not depend
  // Undefined macros that #if, #ifdef or #ifndef of the text test.
  std::vector<std::string> asked_macros;
  std::optional<double> constant;  // the value, if it depends on no input
  // The value is 0 at all of many places chosen at random (set by ShaderReflectance).
  bool zero_where_asked = false;
  bool oriented = false;  // reads the tangent
  // The names of light and viewer are exchanged: the file's sampler writes the direction of this name.
  bool exchanged = false;
  bool draws = false;       // is a sampler: its arguments may be random numbers
  std::size_t randoms = 0;  // number of random numbers that a sampler takes
  // The sampler and the density of the same file (shader/joint.h); null: the file has neither.
  std::shared_ptr<const Joint> joint = {};
  Symmetry symmetry, symmetry_as_meant;
  // The function with every value that has, or may have, 16 bits rounded to half precision; in double this
  // program rounds nothing. Null: the function has no such values.
  std::shared_ptr<const Function> in_half = {};
  // Values of 16-bit types are rounded in float, too.
  bool has_half_types = false;
  // The reason why half precision is not evaluated although the text has types that may have 16 bits; empty:
  // it is evaluated, or there are no such types.
  std::string half_unknown;

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
  // Returns true unless the value is proved to be unchanged when light and viewer rotate together. If true,
  // searches must rotate the light, too.
  bool may_turn() const { return !symmetry.isotropic || !symmetry_as_meant.isotropic; }
  // Returns true unless half of the azimuths is proved to represent all azimuths: by the sign of the
  // azimuth between light and viewer, or by both reflections of an anisotropic function.
  bool all_round() const { return needs_all(symmetry) || needs_all(symmetry_as_meant); }
  // Returns whether light or viewer is among the inputs, by itself, in a product or in the half vector.
  bool is_given(Axis axis) const;
  // Returns the default values of all parameters, in order.
  std::vector<double> defaults() const;
  static bool needs_all(const Symmetry& s) { return !s.reflects && !(s.isotropic && s.mirrored); }
  std::uint64_t number = 0;  // of this function, for caches; unique
};

// Compiles and flattens a shader. Throws InputError.
Function make_function(const ShaderChoice& choice);
Function make_function(Source source, const ShaderChoice& choice = {});
Function make_function(Source source, const ShaderChoice& choice, Compiler& compiler);

// Returns advice for the case that the meaning of an argument is unknown.
std::string entry_advice(const Function& function);

// Returns a note on a function that is 0 or does not depend on all declared parameters, with the undefined
// macros that may be the reason; empty if there is nothing to report.
std::string said_of_unread(const Function& function);

// Returns the content of an integer or boolean slot that is bound to a parameter with the value v.
inline std::uint32_t integer_of(const Binding& b, double v) {
  return b.boolean ? std::uint32_t(v >= 0.5) : detail::to_integer(std::floor(v + 0.5), Op::to_signed);
}

// A function's bank of slots for runs of W directions, filled with the values of its parameters.
template <class T, int W>
class Runner {
 public:
  using Lanes = std::array<std::array<T, W>, 3>;  // the coordinates of a vector
  explicit Runner(const Function& function)
      : number_(function.number), program_(&function.template program<T>()), bank_(*program_) {}
  // A runner for many directions with the same values: set_values computes all that depends on values alone.
  static std::unique_ptr<Runner> hoisted(const Function& function) {
    auto runner = std::make_unique<Runner>(function);
    SlotSet inputs(*runner->program_);
    for (const Binding& b : function.template bound<T>())
      inputs.of(b.integer)[b.slot] = b.from != Binding::From::value;
    runner->hoisted_ = hoist(*runner->program_, inputs);
    return runner;
  }
  std::uint64_t number() const { return number_; }

  void set_values(const Function& function, std::span<const T> values) {
    if constexpr (std::floating_point<T>)
      if (hoisted_ && !are_new(values)) return;
    for (const Binding& b : function.template bound<T>()) {
      if (b.from != Binding::From::value) continue;
      const T& value = values[b.value];
      if (!b.integer) {
        bank_.set(b.slot, value);
        continue;
      }
      bank_.set_integer(b.slot, integer_of(b, Functions<T>::value(value)));
    }
    if (hoisted_) detail::run_all(hoisted_->once.data(), hoisted_->once.size(), bank_);
  }
  // States by which values, and whether by a rotation of both directions, the next runs take derivatives.
  void set_variables(const Function& function, const std::vector<bool>& values, bool directions)
    requires requires(Bank<T, W>& bank) { bank.set_variables({}); }
  {
    SlotSet slots(*program_);
    for (const Binding& b : function.template bound<T>())
      slots.of(b.integer)[b.slot] = b.from == Binding::From::value ? values[b.value] : directions;
    add_computed(*program_, slots, false);
    bank_.set_variables(std::move(slots.numbers));
  }
  // Sets the directions of all lanes.
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
    for (const Binding& b : function.template bound<T>()) {
      if (b.from == Binding::From::value || b.from == Binding::From::random) continue;
      if (b.integer) {
        bank_.set_integer(b.slot, b.from == Binding::From::one);
        continue;
      }
      const auto out = bank_.number(b.slot);
      const auto copy = [&](const std::array<T, W>& from) {
        for (std::size_t l = 0; l < W; ++l) out[l] = from[l];
      };
      if (b.from == Binding::From::coordinate && frame_coordinate(b.a) < 0) {
        copy(axis(b.a)[std::size_t(b.component)]);
      } else if (b.from == Binding::From::product &&
                 (frame_coordinate(b.a) < 0 || frame_coordinate(b.b) < 0)) {
        // The product with an axis of the frame is a coordinate.
        const bool first = frame_coordinate(b.a) >= 0, second = frame_coordinate(b.b) >= 0;
        if (first || second) {
          copy(axis(first ? b.b : b.a)[std::size_t(frame_coordinate(first ? b.a : b.b))]);
        } else {
          const Lanes &x = axis(b.a), &y = axis(b.b);
          for (std::size_t l = 0; l < W; ++l)
            out[l] = x[0][l] * y[0][l] + x[1][l] * y[1][l] + x[2][l] * y[2][l];
        }
        // Products of unit vectors are clamped to [-1, 1], because an excess from rounding is not the
        // shader's fault.
        for (std::size_t l = 0; l < W; ++l) {
          const T x = out[l];
          out[l] = detail::pick(one < x, one, detail::pick(x < -one, -one, x));
        }
      } else {
        const bool is_one = b.from == Binding::From::one ||
                            (b.from == Binding::From::coordinate && frame_coordinate(b.a) == b.component) ||
                            (b.from == Binding::From::product && b.a == b.b);
        bank_.set(b.slot, is_one ? one : zero);
      }
    }
  }
  static Lanes lanes_of(const Vec3<T>& w)
    requires(W == 1)
  {
    return {{{w.x}, {w.y}, {w.z}}};
  }
  // Runs the program. Throws EndlessLoop, with the inputs of the runner.
  void run(int lanes, std::span<const T> values, const Lanes& wi, const Lanes& wo) {
    try {
      shader::run<T, W>(hoisted_ ? hoisted_->rest : *program_, bank_, lanes);
    } catch (EndlessLoop& loop) {
      for (const T& v : values) loop.values.push_back(Functions<T>::value(v));
      for (std::size_t k = 0; k < 3; ++k) {
        loop.wi[k] = Functions<T>::value(wi[k][std::size_t(loop.lane)]);
        loop.wo[k] = Functions<T>::value(wo[k][std::size_t(loop.lane)]);
      }
      throw;
    }
  }
  // Sets the random numbers of one lane of a sampler.
  void set_randoms(const Function& function, int lane, std::span<const double> numbers) {
    for (const Binding& b : function.template bound<T>())
      if (b.from == Binding::From::random)
        bank_.number(b.slot)[lane] = Functions<T>::number(b.value < numbers.size() ? numbers[b.value] : 0);
  }
  // Returns the value that the function returned; `component` selects a component of a colour.
  T result(int lane, std::size_t component) {
    return bank_.number(program_->results[std::min(component, program_->results.size() - 1)])[lane];
  }
  Bank<T, W>& bank() { return bank_; }

 private:
  // Keeps the values, and returns whether some bit differs from the values of the last call.
  bool are_new(std::span<const T> values) {
    const auto same = [](const T& a, const T& b) { return std::memcmp(&a, &b, sizeof(T)) == 0; };
    if (last_ && std::ranges::equal(*last_, values, same)) return false;
    last_.emplace(values.begin(), values.end());
    return true;
  }

  std::uint64_t number_;
  const Program* program_;
  std::optional<std::vector<T>> last_;
  std::optional<Hoisted> hoisted_;
  Bank<T, W> bank_;
};

// Returns f_r (or f_r cos_i), computed from the value that the function returned.
template <class T>
T reflectance_of_returned(Returns returns, const T& value, const T& cos_i, const T& cos_o,
                          bool times_cosine) {
  const T least = Functions<T>::number(kMinCosine<T>), i = at_least(cos_i, least), o = at_least(cos_o, least);
  if (returns == Returns::f) return times_cosine ? value * i : value;
  if (returns == Returns::f_cos_i) return times_cosine ? value : value / i;
  return times_cosine ? value / o * i : value / o;
}

// Returns f_r at one pair of unit directions, 1/sr. The horizon is not checked here. `values`: the values
// of all parameters in order, the three values of a colour together. Throws EndlessLoop.
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
