// Compiled with -ffp-contract=fast. Everything is inlined here (flatten), because a contracted copy of a
// library function could otherwise replace the library's own.
#include "brdf/forms.h"
#include "tests/render/contracted.h"

namespace brdf::render {
namespace {

template <class F>
#if defined(__x86_64__)
[[gnu::flatten, gnu::target("fma")]]
#endif
ProofValues
contracted(F f, const ProofConfiguration& c) {
  using Weights = typename F::template Weights<float>;
  const auto shape = from_values<typename F::template Shape<float>>(std::span<const float>(c.shape));
  const Geometry<float> g =
      geometry(Vec3<float>{c.wi[0], c.wi[1], c.wi[2]}, Vec3<float>{c.wo[0], c.wo[1], c.wo[2]});
  ProofValues values;
  Weights first{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const std::array<float, 3> w{c.weights[0][channel], c.weights[1][channel], c.weights[2][channel]};
    const Weights weights = from_values<Weights>(std::span<const float>(w));
    if (channel == 0) first = weights;
    values[channel] = eval(f, weights, first, shape, g);
    values[3 + channel] = eval_cos(f, weights, first, shape, g);
  }
  return values;
}

}  // namespace

ProofValues contracted_values(const Reflectance& form, const ProofConfiguration& c) {
  if (form == Reflectance(ward{})) return contracted(ward{}, c);
  if (form == Reflectance(cook_torrance{})) return contracted(cook_torrance{}, c);
  return contracted(oren_nayar{}, c);
}

}  // namespace brdf::render
