// Materials: construction, reading, writing, evaluation, pictures.
#include "brdf/targets.h"
#include "fit/assess/albedo.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/material/glsl.h"
#include "io/material/info_json.h"
#include "io/material/settings.h"
#include "io/page/sphere/page.h"
#include "io/page/sphere/still.h"
#include "python/batches.h"
#include "python/binding.h"
#include "python/waiting.h"

namespace brdf::python {
namespace {

std::string list_json(std::span<const Reflectance> list) {
  io::Json json = io::Json::array();
  for (const Reflectance& form : list) json.push_back(io::to_json(info(form)));
  return io::to_text(json);
}

// Returns a material of the form. Without `channels`, the settings determine the number of channels.
Optics material_of_form(const std::string& form, const std::vector<std::string>& set,
                        const std::optional<std::vector<std::string>>& channels) {
  if (!channels) return {io::choose_material_file({.form = form, .set = set})};
  Material material = make_material(io::require_form(form), *channels);
  io::apply_settings(material, io::parse_settings(set, "--set"));
  io::check_material(material, "channels");
  return {{std::move(material), nullptr}};
}

Optics with_settings(Optics optics, const std::vector<std::string>& set) {
  const std::vector<io::Setting> settings = io::parse_settings(set, "--set");
  if (!settings.empty()) optics.file.fit = nullptr;  // the material is no longer the fitted one
  io::apply_settings(optics.file.material, settings);
  return optics;
}

Optics with_channels(Optics optics, const std::vector<std::string>& channels) {
  Material& material = optics.file.material;
  if (channels.size() != material.channels.size())
    throw InputError("channels: " + std::to_string(channels.size()) + " names for " +
                     io::plural(material.channels.size(), "channel"));
  material.channels = channels;
  io::check_material(material, "channels");
  return optics;
}

Optics sum_of(const Optics& a, const Optics& b) {
  Material material = a.file.material;
  const Material& other = b.file.material;
  if (material.channels != other.channels) throw InputError("a sum's materials must have the same channels");
  material.terms.insert(material.terms.end(), other.terms.begin(), other.terms.end());
  return {{std::move(material), nullptr}};
}

std::vector<std::string> form_names(const Optics& optics) {
  std::vector<std::string> names;
  for (const Term& term : optics.file.material.terms) names.emplace_back(info(term.form).name);
  return names;
}

// Returns true if dimension d + 1 continues dimension d in this array.
bool goes_on(const py::array& a, py::ssize_t d) {
  return a.strides(d) == a.strides(d + 1) * a.shape(d + 1);
}

// Returns the arrays with a common shape of as few dimensions as their strides permit.
template <class T>
PairArrays<T> merged(const py::array& wi, const py::array& wo, py::array& out) {
  PairArrays<T> arrays{{},
                       static_cast<const char*>(wi.data()),
                       static_cast<const char*>(wo.data()),
                       static_cast<char*>(out.mutable_data()),
                       {},
                       {},
                       {}};
  const py::ssize_t last = wi.ndim() - 1;
  arrays.wi_strides.of_last = wi.strides(last);
  arrays.wo_strides.of_last = wo.strides(last);
  arrays.out_strides.of_last = out.strides(last);
  const auto set = [&](auto where) {
    where(arrays.wi_strides.of_pair, wi);
    where(arrays.wo_strides.of_pair, wo);
    where(arrays.out_strides.of_pair, out);
  };
  for (py::ssize_t d = 0; d < last; ++d) {
    const std::size_t size = std::size_t(wi.shape(d));
    if (d > 0 && goes_on(wi, d - 1) && goes_on(wo, d - 1) && goes_on(out, d - 1)) {
      arrays.shape.back() *= size;
      set([&](auto& strides, const py::array& a) { strides.back() = a.strides(d); });
    } else {
      arrays.shape.push_back(size);
      set([&](auto& strides, const py::array& a) { strides.push_back(a.strides(d)); });
    }
  }
  return arrays;
}

template <class T>
void evaluate_as(const Optics& optics, const py::array& wi, const py::array& wo, py::array& out,
                 bool cosine) {
  const PairArrays<T> arrays = merged<T>(wi, wo, out);
  const py::gil_scoped_release unlocked;
  evaluate<T>(optics.file.material, arrays, cosine);
}

// Evaluates arrays wi, wo (..., 3) and out (..., channels), all of one shape (broadcast) and one type,
// aligned.
void evaluate_arrays(const Optics& optics, const py::array& wi, const py::array& wo, py::array out,
                     bool cosine) {
  const bool single = py::isinstance<py::array_t<float>>(out);
  const auto fits = [&](const py::array& a, std::size_t last) {
    return (single ? py::isinstance<py::array_t<float>>(a) : py::isinstance<py::array_t<double>>(a)) &&
           a.ndim() == out.ndim() && a.ndim() > 0 && a.shape(a.ndim() - 1) == py::ssize_t(last) &&
           std::equal(a.shape(), a.shape() + a.ndim() - 1, out.shape());
  };
  if (!fits(wi, 3) || !fits(wo, 3) || !fits(out, optics.file.material.channels.size()))
    throw py::value_error("arrays of other shapes or types than were agreed");
  if (single)
    evaluate_as<float>(optics, wi, wo, out, cosine);
  else
    evaluate_as<double>(optics, wi, wo, out, cosine);
}

// Returns (value, bound, evaluations, converged, rule, low, high) of every angle's channels.
py::list albedo(const Optics& optics, fit::AlbedoChoice choice) {
  fit::options_of(choice);
  std::vector<fit::AlbedoRow> rows;
  Watch watch(py::none{});
  run_watched(watch, [&] {
    const std::vector<double> all = choice.theta;
    for (const double theta : all) {
      if (watch.stop()) return;
      choice.theta = {theta};
      for (fit::AlbedoRow& row : fit::albedo_rows(optics.file, choice)) rows.push_back(std::move(row));
    }
  });
  py::list out;
  for (const fit::AlbedoRow& row : rows) {
    const fit::Extent interval = row.interval.value_or(fit::Extent{});
    out.append(py::make_tuple(row.result.value, row.result.error_bound, row.result.evaluations,
                              row.result.converged, name_of(row.result.rule), interval.low, interval.high));
  }
  return out;
}

// Returns GLSL. Whole shaders have no functions to include; GlslContent explains the options. Functions to
// include are named by `given`, by the material, or by its form.
std::string glsl(const Optics& optics, const std::string& to, bool material, bool include,
                 const std::string& given) {
  if (to != "glsl" && to != "glsl-es") throw InputError("--to: " + to + ": must be glsl or glsl-es");
  const io::MaterialFile& file = optics.file;
  if (!material && !given.empty()) throw InputError("name: a form alone has no function of a material");
  std::string name = given;
  if (include && name.empty())
    name = file.name.empty() ? std::string(info(file.material.terms.front().form).name) : file.name;
  return io::glsl_source(file.material, {.material = material,
                                         .whole = !include,
                                         .dialect = to == "glsl-es" ? GlslDialect::es : GlslDialect::vulkan,
                                         .name = name,
                                         .guarded = include});
}

py::bytes sphere(const Optics& optics, int side) {
  std::string png;
  {
    const py::gil_scoped_release unlocked;
    const Material& material = optics.file.material;
    png = io::sphere::studio_pictures(material, io::sphere::studio_exposure(material), side).whole;
  }
  return png;
}

}  // namespace

void bind_materials(py::module_& module) {
  py::class_<Optics> optics(module, "Optics");
  optics.def_property_readonly("channels", [](const Optics& o) { return o.file.material.channels; })
      .def_property_readonly("forms", &form_names)
      .def_property_readonly("json", [](const Optics& o) { return io::to_text(io::to_json(o.file)); })
      .def_property_readonly("anisotropic", [](const Optics& o) { return is_anisotropic(o.file.material); })
      .def_property_readonly("obstacle",
                             [](const Optics& o) { return io::sphere::obstacle(o.file.material); })
      .def("with_settings", &with_settings)
      .def("with_channels", &with_channels)
      .def("plus", &sum_of)
      .def("save",
           [](const Optics& o, const std::string& path) {
             io::check_targets({{"-o", path}});
             io::write_material_file(path, o.file);
           })
      .def("evaluate", &evaluate_arrays)
      .def("albedo",
           [](const Optics& o, std::vector<double> theta, double phi, std::string fixed, double tolerance,
              std::string rule) {
             return albedo(o, {std::move(theta), phi, tolerance, std::move(fixed), std::move(rule)});
           })
      .def("glsl", &glsl)
      .def("sphere", &sphere);
  module.def("material_of_form", &material_of_form);
  module.def("load", [](const std::string& path) {
    return Optics{io::read_material_file(std::filesystem::path(path))};
  });
  module.def("material_of_json", [](const std::string& text, const std::string& name) {
    return Optics{io::read_material_file(io::Content{name, text})};
  });
  module.def("forms_json", [] { return list_json(catalogue()); });
  module.def("targets_json", [] { return list_json(targets()); });
}

}  // namespace brdf::python
