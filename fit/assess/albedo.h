// The albedo of a material, with the error bound of the integral and the confidence interval of the fit.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brdf/integrals.h"
#include "fit/assess/result.h"
#include "io/material/material_json.h"

namespace brdf::fit {

// The requested directions and integration settings, as given on a command line.
struct AlbedoChoice {
  std::vector<double> theta;  // degrees
  double phi = 0, tolerance = 1e-6;
  std::string fixed = "i", rule = "automatic";
};

struct AlbedoRow {
  double theta;  // degrees
  std::string channel;
  AlbedoResult result;
  // The standard uncertainty with its parts; only if the budget of the instrument is known.
  std::optional<Combined> uncertainty;
  std::optional<Extent> interval;  // 95 %, from the fit that produced the material; an open end is infinite
};

// Returns the options of the integrals. Throws InputError if an angle, a tolerance or a name is not valid.
AlbedoOptions options_of(const AlbedoChoice& choice);

// Returns the directional albedo of every channel at polar angles of incidence in degrees, to a relative
// error of 1e-8, at which albedos can be subtracted from each other: first all channels at the first angle.
std::vector<double> albedos_at(const Material& material, std::span<const double> theta);

// Computes the albedo of every channel at each angle, in the order of the angles.
std::vector<AlbedoRow> albedo_rows(const io::MaterialFile& file, const AlbedoChoice& choice);

// Returns `{"form", "results": [{"theta", "phi", "fixed", "channel", "value", "error_bound", ...}],
// "provenance"}`.
io::Json to_json(const Material& material, const std::vector<AlbedoRow>& rows, const AlbedoChoice& choice);

}  // namespace brdf::fit
