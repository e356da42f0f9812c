// Bindings of `validate`, `judge` and `synth`.
#include "io/columns/supplied.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/material/settings.h"
#include "python/binding.h"
#include "python/callables.h"
#include "python/waiting.h"
#include "synth/instrument.h"
#include "validate/joint/judge_sampler.h"
#include "validate/report/judged.h"

namespace brdf::python {
namespace {

struct Judged {
  validate::ReportContent content;
};

io::Progress told_to(Watch& watch) {
  return [&watch](int done, int total) { watch.tell_or_throw(done, total); };
}

validate::Effort effort_of(const std::string& word) {
  if (word != "quick" && word != "full") throw InputError("--effort: " + word + ": must be quick or full");
  return word == "full" ? validate::Effort::full : validate::Effort::quick;
}

// Judges whole forms first, then files, materials and tables in their order.
Judged judge(const std::vector<std::string>& forms, const py::list& items, const std::string& effort,
             double max_theta, bool keep_fill, std::uint64_t seed, const std::string& quantity,
             const std::string& mirror_side, const std::string& layout, py::object progress) {
  const io::Supplied supplied = supplied_of(quantity, mirror_side, layout);
  const validate::Effort how = effort_of(effort);
  validate::check_max_theta(max_theta);
  Judged judged;
  validate::ReportContent& content = judged.content;
  content.max_theta = max_theta;
  content.keep_fill = keep_fill;
  for (const std::string& name : forms)
    content.subjects.push_back(validate::Subject::form(io::require_form(name)));
  for (const py::handle item : items) {
    if (py::isinstance<Samples>(item)) {
      const std::shared_ptr<const io::SampleTable> table = item.cast<const Samples&>().held;
      const py::gil_scoped_release unlocked;
      validate::add_table(content, *table);
    } else if (py::isinstance<py::tuple>(item)) {
      const auto [name, optics] = item.cast<std::pair<std::string, Optics>>();
      validate::add_material(content, name, optics.file);
    } else {
      const auto path = item.cast<std::string>();
      const py::gil_scoped_release unlocked;
      validate::add_file(content, path, supplied);
    }
  }
  const validate::CheckOptions options{how, max_theta, seed};
  Watch watch(std::move(progress));
  run_watched(watch, [&] { validate::judge_all(content, options, told_to(watch)); });
  return judged;
}

// Judges functions of the caller. A density per other measures than solid angle concerns both densities.
Judged judge_functions(const std::string& name, py::object eval, py::object sample, py::object pdf,
                       std::vector<std::string> channels, std::size_t randoms, bool gives_pdf,
                       bool gives_value, const std::string& returns, const std::string& value,
                       const std::string& density_of, const std::string& effort, std::uint64_t seed) {
  const auto of_eval = named<SampleValue>("returns", returns);
  if (of_eval == SampleValue::weight) throw InputError("returns " + returns + ": must be one of f, f*cos_i");
  const Callables functions{std::move(eval),
                            std::move(sample),
                            std::move(pdf),
                            std::move(channels),
                            randoms,
                            gives_pdf,
                            gives_value,
                            of_eval,
                            value.empty() ? std::nullopt : std::optional(named<SampleValue>("value", value)),
                            named<DensityOf>("density_of", density_of)};
  const validate::CheckOptions options{.effort = effort_of(effort), .seed = seed};
  Watch watch{py::none()};
  const validate::Subject subject = validate::Subject::material(
      name, material_of_functions(functions, watch.stop()), validate::OutsideFacts{});
  const auto sampler = sampler_of_functions(functions, watch.stop());
  Judged judged;
  std::vector<validate::Finding>& findings = judged.content.findings;
  run_watched(watch, [&] {
    // The interpreter's state of this thread is kept between the calls, which saves time in each of them.
    const py::gil_scoped_acquire state;
    const py::gil_scoped_release unlocked;
    findings = validate::judge_sampler(subject, *sampler, options);
  });
  for (std::size_t k = 0; k < findings.size(); ++k) {
    findings[k].subject = name;
    findings[k].check = validate::kSamplerChecks[k];
  }
  return judged;
}

Samples measure(const Optics& optics, synth::Instrument instrument, py::object progress) {
  Watch watch(std::move(progress));
  io::SampleTable table;
  run_watched(watch, [&] { table = synth::measure(optics.file.material, instrument, told_to(watch)); });
  return Samples(std::move(table));
}

Samples synth_samples(const Optics& optics, const std::string& grid, const std::vector<double>& theta_i,
                      double step, const std::optional<std::vector<double>>& azimuths, double blind_zone,
                      double aperture, double source_aperture, double noise, double noise_floor,
                      double saturation, bool clip_negatives, bool sigma_columns, std::uint64_t seed,
                      py::object progress) {
  synth::GridOptions directions{
      .parts = synth::grid_parts(grid),
      .theta_i = theta_i,
      .step = step,
      .azimuths = azimuths.value_or(synth::usual_azimuths(optics.file.material)),
      .blind_zone = blind_zone,
  };
  return measure(optics,
                 {std::move(directions), aperture, source_aperture, noise, noise_floor, saturation,
                  clip_negatives, sigma_columns, seed},
                 std::move(progress));
}

}  // namespace

void bind_judgements(py::module_& module) {
  py::class_<Judged>(module, "Judged")
      .def_property_readonly(
          "json", [](const Judged& j) { return io::to_text(validate::to_json(j.content.findings)); })
      .def_property_readonly("markdown",
                             [](const Judged& j) { return validate::to_markdown(j.content.findings); })
      .def_property_readonly("summary", [](const Judged& j) { return validate::summary(j.content.findings); })
      .def("html",
           [](const Judged& j, const std::vector<std::pair<std::string, std::string>>& pictures) {
             const py::gil_scoped_release unlocked;
             validate::ReportContent content = j.content;
             for (const auto& [name, png] : pictures) content.pictures.push_back({name, png});
             return validate::to_html(content);
           })
      .def("holds", [](const Judged& j, const std::vector<std::string>& required) {
        return validate::holds(j.content.findings, required);
      });
  module.def("check_required", &validate::check_required);
  module.def("validate", &judge);
  module.def("judge", &judge_functions);
  module.def("sampler_checks", [] {
    return std::vector<std::string>(std::begin(validate::kSamplerChecks), std::end(validate::kSamplerChecks));
  });
  module.def("synth", &synth_samples);
  module.def("table_of_material", [](const Optics& optics, const std::string& output) {
    const py::gil_scoped_release unlocked;
    return Samples(synth::table_of_material(optics.file.material, synth::cells_for(output)));
  });
  module.def("write_text", [](const std::string& path, const std::string& text) {
    io::check_targets({{"-o", path}});
    io::write_file_atomically(path, text);
  });
}

}  // namespace brdf::python
