// Matt surfaces: white standards, diffusers, paper, soil.
#pragma once

#include "brdf/form.h"
#include "brdf/matt_basis.h"

namespace brdf {

// Weights of a basis. They may have either sign: whether f is negative somewhere is a property of the
// weights, not of the form.
inline constexpr double kSignedWeightMax = kWeightMax, kUsualSignedWeight = 0.5;
constexpr ParameterInfo matt_weight(std::string_view name, std::string_view doc) {
  return {name, -kSignedWeightMax, kSignedWeightMax, 0, kUsualSignedWeight, "", false, doc, Role::other};
}
inline constexpr ParameterInfo kMattMean{
    "w000", 0, kWeightMax, 0.5, 1, "", false, "weight of the constant, the mean of pi f", Role::diffuse};

template <class T>
struct Matt2Weights {
  T w000, w111;
  static constexpr auto fields() {
    using W = Matt2Weights;
    return std::array{Field{&W::w000, kMattMean},
                      Field{&W::w111, matt_weight("w111", "R_1^1(r_i) R_1^1(r_o), times cos(dphi)")}};
  }
  constexpr auto linear() const { return to_values<T>(*this); }
  static constexpr Matt2Weights from_linear(const std::array<T, 2>& w) {
    return from_values<Matt2Weights>(std::span<const T>(w));
  }
};

template <class T>
struct Matt5Weights {
  T w000, w020, w220, w111, w222;
  static constexpr auto fields() {
    using W = Matt5Weights;
    return std::array{Field{&W::w000, kMattMean},
                      Field{&W::w020, matt_weight("w020", "R_0(r_i) R_2(r_o), symmetric")},
                      Field{&W::w220, matt_weight("w220", "R_2(r_i) R_2(r_o)")},
                      Field{&W::w111, matt_weight("w111", "R_1^1(r_i) R_1^1(r_o), times cos(dphi)")},
                      Field{&W::w222, matt_weight("w222", "R_2^2(r_i) R_2^2(r_o), times cos(2 dphi)")}};
  }
  constexpr auto linear() const { return to_values<T>(*this); }
  static constexpr Matt5Weights from_linear(const std::array<T, 5>& w) {
    return from_values<Matt5Weights>(std::span<const T>(w));
  }
};

template <class T>
struct Matt8Weights {
  T w000, w020, w220, w111, w131, w331, w222, w333;
  static constexpr auto fields() {
    using W = Matt8Weights;
    return std::array{
        Field{&W::w000, kMattMean},
        Field{&W::w020, matt_weight("w020", "R_0(r_i) R_2(r_o), symmetric")},
        Field{&W::w220, matt_weight("w220", "R_2(r_i) R_2(r_o)")},
        Field{&W::w111, matt_weight("w111", "R_1^1(r_i) R_1^1(r_o), times cos(dphi)")},
        Field{&W::w131, matt_weight("w131", "R_1^1(r_i) R_3^1(r_o), symmetric, times cos(dphi)")},
        Field{&W::w331, matt_weight("w331", "R_3^1(r_i) R_3^1(r_o), times cos(dphi)")},
        Field{&W::w222, matt_weight("w222", "R_2^2(r_i) R_2^2(r_o), times cos(2 dphi)")},
        Field{&W::w333, matt_weight("w333", "R_3^3(r_i) R_3^3(r_o), times cos(3 dphi)")}};
  }
  constexpr auto linear() const { return to_values<T>(*this); }
  static constexpr Matt8Weights from_linear(const std::array<T, 8>& w) {
    return from_values<Matt8Weights>(std::span<const T>(w));
  }
};

template <class T>
struct Matt14Weights {
  T w000, w020, w040, w220, w240, w440, w111, w131, w331, w222, w242, w442, w333, w444;
  static constexpr auto fields() {
    using W = Matt14Weights;
    return std::array{
        Field{&W::w000, kMattMean},
        Field{&W::w020, matt_weight("w020", "R_0(r_i) R_2(r_o), symmetric")},
        Field{&W::w040, matt_weight("w040", "R_0(r_i) R_4(r_o), symmetric")},
        Field{&W::w220, matt_weight("w220", "R_2(r_i) R_2(r_o)")},
        Field{&W::w240, matt_weight("w240", "R_2(r_i) R_4(r_o), symmetric")},
        Field{&W::w440, matt_weight("w440", "R_4(r_i) R_4(r_o)")},
        Field{&W::w111, matt_weight("w111", "R_1^1(r_i) R_1^1(r_o), times cos(dphi)")},
        Field{&W::w131, matt_weight("w131", "R_1^1(r_i) R_3^1(r_o), symmetric, times cos(dphi)")},
        Field{&W::w331, matt_weight("w331", "R_3^1(r_i) R_3^1(r_o), times cos(dphi)")},
        Field{&W::w222, matt_weight("w222", "R_2^2(r_i) R_2^2(r_o), times cos(2 dphi)")},
        Field{&W::w242, matt_weight("w242", "R_2^2(r_i) R_4^2(r_o), symmetric, times cos(2 dphi)")},
        Field{&W::w442, matt_weight("w442", "R_4^2(r_i) R_4^2(r_o), times cos(2 dphi)")},
        Field{&W::w333, matt_weight("w333", "R_3^3(r_i) R_3^3(r_o), times cos(3 dphi)")},
        Field{&W::w444, matt_weight("w444", "R_4^4(r_i) R_4^4(r_o), times cos(4 dphi)")}};
  }
  constexpr auto linear() const { return to_values<T>(*this); }
  static constexpr Matt14Weights from_linear(const std::array<T, 14>& w) {
    return from_values<Matt14Weights>(std::span<const T>(w));
  }
};

template <class T>
struct Matt20Weights {
  T w000, w020, w040, w220, w240, w440, w111, w131, w151, w331, w351, w551, w222, w242, w442, w333, w353,
      w553, w444, w555;
  static constexpr auto fields() {
    using W = Matt20Weights;
    return std::array{
        Field{&W::w000, kMattMean},
        Field{&W::w020, matt_weight("w020", "R_0(r_i) R_2(r_o), symmetric")},
        Field{&W::w040, matt_weight("w040", "R_0(r_i) R_4(r_o), symmetric")},
        Field{&W::w220, matt_weight("w220", "R_2(r_i) R_2(r_o)")},
        Field{&W::w240, matt_weight("w240", "R_2(r_i) R_4(r_o), symmetric")},
        Field{&W::w440, matt_weight("w440", "R_4(r_i) R_4(r_o)")},
        Field{&W::w111, matt_weight("w111", "R_1^1(r_i) R_1^1(r_o), times cos(dphi)")},
        Field{&W::w131, matt_weight("w131", "R_1^1(r_i) R_3^1(r_o), symmetric, times cos(dphi)")},
        Field{&W::w151, matt_weight("w151", "R_1^1(r_i) R_5^1(r_o), symmetric, times cos(dphi)")},
        Field{&W::w331, matt_weight("w331", "R_3^1(r_i) R_3^1(r_o), times cos(dphi)")},
        Field{&W::w351, matt_weight("w351", "R_3^1(r_i) R_5^1(r_o), symmetric, times cos(dphi)")},
        Field{&W::w551, matt_weight("w551", "R_5^1(r_i) R_5^1(r_o), times cos(dphi)")},
        Field{&W::w222, matt_weight("w222", "R_2^2(r_i) R_2^2(r_o), times cos(2 dphi)")},
        Field{&W::w242, matt_weight("w242", "R_2^2(r_i) R_4^2(r_o), symmetric, times cos(2 dphi)")},
        Field{&W::w442, matt_weight("w442", "R_4^2(r_i) R_4^2(r_o), times cos(2 dphi)")},
        Field{&W::w333, matt_weight("w333", "R_3^3(r_i) R_3^3(r_o), times cos(3 dphi)")},
        Field{&W::w353, matt_weight("w353", "R_3^3(r_i) R_5^3(r_o), symmetric, times cos(3 dphi)")},
        Field{&W::w553, matt_weight("w553", "R_5^3(r_i) R_5^3(r_o), times cos(3 dphi)")},
        Field{&W::w444, matt_weight("w444", "R_4^4(r_i) R_4^4(r_o), times cos(4 dphi)")},
        Field{&W::w555, matt_weight("w555", "R_5^5(r_i) R_5^5(r_o), times cos(5 dphi)")}};
  }
  constexpr auto linear() const { return to_values<T>(*this); }
  static constexpr Matt20Weights from_linear(const std::array<T, 20>& w) {
    return from_values<Matt20Weights>(std::span<const T>(w));
  }
};

// What the forms of the family share, for the polynomials of one order.
template <int kOrder>
struct Matt {
  static constexpr std::string_view family = "matt";
  static constexpr Kink kink = Kink::none;
  static constexpr MattBasis basis{kOrder, kMattIndices<kOrder>};
  // Errors are relative to |f| + the sum of the sizes of the weights over pi, so one bound holds for all f.
  static constexpr Accuracy within(double in_float, double in_double) {
    return {{in_float, in_float, in_float}, {in_double, in_double, in_double}};
  }

  template <class S, class Shape, class G>
  static auto lobes_of(const Shape&, const Geometry<G>& g) {
    return matt_lobes<kOrder, S>(g);
  }
};

// Koenderink and van Doorn 1998, the functions up to the first order: f = (1/pi) sum of 2 weights times the
// polynomials s_nml of brdf/matt_basis.h.
// Domain: everywhere; w000 0..1000, the other weights -1000..1000.
// Symmetry: isotropic, reciprocal. Polynomials of q = (x, y)/sqrt(1 + z): smooth everywhere.
// Known violations: weights exist for which f is negative. `brdf prove` decides this for a material.
struct matt_2 : Takes<Matt2Weights, NoShape>, Matt<1> {
  static constexpr std::string_view name = "matt_2";
  static constexpr Accuracy accuracy = within(2.6e-7, 4.2e-16);
  static constexpr std::array violations{
      Violation{"non_negative", "for weights of either sign: the least value of 2 weights between -1 and 1",
                "w000=0 w111=-1", 90, -0.318309886}};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    return lobes_of<S>(shape, g);
  }
};

// Koenderink and van Doorn 1998, the functions up to the second order: f = (1/pi) sum of 5 weights times the
// polynomials s_nml of brdf/matt_basis.h.
// Domain: everywhere; w000 0..1000, the other weights -1000..1000.
// Symmetry: isotropic, reciprocal. Polynomials of q = (x, y)/sqrt(1 + z): smooth everywhere.
// Known violations: weights exist for which f is negative, or the albedo above 1. `brdf prove` decides this
// for a material.
struct matt_5 : Takes<Matt5Weights, NoShape>, Matt<2> {
  static constexpr std::string_view name = "matt_5";
  static constexpr Accuracy accuracy = within(7.2e-7, 1.6e-15);
  static constexpr std::array violations{
      Violation{"non_negative", "for weights of either sign: the least value of 5 weights between -1 and 1",
                "w000=0 w020=-1 w220=-1 w111=-1 w222=-1", 90, -1.27323954},
      Violation{"energy", "for weights up to 1 of either sign", "w000=1 w020=-1 w220=1 w111=0 w222=0", 0, 2}};

  template <class S, class G>
  static std::array<S, 5> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    return lobes_of<S>(shape, g);
  }
};

// Koenderink and van Doorn 1998, the functions up to the third order: f = (1/pi) sum of 8 weights times the
// polynomials s_nml of brdf/matt_basis.h.
// Domain: everywhere; w000 0..1000, the other weights -1000..1000.
// Symmetry: isotropic, reciprocal. Polynomials of q = (x, y)/sqrt(1 + z): smooth everywhere.
// Known violations: weights exist for which f is negative, or the albedo above 1. `brdf prove` decides this
// for a material.
struct matt_8 : Takes<Matt8Weights, NoShape>, Matt<3> {
  static constexpr std::string_view name = "matt_8";
  static constexpr Accuracy accuracy = within(1.9e-6, 3.4e-15);
  static constexpr std::array violations{
      Violation{"non_negative", "for weights of either sign: the least value of 8 weights between -1 and 1",
                "w000=0 w020=-1 w220=-1 w111=-1 w131=-1 w331=-1 w222=-1 w333=-1", 90, -2.2281692},
      Violation{"energy", "for weights up to 1 of either sign",
                "w000=1 w020=-1 w220=1 w111=0 w131=0 w331=0 w222=0 w333=0", 0, 2}};

  template <class S, class G>
  static std::array<S, 8> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    return lobes_of<S>(shape, g);
  }
};

// Koenderink and van Doorn 1998, the functions up to the fourth order: f = (1/pi) sum of 14 weights times the
// polynomials s_nml of brdf/matt_basis.h.
// Domain: everywhere; w000 0..1000, the other weights -1000..1000.
// Symmetry: isotropic, reciprocal. Polynomials of q = (x, y)/sqrt(1 + z): smooth everywhere.
// Known violations: weights exist for which f is negative, or the albedo above 1. `brdf prove` decides this
// for a material.
struct matt_14 : Takes<Matt14Weights, NoShape>, Matt<4> {
  static constexpr std::string_view name = "matt_14";
  static constexpr Accuracy accuracy = within(2.9e-6, 6.3e-15);
  static constexpr std::array violations{
      Violation{"non_negative", "for weights of either sign: the least value of 14 weights between -1 and 1",
                "w000=0 w020=-1 w040=-1 w220=-1 w240=-1 w440=-1 w111=-1 w131=-1 w331=-1 w222=-1 w242=-1 "
                "w442=-1 w333=-1 w444=-1",
                90, -4.13802852},
      Violation{"energy", "for weights up to 1 of either sign",
                "w000=1 w020=-1 w040=1 w220=1 w240=-1 w440=0 w111=0 w131=0 w331=0 w222=0 w242=0 w442=0 "
                "w333=0 w444=0",
                0, 2.66666667}};

  template <class S, class G>
  static std::array<S, 14> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    return lobes_of<S>(shape, g);
  }
};

// Koenderink and van Doorn 1998, the functions up to the fifth order: f = (1/pi) sum of 20 weights times the
// polynomials s_nml of brdf/matt_basis.h.
// Domain: everywhere; w000 0..1000, the other weights -1000..1000.
// Symmetry: isotropic, reciprocal. Polynomials of q = (x, y)/sqrt(1 + z): smooth everywhere.
// Known violations: weights exist for which f is negative, or the albedo above 1. `brdf prove` decides this
// for a material.
struct matt_20 : Takes<Matt20Weights, NoShape>, Matt<5> {
  static constexpr std::string_view name = "matt_20";
  static constexpr Accuracy accuracy = within(4.8e-6, 8.8e-15);
  static constexpr std::array violations{
      Violation{"non_negative", "for weights of either sign: the least value of 20 weights between -1 and 1",
                "w000=0 w020=-1 w040=-1 w220=-1 w240=-1 w440=-1 w111=-1 w131=-1 w151=-1 w331=-1 w351=-1 "
                "w551=-1 w222=-1 w242=-1 w442=-1 w333=-1 w353=-1 w553=-1 w444=-1 w555=-1",
                90, -6.04788784},
      Violation{"energy", "for weights up to 1 of either sign",
                "w000=1 w020=-1 w040=1 w220=1 w240=-1 w440=0 w111=0 w131=0 w151=0 w331=0 w351=0 w551=0 "
                "w222=0 w242=0 w442=0 w333=0 w353=0 w553=0 w444=0 w555=0",
                0, 2.66666667}};

  template <class S, class G>
  static std::array<S, 20> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    return lobes_of<S>(shape, g);
  }
};

}  // namespace brdf
