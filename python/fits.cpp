// Fits with the functions of `brdf fit`; options have the same names and values.
#include <sstream>

#include "fit/choice.h"
#include "fit/file_batch.h"
#include "fit/report/html.h"
#include "fit/report/report.h"
#include "io/files/output.h"
#include "io/files/provenance.h"
#include "python/binding.h"
#include "python/waiting.h"

namespace brdf::python {
namespace {

// A result together with its table and options, which reports need.
struct Fitted {
  fit::FitResult result;
  io::SampleTable table;
  fit::FitOptions options;
};

fit::FitChoice choice_of(const std::string& form, const std::string& metric, const std::string& weights,
                         const std::string& robust, const std::vector<std::string>& fix,
                         const std::vector<std::string>& start, const std::vector<std::string>& bounds,
                         const std::vector<std::string>& tie, bool physical, bool anisotropic,
                         bool per_channel, bool free_scale, bool keep_fill, const std::string& polarisation,
                         const std::string& repeats, const std::string& quantity,
                         const std::string& mirror_side, const std::string& layout, double max_theta,
                         std::optional<double> aperture, const std::string& budget, int starts,
                         std::uint64_t seed, const std::string& shape) {
  const fit::FitOptions options{.metric = named<fit::Metric>("--metric", metric),
                                .weighting = named<fit::Weighting>("--weights", weights),
                                .max_theta = max_theta,
                                .anisotropic = anisotropic,
                                .per_channel = per_channel,
                                .free_scale = free_scale,
                                .keep_fill = keep_fill,
                                .arrangement = arrangement_of(polarisation, repeats),
                                .supplied = supplied_of(quantity, mirror_side, layout),
                                .tie = tie,
                                .random_starts = starts,
                                .seed = seed,
                                .aperture = aperture};
  return {form, robust, budget, fix, start, bounds, physical, shape, options};
}

// Returns the samples prepared for a fit, with a name for reports.
fit::Samples prepared(const Samples& samples, const fit::FitOptions& options) {
  io::SampleTable table = samples.table();
  if (table.source.empty()) table.source = "samples";
  return fit::arranged(std::move(table), options);
}

std::unique_ptr<Fitted> fit_samples(const Samples& samples, const fit::FitChoice& choice,
                                    py::object progress) {
  auto fitted = std::make_unique<Fitted>();
  fitted->options = fit::options_of(choice);
  Watch watch(std::move(progress));
  fitted->options.interrupted = &watch.stop();
  run_watched(watch, [&] {
    fit::Samples prepared_samples = prepared(samples, fitted->options);
    fitted->result = fit::fit(prepared_samples, fit::models_of(choice.form), fitted->options,
                              [&](const std::string& what) { watch.tell(what); });
    fitted->table = std::move(prepared_samples.table);
  });
  fitted->options.interrupted = nullptr;
  return fitted;
}

Optics material_of(const Fitted& f, std::size_t k) {
  const fit::FormFit& form = f.result.ranking.at(k);
  if (!form.solved()) return {{form.material, nullptr}};
  return {{form.material, fit::material_block(form, f.result, f.table, f.options)}};
}

std::string text_of(const Fitted& f) {
  std::ostringstream out;
  fit::print(out, f.result, f.table, f.options);
  return out.str();
}

// Writes the files of `brdf fit FILES -o FOLDER` into the folder, except for the pictures.
std::string fit_files(const std::vector<std::string>& files, const std::string& folder, unsigned jobs,
                      const fit::FitChoice& choice, py::object progress) {
  fit::FitOptions options = fit::options_of(choice);
  Watch watch(std::move(progress));
  options.interrupted = &watch.stop();
  std::vector<fit::BatchRow> rows;
  run_watched(watch, [&] {
    rows = fit::run_batch(files, fit::models_of(choice.form), options,
                          {.folder = folder,
                           .jobs = jobs,
                           .settings = io::provenance().version + fit::words_of(choice),
                           .progress = [&](const std::string& what) { watch.tell(what); }});
    fit::write_summary(rows, folder);
  });
  return io::to_text(fit::to_json(rows, folder));
}

}  // namespace

void bind_fits(py::module_& module) {
  py::class_<fit::FitChoice>(module, "FitChoice").def(py::init(&choice_of));
  py::class_<Fitted>(module, "Fitted")
      .def_property_readonly(
          "json", [](const Fitted& f) { return io::to_text(fit::to_json(f.result, f.table, f.options)); })
      .def_property_readonly("text", &text_of)
      .def_property_readonly("interrupted", [](const Fitted& f) { return f.result.interrupted; })
      .def_property_readonly("recommended", [](const Fitted& f) { return f.result.recommended; })
      .def("usable",
           [](const Fitted& f, std::size_t k) { return fit::usable(f.result.ranking.at(k).verdict); })
      .def("material", &material_of)
      .def("html", [](const Fitted& f) {
        const py::gil_scoped_release unlocked;
        return fit::html_report(f.result, f.table, f.options);
      });
  module.def("fit", &fit_samples);
  module.def("fit_files", &fit_files);
}

}  // namespace brdf::python
