#include "cli/fit_files.h"

#include <algorithm>
#include <iostream>

#include "cli/fit_options.h"
#include "cli/terminal.h"
#include "io/error.h"
#include "io/json.h"
#include "io/provenance.h"
#include "io/text.h"
#ifdef BRDF_HAS_RENDER
#include "render/job.h"
#endif

namespace brdf::cli {
namespace {

// A sphere of every new material, where this build and this machine can draw.
void draw_spheres(const std::vector<fit::BatchRow>& rows, const std::filesystem::path& folder) {
#ifdef BRDF_HAS_RENDER
  for (const fit::BatchRow& row : rows) {
    const std::filesystem::path picture = folder / (row.name + ".png");
    if (!row.error.empty() || was_interrupted() || (row.reused && std::filesystem::exists(picture))) continue;
    render::Job job;
    job.materials = {folder / (row.name + ".json")};
    job.output = picture;
    job.width = job.height = 256;
    try {
      for (const std::string& note : render::run(job).notes) Note() << picture.string() << ": " << note;
    } catch (const EnvironmentError& error) {
      Note() << "brdf: no pictures: " << error.what();
      return;
    }
  }
#else
  (void)rows, (void)folder;
#endif
}

}  // namespace

std::vector<fit::BatchRow> fit_files(const FileFits& files, const fit::FitChoice& choice,
                                     const fit::FitOptions& options,
                                     const std::function<void(const std::string&)>& progress) {
  std::vector<fit::BatchRow> rows =
      fit::run_batch(files.samples, fit::models_of(choice.form), options,
                     {.folder = files.folder,
                      .jobs = files.jobs,
                      .settings = io::provenance().version + fit::words_of(choice),
                      .first = files.first,
                      .count = files.count,
                      .progress = progress,
                      .spheres = files.pictures});
  if (files.pictures) draw_spheres(rows, files.folder);
  return rows;
}

Exit summarise(const std::vector<fit::BatchRow>& rows, const std::filesystem::path& folder, bool json) {
  fit::write_summary(rows, folder);
  const bool good = std::ranges::all_of(rows, [](const fit::BatchRow& row) { return fit::usable(row); });
  if (json)
    std::cout << io::to_text(fit::to_json(rows, folder));
  else
    std::cout << io::printable((folder / "summary.csv").string()) << ", "
              << io::printable((folder / "summary.html").string()) << '\n';
  if (std::ranges::any_of(rows, &fit::BatchRow::environment_failed)) return Exit::environment;
  return good ? Exit::good : Exit::failed;
}

}  // namespace brdf::cli
