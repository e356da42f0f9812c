// The virtual goniophotometer: samples of a known material as an instrument would report them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
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
  double source_aperture = 0;  // of the source
  double noise = 0;            // s of the factor exp(s z - s^2/2), z standard normal: mean 1
  double noise_floor = 0;      // standard deviation of the additive noise, 1/sr
  double saturation = 0;       // readings above are cut to this, 1/sr; 0: none
  bool clip_negatives = false;
  bool sigma_columns = false;  // adds the standard deviation of every value, from noise and noise_floor
  std::uint64_t seed = 1;
};

// What a grid is called: in_plane, hemisphere, merl or a file of directions, joined by +.
std::vector<std::string> grid_parts(std::string_view grid);

// The azimuths at which a sample of this material is measured where none are asked for, degrees.
std::vector<double> usual_azimuths(const Material& material);

// Measures the material. The table's metadata records the truth and every setting, its
// warnings what a user should know (a lobe narrower than the aperture, readings
// saturated). The same arguments give the same table on every machine: own random numbers,
// own sines, values rounded to 12 digits. Throws InputError on settings out of range.
io::SampleTable measure(const Material& material, const Instrument& instrument,
                        const io::Progress& progress = {});

// Any file as a table: samples as they are read, a material as it is at the centres of the MERL cells.
io::SampleTable table_of_file(const std::filesystem::path& path, const io::Supplied& supplied = {});

}  // namespace brdf::synth
