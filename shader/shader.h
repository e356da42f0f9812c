// A user's shader as a ReflectanceModel.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/material/shader_language.h"
#include "shader/function.h"
#include "shader/origin.h"

namespace brdf::shader {

// f_r as the shader computes it, in the requested scalar. float rounds each operation correctly; double
// evaluates the same code, with constants in double precision as written. The value is 0 below the horizon,
// where the shader is not called; elsewhere it is the shader's value, finite or not.
//
// Colours are weights. If f is linear in some parameters (determined by evaluation), these are weights,
// too, and the reflectance has lobes and can be fitted. All other parameters are its shape. Evaluation
// throws InputError with the line if a loop does not end.
class ShaderReflectance final : public ReflectanceModel, public io::SpeaksLanguages {
 public:
  explicit ShaderReflectance(Function function, std::optional<ShaderOrigin> origin = {});

  const ReflectanceInfo& info() const override { return info_; }
  const Function& function() const { return function_; }
  // Returns the reference that a material stores; std::nullopt for a text without a file.
  const std::optional<ShaderOrigin>& origin() const { return origin_; }
  // Returns a material with the colours' defaults. It has one channel, or red, green and blue if the shader
  // or the defaults distinguish them.
  Material material(std::shared_ptr<const ShaderReflectance> self) const;

  void eval(const ParameterValues<double>& p, const Directions<double>& d, double* out) const override;
  void eval_cos(const ParameterValues<double>& p, const Directions<double>& d, double* out) const override;
  void eval(const ParameterValues<float>& p, const Directions<float>& d, float* out) const override;
  void eval_cos(const ParameterValues<float>& p, const Directions<float>& d, float* out) const override;
  void lobes(std::span<const double> shape, Partial partial, const Directions<double>& d,
             const LobeRows& out) const override;
  void gradient(const ParameterValues<double>& p, const Directions<double>& d,
                const LobeRows& out) const override;
  std::vector<TableWeight> weights_of(std::span<const double> lobe_weights) const override;
  std::string glsl(const GlslOptions& options) const override;
  std::string functions_in(io::ShaderLanguage language) const override;

  // Returns the function's values for a channel's parameters, in the function's order.
  template <class T>
  std::vector<T> values_of(const ParameterValues<T>& p) const;
  // Returns true if every channel may also depend on the first component of a colour. A channel's value then
  // needs ParameterValues::first.
  bool reads_first_channel() const { return reads_first_; }
  // Parameters of the function at each position of the tables.
  const std::vector<std::size_t>& weight_parameters() const { return weights_; }
  const std::vector<std::size_t>& shape_parameters() const { return shape_; }

 private:
  template <class T>
  void evaluate_all(const ParameterValues<T>& p, const Directions<T>& d, bool times_cosine, T* out) const;
  // Destination of each component of the value; null: the component is not written.
  template <class T>
  using Components = std::array<T*, 3>;
  template <class T, int W>
  void evaluate_block(const std::vector<T>& values, const Directions<T>& d, bool times_cosine,
                      const Components<T>& out) const;
  // Writes derivatives by the parameters in the order of `by` and, last, by the tangent's azimuth. `first`
  // is row 1.
  void derivatives(const std::vector<double>& values, const std::vector<std::size_t>& by, bool by_phi,
                   std::size_t component, const Directions<double>& d, double* first,
                   std::size_t stride) const;
  [[noreturn]] void endless(const EndlessLoop& loop) const;
  void find_tables();

  Function function_;
  std::optional<ShaderOrigin> origin_;
  std::string name_;
  std::vector<std::size_t> weights_, shape_;  // parameters of the function, in the tables' order
  std::vector<ParameterInfo> weight_table_, shape_table_;
  std::vector<LobeWeight> lobes_;
  std::vector<std::string> channels_;
  bool reads_first_ = false;
  std::vector<Violation> violations_;
  ReflectanceInfo info_;
};

// Loads the file as a reflectance. `embedded`: its materials contain the text. Throws InputError.
std::shared_ptr<const ShaderReflectance> load_shader(const ShaderChoice& choice, bool embedded = false);
// Loads the shader again from its origin. Throws InputError.
std::shared_ptr<const ShaderReflectance> shader_from(const ShaderOrigin& origin);

}  // namespace brdf::shader
