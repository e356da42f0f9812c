#include "bench/throughput.h"

#include <cmath>

namespace brdf::bench {
namespace {

// Compiled as the batches are: one clone per generation of the CPU (libbrdf/batch/family.h).
template <class Body>
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
[[gnu::target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4"), gnu::flatten]]
#endif
void repeat(const Body body) {
#if !defined(__clang__)
#pragma GCC ivdep
#endif
  for (int i = 0; i < kThroughputCount; ++i) body(i);
}

}  // namespace

template <class T>
void Throughput<T>::divide(const T* a, const T* b, T* out) {
  repeat([=](int i) { out[i] = a[i] / b[i]; });
}
template <class T>
void Throughput<T>::square_root(const T* a, T* out) {
  repeat([=](int i) { out[i] = std::sqrt(a[i]); });
}
// Four independent chains per value, so that latency does not limit.
template <class T>
void Throughput<T>::fused_multiply_add(const T* a, T* out) {
  repeat([=](int i) {
    const T x = a[i];
    T y0 = x, y1 = x + T(1), y2 = x + T(2), y3 = x + T(3);
    for (int k = 0; k < kFmaPerValue / 4; ++k) {
      y0 = y0 * x + T(0.5);
      y1 = y1 * x + T(0.25);
      y2 = y2 * x + T(0.125);
      y3 = y3 * x + T(0.0625);
    }
    out[i] = (y0 + y1) + (y2 + y3);
  });
}

template struct Throughput<float>;
template struct Throughput<double>;

}  // namespace brdf::bench
