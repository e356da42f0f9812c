// A fuzz target names a reader and the conditions that everything it accepts must meet. The reader must
// refuse other inputs with an InputError; any other exception is a finding.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "brdf/material.h"
#include "io/samples/samples.h"

namespace brdf::fuzz {

using Target = void (*)(std::string_view input);
std::map<std::string, Target, std::less<>>& targets();
// Changes an input in such a way that the target accepts the result more often than after changes of bytes.
using Mutator = std::string (*)(std::string_view input, std::uint32_t seed);
std::map<std::string, Mutator, std::less<>>& mutators();
struct Registered {
  Registered(const char* name, Target target, Mutator mutator = nullptr) {
    targets().emplace(name, target);
    if (mutator) mutators().emplace(name, mutator);
  }
};
// Passes one input to a target. Aborts on a finding.
void run(Target target, std::string_view input);

// Aborts with the text of the rule if the rule does not hold.
void require(bool holds, std::string_view rule);

// Returns a path that holds these bytes until the next call. The path ends in `suffix`, for readers that
// check it.
std::filesystem::path as_file(std::string_view bytes, const std::string& suffix = "");
// Returns a folder of this name in which `file` holds these bytes, in addition to the files of earlier
// calls.
std::filesystem::path folder_with(const std::string& name, const std::string& file = "",
                                  std::string_view bytes = "");
// Returns a path to write to, the same for every call.
std::filesystem::path output();

// Requires columns of one length, angles in their ranges, finite values, and a text that reads back to the
// same table.
void check_samples(io::SampleTable table, bool directions_only = false);
// Requires finite values, and a text that reads back to the same text.
void check_material(const Material& material);

}  // namespace brdf::fuzz
