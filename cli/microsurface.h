// The traced microsurfaces of `brdf synth` and `brdf validate`.
#pragma once

#include <string>
#include <vector>

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

// Theory against simulation. Throws EnvironmentError where this build has no ray tracer.
std::vector<micro::TheoryRow> microsurface_rows(const micro::TheoryOptions& options);

}  // namespace brdf::cli
