// For tests that need the structs of forms: the struct of a reflectance, and its parameters as structs.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "brdf/forms.h"
#include "brdf/material.h"

namespace brdf {

namespace detail {
template <class Variant>
struct TypesOf;
template <class... Form>
struct TypesOf<std::variant<Form...>> {
  using type = ::testing::Types<Form...>;
};
}  // namespace detail

// For typed tests over the whole catalogue: TYPED_TEST_SUITE(Suite, CatalogueTypes, FormName).
using CatalogueTypes = detail::TypesOf<AnyForm>::type;
struct FormName {
  template <class Form>
  static std::string GetName(int) {
    return std::string(Form::name);
  }
};

// Calls f(form) with the struct of a form of the catalogue. All calls must return values of the same type.
template <class F>
auto visit_form(const Reflectance& form, F&& f) {
  std::optional<decltype(f(lambert{}))> result;
  with_form(catalogue_index(form), [&](auto typed) { result = f(typed); });
  return *result;
}

template <Form F>
typename F::template Shape<double> typed_shape(F, const Term& term, std::size_t channel) {
  return from_values<typename F::template Shape<double>>(term.shape_of(channel));
}
template <Form F>
typename F::template Weights<double> typed_weights(F, const Term& term, std::size_t channel) {
  return from_values<typename F::template Weights<double>>(std::span<const double>(term.weights[channel]));
}

}  // namespace brdf
