#include "cli/steps/microsurface.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

#include "cli/options/progress.h"
#include "cli/surface/values.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/files/provenance.h"
#include "io/material/settings.h"

namespace brdf::cli {

void add_microsurface_options(CLI::App& verb, micro::SampleSettings& s) {
  CLI::Option* surface = verb.add_option(
      "--microsurface", s.surface,
      "gaussian or lambert_gaussian (--set alpha, or alpha_x and alpha_y), mirror_grooves (alpha), "
      "lambert_grooves (sigma); mirrors take eta, Lambertian facets rho; --theta-i, --azimuths and --seed "
      "apply");
#ifdef BRDF_HAS_MICRO
  offer(surface, micro::surface_names());
#endif
  const std::vector<CLI::Option*> details{
      verb.add_option("--bounces", s.bounces, "Largest number of reflections of a ray; 1: single reflection")
          ->capture_default_str(),
      verb.add_flag("--orders", s.orders, "One channel for each order of reflection: 1, 2, 3 and more"),
      verb.add_option("--cell", s.cell,
                      "Side of the outgoing cells, degrees (default: from the width of the lobe)"),
      verb.add_option("--min-power", s.min_power, "Leave out cells with less than this share of the light")
          ->capture_default_str(),
      verb.add_option("--surfaces", s.surfaces,
                      "Independent surfaces, at least 8 (default 16; mirror grooves 512)"),
      verb.add_option("--size", s.size, "Cells along each side of a height field's period")
          ->capture_default_str(),
      verb.add_option(
          "--rays", s.rays,
          "Rays per surface and direction (default 262144; mirror grooves 8192, Lambertian facets 4096)"),
      verb.add_flag("--gpu", s.gpu, "Follow the rays over mirrors on the Vulkan device, in double"),
      verb.add_option("--threads", s.threads, "Number of threads; the samples do not depend on it")
          ->check(CLI::Range(1, 1024))
          ->capture_default_str()};
  for (CLI::Option* detail : details) detail->needs(surface);
  // Options of materials and of the instrument do not apply to a traced surface.
  for (const char* name : {"MATERIAL", "--form", "--material", "--grid", "--step", "--blind-zone",
                           "--aperture", "--source-aperture", "--noise", "--noise-floor", "--saturation",
                           "--clip-negatives", "--sigma-columns"}) {
    for (CLI::Option* other : verb.get_options())
      if (other->check_name(name)) surface->excludes(other);
  }
}

#ifdef BRDF_HAS_MICRO

io::SampleTable trace_microsurface(micro::SampleSettings settings, const std::vector<std::string>& set) {
  for (const io::Setting& one : io::parse_settings(set, "--set")) {
    if (one.values.size() != 1) throw InputError("--set " + one.name + ": a microsurface takes one value");
    settings.parameters.emplace_back(one.name, one.values.front());
  }
  return micro::trace_samples(settings, progress_line("brdf synth: surfaces traced"));
}

namespace {

void print_json(const std::vector<micro::TheoryRow>& rows, std::uint64_t seed) {
  io::Json out;
  out["rows"] = io::Json::array();
  for (const micro::TheoryRow& row : rows) {
    io::Json one{{"surface", row.surface},  // a number that does not exist (NaN) is written as null
                 {"quantity", row.quantity},
                 {"simulated", row.simulated},
                 {"standard_error", row.standard_error},
                 {"model", row.model},
                 {"z", row.z},
                 {"exact", row.exact},
                 {"holds", micro::holds(row)}};
    if (!row.cause.empty()) one["cause"] = row.cause;
    out["rows"].push_back(std::move(one));
  }
  out["provenance"] = io::to_json(io::provenance(seed));
  std::cout << io::to_text(out) << '\n';
}

void print_number(double number, int width, int digits) {
  if (std::isnan(number))
    std::cout << std::setw(width) << '-';
  else
    std::cout << std::setw(width) << std::setprecision(digits) << number;
}

// Prints the number of exact statements that hold, and the largest z among the exact statements.
void print_summary(const std::vector<micro::TheoryRow>& rows) {
  const auto size = [](double z) { return std::isnan(z) ? 0 : std::abs(z); };
  int exact = 0, failed = 0;
  const micro::TheoryRow* worst = nullptr;
  for (const micro::TheoryRow& row : rows) {
    if (!row.exact) continue;
    ++exact;
    failed += !micro::holds(row);
    if (worst == nullptr || size(row.z) > size(worst->z)) worst = &row;
  }
  std::cout << "\nexact statements: " << exact << ", failed: " << failed << " (|z| above " << micro::kExactZ
            << ")";
  if (worst != nullptr)
    std::cout << "; greatest |z| " << size(worst->z) << ": " << worst->surface << ", " << worst->quantity;
  std::cout << "\napproximations: the difference from the model is the finding; the text under each table "
               "gives the cause\n";
}

void print_table(const std::vector<micro::TheoryRow>& rows) {
  std::string surface, cause;
  const auto print_cause = [&] {
    if (!cause.empty()) std::cout << "  cause of the differences: " << cause << '\n';
    cause.clear();
  };
  for (const micro::TheoryRow& row : rows) {
    if (row.surface != surface) {
      print_cause();
      surface = row.surface;
      std::cout << '\n'
                << std::left << std::setw(76) << surface << std::right << std::setw(11) << "simulated"
                << std::setw(10) << "error" << std::setw(11) << "model" << std::setw(9) << "z" << '\n';
    }
    if (!row.cause.empty()) cause = row.cause;
    std::cout << "  " << std::left << std::setw(74) << row.quantity << std::right;
    print_number(row.simulated, 11, 5);
    print_number(row.standard_error, 10, 2);
    print_number(row.model, 11, 5);
    print_number(row.z, 9, 3);
    std::cout << (!row.exact ? "" : micro::holds(row) ? "  exact, holds" : "  exact, FAILS") << '\n';
  }
  print_cause();
  print_summary(rows);
}

}  // namespace

Exit validate_microsurface(const micro::TheoryOptions& options, bool json) {
  const std::vector<micro::TheoryRow> rows =
      micro::compare_with_theory(options, progress_line("brdf validate: parts"));
  if (json)
    print_json(rows, options.seed);
  else
    print_table(rows);
  return std::ranges::all_of(rows, micro::holds) ? Exit::good : Exit::failed;
}

#else

namespace {
const char* const kMissing =
    "this build has no traced microsurfaces: Vulkan was missing (see the messages of cmake)";
}

io::SampleTable trace_microsurface(micro::SampleSettings, const std::vector<std::string>&) {
  throw EnvironmentError(kMissing);
}

Exit validate_microsurface(const micro::TheoryOptions&, bool) {
  throw EnvironmentError(kMissing);
}

#endif

}  // namespace brdf::cli
