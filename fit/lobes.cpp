#include "fit/lobes.h"

#include <array>
#include <cmath>

#include "brdf/dual.h"
#include "fit/clones.h"

namespace brdf::fit {
namespace {

template <int N>
using Scalar = std::conditional_t<N == 0, double, Dual<double, N>>;

template <int N>
Scalar<N> seeded(double value, int partial) {
  if constexpr (N == 0) {
    (void)partial;
    return value;
  } else {
    Dual<double, N> x(value);
    if (partial >= 0) x.v.d[partial] = 1;
    return x;
  }
}

template <class S>
double value_of(const S& x) {
  if constexpr (Differentiated<S>)
    return x.a;
  else
    return x;
}

template <class S, std::size_t K, std::size_t... k>
inline void store(const std::array<S, K>& lobes, bool lit, double* out, std::index_sequence<k...>) {
  ((out[k * kBlock] = lit ? value_of(lobes[k]) : 0.0), ...);
  if constexpr (Differentiated<S>) {
    constexpr std::size_t n = sizeof(S::v) / sizeof(double);
    [&]<std::size_t... p>(std::index_sequence<p...>) {
      const auto derivative = [&](std::size_t j) {
        ((out[(K + j * K + k) * kBlock] = lit ? lobes[k].v.d[j] : 0.0), ...);
      };
      (derivative(p), ...);
    }(std::make_index_sequence<n>{});
  }
}

// Derivatives by the shape only, with plain geometry: half the work of the general case below.
template <class F, int N>
BRDF_FIT_CLONES void shape_block(const typename F::template Shape<Scalar<N>>& shape, double cos_phi,
                                 double sin_phi, const DirectionBlock& d, double* __restrict out) {
  for (std::size_t j = 0; j < d.rows; ++j) {
    const Vec3<double> wi{d.wi_x[j], d.wi_y[j], d.wi_z[j]}, wo{d.wo_x[j], d.wo_y[j], d.wo_z[j]};
    const Geometry<double> g = geometry(turn(wi, cos_phi, sin_phi), turn(wo, cos_phi, sin_phi));
    const auto lobes = F::lobes(shape, g);
    store(lobes, !(g.lowest < 0.0), out + j, std::make_index_sequence<lobe_count<F>>{});
  }
}

// Derivatives by the shape and the tangent's azimuth.
template <class F, int N>
BRDF_FIT_CLONES void turned_block(const typename F::template Shape<Scalar<N>>& shape, Scalar<N> cos_phi,
                                  Scalar<N> sin_phi, const DirectionBlock& d, double* __restrict out) {
  using S = Scalar<N>;
  for (std::size_t j = 0; j < d.rows; ++j) {
    const Vec3<S> wi{S(d.wi_x[j]), S(d.wi_y[j]), S(d.wi_z[j])}, wo{S(d.wo_x[j]), S(d.wo_y[j]), S(d.wo_z[j])};
    const Geometry<S> g = geometry(turn(wi, cos_phi, sin_phi), turn(wo, cos_phi, sin_phi));
    const auto lobes = F::lobes(shape, g);
    store(lobes, !(g.lowest.a < 0.0), out + j, std::make_index_sequence<lobe_count<F>>{});
  }
}

template <class F, int N>
auto seeded_shape(const LobeRequest& request) {
  typename F::template Shape<Scalar<N>> shape{};
  std::size_t k = 0;
  for (const auto& field : F::template Shape<Scalar<N>>::fields()) {
    shape.*(field.member) = seeded<N>(request.shape[k], request.partial.empty() ? -1 : request.partial[k]);
    ++k;
  }
  return shape;
}

template <class F, int N>
void run(const LobeRequest& request, const DirectionBlock& d, double* out) {
  shape_block<F, N>(seeded_shape<F, N>(request), std::cos(request.tangent_phi), std::sin(request.tangent_phi),
                    d, out);
}
template <class F, int N>
void run_turned(const LobeRequest& request, const DirectionBlock& d, double* out) {
  const double c = std::cos(request.tangent_phi), s = std::sin(request.tangent_phi);
  Scalar<N> cosine(c), sine(s);
  cosine.v.d[request.tangent_partial] = -s;
  sine.v.d[request.tangent_partial] = c;
  turned_block<F, N>(seeded_shape<F, N>(request), cosine, sine, d, out);
}

using Runner = void (*)(const LobeRequest&, const DirectionBlock&, double*);
struct Runners {
  std::size_t lobes = 0;
  std::array<Runner, kMaxPartials + 1> shape{};  // by number of derivatives
  Runner turned = nullptr;                       // all shape parameters and the tangent
  std::size_t turned_partials = 0;
};

template <class F>
constexpr Runners runners_of() {
  Runners r;
  if constexpr (LinearForm<F>) {
    constexpr int n = int(parameter_count<typename F::template Shape<double>>);
    static_assert(n < int(kMaxPartials) && lobe_count<F> <= kMaxLobes);
    r.lobes = lobe_count<F>;
    [&]<int... k>(std::integer_sequence<int, k...>) {
      ((r.shape[k] = &run<F, k>), ...);
    }(std::make_integer_sequence<int, n + 1>{});
    if constexpr (n > 1) {
      r.turned = &run_turned<F, n + 1>;
      r.turned_partials = n + 1;
    }
  }
  return r;
}

const std::array<Runners, kFormCount>& all_runners() {
  static const auto table = [] {
    std::array<Runners, kFormCount> t;
    std::size_t k = 0;
    for_each_form([&](auto form) { t[k++] = runners_of<decltype(form)>(); });
    return t;
  }();
  return table;
}

}  // namespace

std::size_t lobe_count_of(const AnyForm& form) {
  return all_runners()[form.index()].lobes;
}

void evaluate_lobes(const AnyForm& form, const LobeRequest& request, const DirectionBlock& directions,
                    double* out) {
  const Runners& r = all_runners()[form.index()];
  if (request.tangent_partial < 0) {
    r.shape[request.partials](request, directions, out);
    return;
  }
  if (request.partials == r.turned_partials) {
    r.turned(request, directions, out);
    return;
  }
  // Some parameters are fixed or tied: evaluate all derivatives, keep those asked for.
  const std::size_t columns = (1 + r.turned_partials) * r.lobes;
  alignas(64) thread_local double all[(1 + kMaxPartials) * kMaxLobes * kBlock];
  r.turned(request, directions, all);
  const std::size_t kept = (1 + request.partials) * r.lobes;
  for (std::size_t k = 0; k < std::min(columns, kept) * kBlock; ++k) out[k] = all[k];
}

}  // namespace brdf::fit
