#include "validate/numerics.h"

#include <charconv>
#include <cmath>

#include "brdf/material.h"
#include "validate/exact.h"
#include "validate/extremes.h"

namespace brdf::validate {
namespace {

constexpr double kBody = 1e-6, kFaint = 1e-12, kTail = 1e-30;  // of the lobe's peak

template <class To, class From>
std::vector<To> convert(const std::vector<From>& values) {
  return std::vector<To>(values.begin(), values.end());
}

template <class T>
T evaluate(const Reflectance& form, const std::vector<T>& weights, const std::vector<T>& shape,
           const Vec3<T>& wi, const Vec3<T>& wo, bool cosine) {
  const ParameterValues<T> p{weights, weights, shape};
  T f;
  if (cosine)
    form->eval_cos(p, one_pair(wi, wo), &f);
  else
    form->eval(p, one_pair(wi, wo), &f);
  return f;
}

// "kd=0 ks=1": as few digits as give the same T.
template <class T>
void append(std::string& text, std::span<const ParameterInfo> table, const std::vector<T>& values) {
  for (std::size_t k = 0; k < table.size(); ++k) {
    char digits[32];
    const char* end = std::to_chars(digits, digits + sizeof digits, values[k]).ptr;
    text += (text.empty() ? "" : " ") + std::string(table[k].name) + '=' +
            std::string(static_cast<const char*>(digits), end);
  }
}

// Measures one form in one scalar: the loops of the grid, from shapes down to single values.
template <class T>
class Measurement {
 public:
  Measurement(const Reflectance& form, const char* scalar) : form_(form), info_(info(form)) {
    row_.form = info_.name;
    row_.scalar = scalar;
    signed_ = row_.may_be_negative = info_.violates("non_negative");
  }

  NumericsRow run() {
    const ParameterGrid grid = extreme_parameters(form_);
    for (const auto& w : grid.weights) {
      weights_.push_back(convert<T>(w));
      exact_weights_.push_back(convert<Exact>(weights_.back()));
    }
    for (const auto& shape : grid.shapes) {
      shape_ = convert<T>(shape);
      const LobeWidth width = lobe_width(info_, shape);
      for (const Vec3<double>& wi : extreme_lights()) measure_light(wi, extreme_views(wi, width.x, width.y));
    }
    return row_;
  }

 private:
  struct View {
    Vec3<T> wo;
    std::vector<Exact> exact;  // per set of weights
  };

  void measure_light(const Vec3<double>& light, const std::vector<Vec3<double>>& directions) {
    const Vec3<T> wi = nearly_unit<T>(light);
    const std::vector<Exact> shape = convert<Exact>(shape_);
    std::vector<View> views;
    std::vector<Exact> peak(weights_.size(), Exact(0));
    for (const Vec3<double>& view : directions) {
      const Vec3<T> wo = view == light ? wi : nearly_unit<T>(view);
      views.push_back({wo, exact_eval(form_, exact_weights_, shape, exact_direction(wi), exact_direction(wo),
                                      kMinCosine<T>)});
      for (std::size_t k = 0; k < peak.size(); ++k)
        peak[k] = larger(peak[k], Exact(abs(views.back().exact[k])));
    }
    for (const View& view : views)
      for (std::size_t k = 0; k < weights_.size(); ++k) measure_value(wi, view, k, peak[k]);
  }

  void measure_value(const Vec3<T>& wi, const View& view, std::size_t set, const Exact& peak) {
    const T f = evaluate(form_, weights_[set], shape_, wi, view.wo, false);
    count(f);
    count(evaluate(form_, weights_[set], shape_, wi, view.wo, true));
    const Exact truth = view.exact[set];
    const Exact size = abs(truth);
    if (!std::isfinite(f) || size < Exact(kTail) * peak) return;
    const Exact scale = scale_of(wi, view, set, peak);
    const NumericsBudget budget = numerics_budget(row_.scalar);
    if (size < Exact(kFaint) * peak) {
      row_.tail_error =
          std::max(row_.tail_error, error_of(f, truth, scale, wi, view.wo, set, budget.tail_error));
    } else if (size < Exact(kBody) * peak) {
      row_.faint_error =
          std::max(row_.faint_error, error_of(f, truth, scale, wi, view.wo, set, budget.faint_error));
    } else if (const double error = error_of(f, truth, scale, wi, view.wo, set, budget.max_error);
               error > row_.max_error) {
      row_.max_error = error;
      row_.where = where(wi, view.wo, weights_[set]);
    }
  }

  // The error of f against the exact value `truth`, see NumericsRow.
  double error_of(T f, const Exact& truth, const Exact& scale, const Vec3<T>& wi, const Vec3<T>& wo,
                  std::size_t set, double budget) {
    const auto relative = [&](const Exact& a, const Exact& b) {
      return a == b ? 0.0 : double(Exact(abs(a - b) / scale));
    };
    const double error = relative(Exact(f), truth);
    const double noticeable = budget / 4;
    if (error < noticeable) return error;
    const auto as_it_stands = [](const Vec3<T>& w) {
      return Vec3<Exact>{Exact(w.x), Exact(w.y), Exact(w.z)};
    };
    const Exact stored = exact_eval(form_, {&exact_weights_[set], 1}, convert<Exact>(shape_),
                                    as_it_stands(wi), as_it_stands(wo), kMinCosine<T>)[0];
    if (relative(stored, truth) < noticeable) return error;
    ++row_.as_stored;
    return relative(Exact(f), stored);
  }

  void count(T f) {
    ++row_.count;
    row_.nan += std::isnan(f);
    row_.inf += std::isinf(f);
    row_.negative += f < 0;
  }

  // What the error is relative to; see NumericsRow.
  Exact scale_of(const Vec3<T>& wi, const View& view, std::size_t set, const Exact& peak) const {
    const Exact size = abs(view.exact[set]);
    if (signed_)  // a direct term that changes sign
      return size + (diffuse_ >= 0 ? exact_weights_[set][std::size_t(diffuse_)] / Exact(kPi) : peak);
    if (const int f0 = info_.weight_index(Role::f0); f0 >= 0 && weights_[set][std::size_t(f0)] == 0)
      return abs(view.exact[0]);  // the first set has f0 = 1
    const double mirror = double(wi.z) * double(view.wo.z) - double(wi.x) * double(view.wo.x) -
                          double(wi.y) * double(view.wo.y);
    return info_.kink == Kink::mirror_edge && mirror < 0.5 ? peak : size;
  }

  NumericsRow::Where where(const Vec3<T>& wi, const Vec3<T>& wo, const std::vector<T>& weights) const {
    std::string parameters;
    append(parameters, info_.weights, weights);
    append(parameters, info_.shape, shape_);
    return {parameters, {wi.x, wi.y, wi.z}, {wo.x, wo.y, wo.z}};
  }

  Reflectance form_;
  const ReflectanceInfo& info_;
  int diffuse_ = info_.weight_index(Role::diffuse);
  bool signed_ = false;
  std::vector<std::vector<T>> weights_;
  std::vector<std::vector<Exact>> exact_weights_;
  std::vector<T> shape_;
  NumericsRow row_;
};

}  // namespace

std::vector<NumericsRow> measure_numerics(const Reflectance& form) {
  if (catalogue_index(form) < 0) return {};
  return {Measurement<float>(form, "float").run(), Measurement<double>(form, "double").run()};
}

NumericsBudget numerics_budget(const std::string& scalar) {
  return scalar == "float" ? NumericsBudget{5e-6, 5e-6, 5e-5} : NumericsBudget{1e-14, 1e-14, 5e-14};
}

bool meets_budget(const NumericsRow& row) {
  const NumericsBudget budget = numerics_budget(row.scalar);
  return row.max_error <= budget.max_error && row.faint_error <= budget.faint_error &&
         row.tail_error <= budget.tail_error && row.nan == 0 && row.inf == 0 &&
         (row.negative == 0 || row.may_be_negative);
}

}  // namespace brdf::validate
