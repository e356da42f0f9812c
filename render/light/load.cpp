#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include <cmath>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/formats/exr_stream.h"
#include "render/decode/picture_bytes.h"
#include "render/light/light_map.h"

namespace brdf::render {
namespace {

struct Radiances {
  int width = 0, height = 0;
  std::vector<glm::vec3> values;
};

void require_size(std::int64_t width, std::int64_t height, const std::string& file) {
  if (width < 1 || height < 1 || width * height > kMostLightTexels)
    throw InputError(file + ": is a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                     "; an environment has at most " + std::to_string(kMostLightTexels) + " pixels");
}

Radiances read_exr_pixels(const io::Content& content) {
  const std::string& file = content.name;
  try {
    io::ExrBytes bytes(content);
    Imf::InputFile in(bytes);
    const Imath::Box2i window = in.header().dataWindow();
    Radiances out{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, {}};
    require_size(out.width, out.height, file);
    out.values.resize(std::size_t(out.width) * std::size_t(out.height));
    const bool grey = in.header().channels().findChannel("Y") && !in.header().channels().findChannel("R");
    Imf::FrameBuffer buffer;
    for (int c = 0; c < 3; ++c) {
      const std::string name = grey ? "Y" : std::string(1, "RGB"[c]);
      if (!in.header().channels().findChannel(name.c_str()))
        throw InputError(file + ": has no channel " + name + "; an environment has R, G and B, or Y");
      if (grey && c > 0) break;
      buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, &out.values[0][c], window, sizeof(glm::vec3),
                                           sizeof(glm::vec3) * std::size_t(out.width)));
    }
    in.setFrameBuffer(buffer);
    in.readPixels(window.min.y, window.max.y);
    for (glm::vec3& v : out.values)
      if (grey) v = glm::vec3(v.r);
    return out;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(file + ": is not a readable OpenEXR picture: " + error.what());
  }
}

Radiances read_hdr_pixels(const io::Content& content) {
  const auto size = picture_size(content);
  if (!size) throw InputError(content.name + ": is not a readable Radiance picture: the size is missing");
  require_size(size->width, size->height, content.name);
  const Pixels<float> pixels = decoded_radiance(content, 3, "is not a readable Radiance picture");
  Radiances out{pixels.size.width, pixels.size.height, {}};
  const float* value = pixels.values.get();
  for (std::size_t k = 0; k < std::size_t(out.width) * std::size_t(out.height); ++k, value += 3)
    out.values.emplace_back(value[0], value[1], value[2]);
  return out;
}

}  // namespace

LightMap load_light_map(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file))
    throw InputError(file.string() + ": no such file; an environment is a .hdr or .exr picture, or one of " +
                     known_names<Formula>());
  const io::Content content = io::read_content(file);
  const bool is_open_exr = io::is_exr(content);
  if (!is_open_exr && !is_radiance(content))
    throw InputError(file.string() + ": is neither a Radiance picture (.hdr) nor an OpenEXR one (.exr)");
  const Radiances pixels = is_open_exr ? read_exr_pixels(content) : read_hdr_pixels(content);
  for (std::size_t k = 0; k < pixels.values.size(); ++k) {
    for (int c = 0; c < 3; ++c) {
      const float value = pixels.values[k][c];
      if (std::isfinite(value) && value >= 0) continue;
      throw InputError(file.string() + ": the pixel (" + std::to_string(k % std::size_t(pixels.width)) +
                       ", " + std::to_string(k / std::size_t(pixels.width)) + ") has the value " +
                       std::to_string(value) + "; radiance is finite and not negative");
    }
  }
  return {pixels.width, pixels.height, pixels.values};
}

}  // namespace brdf::render
