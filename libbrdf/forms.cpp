#include "brdf/forms.h"

#include <array>

namespace brdf {
namespace {

template <class P>
constexpr auto parameter_infos() {
  std::array<ParameterInfo, parameter_count<P>> infos{};
  std::size_t k = 0;
  for (const auto& field : P::fields()) infos[k++] = field.info;
  return infos;
}
template <class P>
constexpr auto kInfos = parameter_infos<P>();

template <Form F>
constexpr FormInfo kFormInfo{F::name,
                             F::family,
                             LinearForm<F>,
                             F::name == F::family,
                             kInfos<typename F::template Weights<double>>,
                             kInfos<typename F::template Shape<double>>,
                             F::violations};

int index_of(std::span<const ParameterInfo> table, std::string_view name) {
  for (std::size_t k = 0; k < table.size(); ++k)
    if (table[k].name == name) return int(k);
  return -1;
}

}  // namespace

int FormInfo::shape_index(std::string_view parameter) const {
  return index_of(shape, parameter);
}
int FormInfo::weight_index(std::string_view parameter) const {
  return index_of(weights, parameter);
}

const FormInfo& info(const AnyForm& form) {
  return std::visit([](auto f) -> const FormInfo& { return kFormInfo<decltype(f)>; }, form);
}

std::optional<AnyForm> find_form(std::string_view name) {
  std::optional<AnyForm> found;
  for_each_form([&](auto form) {
    if (form.name == name) found = form;
  });
  return found;
}

}  // namespace brdf
