#include "cli/surface/surface.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/surface/option_table.h"
#include "io/files/json.h"

namespace brdf::cli {
namespace {

OptionSurface surface_of(const std::string& verb, const CLI::Option& option) {
  OptionSurface s;
  s.positional = option.get_positional();
  if (s.positional) {
    s.names = {option.get_name(true)};
  } else {
    for (const std::string& name : option.get_snames()) s.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) s.names.push_back("--" + name);
  }
  s.flag = option.get_items_expected_max() == 0;
  s.required = option.get_required();
  s.repeats = option.get_items_expected_max() > 1;
  s.description = option.get_description();
  s.initial = option.get_default_str();
  if (!s.positional) s.group = option.get_group();
  s.words = offered(option);
  if (s.flag) return s;
  s.takes = value_of(verb, option);
  const std::string type = option.get_type_name();
  s.value = type.substr(0, type.find_first_of(":{ "));
  if (s.value.empty() || s.takes >= Value::word)
    s.value = s.takes == Value::text ? "TEXT" : std::string(name_of(s.takes));
  std::ranges::transform(s.value, s.value.begin(), [](unsigned char c) { return char(std::toupper(c)); });
  return s;
}

// Positional arguments come first, then the groups in the order of the help.
std::size_t rank_of(const OptionSurface& option) {
  return option.positional ? 0 : 1 + std::size_t(find_named<Group>(option.group).value_or(Group::general));
}

}  // namespace

std::vector<VerbSurface> surface_of(const CLI::App& app) {
  std::vector<VerbSurface> verbs;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (verb->get_group().empty() || verb->get_allow_extras()) continue;  // hidden, or left out of this build
    VerbSurface s{verb->get_name(), verb->get_description(), verb->get_footer(), {}};
    for (const CLI::Option* option : verb->get_options())
      s.options.push_back(surface_of(verb->get_name(), *option));
    std::ranges::stable_sort(s.options, {}, &rank_of);
    verbs.push_back(std::move(s));
  }
  return verbs;
}

std::string surface_json(const CLI::App& app) {
  io::Json verbs = io::Json::array();
  for (const VerbSurface& verb : surface_of(app)) {
    io::Json options = io::Json::array();
    for (const OptionSurface& o : verb.options)
      options.push_back({{"names", o.names},
                         {"group", o.group},
                         {"positional", o.positional},
                         {"flag", o.flag},
                         {"required", o.required},
                         {"repeats", o.repeats},
                         {"value", o.value},
                         {"takes", o.flag ? "nothing" : std::string(name_of(o.takes))},
                         {"words", o.words},
                         {"default", o.initial},
                         {"description", o.description}});
    verbs.push_back({{"name", verb.name},
                     {"description", verb.description},
                     {"footer", verb.footer},
                     {"options", options}});
  }
  return io::to_text(io::Json{{"version", BRDF_VERSION}, {"verbs", verbs}});
}

}  // namespace brdf::cli
