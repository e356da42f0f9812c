// The products of a verb that each of its options affects, in one table per verb. An option without effect
// is refused, since the user would assume that it had one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace brdf::cli {

struct OptionOf {
  // Names separated by blanks: "--seed", or for a positional argument its name in capitals.
  std::string_view names;
  unsigned products;  // bits of the affected products
  // If not empty, the options have an effect only together with one of these: "--starts --bootstrap".
  std::string_view with = "";
};

// Throws std::logic_error unless the table has every option of the verb (except --help) exactly once. This
// check ensures that no new option is forgotten here.
void require_every_option(const CLI::App& verb, std::span<const OptionOf> table);

// Throws InputError for a given option that has no effect on the products of this run: `made` has the
// products' bits, `what` is their name in the message ("one table").
void refuse_without_effect(const CLI::App& verb, std::span<const OptionOf> table, unsigned made,
                           const std::string& what);

}  // namespace brdf::cli
