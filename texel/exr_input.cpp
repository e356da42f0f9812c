#include "texel/exr_input.h"

#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfStringAttribute.h>

#include "io/files/error.h"

namespace brdf::texel {
namespace {

Imf::InputFile opened(io::ExrFile& bytes) try {
  return Imf::InputFile(bytes, 1);
} catch (const Iex::BaseExc& error) {
  throw InputError(std::string(bytes.fileName()) + ": is not a readable OpenEXR image: " + error.what());
}

}  // namespace

ExrInput::ExrInput(const std::filesystem::path& path) : path_(path), bytes_(path), file_(opened(bytes_)) {
  const Imath::Box2i window = file_.header().dataWindow();
  left_ = window.min.x;
  top_ = window.min.y;
  width_ = std::size_t(window.max.x - window.min.x + 1);
  height_ = std::size_t(window.max.y - window.min.y + 1);
  const Imf::ChannelList& list = file_.header().channels();
  for (auto channel = list.begin(); channel != list.end(); ++channel) {
    if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
      throw InputError(path.string() + ": channel " + channel.name() + " is subsampled");
    channels_.emplace_back(channel.name());
  }
}

void ExrInput::read_rows(const std::vector<std::string>& channels, std::size_t first, std::size_t rows,
                         std::vector<std::vector<float>>& out) try {
  Imf::FrameBuffer frame;
  out.resize(channels.size());
  const int top = top_ + int(first);
  const Imath::Box2i window({left_, top}, {left_ + int(width_) - 1, top + int(rows) - 1});
  for (std::size_t c = 0; c < channels.size(); ++c) {
    out[c].resize(width_ * rows);
    frame.insert(channels[c], Imf::Slice::Make(Imf::FLOAT, out[c].data(), window));
  }
  file_.setFrameBuffer(frame);
  file_.readPixels(top, top + int(rows) - 1);
} catch (const Iex::BaseExc& error) {
  throw InputError(path_.string() + ": damaged: " + error.what());
}

std::vector<std::pair<std::string, std::string>> ExrInput::attributes() const {
  std::vector<std::pair<std::string, std::string>> out;
  for (auto a = file_.header().begin(); a != file_.header().end(); ++a)
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute()))
      out.emplace_back(a.name(), text->value());
  return out;
}

}  // namespace brdf::texel
