#ifdef BRDF_HAS_RENDER
#include "cli/options/environment_options.h"

#include <CLI/CLI.hpp>

#include "cli/surface/values.h"
#include "render/job.h"
#include "render/light/formula.h"
#include "render/light/points.h"

namespace brdf::cli {

void add_environment_options(CLI::App& verb, render::Job& job, int& samples) {
  offer_names<render::Formula>(verb.add_option(
      "--environment", job.environment,
      "Light from all around: a latitude-longitude picture (.hdr, .exr), or " +
          known_names<render::Formula>() + ". Materials without a scene are lit by nothing else"));
  verb.add_flag("--hard-light", job.hard_light,
                "Light a material without a scene by one directional light instead of the studio")
      ->excludes("--environment");
  verb.add_option("--rotate", job.rotation,
                  "Degrees by which the environment is turned about the vertical axis")
      ->check(CLI::Range(-360.0f, 360.0f));
  verb.add_option("--samples", samples,
                  "Random directions per pixel of an environment's light, rounded up to whole runs of " +
                      std::to_string(render::kRun))
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
}

}  // namespace brdf::cli
#endif
