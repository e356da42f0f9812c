#include "shader/shader.h"

#include <algorithm>

#include "io/files/error.h"
#include "io/files/identifier.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "shader/dependence.h"
#include "shader/glsl.h"
#include "shader/linear.h"

namespace brdf::shader {
namespace {

// Throws InputError if a direction is missing and an argument of three numbers may be it: the argument's
// components affect one channel together, and no line declares it as a colour.
void require_directions(const Function& f) {
  const char* const missing = !f.is_given(Axis::view)    ? "the viewer"
                              : !f.is_given(Axis::light) ? "the light"
                                                         : nullptr;
  if (!missing) return;
  for (const Parameter& p : f.parameters)
    if (p.colour && !p.declared)
      throw InputError(f.source.name + ": no argument of " + f.entry + " is recognised as the direction to " +
                       missing + ", which " + p.name + " may be: " + entry_advice(f) + "; or declare " +
                       p.name + " as a colour with a line `//: color " + p.name + " 0.5 0.5 0.5`");
}

// Replaces each colour by three numbers. A table of one channel cannot describe the effect of other
// channels' colours on a channel, but a table of all three numbers can.
void split_colours(Function& function) {
  std::deque<Parameter> parameters;
  for (const Parameter& p : function.parameters) {
    for (std::size_t c = 0; c < (p.colour ? 3u : 1u); ++c) {
      Parameter& part = parameters.emplace_back(p);
      if (!p.colour) continue;
      part.name += std::string("_") + "rgb"[c];
      part.colour = false;
      part.first += c;
      part.initial.fill(p.initial[c]);
    }
  }
  function.parameters = std::move(parameters);
}

}  // namespace

ShaderReflectance::ShaderReflectance(Function function, std::optional<ShaderOrigin> origin)
    : function_(std::move(function)),
      origin_(std::move(origin)),
      name_(io::identifier(std::filesystem::path(function_.source.name).stem().string())) {
  try {
    find_tables();
  } catch (const EndlessLoop& loop) {
    endless(loop);
  }
}

void ShaderReflectance::find_tables() {
  const Mixing mixing = mixing_of(function_);
  reads_first_ = mixing == Mixing::first;
  if (mixing == Mixing::all) require_directions(function_);
  if (mixing == Mixing::all) split_colours(function_);
  const std::deque<Parameter>& parameters = function_.parameters;
  const std::optional<Linear> linear = reads_first_ ? std::nullopt : linear_parameters(function_);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const bool weight =
        linear ? std::ranges::find(linear->weights, k) != linear->weights.end() : parameters[k].colour;
    (weight ? weights_ : shape_).push_back(k);
  }
  const auto table = [&](const std::vector<std::size_t>& of) {
    std::vector<ParameterInfo> out;
    for (const std::size_t k : of) {
      const Parameter& p = parameters[k];
      const double initial = p.colour ? (p.initial[0] + p.initial[1] + p.initial[2]) / 3 : p.initial[0];
      // A weight above 1 is used only for samples without an absolute scale.
      const double usual = &of == &weights_ ? std::min(p.max, std::max({1.0, initial, p.min})) : p.max;
      out.push_back(
          {p.name, p.min, p.max, initial, usual, "", p.log_scale, p.doc, p.role, Map::none, p.whole});
    }
    return out;
  };
  weight_table_ = table(weights_);
  shape_table_ = table(shape_);
  if (linear) {
    lobes_ = linear->lobes;
    if (linear->f0 >= 0) weight_table_[std::size_t(linear->f0)].role = Role::f0;
  }
  if (function_.returns == Returns::f && !function_.source.returns && holds_cosine(function_))
    function_.notes.push_back(
        "the value is reciprocal after division by the cosine of the incident direction: if the function "
        "returns f times this cosine, use --returns 'f*cos_i' or `//: returns f*cos_i`");
  function_.zero_where_asked = is_zero_where_asked(function_);
  for (const std::string& note : {said_of_unread(function_), said_of_holes(function_)})
    if (!note.empty()) function_.notes.push_back(note);
  if (!same_in_all_channels(function_)) channels_ = {"r", "g", "b"};
  for (const KnownViolation& v : function_.source.violations)
    violations_.push_back({v.check, v.statement, "", v.theta, v.most});
  info_.violations = violations_;
  info_.name = name_;
  info_.family = "shader";
  info_.weights = weight_table_;
  info_.shape = shape_table_;
  info_.channels = channels_;
  info_.lobes = lobes_;
  info_.mixes_channels = lobes_.empty() && !weights_.empty();
  info_.differentiable = true;
  info_.outside = true;
  info_.all_round = !function_.symmetry.mirrored || !function_.symmetry_as_meant.mirrored;
  info_.has_glsl = glsl_obstacle(function_).empty();
}

std::vector<ReflectanceModel::TableWeight> ShaderReflectance::weights_of(
    std::span<const double> lobe_weights) const {
  std::vector<TableWeight> out;
  const int f0 = info_.weight_index(Role::f0);
  for (std::size_t w = 0; w < weights_.size(); ++w) {
    TableWeight weight{0, std::vector<double>(lobes_.size(), 0.0)};
    if (int(w) == f0) {
      double part = 0, whole = 0;
      for (std::size_t k = 0; k < lobes_.size(); ++k) {
        if (lobes_[k].factor == LobeWeight::Factor::one) continue;
        whole += lobe_weights[k];
        if (lobes_[k].factor == LobeWeight::Factor::f0) part += lobe_weights[k];
      }
      weight.value = whole > 0 ? part / whole : weight_table_[w].initial;
      for (std::size_t k = 0; k < lobes_.size() && whole > 0; ++k)
        if (lobes_[k].factor != LobeWeight::Factor::one)
          weight.by_lobe[k] = ((lobes_[k].factor == LobeWeight::Factor::f0) - weight.value) / whole;
    } else {
      for (std::size_t k = 0; k < lobes_.size(); ++k)
        if (lobes_[k].weight == w) weight.value += lobe_weights[k], weight.by_lobe[k] = 1;
    }
    out.push_back(std::move(weight));
  }
  return out;
}

std::string ShaderReflectance::glsl(const GlslOptions& options) const {
  const bool es = options.dialect == GlslDialect::es;
  return glsl_of(function_, name_, weights_, shape_,
                 {es ? io::ShaderLanguage::glsl_es : io::ShaderLanguage::glsl, options.precise,
                  io::argument_names(shape_table_, weight_table_)});
}

std::string ShaderReflectance::functions_in(io::ShaderLanguage language) const {
  return glsl_of(function_, name_, weights_, shape_,
                 {language, true, io::argument_names(shape_table_, weight_table_)});
}

Material ShaderReflectance::material(std::shared_ptr<const ShaderReflectance> self) const {
  const bool coloured = !channels_.empty() || std::ranges::any_of(weights_, [&](std::size_t k) {
    const Parameter& p = function_.parameters[k];
    return p.colour && (p.initial[0] != p.initial[1] || p.initial[0] != p.initial[2]);
  });
  Material m = make_material(Reflectance(std::move(self)), coloured ? std::vector<std::string>{"r", "g", "b"}
                                                                    : std::vector<std::string>{"fr"});
  for (std::size_t c = 0; c < m.channels.size(); ++c)
    for (std::size_t k = 0; k < weights_.size(); ++k)
      m.terms.front().weights[c][k] =
          function_.parameters[weights_[k]].initial[function_.parameters[weights_[k]].colour ? c : 0];
  return m;
}

std::shared_ptr<const ShaderReflectance> load_shader(const ShaderChoice& choice, bool embedded) {
  return shader_from(origin_of(choice, embedded));
}

std::shared_ptr<const ShaderReflectance> shader_from(const ShaderOrigin& origin) {
  const ShaderChoice& choice = origin.choice;
  return std::make_shared<const ShaderReflectance>(
      origin.text.empty() ? make_function(choice)
                          : make_function(parse_source(choice.file, origin.text), choice),
      origin);
}

}  // namespace brdf::shader
