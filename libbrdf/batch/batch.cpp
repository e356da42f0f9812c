#include "brdf/batch.h"

#include <cmath>

#include "batch/batch_table.h"

namespace brdf {
namespace {

template <class T>
const BatchKernels<T>& find_kernels(const AnyForm& form) {
  return std::visit(
      []<class F>(F f) -> const BatchKernels<T>& {
        static const BatchTable<T> table = family_batches<FamilyName(F::family), T>();
        return table[AnyForm(f).index()];
      },
      form);
}

// Calls the term's kernel on blocks that stay in the cache, turned into its tangent frame where it has one.
void eval_term(BatchKernels<double>::Eval kernel, const Term& term, std::size_t channel,
               const Directions<double>& directions, double* out) {
  const auto call = [&](const Directions<double>& block, double* block_out) {
    kernel(term.weights[channel], term.weights[0], term.shape_of(channel), block, block_out);
  };
  if (term.tangent_phi == 0) return call(directions, out);
  constexpr std::size_t kBlock = 512;
  DirectionArrays<double> turned(std::min(kBlock, directions.count));
  for (std::size_t first = 0; first < directions.count; first += kBlock) {
    const Directions<double> block = directions.part(first, std::min(kBlock, directions.count - first));
    turn_batch(block, term.tangent_phi, turned);
    call(turned.view().part(0, block.count), out + first);
  }
}

}  // namespace

template <>
const BatchKernels<float>& batch_kernels(const AnyForm& form) {
  return find_kernels<float>(form);
}
template <>
const BatchKernels<double>& batch_kernels(const AnyForm& form) {
  return find_kernels<double>(form);
}

void eval_batch(const Term& term, std::size_t channel, const Directions<double>& directions, double* out) {
  eval_term(batch_kernels<double>(term.form).eval, term, channel, directions, out);
}
void eval_cos_batch(const Term& term, std::size_t channel, const Directions<double>& directions,
                    double* out) {
  eval_term(batch_kernels<double>(term.form).eval_cos, term, channel, directions, out);
}

void turn_batch(const Directions<double>& directions, double phi, DirectionArrays<double>& out) {
  const double c = std::cos(phi), s = std::sin(phi);
  for (std::size_t i = 0; i < directions.count; ++i)
    out.set(i, turn(directions.wi(i), c, s), turn(directions.wo(i), c, s));
}

}  // namespace brdf
