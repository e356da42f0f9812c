#include "synth/instrument.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "brdf/aperture.h"
#include "brdf/math.h"
#include "io/columns/foreign_json.h"
#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/provenance.h"
#include "io/files/standard_input.h"
#include "io/files/text.h"
#include "io/formats/read.h"
#include "io/material/below_zero.h"
#include "io/material/material_json.h"
#include "synth/patch_means.h"
#include "synth/random.h"

namespace brdf::synth {
namespace {

// Rounds to 12 digits, as an instrument's display does. Digits beyond the 12th are rounding errors, which
// differ between machines.
double displayed(double value) {
  constexpr int kDigits = 12;
  char text[40];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, kDigits - 1).ptr;
  std::from_chars(text, end, value);
  return value;
}

void check(const Instrument& instrument) {
  io::require_between("--aperture", instrument.aperture, 0, 90, " degrees");
  io::require_between("--source-aperture", instrument.source_aperture, 0, 90, " degrees");
  io::require_between("--noise", instrument.noise, 0, 2);
  io::require_between("--noise-floor", instrument.noise_floor, 0, 1e6, " 1/sr");
  io::require_between("--saturation", instrument.saturation, 0, 1e300, " 1/sr");
  if (instrument.sigma_columns && instrument.noise == 0 && instrument.noise_floor == 0)
    throw InputError("--sigma-columns: needs --noise or --noise-floor, because otherwise every sigma is 0");
}

// Fills the table with noise-free readings.
void read_out(const Material& material, const Instrument& instrument, const io::Progress& progress,
              io::SampleTable& table) {
  const std::size_t channels = material.channels.size();
  // Two apertures multiply the number of nodes: 50 x 50 nodes for both, 288 nodes for one.
  const bool both = instrument.aperture > 0 && instrument.source_aperture > 0;
  const int rings = both ? kSynthRingsOfTwo : kSynthRings;
  const auto source = aperture_nodes(degrees(instrument.source_aperture), rings);
  const auto detector = aperture_nodes(degrees(instrument.aperture), rings);
  const bool is_point = source.size() == 1 && detector.size() == 1;
  const DirectionArrays<double> arrays = io::unit_directions(table);
  const Directions<double> d = arrays.view();
  std::vector<double> value(channels), centre(channels);
  double peak = 0, read_at_peak = 0;
  constexpr std::size_t kStride = 256;  // rows between reports
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (progress && k % kStride == 0) progress(static_cast<int>(k), static_cast<int>(table.rows()));
    const Vec3<double> wi = d.wi(k), wo = d.wo(k);
    eval(material, wi, wo, centre);
    if (is_point)
      value = centre;
    else
      eval_aperture(material, wi, wo, source, detector, value);
    for (std::size_t c = 0; c < channels; ++c) {
      table.values[c].push_back(value[c]);
      if (centre[c] > peak) {
        peak = centre[c];
        read_at_peak = value[c];
      }
    }
  }
  if (progress) progress(static_cast<int>(table.rows()), static_cast<int>(table.rows()));
  // A Gaussian lobe as wide (full width at half maximum) as the aperture reads 0.72 of its peak.
  if (read_at_peak < 0.72 * peak)
    table.warnings.push_back("the lobe is narrower than the aperture: the peak reads " +
                             std::to_string(std::lround(100 * read_at_peak / peak)) +
                             " % of the ground truth (fit with --aperture)");
}

// Adds the effects of the instrument. Two random numbers are drawn per reading in any case, so that a
// setting has no side effects on the other random numbers.
void disturb(const Instrument& instrument, io::SampleTable& table) {
  NormalPairs normal(instrument.seed);
  std::size_t saturated = 0, clipped = 0;
  const double s = instrument.noise;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    for (std::size_t c = 0; c < table.channels.size(); ++c) {
      double& value = table.values[c][k];
      const NormalPairs::Pair z = normal.next();
      if (instrument.sigma_columns) {
        const double relative = std::sqrt(math::exp(s * s) - 1) * value;  // of the log-normal factor
        const double sigma = std::sqrt(relative * relative + instrument.noise_floor * instrument.noise_floor);
        table.sigma[c].push_back(displayed(std::max(sigma, 1e-300)));  // the format requires sigma > 0
      }
      if (s > 0) value *= math::exp(s * z.first - 0.5 * s * s);
      if (instrument.noise_floor > 0) value += instrument.noise_floor * z.second;
      if (instrument.saturation > 0 && value > instrument.saturation) {
        value = instrument.saturation;
        ++saturated;
      }
      if (instrument.clip_negatives && value < 0) {
        value = 0;
        ++clipped;
      }
      value = displayed(value);
    }
  }
  if (saturated > 0) table.warnings.push_back(std::to_string(saturated) + " readings saturated");
  if (clipped > 0) table.warnings.push_back(std::to_string(clipped) + " negative readings set to 0");
}

std::string form_names(const Material& material) {
  std::vector<std::string> names;
  for (const Term& term : material.terms) names.emplace_back(info(term.form).name);
  return io::joined(names, "+");
}

void record(const Material& material, const Instrument& instrument, io::SampleTable& table) {
  const auto add = [&](const char* key, std::string value) {
    table.metadata.emplace_back(key, std::move(value));
  };
  const GridOptions& grid = instrument.grid;
  add("sample", "synthetic " + form_names(material));
  add("instrument", "virtual goniophotometer (brdf synth)");
  add("source", "computed; truth below");
  add("licence", "Apache-2.0");
  for (auto& field : io::provenance_fields(io::provenance(instrument.seed))) table.metadata.push_back(field);
  add("truth", io::to_line(io::to_json(material)));
  std::vector<std::string> parts = grid.parts;
  for (std::string& part : parts) part = io::input_name(part);
  add("grid", io::joined(parts, "+"));
  if (!grid.theta_i.empty()) add("theta_i", io::joined_numbers(grid.theta_i, ","));
  if (grid.step > 0) add("step", io::to_text(grid.step));
  add("azimuths", io::joined_numbers(grid.azimuths, ","));
  add("blind_zone", io::to_text(grid.blind_zone));
  add("aperture", io::to_text(instrument.aperture));
  add("source_aperture", io::to_text(instrument.source_aperture));
  add("noise", io::to_text(instrument.noise));
  add("noise_floor", io::to_text(instrument.noise_floor));
  add("saturation", instrument.saturation > 0 ? io::to_text(instrument.saturation) : "none");
  add("clip_negatives", instrument.clip_negatives ? "yes" : "no");
}

}  // namespace

std::vector<std::string> grid_parts(std::string_view grid) {
  std::vector<std::string_view> parts;
  io::split(grid, '+', parts);
  return {parts.begin(), parts.end()};
}

std::vector<double> usual_azimuths(const Material& material) {
  return is_anisotropic(material) ? std::vector<double>{0, 45, 90} : std::vector<double>{0};
}

io::SampleTable measure(const Material& material, const Instrument& instrument,
                        const io::Progress& progress) {
  check(instrument);
  io::require_not_below_zero(material, "the material");
  io::SampleTable table = make_grid(instrument.grid);
  table.set_channels(material.channels);
  read_out(material, instrument, progress, table);
  disturb(instrument, table);
  record(material, instrument, table);
  return table;
}

Cells cells_for(const std::filesystem::path& output) {
  return output.extension() == ".xml" ? Cells::klems : Cells::merl;
}

io::SampleTable table_of_material(const Material& material, Cells cells, const io::Progress& progress) {
  if (cells == Cells::merl) {
    Instrument instrument;
    instrument.grid.parts = {"merl"};
    return measure(material, instrument, progress);
  }
  PatchMeans means = patch_means(material, progress);
  std::string accuracy =
      "each value is a mean over two patches; estimated error of the integration: at most " +
      io::percent(means.error);
  if (means.unresolved > 0)
    accuracy += "; " + io::plural(means.unresolved, "value") + " of " + std::to_string(means.table.rows()) +
                " are less accurate, because the highlight is too narrow for the integration";
  means.table.warnings.push_back(accuracy);
  return std::move(means.table);
}

io::SampleTable table_of_file(const std::filesystem::path& path, const io::Supplied& supplied, Cells cells) {
  io::Content content = io::read_content(path);
  if (!io::may_be_material(content)) return io::read_samples(std::move(content), supplied);
  io::Supplied stated = supplied;
  stated.polarised = false;  // a material has no Mueller matrix, and its channels are chosen by their names
  if (stated != io::Supplied())
    throw InputError(
        path.string() +
        ": --quantity, --mirror-side, --layout and --matrix apply to samples, not to a material");
  io::SampleTable table = table_of_material(io::read_material(content), cells);
  table.source = path.string();
  table.format = "material";
  return table;
}

}  // namespace brdf::synth
