#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/files/png.h"
#include "io/files/provenance.h"
#include "io/formats/exr_stream.h"
#include "render/picture/picture.h"
#include "render/scene/texture.h"

namespace brdf::render {
namespace {

std::string channel_name(const std::string& layer, char channel) {
  return layer.empty() ? std::string(1, channel) : layer + "." + channel;
}

// Rows and pixels are contiguous; the corner of the window is the first pixel.
Imf::Slice slice(const Picture& picture, int channel, const Imath::Box2i& window) {
  const float* const first = &picture.pixels[0][channel];
  return Imf::Slice::Make(Imf::FLOAT, first, window, sizeof(glm::vec4),
                          sizeof(glm::vec4) * std::size_t(picture.width));
}

}  // namespace

std::string png_of(const BytePicture& picture) {
  static_assert(sizeof(picture.pixels[0]) == 3);
  return io::png_of_pixels(
      std::size_t(picture.width), std::size_t(picture.height),
      {reinterpret_cast<const unsigned char*>(picture.pixels.data()), 3 * picture.pixels.size()});
}

void write_png(const std::filesystem::path& file, const BytePicture& picture) {
  io::write_file_atomically(file, png_of(picture));
}

void write_exr(const std::filesystem::path& file, const std::vector<Layer>& layers) {
  Imf::Header header(layers.at(0).picture->width, layers.at(0).picture->height);
  Imf::FrameBuffer buffer;
  for (const Layer& layer : layers) {
    for (int c = 0; c < (layer.alpha ? 4 : 3); ++c) {
      const std::string name = channel_name(layer.name, "RGBA"[c]);
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      buffer.insert(name, slice(*layer.picture, c, header.dataWindow()));
    }
  }
  const io::Provenance made = io::provenance();
  header.insert("brdf_version", Imf::StringAttribute(made.version));
  header.insert("command", Imf::StringAttribute(made.command));
  Imf::StdOSStream bytes;
  {
    Imf::OutputFile out(bytes, header);
    out.setFrameBuffer(buffer);
    out.writePixels(layers[0].picture->height);
  }
  io::write_file_atomically(file, bytes.str());
}

Picture read_exr(const std::filesystem::path& file, const std::string& layer) {
  const io::Content content = io::read_content(file);
  try {
    io::ExrBytes bytes(content);
    Imf::InputFile in(bytes);
    const Imath::Box2i window = in.header().dataWindow();
    const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1,
                       height = std::int64_t(window.max.y) - window.min.y + 1;
    if (width > kMostTexels || height > kMostTexels || width * height > kMostTexels)
      throw InputError(file.string() + ": has " + std::to_string(width) + " x " + std::to_string(height) +
                       " pixels; at most " + std::to_string(kMostTexels) + " are read");
    Picture picture{int(width), int(height)};
    Imf::FrameBuffer buffer;
    for (int c = 0; c < 4; ++c) {
      const std::string name = channel_name(layer, "RGBA"[c]);
      if (!in.header().channels().findChannel(name)) {
        if (c == 3) continue;
        throw InputError(file.string() + ": has no channel " + name);
      }
      buffer.insert(name, slice(picture, c, window));
    }
    in.setFrameBuffer(buffer);
    in.readPixels(window.min.y, window.max.y);
    return picture;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(file.string() + ": cannot be read as OpenEXR: " + error.what());
  }
}

}  // namespace brdf::render
