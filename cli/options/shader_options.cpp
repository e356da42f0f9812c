#include "cli/options/shader_options.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "cli/options/options.h"
#include "cli/options/terminal.h"
#include "io/files/error.h"
#include "io/files/text.h"
#ifdef BRDF_HAS_SHADER
#include "shader/blame.h"
#include "shader/comparisons.h"
#include "shader/front/languages.h"
#include "shader/half_precision.h"
#include "shader/in_more_digits.h"
#include "shader/joint.h"
#include "shader/material_form.h"
#include "shader/sampler_of.h"
#include "shader/shader.h"
#include "shader/undefined.h"
#endif

namespace brdf::cli {
#ifdef BRDF_HAS_SHADER
namespace {

std::string explain(const shader::ShaderReflectance& model, std::string_view check, const Material& at,
                    const Vec3<double>& wi, const Vec3<double>& wo) {
  using shader::Fault;
  const bool half = check == "half" && model.function().in_half;
  const shader::Function& function = half ? *model.function().in_half : model.function();
  const Fault fault = check == "finite"         ? Fault::not_finite
                      : check == "non_negative" ? Fault::negative
                                                : Fault::loses_digits;
  for (std::size_t c = 0; c < at.channels.size(); ++c) {
    const std::vector<double> values = model.values_of(at.terms.front().values(c));
    const std::string text =
        to_text(shader::blame<double>(function, fault, values, wi, wo, std::min<std::size_t>(c, 2)));
    if (!text.empty()) return text;
  }
  return "";
}

std::string explain_jump(const shader::ShaderReflectance& model, const Material& at,
                         const shader::DirectionPair& here, const shader::DirectionPair& there) {
  for (std::size_t c = 0; c < at.channels.size(); ++c) {
    const std::vector<double> values = model.values_of(at.terms.front().values(c));
    const std::string text =
        to_text(shader::blame_jump(model.function(), values, here, there, std::min<std::size_t>(c, 2)));
    if (!text.empty()) return text;
  }
  return "";
}

std::string undefined_text(const shader::ShaderReflectance& model, const Material& at, const Vec3<double>& wi,
                           const Vec3<double>& wo) {
  if (std::min(wi.z, wo.z) < 0) return "";  // the shader is not called
  for (std::size_t c = 0; c < at.channels.size(); ++c) {
    const std::vector<double> values = model.values_of(at.terms.front().values(c));
    auto found = shader::undefined_value<double>(model.function(), values, wi, wo);
    if (!found) found = shader::undefined_value<float>(model.function(), values, wi, wo);
    if (found) return to_text(model.function(), *found);
    if (!model.info().mixes_channels && model.info().channels.empty()) break;
  }
  return "";
}

std::vector<double> in_more_digits(const shader::ShaderReflectance& model, const Material& at,
                                   const Vec3<double>& wi, const Vec3<double>& wo) {
  std::vector<double> out;
  for (std::size_t c = 0; c < at.channels.size(); ++c)
    out.push_back(shader::in_more_digits(model.function(), model.values_of(at.terms.front().values(c)), wi,
                                         wo, std::min<std::size_t>(c, 2)));
  return out;
}

// Returns an empty function if the shader has no values of 16 bits.
std::function<std::vector<double>(const Material&, const Vec3<double>&, const Vec3<double>&)> in_half(
    std::shared_ptr<const shader::ShaderReflectance> model) {
  if (!model->function().in_half) return {};
  return [model](const Material& at, const Vec3<double>& wi, const Vec3<double>& wo) {
    std::vector<double> out;
    for (std::size_t c = 0; c < at.channels.size(); ++c)
      out.push_back(shader::in_half(model->function(), model->values_of(at.terms.front().values(c)), wi, wo,
                                    std::min<std::size_t>(c, 2)));
    return out;
  };
}

using LookAtComparison =
    std::function<void(std::uint32_t number, std::uint32_t line, bool holds, double surplus)>;

// An evaluation that does not end has the comparisons up to its end; other checks report it.
void for_each_comparison(const shader::ShaderReflectance& model, const Material& at, const Vec3<double>& wi,
                         const Vec3<double>& wo, const LookAtComparison& look) {
  try {
    shader::for_each_comparison(
        model.function(), model.values_of(at.terms.front().values(0)), wi, wo,
        [&](const shader::MetComparison& c) { look(c.number, c.line, c.holds, c.surplus); });
  } catch (const shader::EndlessLoop&) {
  }
}

LoadedShader described(std::shared_ptr<const shader::ShaderReflectance> model, std::string words) {
  return {Reflectance(model),
          model->material(model),
          std::move(words),
          model->function().notes,
          model->function().oriented,
          model->function().may_turn(),
          model->function().all_round(),
          model->function().as_written.size(),
          [model](std::string_view check, const Material& at, const Vec3<double>& wi,
                  const Vec3<double>& wo) { return explain(*model, check, at, wi, wo); },
          [model](const Material& at, const Vec3<double>& wi, const Vec3<double>& wo,
                  const Vec3<double>& other_wi, const Vec3<double>& other_wo) {
            return explain_jump(*model, at, {wi, wo}, {other_wi, other_wo});
          },
          [model](const Material& at, const Vec3<double>& wi, const Vec3<double>& wo) {
            return undefined_text(*model, at, wi, wo);
          },
          [model](const Material& at, const Vec3<double>& wi, const Vec3<double>& wo) {
            return in_more_digits(*model, at, wi, wo);
          },
          in_half(model),
          model->function().half_unknown,
          model->function().has_half_types,
          shader::sampler_of(model),
          [model](const Material& at, const Vec3<double>& wi, const Vec3<double>& wo,
                  const LookAtComparison& look) { for_each_comparison(*model, at, wi, wo, look); },
          [model](std::uint32_t line) { return shader::line_of_text(model->function().source.text, line); }};
}

}  // namespace
#endif

void add_shader_options(CLI::App& verb, ShaderOptions& options) {
  verb.add_option(
      "--shader", options.file,
      "A shader's file (GLSL, HLSL, SPIR-V, BRDF Explorer's .brdf) with the reflectance as a function");
  add_repeated_option(verb, "--param", options.parameters,
                      "A parameter's range, NAME=MIN:MAX or NAME=MIN:MAX:DEFAULT, :log after it for a log "
                      "scale (of --shader)");
  verb.add_option("--entry", options.entry,
                  "The function, NAME or NAME(L, V, N, ...) with the meaning of its arguments (of --shader; "
                  "default: the function brdf)");
  offer(verb.add_option(
            "--returns", options.returns,
            "The quantity that the function returns: f (default), f*cos_i or f*cos_o (of --shader)"),
        {"f", "f*cos_i", "f*cos_o"});
  add_repeated_option(
      verb, "--define", options.defines,
      "A macro that is defined before the file's first line, NAME=VALUE, NAME (then 1) or NAME= (then "
      "nothing) (of --shader)");
  add_repeated_option(verb, "-I,--include-folder", options.include_folders,
                      "A folder for included files, searched after the file's own folder (of --shader)");
  add_repeated_option(verb, "--texture", options.textures,
                      "A texture's file, NAME=FILE.exr, then :nearest or :bilinear, and :repeat, :clamp or "
                      ":mirror (of --shader; default: bilinear, repeat)");
}

void add_sampler_options(CLI::App& verb, ShaderOptions& options) {
  verb.add_option(
      "--sample", options.sample,
      "The sampler of directions, NAME or NAME(u, V, N, ...) with the meaning of its arguments (of "
      "--shader; default: according to its name)");
  verb.add_option(
      "--pdf", options.pdf,
      "The density of the sampler's directions, NAME or NAME(L, V, N, ...) (of --shader; default: "
      "according to its name)");
}

std::vector<std::string> shader_suffixes() {
#ifdef BRDF_HAS_SHADER
  std::vector<std::string> out(std::begin(shader::kHlslSuffixes), std::end(shader::kHlslSuffixes));
  out.insert(out.end(), std::begin(shader::kOtherSuffixes), std::end(shader::kOtherSuffixes));
  return out;
#else
  throw EnvironmentError("this build has no shader compiler");
#endif
}

bool is_given(const ShaderOptions& options) {
  for (const auto& [name, given] :
       {std::pair("--param", !options.parameters.empty()), std::pair("--entry", !options.entry.empty()),
        std::pair("--returns", !options.returns.empty()), std::pair("--sample", !options.sample.empty()),
        std::pair("--pdf", !options.pdf.empty()), std::pair("--define", !options.defines.empty()),
        std::pair("-I", !options.include_folders.empty()), std::pair("--texture", !options.textures.empty())})
    if (given && options.file.empty()) throw InputError(std::string(name) + ": needs --shader FILE");
#ifndef BRDF_HAS_SHADER
  if (!options.file.empty())
    throw EnvironmentError("--shader " + options.file + ": this build has no shader compiler (glslang)");
#endif
  return !options.file.empty();
}

#ifdef BRDF_HAS_SHADER
shader::ShaderChoice choice_of(const ShaderOptions& options) {
  std::vector<shader::TextureChoice> textures;
  for (const std::string& text : options.textures) textures.push_back(shader::parse_texture(text));
  return {options.file,        options.parameters,      options.entry,  options.returns,
          options.defines,     options.include_folders, options.sample, options.pdf,
          std::move(textures), options.shares_textures};
}
#endif

std::optional<LoadedShader> load(const ShaderOptions& options, const std::string& verb, bool quiet) {
  if (!is_given(options)) return std::nullopt;
#ifdef BRDF_HAS_SHADER
  const shader::ShaderChoice choice = choice_of(options);
  const auto model = shader::load_shader(choice, options.embed);
  LoadedShader loaded = described(model, shader::command_words(choice));
  for (const shader::Parameter& p : model->function().parameters)
    if (verb == "fit" && p.whole)
      loaded.notes.push_back(p.name +
                             " is a whole number, which a fit does not search: the fit holds it at " +
                             io::to_text(p.initial[0]) + " unless --fix gives another value");
  if (const auto joint = model->function().joint; joint && verb == "validate")
    loaded.notes.insert(loaded.notes.end(), joint->notes().begin(), joint->notes().end());
  if (!quiet)
    for (const std::string& note : loaded.notes)
      Note() << "brdf " << verb << ": " << options.file << ": " << note;
  return loaded;
#else
  (void)verb, (void)quiet;
  return std::nullopt;
#endif
}

std::optional<LoadedShader> shader_in(const Material& material) {
#ifdef BRDF_HAS_SHADER
  if (material.terms.size() != 1) return std::nullopt;
  const auto form = std::make_shared<const Reflectance>(material.terms.front().form);
  const shader::ShaderReflectance* model = shader::shader_of(*form);
  if (model == nullptr) return std::nullopt;
  return described({form, model}, "");
#else
  (void)material;
  return std::nullopt;
#endif
}

void use_shaders_in_materials() {
#ifdef BRDF_HAS_SHADER
  shader::use_in_materials();
#endif
}

void add_material_options(CLI::App& verb, MaterialOptions& options) {
  add_material_options(verb, static_cast<io::MaterialChoice&>(options));
  add_shader_options(verb, options.shader);
}

void add_material_argument(CLI::App& verb, MaterialOptions& options) {
  add_material_argument(verb, options.material, "--material", "A material's JSON file");
}

io::MaterialFile choose_material_file(const MaterialOptions& options, const std::string& verb) {
  io::MaterialChoice choice = options;
  if (const auto shader = load(options.shader, verb)) choice.made = shader->material;
  return io::choose_material_file(choice);
}

Material choose_material(const MaterialOptions& options, const std::string& verb) {
  return choose_material_file(options, verb).material;
}

}  // namespace brdf::cli
