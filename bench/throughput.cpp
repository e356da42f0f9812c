#include "bench/throughput.h"

#include <cmath>

#include "brdf/clones.h"

// Compiled with the same settings as the batches.
namespace brdf::bench {

template <class T>
void Throughput<T>::divide(const T* a, const T* b, T* out) {
  repeat([=](std::size_t i) { out[i] = a[i] / b[i]; }, kThroughputCount);
}
template <class T>
void Throughput<T>::square_root(const T* a, T* out) {
  repeat([=](std::size_t i) { out[i] = std::sqrt(a[i]); }, kThroughputCount);
}
// Four independent chains per value, to hide the latency.
template <class T>
void Throughput<T>::fused_multiply_add(const T* a, T* out) {
  const auto chains = [=](std::size_t i) {
    const T x = a[i];
    T y0 = x, y1 = x + T(1), y2 = x + T(2), y3 = x + T(3);
    for (int k = 0; k < kFmaPerValue / 4; ++k) {
      y0 = y0 * x + T(0.5);
      y1 = y1 * x + T(0.25);
      y2 = y2 * x + T(0.125);
      y3 = y3 * x + T(0.0625);
    }
    out[i] = (y0 + y1) + (y2 + y3);
  };
  repeat(chains, kThroughputCount);
}

template struct Throughput<float>;
template struct Throughput<double>;

}  // namespace brdf::bench
