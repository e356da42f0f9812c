// The albedo of a material, with the integral's bound and the fit's interval.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brdf/integrals.h"
#include "fit/assess/result.h"
#include "io/material/material_json.h"

namespace brdf::fit {

// What is asked, as on a command line.
struct AlbedoChoice {
  std::vector<double> theta;  // degrees
  double phi = 0, tolerance = 1e-6;
  std::string fixed = "i", rule = "automatic";
};

struct AlbedoRow {
  double theta;  // degrees
  std::string channel;
  AlbedoResult result;
  std::optional<Extent> interval;  // 95 %, of the fit that the material came from; an open end is infinite
};

// The integrals' options. Throws InputError on an angle, a tolerance or a word that is none.
AlbedoOptions options_of(const AlbedoChoice& choice);

// Every angle's channels in order.
std::vector<AlbedoRow> albedo_rows(const io::MaterialFile& file, const AlbedoChoice& choice);

// `{"form", "results": [{"theta", "phi", "fixed", "channel", "value", "error_bound", ...}], "provenance"}`.
io::Json to_json(const Material& material, const std::vector<AlbedoRow>& rows, const AlbedoChoice& choice);

}  // namespace brdf::fit
