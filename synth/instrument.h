// The virtual goniophotometer: samples of a known material as an instrument would report them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/material.h"
#include "io/columns/supplied.h"
#include "io/files/parallel.h"
#include "io/samples/samples.h"
#include "synth/grid.h"

namespace brdf::synth {

struct Instrument {
  GridOptions grid;
  double aperture = 0;         // full angular width of the detector, degrees
  double source_aperture = 0;  // full angular width of the source, degrees
  double noise = 0;            // s of the factor exp(s z - s^2/2), z standard normal: mean 1
  double noise_floor = 0;      // standard deviation of the additive noise, 1/sr
  double saturation = 0;       // larger readings are clamped to this, 1/sr; 0: no saturation
  bool clip_negatives = false;
  bool sigma_columns = false;  // adds the standard deviation of every value, from noise and noise_floor
  std::uint64_t seed = 1;
};

// Splits the name of a grid into its parts. The parts in_plane, hemisphere, merl or a file of directions
// are joined by +.
std::vector<std::string> grid_parts(std::string_view grid);

// Returns the default azimuths, in degrees, at which a sample of this material is measured.
std::vector<double> usual_azimuths(const Material& material);

// Measures the material. The metadata of the table records the ground truth and every setting. Its warnings
// list facts that users should know (a lobe narrower than the aperture, saturated readings). The same
// arguments give the same table on every machine, because random numbers and sines are the library's own
// and values are rounded to 12 digits. Throws InputError for settings out of range.
io::SampleTable measure(const Material& material, const Instrument& instrument,
                        const io::Progress& progress = {});

// The table that represents a material: values at the centres of the MERL cells, or means over the patches of
// a Klems basis (patch_means.h).
enum class Cells { merl, klems };
// Returns the cells for a material that is written to this file: klems for .xml, otherwise merl.
Cells cells_for(const std::filesystem::path& output);

// Returns the table of a material. The warnings of means state their accuracy.
io::SampleTable table_of_material(const Material& material, Cells cells, const io::Progress& progress = {});

// Returns any file as a table: samples unchanged, a material by table_of_material().
io::SampleTable table_of_file(const std::filesystem::path& path, const io::Supplied& supplied = {},
                              Cells cells = Cells::merl);

}  // namespace brdf::synth
