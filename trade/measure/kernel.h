// A choice as a batched function. The exact and the fast method use the same loop and are vectorised alike.
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "brdf/clones.h"
#include "trade/measure/rows.h"

namespace brdf::trade {

// Columns as read by a kernel.
template <class T>
using Inputs = std::vector<const T*>;
template <class T>
Inputs<T> pointers(const Columns<T>& columns) {
  Inputs<T> in;
  for (const std::vector<T>& column : columns) in.push_back(column.data());
  return in;
}

// Columns for timed runs, at the same addresses relative to each other and to cache lines in every run: the
// placement by an allocator changes the time of the fastest kernels by half. The output lies before the
// inputs, and all columns are a few cache lines apart (modulo 4096 bytes), which keeps loads from waiting
// for a store to another page.
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

// A kernel in both precisions, type erased.
struct Kernel {
  std::function<void(const Inputs<double>&, std::span<double>)> in_double;
  std::function<void(const Inputs<float>&, std::span<float>)> in_float;
  explicit operator bool() const { return bool(in_double); }
};

// The kind of row that a function reads.
template <template <class> class R>
struct RowKind {};
template <class K, template <class> class R>
concept Reads = std::invocable<const K&, const R<double>&>;
template <class K>
constexpr auto row_of() {
  if constexpr (Reads<K, DirectionRow>)
    return RowKind<DirectionRow>{};
  else if constexpr (Reads<K, CosineRow>)
    return RowKind<CosineRow>{};
  else if constexpr (Reads<K, FresnelRow>)
    return RowKind<FresnelRow>{};
  else if constexpr (Reads<K, AngleRow>)
    return RowKind<AngleRow>{};
  else
    return RowKind<ArgumentRow>{};
}

namespace detail {

// Returns the columns of a kind of row.
template <template <class> class R, class T>
std::array<const T*, kFields<R>> columns_of(const Inputs<T>& in) {
  if (in.size() != kFields<R>) throw std::logic_error("a kernel was given the points of another question");
  std::array<const T*, kFields<R>> columns{};
  std::copy(in.begin(), in.end(), columns.begin());
  return columns;
}

template <bool kTimed, class K, template <class> class R>
Kernel batched(K kernel, RowKind<R>) {
  const auto run = [kernel]<class T>(const Inputs<T>& in, std::span<T> out) {
    const auto body = [kernel, columns = columns_of<R, T>(in), to = out.data()](std::size_t i) {
      to[i] = kernel(row_from<R, T>([&](std::size_t k) { return columns[k][i]; }));
    };
    if constexpr (kTimed)
      repeat(body, out.size());
    else
      for (std::size_t i = 0; i < out.size(); ++i) body(i);
  };
  return {run, run};
}

template <class F, template <class> class R>
Kernel point_by_point(F f, RowKind<R>) {
  const auto run = [f]<class T>(const Inputs<T>& in, std::span<T> out) {
    const auto columns = columns_of<R, T>(in);
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = T(f(row_from<R, double>([&](std::size_t k) { return double(columns[k][i]); })));
  };
  return {run, run};
}

}  // namespace detail

// Returns a kernel that evaluates `k(row)` for every point, in the loop that the library's batches use. K
// must be a small object: constants, or a view of a table.
template <class K>
Kernel kernel(K k) {
  return detail::batched<true>(std::move(k), row_of<K>());
}

// Returns a kernel with the same values from a loop that is not timed (for pictures). The loop is not
// compiled separately for each kind of CPU.
template <class K>
Kernel untimed_kernel(K k) {
  return detail::batched<false>(std::move(k), row_of<K>());
}

// Returns a kernel of directions with a fixed width and f0 in place of the row's values. This avoids
// compiling the kernel once more.
inline Kernel fixed_at(const Kernel& kernel, double width, double f0 = 0) {
  const auto fixed = [=]<class T>(const auto& run) {
    return [=](Inputs<T> in, std::span<T> out) {
      const std::vector<T> widths(out.size(), T(width)), reflectances(out.size(), T(f0));
      in.at(offsetof(DirectionRow<double>, width) / sizeof(double)) = widths.data();
      in.at(offsetof(DirectionRow<double>, f0) / sizeof(double)) = reflectances.data();
      run(in, out);
    };
  };
  return {fixed.template operator()<double>(kernel.in_double),
          fixed.template operator()<float>(kernel.in_float)};
}

// Returns a kernel of a function of one row in double that is too expensive, or has too many branches, for a
// vectorised loop.
template <class F>
Kernel scalar_kernel(F f) {
  return detail::point_by_point(std::move(f), row_of<F>());
}

}  // namespace brdf::trade
