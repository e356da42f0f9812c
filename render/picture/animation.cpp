#include "render/picture/animation.h"

#include <webp/encode.h>
#include <webp/mux.h>

#include <algorithm>
#include <cmath>

#include "io/files/error.h"

namespace brdf::render {
namespace {

[[noreturn]] void gave_up(const char* why) {
  throw EnvironmentError(std::string("the WebP encoder failed: ") + why);
}

// Frees the memory that the library has allocated for the picture.
struct EncoderPicture {
  WebPPicture picture;
  EncoderPicture() {
    if (!WebPPictureInit(&picture)) gave_up("incompatible version of libwebp");
  }
  EncoderPicture(const EncoderPicture&) = delete;
  EncoderPicture& operator=(const EncoderPicture&) = delete;
  ~EncoderPicture() { WebPPictureFree(&picture); }
};

}  // namespace

struct Animation::Encoder {
  WebPAnimEncoder* made = nullptr;
  WebPConfig config{};
  ~Encoder() { WebPAnimEncoderDelete(made); }
};

Animation::Animation(int width, int height, double frames_per_second, int quality)
    : encoder_(std::make_unique<Encoder>()),
      milliseconds_(1000 / frames_per_second),
      width_(width),
      height_(height) {
  if (std::max(width, height) > WEBP_MAX_DIMENSION)
    throw InputError("an animation has at most " + std::to_string(WEBP_MAX_DIMENSION) +
                     " pixels on a side, not " + std::to_string(std::max(width, height)));
  WebPAnimEncoderOptions options;
  if (!WebPAnimEncoderOptionsInit(&options) || !WebPConfigInit(&encoder_->config))
    gave_up("incompatible version of libwebp");
  options.anim_params.loop_count = 0;  // endless
  encoder_->config.lossless = quality >= 100;
  encoder_->config.exact = 1;
  // For lossless encoding, the quality sets the effort.
  encoder_->config.quality = float(quality >= 100 ? 50 : quality);
  encoder_->config.method = 3;
  encoder_->made = WebPAnimEncoderNew(width, height, &options);
  if (!encoder_->made) gave_up("out of memory");
}

Animation::~Animation() = default;

void Animation::add(const BytePicture& picture) {
  EncoderPicture frame;
  frame.picture.use_argb = 1;
  frame.picture.width = width_;
  frame.picture.height = height_;
  if (!WebPPictureImportRGB(&frame.picture, picture.pixels.data()->data(), 3 * width_))
    gave_up("out of memory");
  const int when = int(std::lround(milliseconds_ * frames_++));
  if (!WebPAnimEncoderAdd(encoder_->made, &frame.picture, when, &encoder_->config))
    gave_up(WebPAnimEncoderGetError(encoder_->made));
}

std::string Animation::finish() {
  const int end = int(std::lround(milliseconds_ * frames_));
  WebPData data;
  WebPDataInit(&data);
  if (!WebPAnimEncoderAdd(encoder_->made, nullptr, end, nullptr) ||
      !WebPAnimEncoderAssemble(encoder_->made, &data))
    gave_up(WebPAnimEncoderGetError(encoder_->made));
  std::string bytes(reinterpret_cast<const char*>(data.bytes), data.size);
  WebPDataClear(&data);
  return bytes;
}

}  // namespace brdf::render
