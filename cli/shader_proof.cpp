#include "cli/shader_proof.h"

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "cli/progress.h"
#include "cli/shader_cost.h"
#include "io/error.h"
#include "io/json.h"
#include "io/numbers.h"
#include "io/provenance.h"

#ifdef BRDF_HAS_RENDER
#include "render/gpu/held.h"
#include "render/proof/shader_proof.h"
#endif

namespace brdf::cli {

#ifdef BRDF_HAS_RENDER

namespace {

void print_json(const std::vector<render::ProofRow>& rows, const std::vector<ShaderCost>& costs,
                const std::string& device, bool software, std::uint64_t seed) {
  io::Json out;
  out["device"] = device;
  out["software"] = software;
  out["rows"] = io::Json::array();
  for (const render::ProofRow& row : rows)
    out["rows"].push_back({{"form", row.form},
                           {"count", row.count},
                           {"differing", row.differing},
                           {"max_ulp", row.max_ulp},
                           {"beyond_tolerance", row.beyond_tolerance},
                           {"seconds_to_compile", row.seconds_to_compile},
                           {"passes", render::passes(row, software)}});
  for (const ShaderCost& c : costs)
    out["costs"].push_back({{"name", c.name}, {"operations", c.operations}, {"driver_ns", c.driver_ns}});
  out["provenance"] = io::to_json(io::provenance(seed));
  std::cout << io::to_text(out) << '\n';
}

void print_table(const std::vector<render::ProofRow>& rows, const std::string& device, bool software,
                 bool of_shader) {
  const char* rule = of_shader
                         ? ": beside correctly rounded float; what differs is the driver's own functions"
                     : software ? ": every bit must agree"
                                : ": within the tolerance";
  std::cout << device << rule << '\n'
            << std::left << std::setw(28) << "form" << std::right << std::setw(14) << "configurations"
            << std::setw(18) << "differing values" << std::setw(12) << "max ulp" << std::setw(18)
            << "beyond tolerance" << '\n';
  for (const render::ProofRow& row : rows)
    std::cout << std::left << std::setw(28) << row.form << std::right << std::setw(14) << row.count
              << std::setw(18) << row.differing << std::setw(12) << row.max_ulp << std::setw(18)
              << row.beyond_tolerance << (of_shader || render::passes(row, software) ? "" : "  FAILS")
              << '\n';
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

Exit validate_gpu(std::span<const Reflectance> forms, std::uint64_t seed, bool json,
                  const LoadedShader* shader) {
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
    print_json(rows, costs, device.name(), software, seed);
  } else {
    print_table(rows, device.name(), software, shader != nullptr);
    print_costs(costs);
  }
  if (shader) return Exit::good;
  return std::all_of(rows.begin(), rows.end(),
                     [&](const render::ProofRow& row) { return render::passes(row, software); })
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
