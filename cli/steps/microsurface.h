// The traced microsurfaces of `brdf synth` and `brdf validate`.
#pragma once

#include <string>
#include <vector>

#include "cli/verb.h"
#include "micro/samples.h"
#include "micro/theory.h"

namespace CLI {
class App;
}

namespace brdf::cli {

// Adds --microsurface and its own options.
void add_microsurface_options(CLI::App& verb, micro::SampleSettings& settings);

// Traces the surface with parameters given as name=value (`set`) for `brdf synth`. Throws InputError for
// invalid parameters, and EnvironmentError if this build has no ray tracer or no device for --gpu.
io::SampleTable trace_microsurface(micro::SampleSettings settings, const std::vector<std::string>& set);

// Compares theory and simulation for `brdf validate --microsurface`, and prints a table or JSON on stdout.
// Returns Exit::failed if an exact statement does not hold. Throws EnvironmentError if this build has no ray
// tracer.
Exit validate_microsurface(const micro::TheoryOptions& options, bool json);

}  // namespace brdf::cli
