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

// Adds --microsurface and the options that only it has.
void add_microsurface_options(CLI::App& verb, micro::SampleSettings& settings);

// Traces the surface with parameters given as name=value (`set`), as `brdf synth` has them. Throws
// InputError, and EnvironmentError where this build has no ray tracer.
io::SampleTable trace_microsurface(micro::SampleSettings settings, const std::vector<std::string>& set);

// `brdf validate --microsurface`: theory against simulation, as a table or as JSON on stdout. kFailed where a
// statement that is exact does not hold. Throws EnvironmentError where this build has no ray tracer.
Exit validate_microsurface(const micro::TheoryOptions& options, bool json);

}  // namespace brdf::cli
