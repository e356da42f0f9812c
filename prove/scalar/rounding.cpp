#include "prove/scalar/rounding.h"

#include "brdf/forms.h"

namespace brdf::prove {

inline constexpr int kShards = 4;
template <int kShard>
std::vector<LobeRounding> rounding_of_shard(int place, Precision precision, std::span<const Bounds> box);
extern template std::vector<LobeRounding> rounding_of_shard<0>(int, Precision, std::span<const Bounds>);
extern template std::vector<LobeRounding> rounding_of_shard<1>(int, Precision, std::span<const Bounds>);
extern template std::vector<LobeRounding> rounding_of_shard<2>(int, Precision, std::span<const Bounds>);
extern template std::vector<LobeRounding> rounding_of_shard<3>(int, Precision, std::span<const Bounds>);

namespace {

constexpr std::size_t kDirections = 4;  // the last four variables

std::size_t weights_of(int place) {
  std::size_t count = 0;
  with_form(place, [&](auto form) {
    using F = decltype(form);
    if constexpr (LinearForm<F>) count = F::template Weights<double>::fields().size();
  });
  return count;
}

}  // namespace

Domain rounding_domain(int form) {
  Domain domain = domain_of(form);
  domain.variables.resize(domain.variables.size() - kDirections - weights_of(form));
  return domain;
}

std::vector<LobeRounding> rounding_within(int form, Precision precision, std::span<const Bounds> box) {
  static constexpr decltype(&rounding_of_shard<0>) kParts[kShards] = {
      rounding_of_shard<0>, rounding_of_shard<1>, rounding_of_shard<2>, rounding_of_shard<3>};
  return kParts[form % kShards](form, precision, box);
}

std::vector<LobeRounding> rounding_of(int form, Precision precision, std::span<const Bounds> box) {
  std::vector<Bounds> all(box.begin(), box.end());
  const Domain whole = domain_of(form);
  while (all.size() < whole.variables.size()) {
    const Variable& v = whole.variables[all.size()];
    all.push_back({v.low, v.high});
  }
  return rounding_within(form, precision, all);
}

}  // namespace brdf::prove
