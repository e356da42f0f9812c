// Options that several verbs share.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "brdf/names.h"
#include "cli/surface/values.h"
#include "io/columns/supplied.h"
#include "io/files/error.h"
#include "io/material/settings.h"
#include "io/samples/arrange.h"

namespace CLI {
class App;
}

namespace brdf::cli {

// Throws InputError if an option or an argument of the parsed verb has an empty value, as an unset
// variable of a shell leaves it.
void refuse_empty_values(const CLI::App& verb);

// Adds an option that takes one word. `set` throws InputError for an invalid word.
CLI::Option* add_word_option(CLI::App& verb, const std::string& name, std::string_view initial,
                             std::function<void(const std::string&)> set, const std::string& description);

// Adds an option that takes one of the enum's names. The names are appended to the description.
template <class Enum>
void add_named_option(CLI::App& verb, const std::string& name, Enum& value, const std::string& description) {
  const auto set = [&value, name](const std::string& word) {
    const auto found = find_named<Enum>(word);
    if (!found) throw InputError(name + " " + word + ": must be one of " + known_names<Enum>());
    value = *found;
  };
  offer_names<Enum>(
      add_word_option(verb, name, name_of(value), set, description + ": " + known_names<Enum>()));
}

// Returns the forms of a repeated --form, or all forms for --all. Throws InputError if neither is given, or
// if a name is unknown.
std::vector<Reflectance> forms_of(const std::vector<std::string>& names, bool all);

// Adds --form, --material and --set, identical in every verb that takes one material.
void add_material_options(CLI::App& verb, io::MaterialChoice& choice);
// Adds the positional argument MATERIAL, which sets `file`. `option` names the older option with the same
// meaning; both together are refused.
CLI::Option* add_material_argument(CLI::App& verb, std::string& file, const std::string& option,
                                   const std::string& description);

// Adds -q and --quiet to every verb of the program.
void add_quiet_option(CLI::App& app);

// Adds --polarisation and --repeats, identical in every verb that reads samples to use them.
void add_arrangement_options(CLI::App& verb, io::Arrangement& arrangement);

// Adds --keep-fill, identical in every verb that reads samples.
void add_keep_fill_option(CLI::App& verb, bool& keep_fill);

// Adds --quantity, --mirror-side and --layout, identical in every verb that reads samples.
void add_supplied_options(CLI::App& verb, io::Supplied& supplied);

// Adds an option that takes a number of bytes above 0, optionally with K, M or G (powers of 1024).
void add_memory_option(CLI::App& verb, std::uint64_t& bytes, const std::string& name,
                       const std::string& description);
// Adds --memory-limit.
void add_memory_option(CLI::App& verb, std::uint64_t& bytes, const std::string& of = "device memory");

// Makes every numeric option of all verbs parse numbers as files do: whole words, decimal, finite, and
// within the range of the option's type.
void require_plain_numbers(CLI::App& app);

// Adds an option that may be repeated and takes one word each time (otherwise it would also take a file that
// follows).
void add_repeated_option(CLI::App& verb, const std::string& name, std::vector<std::string>& values,
                         const std::string& description);

}  // namespace brdf::cli
