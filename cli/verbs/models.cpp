#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iomanip>
#include <iostream>
#include <memory>

#include "brdf/targets.h"
#include "cli/options/shader_options.h"
#include "cli/options/terminal.h"
#include "cli/verb.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/material/info_json.h"
#include "io/material/settings.h"

namespace brdf::cli {
namespace {

// Returns a bound of a range; multiples of pi/2 in radians are named.
std::string bound(double value, std::string_view unit) {
  if (unit == "rad" && value == kPi / 2) return "pi/2";
  if (unit == "rad" && value == kPi) return "pi";
  return io::to_text(value);
}
std::string range(const ParameterInfo& p) {
  const std::string unit = p.unit.empty() ? "" : " " + std::string(p.unit);
  return bound(p.min, p.unit) + " to " + bound(p.max, p.unit) + unit;
}

// Prints one form of the list: a line of parameters with range and unit, then a line of known violations.
void print_line(std::ostream& out, const ReflectanceInfo& form) {
  out << "  " << std::left << std::setw(27) << form.name << (form.fittable() ? "fittable  " : "          ");
  const char* separator = "";
  for (const auto table : {form.weights, form.shape})
    for (const ParameterInfo& p : table) {
      out << separator << p.name << ' ' << range(p);
      separator = ", ";
    }
  out << "\n      violates: ";
  separator = "";
  for (const Violation& v : form.violations) {
    out << separator << v.check << " (" << v.statement << ")";
    separator = "; ";
  }
  out << (form.violations.empty() ? "nothing known" : "") << '\n';
}

// Prints the forms by family.
void print_list() {
  PlainText out;
  const char* separator = "";
  for (const std::vector<Reflectance>& family : families()) {
    out << separator << info(family.front()).family << '\n';
    for (const Reflectance& form : family) print_line(out, info(form));
    separator = "\n";
  }
  out << "\nother programs' models (targets of fits and exports; not in --form all)\n";
  for (const Reflectance& target : targets()) print_line(out, info(target));
}

std::string listed_numbers(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(io::to_text(value));
  return io::joined(texts, ",");
}

// Returns the defaults of a parameter: one number, or one for each channel of a material in which they
// differ.
std::vector<double> defaults_of(const ParameterInfo& p, const Material* material) {
  if (!material) return {p.initial};
  const ReflectanceInfo& form = info(material->terms.front().form);
  std::vector<double> values;
  for (std::size_t c = 0; c < material->channels.size(); ++c) {
    const auto own = material->terms.front().values(c);
    for (std::size_t k = 0; k < form.weights.size(); ++k)
      if (&form.weights[k] == &p) values.push_back(own.weights[k]);
    for (std::size_t k = 0; k < form.shape.size(); ++k)
      if (&form.shape[k] == &p) values.push_back(own.shape[k]);
  }
  if (std::ranges::adjacent_find(values, std::not_equal_to()) == values.end()) values.resize(1);
  return values;
}

// `material`: of a shader with the defaults of its colours; null for a form.
void print_form(const ReflectanceInfo& form, const Material* material) {
  PlainText out;
  out << form.name << " (family " << form.family << (form.fittable() ? ", fittable" : "") << ")\n";
  std::size_t longest = 9;
  for (const auto table : {form.weights, form.shape})
    for (const ParameterInfo& p : table) longest = std::max(longest, p.name.size());
  const auto print = [&](const ParameterInfo& p, const char* kind) {
    out << "  " << std::left << std::setw(int(longest) + 1) << p.name << std::setw(7) << kind << std::setw(25)
        << range(p) << " default " << std::setw(8) << listed_numbers(defaults_of(p, material)) << ' ' << p.doc
        << '\n';
  };
  for (const ParameterInfo& p : form.weights) print(p, "weight");
  for (const ParameterInfo& p : form.shape) print(p, "shape");
  for (const Violation& v : form.violations)
    out << "  known violation, " << v.check << ": " << v.statement << " (" << v.witness << ": "
        << io::to_text(v.value) << " at " << io::to_text(v.theta) << " degrees)\n";
}

io::Json list_json(std::span<const Reflectance> forms) {
  io::Json list = io::Json::array();
  for (const Reflectance& form : forms) list.push_back(io::to_json(info(form)));
  return list;
}

// Gives the colours of a shader's form their defaults, one for each channel.
void set_defaults(const ReflectanceInfo& form, const Material& material, io::Json& json) {
  std::size_t place = 0;
  for (const auto table : {form.weights, form.shape})
    for (const ParameterInfo& p : table) {
      const std::vector<double> values = defaults_of(p, &material);
      json["parameters"][place++]["default"] =
          values.size() > 1 ? io::Json(values) : io::Json(values.front());
    }
}

}  // namespace

void add_models(CLI::App& app) {
  struct ModelsCall {
    std::string form;
    ShaderOptions shader;
    bool json = false;
  };
  auto options = std::make_shared<ModelsCall>();
  CLI::App* verb =
      add_verb(app, Purpose::look, "models", "List the forms, their parameters and known violations");
  verb->add_option("FORM", options->form, "Form to describe in detail");
  add_shader_options(*verb, options->shader);
  verb->add_flag("--json", options->json, "JSON on stdout");
  verb->footer(
      "Examples: brdf models ward\n"
      "          brdf models --json\n"
      "          brdf models --shader disney.brdf\n"
      "          brdf models --shader skin.hlsl --define QUALITY=2 -I engine/common\n"
      "          brdf models --shader paint.glsl --texture albedoMap=albedo.exr:nearest:clamp");
  on_run(*verb, [options] {
    if (!options->form.empty() && !options->shader.file.empty()) throw InputError("give a form or --shader");
    const auto shader = load(options->shader, "models");
    const bool all = options->form.empty() && !shader;
    std::vector<Reflectance> forms(catalogue().begin(), catalogue().end());
    if (!all) forms = {shader ? shader->reflectance : io::require_form(options->form)};
    if (options->json) {
      io::Json json;
      json["forms"] = list_json(forms);
      if (shader) set_defaults(info(forms[0]), shader->material, json["forms"][0]);
      if (all) json["targets"] = list_json(targets());
      std::cout << io::to_text(json);
    } else if (all) {
      print_list();
    } else {
      print_form(info(forms[0]), shader ? &shader->material : nullptr);
    }
    return Exit::good;
  });
}

}  // namespace brdf::cli
