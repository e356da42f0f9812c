#include "study/sample.h"

#include <cmath>

#include "fit/fit.h"
#include "fit/report/first_screen.h"
#include "fit/report/plain_words.h"
#include "fit/report/report.h"
#include "io/files/error.h"
#include "io/formats/read.h"
#include "io/material/glsl.h"
#include "io/material/material_json.h"
#include "study/page.h"
#include "study/proofs.h"
#include "validate/form/checks.h"
#include "validate/report/report.h"

namespace brdf::study {
namespace {

using io::Json;

// The number of findings with each outcome.
Json counts(const std::vector<validate::Finding>& findings) {
  Json json = Json::object();
  for (const std::string_view name : kNames<validate::Outcome>) json[std::string(name)] = 0;
  for (const validate::Finding& f : findings) {
    Json& count = json[std::string(name_of(f.outcome))];
    count = count.get<int>() + 1;
  }
  return json;
}

Json failed_checks(const std::vector<validate::Finding>& findings) {
  Json names = Json::array();
  for (const validate::Finding& f : findings)
    if (f.outcome == validate::Outcome::fail) names.push_back(f.check);
  return names;
}

Json undecided_checks(const std::vector<validate::Finding>& findings) {
  Json names = Json::array();
  for (const validate::Finding& f : findings)
    if (f.outcome == validate::Outcome::undecided) names.push_back(f.check);
  return names;
}

// The estimated parameters with the intervals that the page shows, for the comparison with another run.
Json estimates_of(const fit::FormFit& fit) {
  Json list = Json::array();
  for (const fit::Estimate& e : fit.estimates) {
    const fit::NamedParameter parameter = fit::named(fit, e);
    if (parameter.repeats || e.status == fit::Status::unidentified) continue;
    const bool wide = fit.lack_of_fit.beyond_scatter && std::isfinite(e.with_lack_of_fit.low);
    const fit::Extent extent = wide ? e.with_lack_of_fit : fit::Extent{e.low, e.high};
    list.push_back({{"name", parameter.symbol},
                    {"channel", e.channel},
                    {"value", io::finite_or_null(e.value)},
                    {"low", io::finite_or_null(extent.low)},
                    {"high", io::finite_or_null(extent.high)}});
  }
  return list;
}

// Warnings that users should consider before they use the fit.
Json warnings_of(const fit::FitResult& result) {
  Json texts = Json::array();
  for (const std::string& fault : fit::sheet_in_words(result))
    texts.push_back("The measurements: " + fault + ".");
  for (const io::Remark& remark : fit::remarks_on(result.ranking.front()))
    if (remark.mark >= io::Mark::unknown && remark.mark <= io::Mark::bad) texts.push_back(remark.text);
  return texts;
}

Json row_of(const Findings& found, const std::string& name, const SampleOptions& options) {
  const bool relative = options.fit.free_scale;
  const fit::FormFit& best = found.fit.ranking.front();
  Json row{{"name", name}, {"file", found.table.source}, {"error", nullptr}};
  row["rows"] = found.table.rows();
  row["channels"] = found.table.channels;
  row["form"] = best.form;
  row["verdict"] = name_of(best.verdict);
  row["mark"] = name_of(fit::mark_of(best));
  row["usable"] = fit::usable(best.verdict);
  row["statement"] = fit::verdict_sentence(best);
  row["warnings"] = warnings_of(found.fit);
  row["median_relative_error"] = io::finite_or_null(best.median_relative_error);
  row["cross_validated_error"] =
      io::finite_or_null(best.left_out ? best.left_out->errors.median : fit::kUnknown);
  row["residual_over_scatter"] =
      io::finite_or_null(best.lack_of_fit.residual_over_scatter.value_or(fit::kUnknown));
  row["largest_albedo"] =
      best.largest_albedo ? io::finite_or_null(best.largest_albedo->value) : Json(nullptr);
  row["keeps_energy"] =
      best.largest_albedo && !relative ? Json(!best.largest_albedo->breaks_energy()) : Json(nullptr);
  row["weakly_determined"] = fit::weakly_determined(best);
  row["recommended"] = fit::usable(found.fit.ranking[found.fit.recommended].verdict)
                           ? Json(found.fit.ranking[found.fit.recommended].form)
                           : Json(nullptr);
  row["tolerance"] = options.tolerance ? Json(*options.tolerance) : Json(nullptr);
  row["within_tolerance"] =
      options.tolerance ? Json(fit::is_within(best, *options.tolerance)) : Json(nullptr);
  row["estimates"] = estimates_of(best);
  row["next"] = fit::next_step(found.fit);
  row["sheet"] = counts(found.sheet.findings);
  row["sheet_undecided"] = undecided_checks(found.sheet.findings);
  row["sheet_failed"] = failed_checks(found.sheet.findings);
  row["properties"] = counts(found.properties);
  row["properties_failed"] = failed_checks(found.properties);
  row["no_pictures"] = found.spheres.missing.empty() ? Json(nullptr) : Json(found.spheres.missing);
  return row;
}

void add_spheres(const Spheres& spheres, std::vector<File>& files) {
  if (!spheres.missing.empty()) return;
  files.push_back({kStudio, spheres.studio.whole});
  files.push_back({kSmallStudio, spheres.studio.half});
  files.push_back({kMeasured, spheres.whole.measured});
  files.push_back({kFitted, spheres.whole.fitted});
  files.push_back({kDifference, spheres.whole.difference});
}

// Adds the material, its properties, its pictures and its shader. Returns false if the run was interrupted.
bool add_material(Findings& found, const SampleOptions& options, const Step& step, std::vector<File>& files) {
  const fit::FormFit& best = found.fit.ranking.front();
  // Commands use the name that the file has in the page's folder.
  found.subject = validate::Subject::material(kMaterial, best.material);
  found.properties = validate::run_checks({*found.subject}, {});
  mark_proofs_of_material(*found.subject, found.properties);
  step();
  const auto stops = [&] { return options.fit.stop(); };
  if (options.pictures && !stops())
    found.spheres = draw(found.table, best.material, stops);
  else
    found.spheres.missing = "disabled by --no-pictures";
  if (stops()) return false;
  step();
  const Json block = fit::material_block(best, found.fit, found.table, options.fit);
  files.push_back({kMaterial, io::to_text(io::to_json(io::MaterialFile{best.material, block}))});
  files.push_back({kProperties, io::to_text(validate::to_json(found.properties))});
  try {
    files.push_back({kShader, io::glsl_source(best.material)});
  } catch (const InputError& error) {
    found.no_shader = error.what();
  }
  add_spheres(found.spheres, files);
  return true;
}

}  // namespace

SampleStudy study_sample(io::Content content, const std::string& name, const SampleOptions& options,
                         const Step& step) {
  Findings found;
  found.table =
      io::read_samples(std::move(content), io::supplied_for(options.fit.supplied, options.fit.arrangement));
  found.name = std::filesystem::path(found.table.source).filename().string();
  fit::Samples samples = fit::arranged(std::move(found.table), options.fit);
  const std::vector<std::string> assumptions = samples.table.assumptions;
  step();
  found.fit = fit::fit(samples, options.models, options.fit, options.progress);
  found.table = std::move(samples.table);
  found.sheet = std::move(samples.sheet);
  step();
  SampleStudy out;
  out.interrupted = found.fit.interrupted;
  out.assumptions = assumptions;
  if (out.interrupted) return out;
  const fit::FormFit& best = found.fit.ranking.front();
  if (options.fitted && best.solved()) options.fitted(fit::verdict_sentence(best));
  out.files.push_back({kSheet, io::to_text(validate::to_json(found.sheet.findings))});
  out.files.push_back({kFit, io::to_text(fit::to_json(found.fit, found.table, options.fit))});
  out.interrupted = best.solved() && !add_material(found, options, step, out.files);
  if (out.interrupted) return out;
  for (const File& file : out.files) found.files.push_back(file.name);
  out.row = row_of(found, name, options);
  out.files.push_back({kPage, sample_page(found, options)});
  return out;
}

}  // namespace brdf::study
