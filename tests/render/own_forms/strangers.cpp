// Compiled once for the tests of the renderer. If the tests named these forms themselves, each test would
// compile the forms again, without optimisation.
#include "tests/render/strangers.h"

#include "brdf/cosine_lobe.h"
#include "brdf/reflectance_of.h"

namespace brdf::render {
namespace {

// The weight of the lobe comes first, the diffuse weight last.
template <class T>
struct GleamWeights {
  T gleam, ground;
  static constexpr auto fields() {
    return std::array{Field{&GleamWeights::gleam,
                            ParameterInfo{"gleam", 0, 10, 0.4, 1, "", false, "the lobe", Role::specular}},
                      Field{&GleamWeights::ground,
                            ParameterInfo{"ground", 0, 10, 0.3, 1, "", false, "below", Role::diffuse}}};
  }
  constexpr std::array<T, 2> linear() const { return {gleam, ground}; }
  static constexpr GleamWeights from_linear(const std::array<T, 2>& w) { return {w[0], w[1]}; }
};

template <class T>
struct Sharpness {
  T sharpness;
  static constexpr auto fields() {
    return std::array{Field{&Sharpness::sharpness,
                            ParameterInfo{"sharpness", 0, 1e4, 30, 1e3, "", true, "power", Role::exponent}}};
  }
};

struct Gleam : Takes<GleamWeights, Sharpness> {
  static constexpr std::string_view name = "stranger", family = "stranger";
  static constexpr NoViolations violations{};
  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    return {mirror_cosine_power(shape.sharpness, g), S(1 / kPi)};
  }
};
struct Glint : Takes<GleamWeights, Sharpness> {
  static constexpr std::string_view name = "stranger", family = "stranger";
  static constexpr NoViolations violations{};
  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    return {half_cosine_power(shape.sharpness, g), S(1 / kPi)};
  }
};

}  // namespace

Reflectance gleam() {
  return Gleam{};
}

Reflectance glint() {
  return Glint{};
}

}  // namespace brdf::render
