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

std::string to_exr(const Planes& head, const FillRows& fill) {
  Imf::Header header(int(head.width), int(head.height));
  header.setTileDescription({kTile, kTile, Imf::ONE_LEVEL});
  const Imf::PixelType type = head.in_half ? Imf::HALF : Imf::FLOAT;
  for (const std::string& name : head.names) header.channels().insert(name, Imf::Channel(type));
  for (const auto& [key, value] : head.attributes) header.insert(key, Imf::StringAttribute(value));
  Imf::StdOSStream bytes;
  {
    Imf::TiledOutputFile file(bytes, header, 1);
    std::vector<std::vector<float>> values(head.names.size());
    std::vector<std::vector<half>> halves(head.names.size());  // if the file stores 16-bit floats
    for (const Region& rows : divided({0, 0, head.width, head.height}, head.width, kTile)) {
      for (std::vector<float>& plane : values) plane.resize(rows.size());
      fill(rows, values);
      const Imath::Box2i window({0, int(rows.y)}, {int(rows.width) - 1, int(rows.y + rows.height) - 1});
      Imf::FrameBuffer frame;
      for (std::size_t k = 0; k < values.size(); ++k) {
        if (head.in_half) halves[k].assign(values[k].begin(), values[k].end());
        const void* from = head.in_half ? static_cast<const void*>(halves[k].data()) : values[k].data();
        frame.insert(head.names[k], Imf::Slice::Make(type, from, window));
      }
      file.setFrameBuffer(frame);
      const int row = int(rows.y / kTile);
      file.writeTiles(0, file.numXTiles() - 1, row, row);
    }
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

const std::vector<float>* Planes::find_parameter(const std::string& parameter,
                                                 const std::string& channel) const {
  const std::vector<float>* own = find(plane_name(parameter, channel));
  return own ? own : find(parameter);
}

std::string plane_name(const std::string& parameter, const std::string& channel) {
  return channel.empty() ? parameter : parameter + "." + channel;
}

void write_planes(const std::filesystem::path& path, const Planes& planes) {
  write_planes(path, planes, [&](const Region& rows, std::vector<std::vector<float>>& values) {
    for (std::size_t k = 0; k < values.size(); ++k)
      std::copy_n(planes.values[k].begin() + long(rows.y * rows.width), rows.size(), values[k].begin());
  });
}

void write_planes(const std::filesystem::path& path, const Planes& head, const FillRows& fill) {
  io::write_file_atomically(path, to_exr(head, fill));
}

Planes read_planes(const std::filesystem::path& path) {
  ExrInput file(path);
  Planes planes{file.width(), file.height(), file.channels(), {}, file.attributes()};
  file.read_rows(planes.names, 0, planes.height, planes.values);
  return planes;
}

}  // namespace brdf::texel
