#include "cli/steps/shader_proof.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

#include "cli/options/progress.h"
#include "cli/steps/shader_cost.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/files/numbers.h"
#include "io/files/provenance.h"

#ifdef BRDF_HAS_RENDER
#include "render/gpu/held.h"
#include "render/proof/shader_proof.h"
#endif

namespace brdf::cli {

#ifdef BRDF_HAS_RENDER

namespace {

// Names the numbers of a configuration by the tables of the form.
io::Json parameters_of(const Reflectance& form, const render::ProofWorst& w) {
  io::Json out = io::Json::object();
  const ReflectanceInfo& info = form.info();
  for (std::size_t k = 0; k < info.weights.size(); ++k)
    out[std::string(info.weights[k].name)] = w.at.weights[k][w.value % 3];
  for (std::size_t k = 0; k < info.shape.size(); ++k) out[std::string(info.shape[k].name)] = w.at.shape[k];
  return out;
}

io::Json to_json(const Reflectance& form, const render::ProofWorst& w) {
  const auto number = [](float x) {
    return std::isfinite(x) ? io::Json(x) : io::Json(io::short_number(x, 9));
  };
  return {{"value", w.value < 3 ? "f" : "f cos_i"},
          {"device", number(w.device)},
          {"library", number(w.library)},
          {"wi", std::vector(w.at.wi.begin(), w.at.wi.begin() + 3)},
          {"wo", std::vector(w.at.wo.begin(), w.at.wo.begin() + 3)},
          {"parameters", parameters_of(form, w)}};
}

void print_worst(const Reflectance& form, const render::ProofWorst& w) {
  const auto direction = [](const std::array<float, 4>& v) {
    return "(" + io::short_number(v[0], 9) + ", " + io::short_number(v[1], 9) + ", " +
           io::short_number(v[2], 9) + ")";
  };
  std::cout << "  furthest: " << (w.value < 3 ? "f" : "f cos_i") << " is " << io::short_number(w.device, 9)
            << " there, " << io::short_number(w.library, 9) << " rounded correctly, for light "
            << direction(w.at.wi) << ", viewer " << direction(w.at.wo);
  const io::Json parameters = parameters_of(form, w);
  for (const auto& [name, value] : parameters.items())
    std::cout << ", " << name << " " << io::short_number(value.get<double>(), 9);
  std::cout << '\n';
}

void print_json(std::span<const Reflectance> forms, const std::vector<render::ProofRow>& rows,
                const std::vector<ShaderCost>& costs, const std::string& device, bool software,
                std::uint64_t seed) {
  io::Json out;
  out["device"] = device;
  out["software"] = software;
  out["rows"] = io::Json::array();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const render::ProofRow& row = rows[k];
    out["rows"].push_back({{"form", row.form},
                           {"count", row.count},
                           {"differing", row.differing},
                           {"max_ulp", row.max_ulp},
                           {"beyond_tolerance", row.beyond_tolerance},
                           {"seconds_to_compile", row.seconds_to_compile},
                           {"passes", render::passes(row, software)}});
    if (row.differing > 0) out["rows"].back()["furthest"] = to_json(forms[k], row.worst);
  }
  for (const ShaderCost& c : costs)
    out["costs"].push_back({{"name", c.name}, {"operations", c.operations}, {"driver_ns", c.driver_ns}});
  out["provenance"] = io::to_json(io::provenance(seed));
  std::cout << io::to_text(out) << '\n';
}

void print_table(std::span<const Reflectance> forms, const std::vector<render::ProofRow>& rows,
                 const std::string& device, bool software, bool of_shader) {
  const char* rule = of_shader  ? ": compared with correctly rounded float"
                     : software ? ": every bit must agree"
                                : ": within the tolerance";
  std::cout << device << rule << '\n'
            << std::left << std::setw(28) << "form" << std::right << std::setw(14) << "configurations"
            << std::setw(18) << "differing values" << std::setw(12) << "max ulp" << std::setw(18)
            << "beyond tolerance" << '\n';
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const render::ProofRow& row = rows[k];
    const bool fails = !of_shader && !render::passes(row, software);
    std::cout << std::left << std::setw(28) << row.form << std::right << std::setw(14) << row.count
              << std::setw(18) << row.differing << std::setw(12) << row.max_ulp << std::setw(18)
              << row.beyond_tolerance << (fails ? "  FAILS" : "") << '\n';
    if (fails || row.beyond_tolerance > 0) print_worst(forms[k], row.worst);
    if (of_shader && row.differing > 0)
      std::cout << "  The causes were not examined. A usual one is a function that the driver rounds in its "
                   "own way, such as acos or pow.\n";
  }
}

void print_costs(const std::vector<ShaderCost>& costs) {
  if (costs.empty()) return;
  std::cout << '\n'
            << std::left << std::setw(28) << "cost of an evaluation" << std::right << std::setw(14)
            << "operations" << std::setw(18) << "ns on the driver" << '\n';
  for (const ShaderCost& c : costs)
    std::cout << std::left << std::setw(28) << c.name << std::right << std::setw(14) << c.operations
              << std::setw(18) << io::short_number(c.driver_ns, 3) << '\n';
}

}  // namespace

Exit validate_gpu(std::span<const Reflectance> all, std::uint64_t seed, bool json,
                  const LoadedShader* shader) {
  std::vector<Reflectance> forms;
  for (const Reflectance& form : all) forms.push_back(render::with_room(form));
  render::Device device;
  const bool software = render::is_software(device);
  const auto progress = progress_line("brdf validate: forms probed");
  int done = 0;
  const std::vector<render::ProofRow> rows = render::shader_proof(
      device, forms, {.seed = seed}, [&](const render::ProofRow&) { progress(++done, int(forms.size())); });
  std::vector<ShaderCost> costs;
#ifdef BRDF_HAS_SHADER
  if (shader)
    costs =
        shader_costs(device, forms.front(), std::string(shader->reflectance.info().name), shader->operations);
#endif
  if (json) {
    print_json(forms, rows, costs, device.name(), software, seed);
  } else {
    print_table(forms, rows, device.name(), software, shader != nullptr);
    print_costs(costs);
  }
  if (shader) return Exit::good;
  return std::ranges::all_of(rows, [&](const render::ProofRow& row) { return render::passes(row, software); })
             ? Exit::good
             : Exit::failed;
}

Reflectance with_room(const Material& material) {
  return render::with_room(material).terms.front().form;
}

#else

Reflectance with_room(const Material& material) {
  return material.terms.front().form;
}

Exit validate_gpu(std::span<const Reflectance>, std::uint64_t, bool, const LoadedShader*) {
  throw EnvironmentError("this build has no shaders: Vulkan was missing (see the messages of cmake)");
}

#endif

}  // namespace brdf::cli
