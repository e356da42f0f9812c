// Which products of a verb its options have an effect on: one table for a verb. What is given without an
// effect is refused, for it seems to hold.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace brdf::cli {

struct OptionOf {
  std::string_view names;      // between blanks: "--seed", or of a positional one its name in capitals
  unsigned products;           // bits
  std::string_view with = "";  // they have an effect beside one of these alone: "--starts --bootstrap"
};

// Throws std::logic_error unless the table has every option of the verb (but --help) once: an option that is
// added to a verb cannot be forgotten here.
void require_every_option(const CLI::App& verb, std::span<const OptionOf> table);

// Throws InputError for an option that was given and has no effect on what the verb makes: `made` are the
// products' bits, `what` calls them ("one table").
void refuse_without_effect(const CLI::App& verb, std::span<const OptionOf> table, unsigned made,
                           const std::string& what);

}  // namespace brdf::cli
