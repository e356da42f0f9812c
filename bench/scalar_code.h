// The scalar code with which the batches are compared.
#pragma once

#include "brdf/reflectance.h"

namespace brdf::bench {

// Computes f_r cos_i of one channel for each pair of directions. Parameters are in table order.
template <class T>
using Scalar = void (*)(std::span<const T> weights, std::span<const T> shape, const Directions<T>&, T* out);

// Returns the library's template, with one call of brdf::eval_cos per pair.
template <class T>
Scalar<T> scalar_template(const Reflectance& form);

// Returns code as written from a textbook: world space, normalised half vector, pow, acos. Null for other
// forms.
template <class T>
Scalar<T> textbook(const Reflectance& form);

// The project's goals for the batches of a form that textbooks cover; 0: no goal.
struct Goals {
  double of_limit_in_double = 0, of_limit_in_float = 0;  // fraction of the machine's limit
  double float_over_double = 2;                          // 0: bound by memory, no goal
};
Goals goals_of(const Reflectance& form);

}  // namespace brdf::bench
