// A choice as a batched function: the same loop, vectorised alike, for the exact and the fast path.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace brdf::trade {

// What a kernel may read of one point: a row of at most nine numbers, whose meaning the question states.
inline constexpr std::size_t kInputs = 9;
template <class T>
using Row = std::array<T, kInputs>;

// Points as structure of arrays: columns[input][point].
template <class T>
using Columns = std::array<std::vector<T>, kInputs>;

// The same as a kernel reads it.
template <class T>
using Inputs = std::array<const T*, kInputs>;
template <class T>
Inputs<T> pointers(const Columns<T>& columns) {
  Inputs<T> in;
  for (std::size_t k = 0; k < kInputs; ++k) in[k] = columns[k].data();
  return in;
}

// Columns for timed runs, at the same places relative to each other and to cache lines in every run: where an
// allocator happens to put them changes the time of the fastest kernels by half. The output lies before the
// inputs and all a few lines apart (modulo 4096 bytes), so that no load waits for a store to another page.
template <class T>
class Slab {
 public:
  Slab(std::size_t columns, std::size_t count)
      : stride_((count * sizeof(T) + kLine - 1) / kLine * kLine + 5 * kLine),
        bytes_((columns + 1) * stride_ + kPage) {}
  Slab(const Slab&) = delete;
  Slab& operator=(const Slab&) = delete;
  T* output() { return at(0); }
  T* column(std::size_t k) { return at(k + 1); }
  const T* output() const { return at(0); }
  const T* column(std::size_t k) const { return at(k + 1); }

 private:
  static constexpr std::size_t kLine = 64, kPage = 4096;
  T* at(std::size_t k) const {
    void* begin = const_cast<std::byte*>(bytes_.data());
    std::size_t space = bytes_.size();
    return reinterpret_cast<T*>(static_cast<std::byte*>(std::align(kPage, 1, begin, space)) + k * stride_);
  }
  std::size_t stride_;
  std::vector<std::byte> bytes_;
};

// GCC's per-processor clones; clang has none that allow flattening and is correct, but slower, there, and the
// address sanitizer cannot resolve them.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define BRDF_TRADE_CLONES [[gnu::target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4"), gnu::flatten]]
#else
#define BRDF_TRADE_CLONES
#endif

// `kernel(row)` for every point. K is a small object: constants, or a view of a table.
template <class K, class T>
BRDF_TRADE_CLONES void evaluate(const K& kernel, const T* const* in, T* __restrict out, std::size_t count) {
  const T* const x0 = in[0];
  const T* const x1 = in[1];
  const T* const x2 = in[2];
  const T* const x3 = in[3];
  const T* const x4 = in[4];
  const T* const x5 = in[5];
  const T* const x6 = in[6];
  const T* const x7 = in[7];
  const T* const x8 = in[8];
  for (std::size_t k = 0; k < count; ++k)
    out[k] = kernel(Row<T>{x0[k], x1[k], x2[k], x3[k], x4[k], x5[k], x6[k], x7[k], x8[k]});
}

// A kernel in both precisions, type erased.
struct Kernel {
  std::function<void(const Inputs<double>&, std::span<double>)> in_double;
  std::function<void(const Inputs<float>&, std::span<float>)> in_float;
};

template <class K>
Kernel kernel(K k) {
  const auto shared = std::make_shared<const K>(std::move(k));
  return {[shared](const Inputs<double>& in, std::span<double> out) {
            evaluate(*shared, in.data(), out.data(), out.size());
          },
          [shared](const Inputs<float>& in, std::span<float> out) {
            evaluate(*shared, in.data(), out.data(), out.size());
          }};
}

// A function of one point that is too dear, or too branched, for a vectorised loop.
inline Kernel scalar_kernel(std::function<double(const Row<double>&)> f) {
  const auto shared = std::make_shared<const std::function<double(const Row<double>&)>>(std::move(f));
  const auto run = [shared](const auto& in, auto out) {
    for (std::size_t k = 0; k < out.size(); ++k) {
      Row<double> row;
      for (std::size_t c = 0; c < kInputs; ++c) row[c] = double(in[c][k]);
      using T = std::remove_cvref_t<decltype(out[k])>;
      out[k] = T((*shared)(row));
    }
  };
  return {run, run};
}

}  // namespace brdf::trade
