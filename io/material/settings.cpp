#include "io/material/settings.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/limits.h"
#include "io/files/near_name.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

constexpr std::string_view kTangent = "tangent_phi";  // of a term, not in its form's table

std::vector<std::string> channel_names(std::size_t count) {
  if (count == 1) return {"fr"};
  if (count == 3) return {"r", "g", "b"};
  std::vector<std::string> names;
  for (std::size_t k = 0; k < count; ++k) names.push_back("c" + std::to_string(k));
  return names;
}

[[noreturn]] void refuse(const Setting& setting, const std::string& rule) {
  throw InputError("--set " + setting.name + ": " + rule);
}

void check_range(const Setting& setting, double min, double max) {
  for (const double value : setting.values)
    if (!(value >= min && value <= max))
      refuse(setting, to_text(value) + " must be between " + to_text(min) + " and " + to_text(max));
}

void check_values(const Setting& setting, const ParameterInfo& p) {
  check_range(setting, p.min, p.max);
  for (const double value : setting.values)
    if (nearest_value(p, value) != value) refuse(setting, to_text(value) + " must be a whole number");
}

// Returns the value of the setting for each of `channels` channels.
std::vector<double> per_channel(const Setting& setting, std::size_t channels) {
  if (setting.values.size() == 1) return std::vector(channels, setting.values[0]);
  if (setting.values.size() != channels)
    refuse(setting, plural(setting.values.size(), "value") + " for " + plural(channels, "channel"));
  return setting.values;
}

void set_weight(Term& term, std::size_t index, const Setting& setting) {
  const ParameterInfo& p = info(term.form).weights[index];
  check_values(setting, p);
  const std::vector<double> values = per_channel(setting, term.weights.size());
  for (std::size_t c = 0; c < values.size(); ++c) term.weights[c][index] = values[c];
}

void set_shape(Term& term, std::size_t index, const Setting& setting) {
  const ParameterInfo& p = info(term.form).shape[index];
  check_values(setting, p);
  const std::vector<double> values = per_channel(setting, term.weights.size());
  if (setting.values.size() > 1 && term.shape.size() == 1) {
    const std::vector<double> shared = term.shape[0];
    term.shape.assign(values.size(), shared);
  }
  for (std::size_t s = 0; s < term.shape.size(); ++s) term.shape[s][index] = values[s];
}

// Applies a setting. Returns false if the term has no such parameter.
bool apply(Term& term, const Setting& setting) {
  const ReflectanceInfo& table = info(term.form);
  if (table.anisotropic() && setting.name == table.tied_name()) {
    const auto [along, across] = table.axes();
    for (const int k : {along, across}) set_shape(term, static_cast<std::size_t>(k), setting);
    return true;
  }
  if (setting.name == kTangent && table.anisotropic()) {
    check_range(setting, -180, 180);
    if (setting.values.size() != 1) refuse(setting, "takes one value");
    term.tangent_phi = degrees(setting.values[0]);
    return true;
  }
  if (const int k = table.weight_index(setting.name); k >= 0) {
    set_weight(term, static_cast<std::size_t>(k), setting);
    return true;
  }
  if (const int k = table.shape_index(setting.name); k >= 0) {
    set_shape(term, static_cast<std::size_t>(k), setting);
    return true;
  }
  return false;
}

// Lists the parameters of the material, for messages about an unknown name.
std::string known_parameters(std::string_view name, const Material& material) {
  std::vector<std::string> known;
  const auto add = [&](std::string_view other) {
    if (std::ranges::find(known, other) == known.end()) known.emplace_back(other);
  };
  for (const Term& term : material.terms) {
    const ReflectanceInfo& table = info(term.form);
    for (const ParameterInfo& p : table.weights) add(p.name);
    for (const ParameterInfo& p : table.shape) add(p.name);
    if (table.anisotropic()) {
      add(table.tied_name());
      add(kTangent);
    }
  }
  return known_names_text(name, known);
}

}  // namespace

Reflectance require_form(const std::string& name) {
  if (const auto form = find_form(name)) return *form;
  std::vector<std::string> known;
  for (const Reflectance& form : catalogue()) known.emplace_back(info(form).name);
  throw InputError("'" + name + "' is not the name of a form (" + known_names_text(name, known) + ")");
}

std::vector<Setting> parse_settings(const std::vector<std::string>& texts, std::string_view option) {
  std::vector<Setting> settings;
  std::vector<std::string_view> fields;
  for (const std::string& text : texts) {
    const auto refused = [&](const std::string& rule) {
      return InputError(std::string(option) + " '" + text + "': " + rule);
    };
    const std::size_t equals = text.find('=');
    if (equals == text.npos || equals == 0) throw refused("must be name=value or name=value,value,...");
    Setting setting{std::string(trimmed(std::string_view(text).substr(0, equals))), {}};
    split(std::string_view(text).substr(equals + 1), ',', fields);
    for (const std::string_view field : fields) {
      double value;
      if (!parse_number(field, value) || !std::isfinite(value))
        throw refused("'" + std::string(field) + "' is not a finite number");
      setting.values.push_back(value);
    }
    const auto same = [&](const Setting& s) { return s.name == setting.name; };
    if (std::ranges::any_of(settings, same)) throw refused("is set twice");
    settings.push_back(std::move(setting));
  }
  return settings;
}

void apply_settings(Material& material, const std::vector<Setting>& settings) {
  for (const Setting& setting : settings) {
    bool known = false;
    for (Term& term : material.terms) known |= apply(term, setting);
    if (!known) refuse(setting, "unknown parameter (" + known_parameters(setting.name, material) + ")");
  }
}

ParameterInfo parameter_named(const Material& material, const std::string& name, const std::string& option) {
  for (const Term& term : material.terms) {
    const ReflectanceInfo& table = info(term.form);
    if (table.anisotropic() && name == kTangent)
      return {.name = kTangent, .min = -180, .max = 180, .initial = 0, .usual_max = 180, .unit = "degrees"};
    if (table.anisotropic() && name == table.tied_name()) return table.shape[std::size_t(table.axes().along)];
    if (const int k = table.weight_index(name); k >= 0) return table.weights[std::size_t(k)];
    if (const int k = table.shape_index(name); k >= 0) return table.shape[std::size_t(k)];
  }
  throw InputError(option + " " + name + ": unknown parameter (" + known_parameters(name, material) + ")");
}

MaterialFile choose_material_file(const MaterialChoice& choice) {
  if (!choice.form.empty() + !choice.material.empty() + choice.made.has_value() != 1)
    throw InputError("give exactly one of MATERIAL, --form and --shader");
  const std::vector<Setting> settings = parse_settings(choice.set, "--set");
  MaterialFile file;
  if (!choice.material.empty()) {
    file = read_material_file(choice.material);
  } else {
    std::size_t channels = choice.made ? choice.made->channels.size() : 1;
    for (const Setting& setting : settings) channels = std::max(channels, setting.values.size());
    if (channels > kMostChannels)
      throw InputError("--set: " + plural(channels, "value") + " exceed the limit of " +
                       std::to_string(kMostChannels) + " channels of a material");
    if (choice.made && channels == choice.made->channels.size())
      file.material = *choice.made;
    else
      file.material = make_material(choice.made ? choice.made->terms.front().form : require_form(choice.form),
                                    channel_names(channels));
  }
  if (!settings.empty())
    file = {std::move(file.material), nullptr};  // no longer the material that was fitted or published
  apply_settings(file.material, settings);
  return file;
}

Material choose_material(const MaterialChoice& choice) {
  return choose_material_file(choice).material;
}

}  // namespace brdf::io
