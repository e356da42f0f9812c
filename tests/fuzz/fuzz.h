// A fuzz target names a reader and what must hold of everything that it accepts. What it refuses it refuses
// with an InputError; any other exception is a finding.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "brdf/material.h"
#include "io/samples/samples.h"

namespace brdf::fuzz {

using Target = void (*)(std::string_view input);
std::map<std::string, Target, std::less<>>& targets();
// A change of an input that its target sees more of than of changed bytes.
using Mutator = std::string (*)(std::string_view input, std::uint32_t seed);
std::map<std::string, Mutator, std::less<>>& mutators();
struct Registered {
  Registered(const char* name, Target target, Mutator mutator = nullptr) {
    targets().emplace(name, target);
    if (mutator) mutators().emplace(name, mutator);
  }
};
// One input through a target. Aborts on a finding.
void run(Target target, std::string_view input);

// Aborts, with the rule that does not hold.
void require(bool holds, std::string_view rule);

// A path that holds these bytes until the next call; readers that go by suffixes see this one.
std::filesystem::path as_file(std::string_view bytes, const std::string& suffix = "");
// A folder of that name in which a file holds these bytes, beside what earlier calls put there.
std::filesystem::path folder_with(const std::string& name, const std::string& file = "",
                                  std::string_view bytes = "");
// A path to write to, the same every time.
std::filesystem::path output();

// Columns of one length, angles in their ranges, finite values, and a text that reads back to the same table.
void check_samples(io::SampleTable table, bool directions_only = false);
// Finite values, and a text that reads back to the same text.
void check_material(const Material& material);

}  // namespace brdf::fuzz
