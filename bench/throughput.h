// The limits of the machine: its rate of divisions, roots, and multiply-adds with its widest vectors.
#pragma once

namespace brdf::bench {

// One pass over kThroughputCount values, which stay in the first-level cache.
inline constexpr int kThroughputCount = 1024;
inline constexpr int kFmaPerValue = 32;
template <class T>
struct Throughput {
  static void divide(const T* a, const T* b, T* out);
  static void square_root(const T* a, T* out);
  static void fused_multiply_add(const T* a, T* out);  // kFmaPerValue for each value
};
extern template struct Throughput<float>;
extern template struct Throughput<double>;

}  // namespace brdf::bench
