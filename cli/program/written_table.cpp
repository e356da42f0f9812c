#include "cli/program/written_table.h"

#include <algorithm>
#include <filesystem>

#include "interop/cosine_transform.h"
#include "interop/lookup_table.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/files/png.h"
#include "io/files/provenance.h"
#ifdef BRDF_HAS_MAPS
#include "texel/planes.h"
#endif

namespace brdf::cli {
namespace {

using Planes = std::vector<std::pair<std::string, std::vector<double>>>;

#ifdef BRDF_HAS_MAPS
void write_image(const std::string& path, std::size_t width, std::size_t height, const Planes& named,
                 const std::vector<std::string>& sentences, bool in_half) {
  texel::Planes planes{width, height, {}, {}};
  planes.in_half = in_half;
  for (const auto& [name, values] : named) {
    planes.names.push_back(name);
    planes.values.emplace_back(values.begin(), values.end());
  }
  planes.attributes = {{"brdf.command", io::provenance().command}};
  for (const std::string& sentence : sentences)
    planes.attributes.emplace_back("brdf." + std::to_string(planes.attributes.size()), sentence);
  texel::write_planes(path, planes);
}
#else
void write_image(const std::string& path, std::size_t, std::size_t, const Planes&,
                 const std::vector<std::string>&, bool) {
  throw InputError(path + ": this build has no OpenEXR, which tables need");
}
#endif

// Throws InputError unless the path's suffix is a format of file that holds the table's numbers.
void check_suffix(const std::string& path, interop::TableFormat format) {
  const std::string suffix = std::filesystem::path(path).extension();
  if (suffix == ".exr" || suffix.empty() || (suffix == ".png" && format == interop::TableFormat::bits8))
    return;
  throw InputError(path + ": " +
                   (suffix == ".png"
                        ? "the table holds numbers of " + std::string(name_of_format(format)) +
                              ", and a PNG is written for 8 bits: write .exr"
                        : "unknown suffix of a lookup table (known: .exr; .png for a layout of 8 bits)"));
}

// Writes the channels as red and green of 8 bits.
void write_png(const std::string& path, const interop::LookupTable& table) {
  constexpr double kMost = 255;
  std::vector<unsigned char> pixels(3 * table.width * table.height);
  for (std::size_t c = 0; c < table.channels.size(); ++c)
    for (std::size_t k = 0; k < table.width * table.height; ++k)
      pixels[3 * k + c] =
          static_cast<unsigned char>(kMost * stored(table.texels[c][k], interop::TableFormat::bits8) + 0.5);
  io::write_file_atomically(path, io::png_of_pixels(table.width, table.height, pixels));
}

WrittenTable write_transforms(const Material& material, const std::string& path) {
  const interop::CosineTable table = interop::cosine_table(material);
  Planes planes;
  for (const auto& [name, member] : {std::pair{"R", &interop::CosineTransform::x},
                                     {"G", &interop::CosineTransform::y},
                                     {"B", &interop::CosineTransform::z},
                                     {"A", &interop::CosineTransform::w}}) {
    std::vector<double> values;
    for (const interop::CosineTransform& transform : table.transforms) values.push_back(transform.*member);
    planes.emplace_back(name, std::move(values));
  }
  planes.emplace_back("albedo.white", table.white);
  planes.emplace_back("albedo.bias", table.bias);
  WrittenTable out{interop::sentences(table), interop::to_json(table), table.not_converged};
  write_image(path, table.side, table.side, planes, out.sentences, false);
  return out;
}

}  // namespace

bool is_lookup_table(std::string_view to) {
  return std::ranges::find(kTables, to) != std::end(kTables);
}

WrittenTable write_lookup_table(std::string_view to, const Material& material, std::string_view layout,
                                const std::string& path) {
  if (to == "ltc") {
    check_suffix(path, interop::TableFormat::float32);
    return write_transforms(material, path);
  }
  const interop::TableLayout& chosen = *interop::find_table_layout(layout);
  check_suffix(path, chosen.format);
  const interop::LookupTable table = interop::lookup_table(
      material, to == "dfg" ? interop::TableKind::dfg : interop::TableKind::albedo, chosen);
  Planes planes;
  for (std::size_t c = 0; c < table.channels.size(); ++c)
    planes.emplace_back(c == 0 ? "R" : "G", table.texels[c]);
  WrittenTable out{interop::sentences(table), interop::to_json(table), table.not_converged};
  if (path.ends_with(".png"))
    write_png(path, table);
  else
    write_image(path, table.width, table.height, planes, out.sentences,
                chosen.format == interop::TableFormat::half);
  return out;
}

}  // namespace brdf::cli
