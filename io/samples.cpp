#include "io/samples.h"

#include "io/astm.h"
#include "io/csv.h"
#include "io/merl.h"
#include "io/rgl.h"
#include "io/zemax.h"

namespace brdf::io {

std::string SampleTable::where(std::size_t row) const {
  if (row < lines.size()) return source + ", line " + std::to_string(lines[row]);
  return source + ", row " + std::to_string(row + 1);
}

std::optional<std::string> SampleTable::find_metadata(std::string_view key) const {
  for (const auto& [name, value] : metadata)
    if (name == key) return value;
  return std::nullopt;
}

void SampleTable::reserve(std::size_t rows) {
  for (auto* column : {&theta_i, &phi_i, &theta_o, &phi_o}) column->reserve(rows);
  for (auto& column : values) column.reserve(rows);
}

void SampleTable::add_directions(double theta_of_light, double phi_of_light, double theta_of_viewer,
                                 double phi_of_viewer) {
  theta_i.push_back(theta_of_light);
  phi_i.push_back(phi_of_light);
  theta_o.push_back(theta_of_viewer);
  phi_o.push_back(phi_of_viewer);
}

SampleTable read_samples(const std::filesystem::path& path) {
  if (rgl::recognises(path)) return rgl::read(path);
  if (merl::recognises(path)) return merl::read(path);
  if (zemax::recognises(path)) return zemax::read(path);
  if (astm::recognises(path)) return astm::read(path);
  return read_csv(path, true);
}

SampleTable read_directions(const std::filesystem::path& path) {
  return read_csv(path, false);
}

}  // namespace brdf::io
