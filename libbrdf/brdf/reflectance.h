// One interface for everything that reflects: a form of the catalogue, a model of another program, a table.
//
// A reflectance has parameters (weights per channel, and a shape) and returns values for blocks of
// directions. Its info lists the optional features: lobes that are linear in the weights, derivatives,
// GLSL, a sampler, facts. Callers test for a feature, never for a concrete type. Dispatch happens once per
// call; pass blocks of directions.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/directions.h"
#include "brdf/facts.h"
#include "brdf/parameter.h"

namespace brdf {

// The weight of one lobe as a function of a channel's weights: one of them, unchanged or times f0 or 1 - f0.
struct LobeWeight {
  enum class Factor { one, f0, rest };
  std::size_t weight = 0;  // index into the table
  Factor factor = Factor::one;
};

// Returns the weight that f0 splits into lobes, -1 if f0 splits no weight, and -2 if it splits more than one.
constexpr int weight_of_f0(std::span<const LobeWeight> lobes) {
  int found = -1;
  for (const LobeWeight& lobe : lobes)
    if (lobe.factor != LobeWeight::Factor::one && found != int(lobe.weight))
      found = found == -1 ? int(lobe.weight) : -2;
  return found;
}

// Returns true if the weights can be computed from the weights of the lobes: each weight has a lobe, and
// f0, if there is one, splits the lobes of exactly one weight.
constexpr bool weights_follow_from_lobes(std::span<const LobeWeight> lobes,
                                         std::span<const ParameterInfo> weights) {
  std::size_t f0s = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    bool has[3] = {};
    for (const LobeWeight& lobe : lobes)
      if (lobe.weight == k) has[std::size_t(lobe.factor)] = true;
    const int kinds = has[0] + has[1] + has[2];
    if (weights[k].role == Role::f0)
      ++f0s;
    else if (kinds == 0 || (kinds == 1 && !has[std::size_t(LobeWeight::Factor::one)]))
      return false;
  }
  const int divided = weight_of_f0(lobes);
  return f0s == 0 ? divided == -1 : f0s == 1 && divided >= 0;
}

// Properties of a reflectance that are known without evaluating it.
struct ReflectanceInfo {
  std::string_view name;
  std::string_view family;
  bool canonical = false;                    // the main form of the family
  std::span<const ParameterInfo> weights{};  // per channel
  std::span<const ParameterInfo> shape{};
  std::span<const std::string> channels{};  // the only channels that have values; empty: any
  std::span<const Violation> violations{};
  std::span<const LobeWeight> lobes{};  // linear in the weights for a given shape; empty: not linear
  bool mixes_channels = false;          // a channel's value depends on the first channel's weights
  bool differentiable = false;          // has gradient()
  bool has_glsl = false;
  bool follows_lobe = false;  // sample() follows the lobe, not only the cosine
  Kink kink = Kink::unplaced;
  // True for code outside the catalogue. Integrals then assume nothing that only a few values suggest.
  bool outside = false;
  bool all_round = false;  // for such code: symmetry between the two halves of the azimuth is not assumed
  const Accuracy* accuracy = nullptr;  // null: not measured
  const FacetFacts* facets = nullptr;  // null: not based on a distribution of facets
  const MattBasis* basis = nullptr;    // null: the lobes are not a basis of both signs
  bool about_light = false;            // the lobe lies about the fixed direction, not about its mirror image
  std::span<const ClosedAlbedo> albedos{};

  bool fittable() const { return !lobes.empty(); }
  // Returns true if the reflectance has two widths or two exponents.
  bool anisotropic() const { return axes().across >= 0; }
  bool violates(std::string_view check) const;

  // Return the position in a table, or -1 if there is no such parameter.
  int shape_index(std::string_view parameter) const;
  int weight_index(std::string_view parameter) const;
  int shape_index(Role role) const;
  int weight_index(Role role) const;
  // The widths (or exponents) along and across the tangent: both are set, or neither.
  struct Axes {
    int along = -1, across = -1;
  };
  Axes axes() const;
  // Returns the common name of both axes, which is the common part of their names: "alpha" for alpha_x and
  // alpha_y.
  std::string_view tied_name() const;
};

// Returns the weights of the lobes of a reflectance, computed from the weights of a channel.
std::vector<double> linear_weights(const ReflectanceInfo& info, std::span<const double> weights);

// The parameters of one channel in the order of the tables. `first` are the weights of the first channel.
template <class T>
struct ParameterValues {
  std::span<const T> weights, first, shape;
  std::size_t channel = 0;
};

// The partial derivatives that a call for lobes computes. D is their number.
enum class Partial {
  none,          // D = 0
  shape,         // D = P, the shape parameters in table order
  shape_and_phi  // D = P + 1, with tangent_phi last: the directions are given in the frame that rotates
};

// Output rows for lobes. Row k (1 + D) holds lobe k, and the D rows after it hold its derivatives. Row r
// starts at data + r * stride. stride is at least the number of directions.
struct LobeRows {
  double* data;
  std::size_t stride;
};

// GLSL 4.50 of Vulkan, or GLSL ES 3.00 of WebGL 2. GLSL ES has no `precise`, and its compilers fold
// constants that are added and subtracted again. For GLSL ES the same formula is therefore written with
// roundEven and with integer exponents, which gives the same bits.
enum class GlslDialect { vulkan, es };

struct GlslOptions {
  bool precise = true;  // false only for the negative control of the shader proof
  GlslDialect dialect = GlslDialect::vulkan;

  bool marks_precise() const { return precise && dialect == GlslDialect::vulkan; }
};

// Interface that every reflectance implements. Directions are unit vectors in the tangent frame. Outputs
// may not overlap inputs.
class ReflectanceModel {
 public:
  virtual ~ReflectanceModel() = default;
  // Returns the info, which lives as long as the model.
  virtual const ReflectanceInfo& info() const = 0;

  // Compute f_r of one channel in 1/sr, without the cosine: 0 below the horizon, finite everywhere.
  // eval_cos computes f_r cos_i. The default implementations for float convert to double and back.
  virtual void eval(const ParameterValues<double>& p, const Directions<double>& d, double* out) const = 0;
  virtual void eval_cos(const ParameterValues<double>& p, const Directions<double>& d, double* out) const;
  virtual void eval(const ParameterValues<float>& p, const Directions<float>& d, float* out) const;
  virtual void eval_cos(const ParameterValues<float>& p, const Directions<float>& d, float* out) const;

  // Compute the lobes and their derivatives, 0 below the horizon. Valid only if info().lobes is not empty.
  virtual void lobes(std::span<const double> shape, Partial partial, const Directions<double>& d,
                     const LobeRows& out) const;

  // Row 0 receives f_r, the next rows its derivatives by the shape parameters, then by the weights. If
  // `first` is the same array as the weights, the derivatives by the weights include both. Valid only if
  // info().differentiable. The default adds up the derivatives of the lobes, which fits use; it is valid only
  // if info().lobes is not empty.
  virtual void gradient(const ParameterValues<double>& p, const Directions<double>& d,
                        const LobeRows& out) const;

  // Returns the weights computed from the weights of the lobes, each with its derivatives by them. Valid
  // only if info().lobes is not empty.
  struct TableWeight {
    double value;
    std::vector<double> by_lobe;
  };
  virtual std::vector<TableWeight> weights_of(std::span<const double> lobe_weights) const;

  // Draw a random direction roughly proportional to the values seen from wo, and return its density per
  // solid angle; see brdf/sampling.h. The default is cosine-weighted.
  virtual Vec3<double> sample(std::span<const double> shape, double u1, double u2, double u3,
                              const Vec3<double>& wo, double share = 0.5) const;
  virtual double pdf(std::span<const double> shape, const Vec3<double>& wi, const Vec3<double>& wo,
                     double share = 0.5) const;

  // Returns two GLSL functions for RGB materials, in the local frame with n = +z. Valid only if
  // info().has_glsl:
  //   vec3 brdf_eval_<name>(vec3 wi, vec3 wo, float <shape>..., vec3 <weight>...)      f_r, 1/sr
  //   vec3 brdf_eval_cos_<name>(...)                                                   f_r cos_i
  virtual std::string glsl(const GlslOptions& options = {}) const;
  // Returns the sampler with share 0.5 as two more functions (u: three numbers in [0, 1)), or an empty
  // string if there is no sampler in GLSL:
  //   vec3 brdf_sample_<name>(vec3 u, vec3 wo, float <shape>...)
  //   float brdf_pdf_<name>(vec3 wi, vec3 wo, float <shape>...)
  virtual std::string glsl_sampler(const GlslOptions& options = {}) const;
};

// Returns the model of a form's struct. The models of the catalogue are compiled into the library; include
// brdf/reflectance_of.h for forms of your own.
template <class F>
const ReflectanceModel& reflectance_of();

// A reflectance as a value. It is never empty and cheap to copy. Two values are equal if they share the
// model.
class Reflectance {
 public:
  // Constructs the reflectance of a form, from its struct.
  template <class F>
    requires requires { F::name, F::family; }
  Reflectance(F) : Reflectance(reflectance_of<F>()) {}
  // Construct a reflectance from a model that outlives every copy, or that is shared with the copies.
  explicit Reflectance(const ReflectanceModel& model) : model_(std::shared_ptr<void>(), &model) {}
  explicit Reflectance(std::shared_ptr<const ReflectanceModel> model) : model_(std::move(model)) {}

  const ReflectanceInfo& info() const { return model_->info(); }
  const ReflectanceModel* operator->() const { return model_.get(); }
  const ReflectanceModel& operator*() const { return *model_; }
  friend bool operator==(const Reflectance&, const Reflectance&) = default;

 private:
  std::shared_ptr<const ReflectanceModel> model_;
};

inline const ReflectanceInfo& info(const Reflectance& reflectance) {
  return reflectance.info();
}

// Returns the forms of the catalogue (brdf/forms.h), in its order.
// Example:
//     for (const brdf::Reflectance& form : brdf::catalogue()) {
//       std::printf("%s:", std::string(info(form).name).c_str());
//       for (const brdf::ParameterInfo& parameter : info(form).shape)
//         std::printf(" %s", std::string(parameter.name).c_str());
//       std::printf("\n");
//     }
std::span<const Reflectance> catalogue();
// Returns the forms in their order, one group per family.
std::vector<std::vector<Reflectance>> families(std::span<const Reflectance> forms = catalogue());
// Returns the form of the catalogue or the target (brdf/targets.h) with this name, or std::nullopt.
std::optional<Reflectance> find_form(std::string_view name);
// Returns the first form of the catalogue with an info that satisfies the predicate, or std::nullopt.
template <class Is>
std::optional<Reflectance> find_form_if(Is&& is) {
  for (const Reflectance& form : catalogue())
    if (is(form.info())) return form;
  return std::nullopt;
}
// Returns the position in the catalogue, or -1 if the reflectance is not in the catalogue.
int catalogue_index(const Reflectance& reflectance);

}  // namespace brdf
