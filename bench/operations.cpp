#include "bench/operations.h"

#include <functional>
#include <map>

#include "brdf/forms.h"
#include "brdf/trace.h"

namespace brdf::bench {
namespace {

void add(Operations& sum, const Operations& more) {
  sum.divides += more.divides;
  sum.roots += more.roots;
  sum.arithmetic += more.arithmetic;
}

using Calls = std::map<std::string, Operations, std::less<>>;

// Counts the operations needed to compute `root` from inputs with names that start with w (directions) or
// from x (a kernel's argument).
Operations count(const Trace& trace, int root, const Calls& calls) {
  Operations sum;
  std::map<int, bool> varies;
  const std::function<bool(int)> visit = [&](int id) -> bool {
    if (const auto known = varies.find(id); known != varies.end()) return known->second;
    const Trace::Node& node = trace[id];
    bool any = node.operands.empty() && !node.constant &&
               (node.code.starts_with("wi.") || node.code.starts_with("wo.") || node.code == "x");
    for (int operand : node.operands) any = visit(operand) || any;
    varies[id] = any;
    if (!any || node.operands.empty()) return any;
    if (node.code == "/")
      ++sum.divides;
    else if (node.code == "sqrt")
      ++sum.roots;
    else if (const auto call = calls.find(node.code); call != calls.end())
      add(sum, call->second);
    else if (node.type == Trace::Type::float_type &&
             (node.code == "+" || node.code == "-" || node.code == "*"))
      ++sum.arithmetic;
    return any;
  };
  visit(root);
  return sum;
}

// Counts the operations of a traced kernel. In double the polynomial is longer.
template <class Kernel>
Operations kernel_operations(Kernel kernel, std::size_t float_terms, std::size_t terms) {
  Trace trace;
  const Trace::Scope scope(trace);
  Operations sum = count(trace, kernel(Traced::input("x")).node(), {});
  sum.arithmetic += 2 * (int(terms) - int(float_terms));
  return sum;
}

Calls kernel_calls(bool double_precision) {
  using F = kernels::Precision<float>;
  using D = kernels::Precision<double>;
  const auto terms = [&](std::size_t in_float, std::size_t in_double) {
    return double_precision ? in_double : in_float;
  };
  Calls calls;
  calls["brdf_exp"] = kernel_operations([](Traced x) { return kernels::exp(x); }, F::exp.size(),
                                        terms(F::exp.size(), D::exp.size()));
  calls["brdf_log"] = kernel_operations([](Traced x) { return kernels::log(x); }, F::log.size(),
                                        terms(F::log.size(), D::log.size()));
  calls["brdf_log1p"] = kernel_operations([](Traced x) { return kernels::log1p(x, Traced::input("other")); },
                                          F::log.size(), terms(F::log.size(), D::log.size()));
  calls["brdf_erfcx"] = kernel_operations([](Traced x) { return kernels::erfcx(x); }, F::erfcx.size(),
                                          terms(F::erfcx.size(), D::erfcx.size()));
  calls["brdf_angle"] = kernel_operations([](Traced x) { return kernels::angle(x, Traced::input("other")); },
                                          F::atan.size(), terms(F::atan.size(), D::atan.size()));
  return calls;
}

template <class P>
P inputs() {
  P p{};
  for (const auto& field : P::fields()) p.*(field.member) = Traced::input(field.info.name);
  return p;
}

}  // namespace

Operations operations(const Reflectance& form, bool double_precision) {
  const Calls calls = kernel_calls(double_precision);
  Operations counted;
  with_form(catalogue_index(form), [&]<class F>(F f) {
    Trace trace;
    const Trace::Scope scope(trace);
    const auto vector = [](std::string v) {
      return Vec3<Traced>{Traced::input(v + ".x"), Traced::input(v + ".y"), Traced::input(v + ".z")};
    };
    const auto weights = inputs<typename F::template Weights<Traced>>();
    const Traced value = eval_cos(f, weights, weights, inputs<typename F::template Shape<Traced>>(),
                                  geometry(vector("wi"), vector("wo")));
    counted = count(trace, value.node(), calls);
  });
  return counted;
}

}  // namespace brdf::bench
