// The sampler and the density that belong to a shader's reflectance, evaluated in float and in double.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "shader/companions.h"
#include "shader/function.h"

namespace brdf::shader {

class Joint {
 public:
  // A value that the sampler returns; `kind` if its name or a line of the file states the quantity.
  struct Value {
    std::string name;
    std::size_t components = 1;
    std::optional<SampleValue> kind = {};
  };

  bool has_sampler() const { return sampler_.has_value(); }
  bool has_density() const { return density_.has_value(); }
  bool sampler_gives_pdf() const { return pdf_at_ >= 0; }
  const std::vector<Value>& values() const { return value_list_; }
  // Number of random numbers that draw() takes. If `generated`, a run may use fewer: a generator of the file
  // is replaced, and its calls are numbered within each run.
  std::size_t randoms() const { return sampler_ ? sampler_->function.randoms : 0; }
  bool generated() const { return generated_; }
  // The names in the file, for messages.
  const std::string& sampler_name() const { return sampler_name_; }
  const std::string& density_name() const { return density_name_; }
  const std::string& pdf_name() const { return pdf_name_; }
  const std::string& direction_name() const { return direction_name_; }
  // The sampler's only direction, if its name usually means the light and the returned direction has no name.
  const std::string& viewer_name() const { return viewer_name_; }
  DensityOf measure() const { return measure_; }
  bool measure_is_declared() const { return measure_is_declared_; }
  // The reason why float does not show all that a device may compute; empty: it does.
  std::string half_unknown() const;
  // The reasons why a function is not evaluated, as sentences.
  const std::vector<std::string>& missing() const { return missing_; }
  // Sentences on the interpretation of the functions.
  const std::vector<std::string>& notes() const { return notes_; }
  // Names of the parameters of both functions.
  std::set<std::string> parameters() const;

  // `values`: of the reflectance's parameters, in its order. `u`: out.size() rows of randoms() numbers.
  // `single`: in float. Throw InputError with the line if a loop does not end.
  void draw(std::span<const double> values, const Vec3<double>& wo, std::span<const double> u, bool single,
            std::span<Draw> out) const;
  // Writes the density per solid angle of each direction, 1/sr.
  void density(std::span<const double> values, const Vec3<double>& wo, std::span<const Vec3<double>> wi,
               bool single, std::span<double> out) const;

 private:
  friend std::shared_ptr<Joint> make_joint(const spirv::Module&, const spirv::Function&, const Source&,
                                           const LowerOptions&, const std::set<spirv::Id>&);
  friend void bind_joint(Joint&, const Function&);
  struct Part {
    Function function;
    // Of each value of the function: its index among the reflectance's values, or -1 for the initial value.
    std::vector<long> from = {};
    std::vector<double> initial = {};
  };
  template <class T>
  void draw_in(std::span<const double> values, const Vec3<double>& wo, std::span<const double> u,
               std::span<Draw> out) const;
  template <class T>
  void density_in(std::span<const double> values, const Vec3<double>& wo, std::span<const Vec3<double>> wi,
                  std::span<double> out) const;

  std::optional<Part> sampler_, density_;
  std::vector<Value> value_list_;
  int pdf_at_ = -1, valid_at_ = -1;  // places among the sampler's results; the direction is first
  std::size_t values_at_ = 3;
  bool generated_ = false;
  DensityOf measure_ = DensityOf::solid_angle;
  bool measure_is_declared_ = false;
  std::string sampler_name_, density_name_, pdf_name_, direction_name_, viewer_name_;
  std::vector<std::string> missing_, notes_;
};

// Finds, flattens and binds both functions; null if the file has neither. `options`: as for the
// reflectance. Throws InputError for a function that is named but cannot be used.
std::shared_ptr<Joint> make_joint(const spirv::Module& module, const spirv::Function& reflectance,
                                  const Source& source, const LowerOptions& options,
                                  const std::set<spirv::Id>& kernels);
// Connects the parameters of both functions to the parameters of the reflectance.
void bind_joint(Joint& joint, const Function& reflectance);
// Returns whether the function takes an argument that the sampler uses in another sense than usual: the
// sampler writes a direction whose name usually means the viewer, or takes viewer_name().
bool exchanges(const Joint* joint, const spirv::Module& module, const spirv::Function& function);

}  // namespace brdf::shader
