#include "io/material/glsl.h"

#include <algorithm>
#include <cmath>

#include "brdf/trace.h"
#include "io/colour/channel_colours.h"
#include "io/colour/in_colour.h"
#include "io/files/error.h"
#include "io/files/fingerprint.h"
#include "io/files/identifier.h"
#include "io/files/provenance.h"
#include "io/files/text.h"
#include "io/material/shader_language.h"

namespace brdf::io {
namespace {

// Returns the values of a weight in all channels, in the channels' order.
std::vector<double> channels_of(const Term& term, std::size_t weight) {
  std::vector<double> values;
  for (const std::vector<double>& set : term.weights) values.push_back(set[weight]);
  return values;
}

// Returns one parameter of the red, green and blue channels as a vec3.
std::string glsl_vector(const Term& term, const ChannelColours& colours, std::size_t parameter) {
  const auto value = [&](std::size_t colour) {
    return glsl_number(term.weights[colours.of[colour]][parameter]);
  };
  return "vec3(" + value(0) + ", " + value(1) + ", " + value(2) + ")";
}

// Returns a call with one of the shapes of the term.
std::string call(const Term& term, const ChannelColours& colours, std::size_t shape, const std::string& wi,
                 const std::string& wo) {
  const ReflectanceInfo& form = info(term.form);
  std::string text = "brdf_eval_" + std::string(form.name) + "(" + wi + ", " + wo;
  for (std::size_t k = 0; k < form.shape.size(); ++k) text += ", " + glsl_number(term.shape[shape][k]);
  for (std::size_t k = 0; k < form.weights.size(); ++k) text += ", " + glsl_vector(term, colours, k);
  return text + ")";
}

// Returns the value of the term for all three colours, in one call if they share a shape.
std::string value(const Term& term, const ChannelColours& colours, const std::string& wi,
                  const std::string& wo) {
  if (term.shape.size() == 1) return call(term, colours, 0, wi, wo);
  std::string text = "vec3(";
  for (std::size_t colour = 0; colour < 3; ++colour)
    text += (colour ? ", " : "") + call(term, colours, colours.of[colour], wi, wo) + "." + "rgb"[colour];
  return text + ")";
}

// Returns vec3 FUNCTION(wi, wo): the sum of the terms with their parameters as constants.
std::string material_function(const Material& given, const std::string& function) {
  const Material material = in_colour(given);
  const std::optional<ChannelColours> colours = channel_colours(material.channels);
  if (!colours)
    throw InputError("--to glsl needs 1 or 3 channels; the material has " +
                     std::to_string(material.channels.size()) + " channels without a colour");
  std::string text = colours->note.empty() ? "" : "// " + colours->note + "\n";
  text += "vec3 " + function + "(vec3 wi, vec3 wo) {\n  vec3 f = vec3(0.0);\n";
  for (const Term& term : material.terms) {
    require_red_first(term, *colours);
    if (term.tangent_phi == Angle{}) {
      text += "  f += " + value(term, *colours, "wi", "wo") + ";\n";
      continue;
    }
    const std::string c = glsl_number(std::cos(term.tangent_phi.radians())),
                      s = glsl_number(std::sin(term.tangent_phi.radians()));
    const auto turned = [&](const std::string& w) {
      return "vec3(" + w + ".x * " + c + " + " + w + ".y * " + s + ", " + w + ".y * " + c + " - " + w +
             ".x * " + s + ", " + w + ".z)";
    };
    text += "  f += " + value(term, *colours, turned("wi"), turned("wo")) + ";\n";
  }
  return text + "  return f;\n}\n";
}

ShaderLanguage language_of(const GlslContent& content) {
  const bool es = content.dialect == GlslDialect::es;
  return content.translated.value_or(es ? ShaderLanguage::glsl_es : ShaderLanguage::glsl);
}

// Returns the name of the arc tangent of a sine and a cosine. In GLSL the arc tangent of one number has the
// same name.
std::string angle_function(ShaderLanguage language) {
  switch (language) {
    case ShaderLanguage::glsl:
    case ShaderLanguage::glsl_es:
    case ShaderLanguage::explorer:
      return "atan";
    case ShaderLanguage::hlsl:
      return "atan2";
    case ShaderLanguage::cpp:
      return "std::atan2";
  }
  return "";
}

// Returns the library's kernels written with the language's own functions. brdf_erfcx, which GLSL lacks, is
// kept, and so are the functions that the forms use themselves.
std::string builtin_kernels(const GlslOptions& options, ShaderLanguage language) {
  const std::string own = glsl_kernels(options);
  const std::size_t begin = own.find("float brdf_erfcx("), end = own.find("float brdf_angle(");
  return own.substr(0, own.find("float brdf_exp(")) +
         "float brdf_exp(float x) {\n  return exp(x);\n}\n"
         "float brdf_log(float x) {\n  return log(x);\n}\n"
         "float brdf_log1p(float x, float rest) {\n  float u = 1.0 + x;\n"
         "  return u == 1.0 ? x + rest : log(u) * (x / (u - 1.0)) + rest / u;\n}\n" +
         own.substr(begin, end - begin) + "float brdf_angle(float sine, float cosine) {\n  return " +
         angle_function(language) + "(sine, cosine);\n}\n";
}

// Returns the words after a parameter's name: the range, the default, and its meaning. A default that differs
// between the channels is a colour's, whose range is from 0 to 1 or to its largest component.
std::string declared(const ParameterInfo& p, const std::string& name,
                     const std::vector<double>& of_channels) {
  const bool colour = std::ranges::any_of(of_channels, [&](double x) { return x != of_channels[0]; });
  std::string text = (colour ? "//: color " : "//: param ") + name;
  if (colour)
    for (std::size_t c = 0; c < 3; ++c) text += " " + to_text(of_channels[c]);
  else
    text += " " + to_text(p.min) + " " + to_text(p.max) + " " +
            to_text(of_channels.empty() ? p.initial : of_channels[0]);
  return text + (p.log_scale ? " log" : "") + " role " + std::string(name_of(p.role)) + "\n";
}

// Returns the annotations that `--shader` reads: the function, and the ranges of its parameters if it has
// parameters. A .brdf file has no such line for the function, because its function BRDF() passes the sliders
// on.
std::string annotations(const Material& material, const std::string& function, ShaderLanguage language) {
  const auto entry = [&](const std::string& name) {
    return language == ShaderLanguage::explorer ? "" : "//: entry " + name + "(wi, wo)\n";
  };
  if (!function.empty()) return entry(function);
  if (material.terms.size() != 1) return "";
  const Term& term = material.terms.front();
  const ReflectanceInfo& form = info(term.form);
  const std::vector<std::string> names = argument_names(form.shape, form.weights);
  std::string text = entry("brdf_eval_" + std::string(form.name));
  for (std::size_t k = 0; k < form.shape.size(); ++k) text += declared(form.shape[k], names[k], {});
  for (std::size_t k = 0; k < form.weights.size(); ++k)
    text += declared(form.weights[k], names[form.shape.size() + k], channels_of(term, k));
  for (const Violation& v : form.violations)
    text += "//: violates " + std::string(v.check) + " at " + to_text(v.theta) + " " +
            std::string(v.statement) + "\n";
  return text;
}

// Makes brdf_material refer to the function as long as the shader has one material; with two materials the
// name would be ambiguous.
std::string alias(const std::string& function) {
  return "#ifndef BRDF_ONE_MATERIAL\n#define BRDF_ONE_MATERIAL\n#define brdf_material " + function +
         "\n#else\n#undef brdf_material\n#endif\n";
}

// Guards a text so that several exports can follow one another; shared parts occur in the shader once.
std::string guarded_source(const GlslParts& parts, const std::string& given) {
  std::string text = parts.head + guarded("BRDF_KERNELS", parts.kernels,
                                          "two exported texts with different kernels in one shader: export "
                                          "both with the same version of brdf, --to and --kernels");
  for (const auto& [name, functions] : parts.forms)
    text += guarded("BRDF_EVAL_" + name, functions,
                    "two versions of " + name + " in one shader: export both with the same version of brdf");
  if (parts.material.empty()) return text;
  const std::string name = identifier(given);
  return text +
         guarded("BRDF_MATERIAL_" + name, parts.material + alias("brdf_material_" + name),
                 "two materials have the name " + name + " in one shader: export one of them with --name");
}

}  // namespace

std::string text_number(const std::string& text) {
  const std::string hash = fingerprint({text});
  return std::to_string(
      std::stoul(hash.substr(hash.size() - std::min<std::size_t>(hash.size(), 7)), nullptr, 16));
}

std::string guarded(const std::string& macro, const std::string& text, const std::string& clash) {
  const std::string number = text_number(text);
  return "#ifndef " + macro + "\n#define " + macro + " " + number + "\n" + text +
         (clash.empty() ? "" : "#elif " + macro + " != " + number + "\n#error brdf: " + clash + "\n") +
         "#endif\n";
}

std::string glsl_number(double value) {
  std::string text = to_text(static_cast<double>(static_cast<float>(value)));
  return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

GlslParts glsl_parts(const Material& material, const GlslContent& content) {
  const GlslOptions options{.dialect = content.dialect};
  const ShaderLanguage language = language_of(content);
  const bool named = content.guarded || !content.name.empty();
  const std::string function =
      content.material ? "brdf_material" + (named ? "_" + identifier(content.name) : "") : "";
  GlslParts parts;
  parts.head = "// Written by brdf " BRDF_VERSION ": " + provenance().command +
               "\n// Unit vectors in the local frame: normal +z, tangent +x; values are f_r in 1/sr.\n" +
               annotations(material, function, language);
  parts.kernels = content.builtin_kernels ? builtin_kernels(options, language) : glsl_kernels(options);
  for (const Term& term : material.terms) {
    const std::string name(info(term.form).name);
    if (!info(term.form).has_glsl) throw InputError(name + " cannot be written as GLSL");
    const auto* speaks = dynamic_cast<const SpeaksLanguages*>(&*term.form);
    const std::string functions = speaks ? speaks->functions_in(language) : term.form->glsl(options);
    const auto same = std::ranges::find_if(parts.forms, [&](const auto& form) { return form.first == name; });
    if (same == parts.forms.end())
      parts.forms.emplace_back(name, functions);
    else if (same->second != functions)
      throw InputError("two terms have different functions with the name " + name +
                       ", which one shader cannot have: give one of the files another name");
  }
  if (content.material) parts.material = material_function(material, function);
  return parts;
}

std::string glsl_source(const Material& material, const GlslContent& content) {
  const GlslParts parts = glsl_parts(material, content);
  if (content.guarded) return guarded_source(parts, content.name);
  const bool es = content.dialect == GlslDialect::es;
  // In ES the version must be the first line.
  std::string text = content.whole && es ? "#version 300 es\n" : "";
  text += parts.head;
  if (content.whole) text += es ? "precision highp float;\nprecision highp int;\n" : "#version 450\n";
  text += parts.kernels;
  for (const auto& [name, functions] : parts.forms) text += functions;
  text += parts.material;
  if (content.whole) text += "void main() {}\n";
  return text;
}

}  // namespace brdf::io
