// Evaluates materials over arrays of any shape and stride. This code uses addresses only, without pybind11.
#pragma once

#include <cstddef>
#include <vector>

#include "brdf/material.h"

namespace brdf::python {

constexpr double kUnitLength = 1e-4;  // tolerance of a unit vector's squared length

// Throws InputError for a direction that is not a unit vector. The message names the array and the position
// in it.
[[noreturn]] void refuse_direction(const char* name, std::size_t pair, double x, double y, double z);

// The memory layout of an array: bytes between neighbouring elements along each dimension, 0 for a broadcast
// dimension.
struct Strides {
  std::vector<std::ptrdiff_t> of_pair;  // one for each dimension of the pairs
  std::ptrdiff_t of_last = 0;           // along the last dimension: coordinates, or channels
};

template <class T>
struct PairArrays {
  std::vector<std::size_t> shape;  // of the pairs; empty: a single pair
  const char* wi;
  const char* wo;
  char* out;
  Strides wi_strides, wo_strides, out_strides;

  std::size_t count() const;
};

// Computes f_r in 1/sr of every pair and channel (with `cosine`, f_r cos_i), in blocks that stay in the
// cache; no array is copied as a whole. In double the results are bit-identical to brdf::eval; in float they
// are within the forms' stated accuracy. Throws InputError if a direction is not a unit vector (squared
// length within 1e-4 of 1); the message gives its position.
template <class T>
void evaluate(const Material& material, const PairArrays<T>& arrays, bool cosine);

extern template void evaluate<double>(const Material&, const PairArrays<double>&, bool);
extern template void evaluate<float>(const Material&, const PairArrays<float>&, bool);

}  // namespace brdf::python
