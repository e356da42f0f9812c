#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>

#include "cli/options/options.h"
#include "cli/options/shader_options.h"
#include "cli/options/terminal.h"
#include "cli/verb.h"
#include "fit/assess/albedo.h"
#include "fit/assess/derived.h"
#include "fit/assess/reported.h"
#include "fit/report/budget.h"
#include "io/files/json.h"
#include "io/files/numbers.h"

namespace brdf::cli {
namespace {

struct AlbedoCall {
  MaterialOptions material;
  fit::AlbedoChoice albedo;
  bool json = false;
};

void print(std::ostream& out, const fit::AlbedoRow& row) {
  out << std::setw(8) << row.theta << "  " << std::left << std::setw(10) << row.channel << std::right
      << std::setprecision(15) << std::setw(20) << row.result.value << std::setprecision(2) << "  +- "
      << std::left << std::setw(9) << row.result.error_bound << std::right << std::setw(9)
      << row.result.evaluations << "  " << name_of(row.result.rule)
      << (row.result.converged ? "" : "  NOT CONVERGED");
  if (row.interval) out << "  " << fit::extent_text(*row.interval, 5);
  out << std::setprecision(6) << '\n';
}

// Prints which errors the intervals contain and, with a budget, the parts of every standard uncertainty.
void print_scope(std::ostream& out, const io::MaterialFile& file, const std::vector<fit::AlbedoRow>& rows) {
  if (!fit::knowledge_of(file.fit).has_budget()) {
    out << "intervals: " << fit::kScatterOnly << '\n';
    return;
  }
  out << "intervals: the budget of the fit is in them\n";
  for (const fit::AlbedoRow& row : rows)
    if (row.uncertainty)
      out << fit::uncertainty_text(
                 "the albedo at " + io::short_number(row.theta) + " degrees (" + row.channel + ")",
                 row.result.value, *row.uncertainty)
          << '\n';
}

Exit run_albedo(const AlbedoCall& o) {
  fit::options_of(o.albedo);  // throws before any file is read
  const io::MaterialFile file = choose_material_file(o.material, "albedo");
  const std::vector<fit::AlbedoRow> rows = fit::albedo_rows(file, o.albedo);
  if (o.json) {
    std::cout << io::to_text(fit::to_json(file.material, rows, o.albedo));
  } else {
    const bool fitted = std::ranges::any_of(rows, [](const auto& r) { return r.interval.has_value(); });
    PlainText out;
    out << "   theta  channel                  albedo     bound    evaluations  rule"
        << (fitted ? "  95 % interval of the fit" : "") << '\n';
    for (const fit::AlbedoRow& row : rows) print(out, row);
    if (fitted) print_scope(out, file, rows);
  }
  const bool converged = std::ranges::all_of(rows, [](const auto& r) { return r.result.converged; });
  return converged ? Exit::good : Exit::failed;
}

}  // namespace

void add_albedo(CLI::App& app) {
  auto options = std::make_shared<AlbedoCall>();
  CLI::App* verb = add_verb(app, Purpose::judge, "albedo",
                            "Compute the directional albedo of a material, with an error bound");
  add_material_options(*verb, options->material);
  add_material_argument(*verb, options->material);
  verb->add_option("--theta", options->albedo.theta,
                   "Polar angles of the fixed direction, degrees, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->required();
  verb->add_option("--phi", options->albedo.phi, "Azimuth of the fixed direction, degrees")
      ->capture_default_str();
  verb->add_option("--fixed", options->albedo.fixed, "Fixed direction: i (light) or o (viewer)")
      ->check(CLI::IsMember({"i", "o"}))
      ->capture_default_str();
  verb->add_option("--tolerance", options->albedo.tolerance, "Relative error to reach")
      ->capture_default_str();
  offer_names<Rule>(
      verb->add_option("--rule", options->albedo.rule, "Quadrature rule: automatic, pole, slope or adaptive")
          ->capture_default_str());
  verb->add_flag("--json", options->json, "JSON on stdout");
  verb->footer(
      "For a material that `fit` has written, the 95 % interval of the fit is printed, too (not with "
      "--set).\n"
      "Exit code 1 if an integral did not converge. At 90 degrees the value is computed at a cosine of\n"
      "1e-12: for a form that grows without limit towards grazing, that cosine decides the value.\n"
      "Examples: brdf albedo --form cook_torrance --set kd=0 --set ks=1 --set f0=1 --set alpha=1 --theta "
      "0,60\n"
      "          brdf albedo fitted.json --theta 45 --phi 30 --fixed o --rule adaptive "
      "--tolerance "
      "1e-8 --json\n"
      "          brdf albedo --shader disney.brdf --set roughness=0.3 --theta 0,60,85");
  on_run(*verb, [options] { return run_albedo(*options); });
}

}  // namespace brdf::cli
