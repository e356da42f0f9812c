#include <CLI/CLI.hpp>
#include <memory>

#include "cli/options/options.h"
#include "cli/options/products.h"
#include "cli/options/progress.h"
#include "cli/verb.h"
#include "render/job.h"

namespace brdf::cli {
namespace {

struct MapsCall {
  std::string kind;
  std::filesystem::path folder;
  int size = 256;
  std::uint64_t seed = 1;
};

enum MapsProduct : unsigned { kSeeded = 1, kLookup = 2 };
constexpr OptionOf kMapsOptions[] = {
    {"KIND --output", kSeeded | kLookup},
    {"--size --seed", kSeeded},
};

Exit run_maps(const CLI::App& verb, const MapsCall& o) {
  const bool lookup = o.kind == "lookup";
  refuse_without_effect(verb, kMapsOptions, lookup ? kLookup : kSeeded, o.kind);
  const auto progress = progress_line("brdf maps: pictures");
  lookup ? render::write_lookup_pictures(o.folder, progress)
         : render::write_maps(o.kind, o.size, o.seed, o.folder, progress);
  return Exit::good;
}

}  // namespace

void add_maps(CLI::App& app) {
  auto o = std::make_shared<MapsCall>();
  CLI::App* verb = add_verb(app, Purpose::look, "maps",
                            "Write seeded texture maps, or the lookup article's tables, as PNG");
  offer(verb->add_option(
                "KIND", o->kind,
                "rusty_metal (albedo, normal, roughness, metallic), tiles (albedo), or lookup (the article's "
                "factors and their product)")
            ->required(),
        {"rusty_metal", "tiles", "lookup"})
      ->check(CLI::IsMember({"rusty_metal", "tiles", "lookup"}));
  verb->add_option("--size", o->size, "Pixels along each side")
      ->check(CLI::Range(8, 4096))
      ->capture_default_str();
  verb->add_option("--seed", o->seed, "Seed of the random numbers")->capture_default_str();
  verb->add_option("-o,--output", o->folder, "Folder to write into; created if needed")->required();
  require_every_option(*verb, kMapsOptions);
  verb->footer(
      "Examples: brdf maps tiles --size 512 --seed 2 -o tiles\n"
      "          brdf maps lookup -o tables");
  on_run(*verb, [o, verb] { return run_maps(*verb, *o); });
}

}  // namespace brdf::cli
