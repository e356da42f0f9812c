#include "cli/options/products.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>

#include "cli/surface/option_table.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::cli {
namespace {

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string_view> fields;
  io::split_blanks(text, fields);
  return {fields.begin(), fields.end()};
}

bool is_given(const CLI::App& verb, std::string_view name) {
  const CLI::Option* const option = verb.get_option_no_throw(std::string(name));
  return option && option->count() > 0;
}

}  // namespace

void require_every_option(const CLI::App& verb, std::span<const OptionOf> table) {
  std::vector<std::string> listed, known;
  for (const OptionOf& row : table)
    for (std::string& name : words(row.names)) listed.push_back(std::move(name));
  for (const CLI::Option* option : verb.get_options())
    if (const std::string name = table_name(*option); name != "--help") known.push_back(name);
  std::ranges::sort(listed);
  std::ranges::sort(known);
  std::vector<std::string> wrong;
  std::ranges::set_symmetric_difference(listed, known, std::back_inserter(wrong));
  if (!wrong.empty())
    throw std::logic_error("brdf " + verb.get_name() +
                           ": in its options or in their table alone: " + io::joined(wrong));
}

void refuse_without_effect(const CLI::App& verb, std::span<const OptionOf> table, unsigned made,
                           const std::string& what) {
  for (const OptionOf& row : table) {
    const std::vector<std::string> beside = words(row.with);
    const bool stands_alone = !beside.empty() && std::ranges::none_of(beside, [&](const std::string& other) {
      return is_given(verb, other);
    });
    for (const std::string& name : words(row.names)) {
      if (!is_given(verb, name)) continue;
      if ((row.products & made) == 0)
        throw InputError(name + ": has no effect on " + what + ": leave it out");
      if (stands_alone)
        throw InputError(name + ": has no effect without " + io::joined(beside, " or ") + ": leave it out");
    }
  }
}

}  // namespace brdf::cli
