// Materials over arrays of any shape and stride: no pybind11 here, only addresses.
#pragma once

#include <cstddef>
#include <vector>

#include "brdf/material.h"

namespace brdf::python {

constexpr double kUnitLength = 1e-4;  // by which a unit vector's squared length may be off

// Throws InputError on a direction that is no unit vector, by its array's name and its place in it.
[[noreturn]] void refuse_direction(const char* name, std::size_t pair, double x, double y, double z);

// Where the elements of an array lie: bytes from one to the next along each dimension, 0 where it is
// broadcast.
struct Strides {
  std::vector<std::ptrdiff_t> of_pair;  // one for each dimension of the pairs
  std::ptrdiff_t of_last = 0;           // along the last dimension: coordinates, or channels
};

template <class T>
struct PairArrays {
  std::vector<std::size_t> shape;  // of the pairs; empty: a single one
  const char* wi;
  const char* wo;
  char* out;
  Strides wi_strides, wo_strides, out_strides;

  std::size_t count() const;
};

// f_r in 1/sr of every pair and channel (cosine: f_r cos_i), in blocks that stay in the cache; no array is
// copied as a whole. The same bits as brdf::eval in double, within the forms' stated accuracy in float.
// Throws InputError where a direction is no unit vector (within 1e-4), by its place.
template <class T>
void evaluate(const Material& material, const PairArrays<T>& arrays, bool cosine);

extern template void evaluate<double>(const Material&, const PairArrays<double>&, bool);
extern template void evaluate<float>(const Material&, const PairArrays<float>&, bool);

}  // namespace brdf::python
