#include "browser/session.h"

#include <array>
#include <cmath>
#include <numeric>

#include "brdf/integrals.h"
#include "fit/choice.h"
#include "interop/programs.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/parallel.h"
#include "io/files/provenance.h"
#include "io/files/shell.h"
#include "io/files/text.h"
#include "io/material/glsl.h"
#include "io/material/info_json.h"
#include "io/material/material_json.h"
#include "io/material/settings.h"
#include "study/sample.h"

namespace brdf::browser {
namespace {

using io::Json;
using io::JsonPlace;

bool has(const JsonPlace& request, const char* key) {
  return request.has(key) && !request.value()[key].is_null();
}

std::string text_at(const JsonPlace& request, const char* key) {
  return has(request, key) ? request.at(key).text() : "";
}

// A form with the ranges of sliders: usual values, not the whole domain.
Json form_json(const ReflectanceInfo& form) {
  Json parameters = Json::array();
  for (const bool colour : {true, false})
    for (const ParameterInfo& p : colour ? form.weights : form.shape)
      parameters.push_back({{"symbol", p.name},
                            {"name", p.doc},
                            {"low", usual_min(p)},
                            {"high", std::min(p.max, p.usual_max)},
                            {"default", p.initial},
                            {"colour", colour}});
  return {
      {"name", form.name}, {"title", form.family}, {"fittable", form.fittable()}, {"parameters", parameters}};
}

Json about() {
  Json forms = Json::array(), metrics = Json::array();
  for (const std::vector<Reflectance>& family : families())
    for (const Reflectance& form : family) forms.push_back(form_json(info(form)));
  for (const std::string_view metric : kNames<fit::Metric>) metrics.push_back(metric);
  return {{"version", io::provenance().version},
          {"forms", forms},
          {"metrics", metrics},
          {"files", Json::array()}};
}

// The material of a request, and the options that choose it in a terminal.
struct Chosen {
  Material material;
  std::string words;
};

Chosen material_of(const JsonPlace& request) {
  if (has(request, "material"))
    return {io::material_from_json(request.at("material")).material, " material.json"};
  io::MaterialChoice choice;
  choice.form = request.at("form").text();
  std::string words = " --form " + choice.form;
  if (has(request, "parameters"))
    for (const auto& [name, values] : request.at("parameters").value().items()) {
      std::vector<std::string> numbers;
      for (const Json& value : values) {
        if (!value.is_number())
          throw InputError("$.parameters." + name + ": " + value.dump() + " must be a number");
        numbers.push_back(io::to_text(value.get<double>()));
      }
      choice.set.push_back(name + "=" + io::joined(numbers, ","));
      words += " --set " + choice.set.back();
    }
  return {io::choose_material(choice), words};
}

// Angles of incidence of the curve of the albedo, degrees.
std::vector<double> angles_of_curve() {
  std::vector<double> thetas;
  for (double theta = 0; theta < 90; theta += 5) thetas.push_back(theta);
  thetas.push_back(89);
  return thetas;
}

// The curves of the channels: the albedo at each angle, null if it is not known, and whether the least value
// within the bound of its error is above 1 somewhere.
struct Albedos {
  Json curves = Json::array();
  bool above_one = false;
};

Albedos albedos_of(const Material& material, const std::vector<double>& thetas) {
  Albedos out;
  for (std::size_t c = 0; c < material.channels.size(); ++c) out.curves.push_back(Json::array());
  AlbedoOptions options;
  options.tolerance = 1e-5;
  options.max_evaluations = 200'000;
  for (const double theta : thetas) {
    const std::vector<AlbedoResult> found = directional_albedo(material, degrees(theta), degrees(0), options);
    for (std::size_t c = 0; c < found.size(); ++c) {
      out.curves[c].push_back(found[c].converged ? io::finite_or_null(found[c].value) : Json(nullptr));
      out.above_one = out.above_one || (found[c].converged && found[c].value - found[c].error_bound > 1);
    }
  }
  return out;
}

// The mean over the channels of f_r cos_o in the plane of incidence, for theta_o from -89 degrees, which is
// towards the light, to 89.
Json lobe_of(const Material& material, double theta_i) {
  const Vec3<double> wi = direction(degrees(theta_i), degrees(180));
  Json theta = Json::array(), values = Json::array();
  std::vector<double> f(material.channels.size());
  for (int theta_o = -89; theta_o <= 89; ++theta_o) {
    const Vec3<double> wo = direction(degrees(std::abs(theta_o)), degrees(theta_o < 0 ? 180 : 0));
    eval(material, wi, wo, f);
    theta.push_back(theta_o);
    const double sum = std::accumulate(f.begin(), f.end(), 0.0);
    values.push_back(io::finite_or_null(sum / double(f.size()) * wo.z));
  }
  return {{"theta_i", theta_i}, {"theta_o", theta}, {"f_cos", values}};
}

Json names_of(const std::vector<study::File>& files) {
  Json names = Json::array();
  for (const study::File& file : files) names.push_back(file.name);
  return names;
}

}  // namespace

char* Session::put(const std::string& name, std::size_t size) {
  std::string& bytes = inputs_[name];
  bytes.assign(size, '\0');
  return bytes.data();
}

Json Session::study(const JsonPlace& request) {
  const std::string name = request.at("table").text();
  const auto input = inputs_.find(name);
  if (input == inputs_.end()) throw InputError(name + ": the page has no file of this name");
  fit::FitChoice choice;
  if (const std::string form = text_at(request, "form"); !form.empty()) choice.form = form;
  if (!text_at(request, "metric").empty()) choice.options.metric = request.at("metric").named<fit::Metric>();
  study::SampleOptions options;
  options.models = fit::models_of(choice.form);
  options.fit = fit::options_of(choice);
  options.fit_words = fit::words_of(choice);
  if (has(request, "tolerance")) options.tolerance = request.at("tolerance").number(0, 1e6);
  // A name that only looks like standard input is a file here.
  std::string command = "brdf study " + (name == "-" ? "./-" : io::shell_file(name)) + options.fit_words;
  if (options.tolerance) command += " --tolerance " + io::to_text(*options.tolerance);
  command += " --output studied";
  io::record_command(command);
  int steps = 0;
  constexpr std::array kNext{"fitting", "judging the properties", "drawing", "writing the page"};
  static_assert(kNext.size() == study::kSteps);
  const auto report = [&](const std::string& text) {
    listener_.progress(text, double(steps) / study::kSteps);
  };
  report("reading");
  options.progress = report;
  options.fitted = listener_.fitted;
  study::SampleStudy made = study::study_sample({name, input->second}, name, options,
                                                [&] { report(kNext.at(std::size_t(steps++))); });
  files_ = std::move(made.files);
  return {{"row", made.row},
          {"command", command},
          {"assumptions", made.assumptions},
          {"files", names_of(files_)}};
}

Json Session::material(const JsonPlace& request) {
  const Chosen chosen = material_of(request);
  const std::vector<double> theta = angles_of_curve();
  std::vector<std::string> angles;
  for (const double t : theta) angles.push_back(io::to_text(t));
  const std::string command = "brdf albedo" + chosen.words + " --theta " + io::joined(angles, ",");
  io::record_command(command);
  const Albedos albedos = albedos_of(chosen.material, theta);
  const Json lobes{lobe_of(chosen.material, 30), lobe_of(chosen.material, 65)};
  files_.push_back({study::kMaterial, io::to_text(io::to_json(chosen.material))});
  Json no_shader = nullptr;
  try {
    files_.push_back({study::kShader, io::glsl_source(chosen.material)});
  } catch (const InputError& e) {
    no_shader = e.what();
  }
  return {{"command", command},
          {"channels", chosen.material.channels},
          {"theta", theta},
          {"albedo", albedos.curves},
          {"above_one", albedos.above_one},
          {"lobes", lobes},
          {"no_shader", no_shader},
          {"files", names_of(files_)}};
}

Json Session::exported(const JsonPlace& request) {
  const Chosen chosen = material_of(request);
  const std::string command = "brdf export" + chosen.words + " --to gltf";
  io::record_command(command);
  const interop::Exported made = interop::export_to(interop::gltf(), chosen.material, "material", false);
  files_.push_back({"material.gltf", made.text});
  return {{"command", command}, {"statement", interop::in_words(made)}, {"files", names_of(files_)}};
}

Json Session::answer(const std::string& text) {
  io::limit_threads(1);
  files_.clear();
  try {
    const Json json = io::parse_json(text, "request");
    const JsonPlace request(json, "request");
    const std::string wanted = request.at("do").text();
    if (wanted == "about") return about();
    if (wanted == "study") return study(request);
    if (wanted == "material") return material(request);
    if (wanted == "export") return exported(request);
    throw InputError("$.do: '" + wanted + "' is not one of about, study, material, export");
  } catch (const std::bad_alloc&) {
    files_.clear();
    return {{"error", "the memory of the page is full: use the program for a table of this size"}};
  } catch (const std::exception& e) {
    files_.clear();
    return {{"error", e.what()}};
  }
}

}  // namespace brdf::browser
