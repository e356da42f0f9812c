#include "io/samples/samples.h"

#include "io/files/text.h"
#include "io/samples/degrees.h"
#include "io/samples/table_rules.h"

namespace brdf::io {

std::string SampleTable::where(std::size_t row) const {
  if (row < lines.size()) return name() + ", line " + std::to_string(lines[row]);
  return name() + ", row " + std::to_string(row + 1);
}

std::optional<std::string> SampleTable::find_metadata(std::string_view key) const {
  for (const auto& [name, value] : metadata)
    if (name == key) return value;
  return std::nullopt;
}

void SampleTable::assume(const std::string& sentence) {
  warnings.push_back(sentence);
  assumptions.push_back(sentence);
}

void SampleTable::add_comment(std::string_view key, std::string_view value) {
  keep_comment(*this, parse_comment(comment_text({std::string(key), std::string(value)})));
}

void SampleTable::set_channels(std::vector<std::string> names) {
  channels = std::move(names);
  values.assign(channels.size(), {});
  sigma.assign(channels.size(), {});
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

void SampleTable::add_directions(const Vec3<double>& wi, const Vec3<double>& wo) {
  const Polar light = polar_degrees(wi), viewer = polar_degrees(wo);
  add_directions(light.theta, light.phi, viewer.theta, viewer.phi);
}

std::filesystem::path path_beside(const std::string& table, const std::string& named) {
  const std::filesystem::path path(named);
  return path.is_absolute() ? path : std::filesystem::path(table).parent_path() / path;
}

std::optional<std::string> budget_comment_in(const std::filesystem::path& folder, const SampleTable& table) {
  const std::optional<std::string> named = table.find_metadata(kBudgetKey);
  if (!named || trimmed(*named).empty() || std::filesystem::path(*named).is_absolute()) return named;
  return std::filesystem::proximate(path_beside(table.source, *named), folder.empty() ? "." : folder)
      .string();
}

DirectionArrays<double> unit_directions(const SampleTable& table) {
  DirectionArrays<double> directions(table.rows());
  for (std::size_t k = 0; k < table.rows(); ++k)
    directions.set(k, unit_vector(table.theta_i[k], table.phi_i[k]),
                   unit_vector(table.theta_o[k], table.phi_o[k]));
  return directions;
}

}  // namespace brdf::io
