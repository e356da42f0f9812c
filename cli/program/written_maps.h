// Writes fitted maps as textures of another program.
#pragma once

#include <string>
#include <vector>

#include "interop/programs.h"
#include "io/files/json.h"

namespace brdf::cli {

// Returns the names of the programs that textures are written for.
std::vector<std::string> textured_names();

// Files of an export of maps; loss_map and name may be empty.
struct MapFiles {
  std::string maps, loss_map, output, name;
};

// What was written, in sentences and as JSON, and the largest loss of a texel.
struct WrittenMaps {
  std::vector<std::string> sentences;
  io::Json json;
  double largest_loss = 0;
};

// Reads the maps, measures the loss in every texel, and writes the textures and the losses. Shows its
// progress. Throws InputError for maps and names of files that the program does not take, before anything is
// written, and if this build has no OpenEXR.
WrittenMaps write_maps(const interop::Program& program, const MapFiles& files);

}  // namespace brdf::cli
