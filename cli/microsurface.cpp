#include "cli/microsurface.h"

#include <CLI/CLI.hpp>

#include "cli/parameters.h"
#include "cli/progress.h"
#include "io/error.h"

namespace brdf::cli {

void add_microsurface_options(CLI::App& verb, micro::SampleSettings& s) {
  const char* group = "Traced microsurface";
  verb.add_option(
          "--microsurface", s.surface,
          "Trace rays on explicit microgeometry instead: gaussian or lambert_gaussian (--set alpha, or "
          "alpha_x and alpha_y), mirror_grooves (alpha), lambert_grooves (sigma); mirrors take eta, "
          "Lambertian facets rho; --theta-i, --azimuths and --seed apply")
      ->group(group);
  verb.add_option("--bounces", s.bounces, "Reflections to follow; 1: single reflection")
      ->capture_default_str()
      ->group(group);
  verb.add_flag("--orders", s.orders, "One channel for each order of reflection: 1, 2, 3 and more")
      ->group(group);
  verb.add_option("--cell", s.cell, "Side of the outgoing cells, degrees (default by the lobe's width)")
      ->group(group);
  verb.add_option("--min-power", s.min_power, "Leave out cells with less than this share of the light")
      ->capture_default_str()
      ->group(group);
  verb.add_option("--surfaces", s.surfaces,
                  "Independent surfaces, at least 8 (default 16; mirror grooves 512)")
      ->group(group);
  verb.add_option(
          "--rays", s.rays,
          "Rays per surface and direction (default 262144; mirror grooves 8192, Lambertian facets 4096)")
      ->group(group);
}

#ifdef BRDF_HAS_MICRO

io::SampleTable trace_microsurface(micro::SampleSettings settings, const std::vector<std::string>& set) {
  for (const Setting& one : parse_settings(set, "--set")) {
    if (one.values.size() != 1) throw InputError("--set " + one.name + ": a microsurface takes one value");
    settings.parameters.emplace_back(one.name, one.values.front());
  }
  return micro::trace_samples(settings, progress_line("brdf synth: surfaces traced"));
}

std::vector<micro::TheoryRow> microsurface_rows(const micro::TheoryOptions& options) {
  return micro::compare_with_theory(options, progress_line("brdf validate: parts"));
}

#else

namespace {
const char* const kMissing =
    "this build has no traced microsurfaces: Embree was missing (see the messages of cmake)";
}

io::SampleTable trace_microsurface(micro::SampleSettings, const std::vector<std::string>&) {
  throw EnvironmentError(kMissing);
}

std::vector<micro::TheoryRow> microsurface_rows(const micro::TheoryOptions&) {
  throw EnvironmentError(kMissing);
}

#endif

}  // namespace brdf::cli
