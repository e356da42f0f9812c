#ifdef BRDF_HAS_RENDER
#include "cli/steps/render_parity.h"

#include <iostream>

#include "io/files/error.h"
#include "io/files/json.h"
#include "io/material/settings.h"
#include "render/proof/parity.h"

namespace brdf::cli {

Exit run_parity(const std::vector<std::string>& names, bool all, const std::vector<Reflectance>& others,
                bool json) {
  std::vector<Reflectance> forms;
  for (const std::string& name : names) forms.push_back(io::require_form(name));
  if (all) forms.assign(catalogue().begin(), catalogue().end());
  forms.insert(forms.end(), others.begin(), others.end());
  if (forms.empty()) throw InputError("--parity needs --all, --form or --shader");
  render::Device device;
  const auto print_row = [&](const render::ParityRow& row) {
    if (json) return;
    std::cout << row.form << ", " << row.parameters << ", " << row.gbuffer_bits << " bits: relative MSE "
              << row.difference.rel_mse << ", coverage mismatch " << 100 * row.difference.coverage_mismatch
              << " %" << (render::passes(row) ? "" : "  FAILS") << std::endl;
  };
  bool good = true;
  io::Json out;
  out["provenance"] = io::to_json(io::provenance());
  out["rows"] = io::Json::array();
  for (const render::ParityRow& row : render::parity(device, forms, 512, print_row)) {
    io::Json r;
    r["form"] = row.form;
    r["parameters"] = row.parameters;
    r["gbuffer_bits"] = row.gbuffer_bits;
    r["rel_mse"] = row.difference.rel_mse;
    r["bound"] = render::parity_bound(row.gbuffer_bits);
    r["coverage_mismatch"] = row.difference.coverage_mismatch;
    out["rows"].push_back(r);
    good = good && render::passes(row);
  }
  if (json) std::cout << io::to_text(out);
  return good ? Exit::good : Exit::failed;
}

}  // namespace brdf::cli
#endif
