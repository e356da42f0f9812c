#include "work/files.h"

#include "io/files/error.h"
#include "io/files/provenance.h"
#include "io/formats/read.h"
#ifdef BRDF_HAS_RENDER
#include "render/job.h"
#endif

namespace brdf::work {
namespace {

// Draws a sphere of every new material, if this build and this machine can render.
void draw_spheres(const std::vector<fit::BatchRow>& rows, const std::filesystem::path& folder,
                  const Caller& caller) {
#ifdef BRDF_HAS_RENDER
  for (const fit::BatchRow& row : rows) {
    const std::filesystem::path picture = folder / (row.name + ".png");
    if (!row.error.empty() || caller.stops() || (row.reused && std::filesystem::exists(picture))) continue;
    render::Job job;
    job.materials = {folder / (row.name + ".json")};
    job.output = picture;
    job.width = job.height = 256;
    try {
      for (const std::string& note : render::run(job).notes) caller.say(picture.string() + ": " + note);
    } catch (const EnvironmentError& error) {
      caller.say(std::string("brdf: no pictures: ") + error.what());
      return;
    }
  }
#else
  (void)rows, (void)folder, (void)caller;
#endif
}

}  // namespace

std::vector<fit::BatchRow> fit_files(const FileFits& files, const fit::FitChoice& choice,
                                     const fit::FitOptions& options, const Caller& caller,
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
  if (files.pictures) draw_spheres(rows, files.folder, caller);
  return rows;
}

fit::Samples samples_to_fit(const std::string& file, const fit::FitOptions& options, const Caller& caller) {
  fit::Samples samples =
      fit::arranged(io::read_samples(file, io::supplied_for(options.supplied, options.arrangement)), options);
  for (const std::string& warning : samples.table.warnings) caller.say("brdf fit: " + file + ": " + warning);
  return samples;
}

study::StudyOptions study_options(const fit::FitChoice& choice, bool pictures,
                                  const std::filesystem::path& folder, unsigned jobs, const Caller& caller) {
  study::StudyOptions options;
  options.folder = folder;
  options.sample.models = fit::models_of(choice.form);
  options.sample.fit = fit_options(choice, jobs, caller.interrupted);
  options.sample.fit_words = fit::words_of(choice);
  options.settings = io::provenance().version + options.sample.fit_words;
  options.sample.pictures = pictures;
  options.jobs = jobs;
  return options;
}

}  // namespace brdf::work
