// Everything that reflects, asked through one interface: a
// form of the catalogue, another program's model, a table.
//
// A reflectance has parameters (weights per channel, and a shape) and gives values for rows of directions.
// What else it has (lobes that are linear in the weights, derivatives, GLSL, a sampler, facts) it says in its
// info. Nobody who uses one asks what it is. Dispatch happens once per call: hand over blocks of directions.
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

// How the weight of one lobe follows from a channel's
// weights: one of them, as it stands or times f0 or 1 - f0.
struct LobeWeight {
  enum class Factor { one, f0, rest };
  std::size_t weight = 0;  // index into the table
  Factor factor = Factor::one;
};

// The weight whose lobes f0 divides; -1 where none is divided, -2 where more than one is.
constexpr int weight_of_f0(std::span<const LobeWeight> lobes) {
  int found = -1;
  for (const LobeWeight& lobe : lobes)
    if (lobe.factor != LobeWeight::Factor::one && found != int(lobe.weight))
      found = found == -1 ? int(lobe.weight) : -2;
  return found;
}

// Whether the weights can be told from the lobes' weights: each has a lobe, and where there is an f0, it
// divides the lobes of one weight and of no other.
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

// What can be said of a reflectance without evaluating it.
struct ReflectanceInfo {
  std::string_view name;
  std::string_view family;
  bool canonical = false;                    // the family's own form
  std::span<const ParameterInfo> weights{};  // per channel
  std::span<const ParameterInfo> shape{};
  std::span<const std::string> channels{};  // the only ones it has values for; empty: any
  std::span<const Violation> violations{};
  std::span<const LobeWeight> lobes{};  // linear in the weights given the shape; empty: it is not
  bool mixes_channels = false;          // a channel's value depends on the first channel's weights
  bool differentiable = false;          // has gradient()
  bool has_glsl = false;
  bool follows_lobe = false;  // sample() does more than the cosine
  Kink kink = Kink::unplaced;
  // Of code that is not in the catalogue: integrals take nothing for granted that a few values suggest.
  bool outside = false;
  bool all_round = false;              // of such code: half of the azimuths is not known to stand for all
  const Accuracy* accuracy = nullptr;  // null: not measured
  const FacetFacts* facets = nullptr;  // null: it stands for no distribution of facets
  std::span<const ClosedAlbedo> albedos{};

  bool fittable() const { return !lobes.empty(); }
  // Whether it has two widths or two exponents.
  bool anisotropic() const { return axes().across >= 0; }
  bool violates(std::string_view check) const;

  // Positions in the tables, -1 where there is no such parameter.
  int shape_index(std::string_view parameter) const;
  int weight_index(std::string_view parameter) const;
  int shape_index(Role role) const;
  int weight_index(Role role) const;
  // The widths (or exponents) along and across the tangent: both, or neither.
  struct Axes {
    int along = -1, across = -1;
  };
  Axes axes() const;
  // What both axes are called together: the common part of their names, "alpha" of alpha_x and alpha_y.
  std::string_view tied_name() const;
};

// The weights of a reflectance's lobes, from a channel's weights.
std::vector<double> linear_weights(const ReflectanceInfo& info, std::span<const double> weights);

// One channel's parameters in the order of the tables. `first` are the first channel's weights.
template <class T>
struct ParameterValues {
  std::span<const T> weights, first, shape;
  std::size_t channel = 0;
};

// Which partial derivatives a call for lobes takes: D of them.
enum class Partial {
  none,          // D = 0
  shape,         // D = P, the shape parameters in table order
  shape_and_phi  // D = P + 1, then tangent_phi: the directions are given in the frame that turns
};

// Where lobes are written: row k (1 + D) is lobe k, the D rows after it its derivatives. Row r starts at
// data + r * stride; stride is at least the number of directions.
template <class T>
struct LobeRows {
  T* data;
  std::size_t stride;
};

// Vulkan's GLSL 4.50, or GLSL ES 3.00 as WebGL 2 has it. The latter knows no `precise`, and its compilers
// fold constants that are added and subtracted; the same formula is therefore written with roundEven and
// exponents as integers, which give the same bits.
enum class GlslDialect { vulkan, es };

struct GlslOptions {
  bool precise = true;  // false only for the negative control of the shader's proof
  GlslDialect dialect = GlslDialect::vulkan;

  bool marks_precise() const { return precise && dialect == GlslDialect::vulkan; }
};

// To be implemented by what reflects. Directions are unit
// vectors in the tangent frame. Outputs may not overlap inputs.
class ReflectanceModel {
 public:
  virtual ~ReflectanceModel() = default;
  // Lives as long as the model.
  virtual const ReflectanceInfo& info() const = 0;

  // f_r of one channel in 1/sr, without cosine; 0 below the horizon, finite everywhere. eval_cos: f_r cos_i.
  // In float: by the double ones, unless there is something better.
  virtual void eval(const ParameterValues<double>& p, const Directions<double>& d, double* out) const = 0;
  virtual void eval_cos(const ParameterValues<double>& p, const Directions<double>& d, double* out) const;
  virtual void eval(const ParameterValues<float>& p, const Directions<float>& d, float* out) const;
  virtual void eval_cos(const ParameterValues<float>& p, const Directions<float>& d, float* out) const;

  // The lobes and their derivatives, 0 below the horizon; only where info().lobes says so.
  virtual void lobes(std::span<const double> shape, Partial partial, const Directions<double>& d,
                     const LobeRows<double>& out) const;
  virtual void lobes(std::span<const float> shape, Partial partial, const Directions<float>& d,
                     const LobeRows<float>& out) const;

  // Row 0: f_r; then its derivatives by the shape's parameters, then by the weights (where `first` are the
  // same weights, by both). Only where info().differentiable says so.
  virtual void gradient(const ParameterValues<double>& p, const Directions<double>& d,
                        const LobeRows<double>& out) const;

  // Weights from the lobes' weights, each with its derivatives by those. Only where info().lobes says so.
  struct TableWeight {
    double value;
    std::vector<double> by_lobe;
  };
  virtual std::vector<TableWeight> weights_of(std::span<const double> lobe_weights) const;

  // A random direction in proportion to the values seen from wo, and its density per solid angle; see
  // brdf/sampling.h. Without more knowledge: the cosine.
  virtual Vec3<double> sample(std::span<const double> shape, double u1, double u2, double u3,
                              const Vec3<double>& wo, double share = 0.5) const;
  virtual double pdf(std::span<const double> shape, const Vec3<double>& wi, const Vec3<double>& wo,
                     double share = 0.5) const;

  // Two functions for RGB materials, in the local frame with n = +z; only where info().has_glsl says so:
  //   vec3 brdf_eval_<name>(vec3 wi, vec3 wo, float <shape>..., vec3 <weight>...)      f_r, 1/sr
  //   vec3 brdf_eval_cos_<name>(...)                                                   f_r cos_i
  virtual std::string glsl(const GlslOptions& options = {}) const;
  // The sampler, of share 0.5, as two functions beside those (u: three numbers in [0, 1)); empty where it is
  // not written in GLSL:
  //   vec3 brdf_sample_<name>(vec3 u, vec3 wo, float <shape>...)
  //   float brdf_pdf_<name>(vec3 wi, vec3 wo, float <shape>...)
  virtual std::string glsl_sampler(const GlslOptions& options = {}) const;
};

// The model of a form's struct. Those of the catalogue are compiled into the library; for one's own include
// brdf/reflectance_of.h.
template <class F>
const ReflectanceModel& reflectance_of();

// A reflectance as a value: never empty, cheap to copy, the same only as itself.
class Reflectance {
 public:
  // A form, by its struct.
  template <class F>
    requires requires { F::name, F::family; }
  Reflectance(F) : Reflectance(reflectance_of<F>()) {}
  // A model that outlives every copy, or is shared with them.
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

// The forms of the catalogue (brdf/forms.h), in its order.
std::span<const Reflectance> catalogue();
// Forms in their order, one group per family.
std::vector<std::vector<Reflectance>> families(std::span<const Reflectance> forms = catalogue());
// A form of the catalogue, or a target (brdf/targets.h), by its name.
std::optional<Reflectance> find_form(std::string_view name);
// The first form of the catalogue of whose info that is true.
template <class Is>
std::optional<Reflectance> find_form_if(Is&& is) {
  for (const Reflectance& form : catalogue())
    if (is(form.info())) return form;
  return std::nullopt;
}
// Its place there; -1 for what is not in it.
int catalogue_index(const Reflectance& reflectance);

}  // namespace brdf
