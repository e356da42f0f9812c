#include "maps/textures/texel_materials.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/result.h"
#include "io/colour/channel_colours.h"
#include "io/files/error.h"
#include "io/files/text.h"

namespace brdf::maps {
namespace {

// Returns the form that the file names.
Reflectance form_of(const texel::Planes& planes, const std::string& file) {
  const auto named =
      std::ranges::find(planes.attributes, "form", &std::pair<std::string, std::string>::first);
  if (named == planes.attributes.end())
    throw InputError(file + ": has no attribute 'form', so that it is no map of fitted parameters; " +
                     "brdf fit STACK -o FOLDER writes FOLDER/maps.exr");
  if (named->second.find('+') != std::string::npos)
    throw InputError(file + ": holds the sum " + named->second +
                     ", but a texture holds the parameters of a single form; fit the stack with one form");
  const std::optional<Reflectance> form = find_form(named->second);
  if (!form) throw InputError(file + ": the form '" + named->second + "' is no form of brdf");
  return *form;
}

}  // namespace

TexelMaterials::TexelMaterials(const std::filesystem::path& path)
    : planes_(texel::read_planes(path)), name_(path.string()), form_(form_of(planes_, name_)) {
  find_planes();
  fitted_.resize(size());
  for (std::size_t k = 0; k < size(); ++k) check_texel(k);
  if (fitted_count() == 0)
    throw InputError(name_ + ": no texel has a fit: the parameters of every texel are NaN");
}

const std::vector<float>& TexelMaterials::plane(const std::string& parameter,
                                                const std::string& channel) const {
  if (const std::vector<float>* found = planes_.find_parameter(parameter, channel)) return *found;
  const std::string name = texel::plane_name(parameter, channel);
  const auto of_channel =
      std::ranges::find_if(planes_.names, [&](const std::string& n) { return n.starts_with(name + "."); });
  if (of_channel != planes_.names.end())
    throw InputError(name_ + ": has " + *of_channel +
                     ", a shape for each channel, but a texture holds one shape for all channels; fit the "
                     "stack without --per-channel");
  throw InputError(name_ + ": has no channel " + name + ", which the form " + std::string(info(form_).name) +
                   " needs");
}

void TexelMaterials::find_planes() {
  const ReflectanceInfo& form = info(form_);
  for (const ParameterInfo& p : form.shape) shape_.push_back(&plane(std::string(p.name)));
  if (form.weights.empty())
    throw InputError(name_ + ": the form " + std::string(form.name) +
                     " has no weights, so that the file does not tell the channels");
  for (const ParameterInfo& p : form.weights) {
    const std::string layers = std::string(p.name) + ".";
    for (const std::string& name : planes_.names)
      if (name.starts_with(layers)) channels_.push_back(name.substr(layers.size()));
    if (!channels_.empty()) break;  // the channels of an earlier weight are tied
  }
  // OpenEXR sorts channels by name.
  if (const auto colours = io::channel_colours(channels_); channels_.size() == 3 && colours)
    channels_ = {channels_[colours->of[0]], channels_[colours->of[1]], channels_[colours->of[2]]};
  if (channels_.empty()) channels_ = {""};
  for (const std::string& channel : channels_)
    for (const ParameterInfo& p : form.weights) weights_.push_back(&plane(std::string(p.name), channel));
  for (const char* axis : {"normal.x", "normal.y", "normal.z"}) normal_.push_back(&plane(axis));
  if (channels_ == std::vector<std::string>{""}) channels_ = {"value"};
}

void TexelMaterials::check_texel(std::size_t texel) {
  const ReflectanceInfo& form = info(form_);
  fitted_[texel] = true;
  for (const auto* planes : {&shape_, &weights_, &normal_})
    for (const std::vector<float>* values : *planes)
      if (std::isnan((*values)[texel])) fitted_[texel] = false;
  if (!fitted_[texel]) return;
  const auto check = [&](const ParameterInfo& p, const std::vector<float>& values) {
    // A float beside a bound is the rounded bound.
    const double value = double(values[texel]), slack = 1e-6 * std::max(std::abs(p.max), std::abs(p.min));
    if (!(value >= p.min - slack && value <= p.max + slack))
      throw InputError(name_ + ": " + place(texel) + ": " + std::string(p.name) + " is " +
                       io::to_text(value) + ", but must be " + io::to_text(p.min) + " to " +
                       io::to_text(p.max));
  };
  for (std::size_t k = 0; k < form.shape.size(); ++k) check(form.shape[k], *shape_[k]);
  for (std::size_t k = 0; k < weights_.size(); ++k)
    check(form.weights[k % form.weights.size()], *weights_[k]);
  if (!((*normal_[2])[texel] > 0))
    throw InputError(name_ + ": " + place(texel) + ": the normal must have a z above 0");
  if (const auto [along, across] = form.axes();
      along >= 0 && across >= 0 &&
      (*shape_[std::size_t(along)])[texel] != (*shape_[std::size_t(across)])[texel])
    throw InputError(name_ + ": " + place(texel) + ": " + std::string(form.shape[std::size_t(along)].name) +
                     " and " + std::string(form.shape[std::size_t(across)].name) +
                     " differ, but textures are written for isotropic maps; fit the stack without "
                     "--anisotropic");
  const std::vector<float>* verdict = planes_.find("verdict");
  if (verdict && !fit::usable(fit::Verdict(int((*verdict)[texel])))) ++unusable_;
}

std::size_t TexelMaterials::fitted_count() const {
  return std::size_t(std::ranges::count(fitted_, true));
}

Material TexelMaterials::at(std::size_t texel) const {
  const ReflectanceInfo& form = info(form_);
  const auto value = [&](const ParameterInfo& p, const std::vector<float>& values) {
    return std::clamp(double(values[texel]), p.min, p.max);
  };
  Material out{channels_, {{form_, {{}}, {}}}};
  for (std::size_t k = 0; k < form.shape.size(); ++k)
    out.terms[0].shape[0].push_back(value(form.shape[k], *shape_[k]));
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    std::vector<double>& weights = out.terms[0].weights.emplace_back();
    for (std::size_t k = 0; k < form.weights.size(); ++k)
      weights.push_back(value(form.weights[k], *weights_[c * form.weights.size() + k]));
  }
  return out;
}

Vec3<double> TexelMaterials::normal(std::size_t texel) const {
  const Vec3<double> n{double((*normal_[0])[texel]), double((*normal_[1])[texel]),
                       double((*normal_[2])[texel])};
  return n * (1 / std::sqrt(dot(n, n)));
}

bool TexelMaterials::has_normals() const {
  for (std::size_t k = 0; k < size(); ++k)
    if (fitted_[k] && ((*normal_[0])[k] != 0 || (*normal_[1])[k] != 0)) return true;
  return false;
}

std::string TexelMaterials::place(std::size_t texel) const {
  return "texel " + std::to_string(texel % width()) + "," + std::to_string(texel / width());
}

}  // namespace brdf::maps
