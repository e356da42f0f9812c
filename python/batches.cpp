#include "python/batches.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "brdf/clones.h"
#include "io/files/error.h"
#include "io/files/numbers.h"

namespace brdf::python {
namespace {

constexpr std::size_t kBlock = 512;  // pairs; their coordinates and values stay in the first-level cache

// A position in arrays of the same shape, advanced in C order.
class Walk {
 public:
  explicit Walk(const std::vector<std::size_t>& shape) : shape_(shape), at_(shape.size(), 0) {}

  // Calls visit(k, n) for the next `count` pairs, in runs k to k + n - 1 along the innermost dimension.
  template <class Visit>
  void next(std::size_t count, Visit&& visit) {
    for (std::size_t k = 0; k < count;) {
      const std::size_t left = at_.empty() ? 1 : shape_.back() - at_.back();
      const std::size_t n = std::min(left, count - k);
      visit(k, n);
      advance(n);
      k += n;
    }
  }
  std::ptrdiff_t offset(const Strides& strides) const {
    std::ptrdiff_t bytes = 0;
    for (std::size_t d = 0; d < at_.size(); ++d) bytes += std::ptrdiff_t(at_[d]) * strides.of_pair[d];
    return bytes;
  }

 private:
  void advance(std::size_t pairs) {
    if (at_.empty()) return;
    at_.back() += pairs;
    for (std::size_t d = at_.size() - 1; d > 0 && at_[d] == shape_[d]; --d) {
      at_[d] = 0;
      ++at_[d - 1];
    }
  }

  std::vector<std::size_t> shape_;
  std::vector<std::size_t> at_;
};

std::ptrdiff_t step(const Strides& strides) {
  return strides.of_pair.empty() ? 0 : strides.of_pair.back();
}

template <class T>
T load(const char* at) {
  return *reinterpret_cast<const T*>(at);
}

// Coordinates of one block, one array for each coordinate.
template <class T>
struct Block {
  T coordinates[6][kBlock];
  T values[kBlock], sum[kBlock];

  Directions<T> view(std::size_t count) const {
    return {coordinates[0], coordinates[1], coordinates[2], coordinates[3],
            coordinates[4], coordinates[5], count};
  }
};

}  // namespace

// Reads `count` directions into three arrays. The source has numpy's default layout or any strides.
template <class T>
BRDF_CLONES void gather(const char* from, std::ptrdiff_t step, std::ptrdiff_t last, std::size_t count,
                        T* __restrict x, T* __restrict y, T* __restrict z) {
  constexpr std::ptrdiff_t kSize = sizeof(T);
  if (step == 3 * kSize && last == kSize) {
    const T* __restrict const at = reinterpret_cast<const T*>(from);
    for (std::size_t k = 0; k < count; ++k) {
      x[k] = at[3 * k];
      y[k] = at[3 * k + 1];
      z[k] = at[3 * k + 2];
    }
    return;
  }
  for (std::size_t k = 0; k < count; ++k, from += step) {
    x[k] = load<T>(from);
    y[k] = load<T>(from + last);
    z[k] = load<T>(from + 2 * last);
  }
}

// Returns true if all vectors are unit vectors. A vector with NaN is not a unit vector.
template <class T>
BRDF_CLONES bool are_unit(std::size_t count, const T* x, const T* y, const T* z) {
  std::uint32_t good = 0;
  for (std::size_t k = 0; k < count; ++k)
    good += std::abs(x[k] * x[k] + y[k] * y[k] + z[k] * z[k] - 1) <= T(kUnitLength);
  return good == count;
}

namespace {

template <class T>
[[noreturn]] void refuse(const char* name, const T* x, const T* y, const T* z, std::size_t first,
                         std::size_t count) {
  std::size_t k = 0;
  while (k + 1 < count && are_unit(1, x + k, y + k, z + k)) ++k;
  refuse_direction(name, first + k, x[k], y[k], z[k]);
}

template <class T>
void scatter(const T* values, std::size_t count, char* to, std::ptrdiff_t step) {
  if (step == sizeof(T)) return (void)std::copy_n(values, count, reinterpret_cast<T*>(to));
  for (std::size_t k = 0; k < count; ++k) *reinterpret_cast<T*>(to + std::ptrdiff_t(k) * step) = values[k];
}

// Reads the directions of the next `count` pairs.
template <class T>
void read_block(const PairArrays<T>& arrays, Walk& walk, std::size_t first, std::size_t count,
                Block<T>& block) {
  walk.next(count, [&](std::size_t k, std::size_t n) {
    const auto read = [&](const char* name, const char* data, const Strides& strides,
                          std::size_t coordinate) {
      T* const x = block.coordinates[coordinate] + k;
      T* const y = block.coordinates[coordinate + 1] + k;
      T* const z = block.coordinates[coordinate + 2] + k;
      gather(data + walk.offset(strides), step(strides), strides.of_last, n, x, y, z);
      if (!are_unit(n, x, y, z)) refuse(name, x, y, z, first + k, n);
    };
    read("wi", arrays.wi, arrays.wi_strides, 0);
    read("wo", arrays.wo, arrays.wo_strides, 3);
  });
}

// Computes one channel of a block: the sum over the terms, starting at 0 as brdf::eval does.
template <class T>
const T* sum_of_terms(const Material& material, std::size_t channel, Block<T>& block, std::size_t count,
                      bool cosine) {
  std::fill_n(block.sum, count, T(0));
  for (const Term& term : material.terms) {
    if (cosine)
      eval_cos_batch(term, channel, block.view(count), block.values);
    else
      eval_batch(term, channel, block.view(count), block.values);
    for (std::size_t k = 0; k < count; ++k) block.sum[k] += block.values[k];
  }
  return block.sum;
}

}  // namespace

void refuse_direction(const char* name, std::size_t pair, double x, double y, double z) {
  throw InputError(std::string(name) + ": pair " + std::to_string(pair) + ": length " +
                   io::short_number(std::sqrt(x * x + y * y + z * z)) +
                   ": must be a unit vector (brdf.directions makes them of angles)");
}

template <class T>
std::size_t PairArrays<T>::count() const {
  std::size_t all = 1;
  for (const std::size_t n : shape) all *= n;
  return all;
}

template <class T>
void evaluate(const Material& material, const PairArrays<T>& arrays, bool cosine) {
  const std::size_t all = arrays.count();
  Block<T> block;
  Walk walk(arrays.shape);
  for (std::size_t first = 0; first < all; first += kBlock) {
    const std::size_t count = std::min(kBlock, all - first);
    const Walk begin = walk;
    read_block(arrays, walk, first, count, block);
    for (std::size_t channel = 0; channel < material.channels.size(); ++channel) {
      const T* const values = sum_of_terms(material, channel, block, count, cosine);
      char* const out = arrays.out + std::ptrdiff_t(channel) * arrays.out_strides.of_last;
      Walk writing = begin;
      writing.next(count, [&](std::size_t k, std::size_t n) {
        scatter(values + k, n, out + writing.offset(arrays.out_strides), step(arrays.out_strides));
      });
    }
  }
}

template void evaluate<double>(const Material&, const PairArrays<double>&, bool);
template void evaluate<float>(const Material&, const PairArrays<float>&, bool);

}  // namespace brdf::python
