#include "texel/planes.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>

#include <algorithm>

#include "io/files/output.h"
#include "texel/exr_input.h"

namespace brdf::texel {
namespace {

constexpr unsigned kTile = 64;

std::string to_exr(const Planes& planes) {
  Imf::Header header(int(planes.width), int(planes.height));
  header.setTileDescription({kTile, kTile, Imf::ONE_LEVEL});
  Imf::FrameBuffer frame;
  std::vector<std::vector<half>> halves;  // of each plane, if the file stores 16-bit floats
  if (planes.in_half)
    for (const std::vector<float>& plane : planes.values) halves.emplace_back(plane.begin(), plane.end());
  const Imf::PixelType type = planes.in_half ? Imf::HALF : Imf::FLOAT;
  for (std::size_t k = 0; k < planes.names.size(); ++k) {
    header.channels().insert(planes.names[k], Imf::Channel(type));
    const void* values =
        planes.in_half ? static_cast<const void*>(halves[k].data()) : planes.values[k].data();
    frame.insert(planes.names[k], Imf::Slice::Make(type, values, header.dataWindow()));
  }
  for (const auto& [key, value] : planes.attributes) header.insert(key, Imf::StringAttribute(value));
  Imf::StdOSStream bytes;
  {
    Imf::TiledOutputFile file(bytes, header, 1);
    file.setFrameBuffer(frame);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  }
  return bytes.str();
}

}  // namespace

std::vector<Region> divided(const Region& grid, std::size_t width, std::size_t height) {
  std::vector<Region> regions;
  for (std::size_t y = 0; y < grid.height; y += height)
    for (std::size_t x = 0; x < grid.width; x += width)
      regions.push_back({x, y, std::min(width, grid.width - x), std::min(height, grid.height - y)});
  return regions;
}

const std::vector<float>* Planes::find(std::string_view name) const {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? nullptr : &values[std::size_t(found - names.begin())];
}

std::string plane_name(const std::string& parameter, const std::string& channel) {
  return channel.empty() ? parameter : parameter + "." + channel;
}

void write_planes(const std::filesystem::path& path, const Planes& planes) {
  io::write_file_atomically(path, to_exr(planes));
}

Planes read_planes(const std::filesystem::path& path) {
  ExrInput file(path);
  Planes planes{file.width(), file.height(), file.channels(), {}, file.attributes()};
  file.read_rows(planes.names, 0, planes.height, planes.values);
  return planes;
}

}  // namespace brdf::texel
