// Batches: one set of parameters, many directions, as fast as the machine allows.
//
// Structures of arrays through the same templates as the scalar code, compiled per family
// (libbrdf/batch/<family>.cpp) once for each generation of the CPU. The results equal the scalar template's
// bit for bit. Measured by bench_eval.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "brdf/material.h"

namespace brdf {

// `count` pairs of unit directions in the tangent frame: one array per coordinate.
template <class T>
struct Directions {
  const T *wi_x, *wi_y, *wi_z;
  const T *wo_x, *wo_y, *wo_z;
  std::size_t count;

  Vec3<T> wi(std::size_t i) const { return {wi_x[i], wi_y[i], wi_z[i]}; }
  Vec3<T> wo(std::size_t i) const { return {wo_x[i], wo_y[i], wo_z[i]}; }
  // `size` pairs from `first` on.
  Directions part(std::size_t first, std::size_t size) const {
    return {wi_x + first, wi_y + first, wi_z + first, wo_x + first, wo_y + first, wo_z + first, size};
  }
};

// Arrays that own directions.
template <class T>
class DirectionArrays {
 public:
  explicit DirectionArrays(std::size_t count) : values_(6 * count), count_(count) {}
  std::size_t size() const { return count_; }
  void set(std::size_t i, const Vec3<T>& wi, const Vec3<T>& wo) {
    const T coordinates[] = {wi.x, wi.y, wi.z, wo.x, wo.y, wo.z};
    for (std::size_t k = 0; k < 6; ++k) values_[k * count_ + i] = coordinates[k];
  }
  Directions<T> view() const {
    const T* p = values_.data();
    return {p, p + count_, p + 2 * count_, p + 3 * count_, p + 4 * count_, p + 5 * count_, count_};
  }

 private:
  std::vector<T> values_;
  std::size_t count_;
};

// Which partial derivatives a lobes batch takes: D of them.
enum class Partial {
  kNone,        // D = 0
  kShape,       // D = P, the shape parameters in table order
  kShapeAndPhi  // D = P + 1, then tangent_phi: the directions are given in the frame that turns
};

// Where a lobes batch writes: row k (1 + D) is lobe k, the D rows after it its derivatives. Row r starts at
// data + r * stride; stride is at least the number of directions.
template <class T>
struct LobeRows {
  T* data;
  std::size_t stride;
};

// The batches of one form with parameters in the order of its tables. Outputs may not overlap inputs.
template <class T>
struct BatchKernels {
  using Parameters = std::span<const T>;
  using Eval = void (*)(Parameters weights, Parameters first, Parameters shape, const Directions<T>&, T* out);
  using Lobes = void (*)(Parameters shape, const Directions<T>&, const LobeRows<T>& out);

  Eval eval = nullptr, eval_cos = nullptr;
  std::array<Lobes, 3> lobes{};  // by Partial; null where the form is not a LinearForm
};

template <class T>
const BatchKernels<T>& batch_kernels(const AnyForm& form);
template <>
const BatchKernels<float>& batch_kernels(const AnyForm& form);
template <>
const BatchKernels<double>& batch_kernels(const AnyForm& form);

// f_r of one channel in 1/sr for every pair of directions, without cosine; 0 below the horizon.
template <class T, Form F>
void eval_batch(F form, const typename F::template Weights<T>& w,
                const typename F::template Weights<T>& first, const typename F::template Shape<T>& shape,
                const Directions<T>& directions, T* out) {
  batch_kernels<T>(form).eval(to_values<T>(w), to_values<T>(first), to_values<T>(shape), directions, out);
}

// f_r cos_i.
template <class T, Form F>
void eval_cos_batch(F form, const typename F::template Weights<T>& w,
                    const typename F::template Weights<T>& first, const typename F::template Shape<T>& shape,
                    const Directions<T>& directions, T* out) {
  batch_kernels<T>(form).eval_cos(to_values<T>(w), to_values<T>(first), to_values<T>(shape), directions, out);
}

// The lobes and their derivatives; 0 below the horizon.
template <class T, LinearForm F>
void lobes_batch(F form, const typename F::template Shape<T>& shape, Partial partial,
                 const Directions<T>& directions, const LobeRows<T>& out) {
  batch_kernels<T>(form).lobes[std::size_t(partial)](to_values<T>(shape), directions, out);
}

// One channel of a material's term, directions in the surface's frame: its tangent_phi is applied.
void eval_batch(const Term& term, std::size_t channel, const Directions<double>& directions, double* out);
void eval_cos_batch(const Term& term, std::size_t channel, const Directions<double>& directions, double* out);

// Writes the directions as seen from a frame whose tangent is turned by phi radians.
void turn_batch(const Directions<double>& directions, double phi, DirectionArrays<double>& out);

}  // namespace brdf
