#include <CLI/CLI.hpp>
#include <memory>

#include "cli/options/fit_options.h"
#include "cli/options/products.h"
#include "cli/options/progress.h"
#include "cli/program/study_files.h"
#include "cli/verb.h"
#include "fit/report/first_screen.h"
#include "work/files.h"

namespace brdf::cli {
namespace {

struct StudyCall {
  std::vector<std::string> samples;
  std::string output, tolerance, against;
  bool json = false, no_pictures = false;
  unsigned jobs = 1;
  fit::FitChoice choice;
};

constexpr OptionOf kStudyOptions[] = {
    {"SAMPLES --form --metric --anisotropic --per-channel --shape "
     "--free-scale --keep-fill --polarisation --repeats "
     "--quantity --mirror-side --layout --budget --max-theta --fix --start --bounds --tie "
     "--physical --robust --weights --starts --aperture "
     "--output --jobs --no-pictures --tolerance --against --json",
     1},
    {"--seed", 1, "--starts"}};

Exit run_study(const CLI::App& verb, const StudyCall& o) {
  refuse_without_effect(verb, kStudyOptions, 1, "a study");
  watch_for_interrupt();
  study::StudyOptions options =
      work::study_options(o.choice, !o.no_pictures, o.output, o.jobs, this_program());
  options.progress = progress_line("brdf study");
  if (!o.tolerance.empty()) options.sample.tolerance = fit::tolerance_of(o.tolerance);
  options.against = o.against;
  return study_files(work::sample_files(o.samples), std::move(options), o.json,
                     o.choice.options.supplied == io::Supplied());
}

}  // namespace

void add_study(CLI::App& app) {
  auto options = std::make_shared<StudyCall>();
  StudyCall& o = *options;
  CLI::App* verb = add_verb(app, Purpose::begin, "study",
                            "Fit and judge samples: a page for each, an overview of several");
  verb->add_option("SAMPLES", o.samples,
                   "Sample tables (CSV, MERL, ...; - for standard input), or folders of them")
      ->required();
  add_fit_options(*verb, o.choice);
  add_budget_option(*verb, o.choice);
  verb->add_option("-o,--output", o.output,
                   "Folder of the results: index.html, and with several samples a folder for each")
      ->required();
  verb->add_option("--jobs", o.jobs, "Samples studied at the same time")->check(CLI::Range(1u, 256u));
  add_pictures_option(*verb, o.no_pictures);
  add_tolerance_option(*verb, o.tolerance);
  verb->add_option("--against", o.against,
                   "Folder of an older study: the overview shows each parameter that left its interval "
                   "(default: the earlier results in the folder of -o)");
  verb->add_flag("--json", o.json, "JSON on stdout");
  verb->footer(
      "Samples whose results are in the folder, made from the same file by the same options, are kept.\n"
      "Examples: brdf study paint.csv -o paint\n"
      "          brdf study samples/*.csv --jobs 4 -o studied\n"
      "          brdf study samples/*.csv --tolerance 5% --against last_month/ -o studied\n"
      "          brdf study plane.csv --quantity BRF --mirror-side negative -o plane\n"
      "          brdf study samples/*.csv --form cook_torrance --no-pictures --json -o numbers");
  require_every_option(*verb, kStudyOptions);
  on_run(*verb, [options, verb] { return run_study(*verb, *options); });
}

}  // namespace brdf::cli
