// Animated WebP, encoded by libwebp.
#pragma once

#include <memory>
#include <string>

#include "render/picture/picture.h"

namespace brdf::render {

// Frames of one size, shown for ever at an even rate. `quality` from 0 to 100: 100 keeps every bit, less is
// lossy. Throws InputError for a picture that is too large (16,383 pixels on a side), EnvironmentError when
// the encoder gives up.
class Animation {
 public:
  Animation(int width, int height, double frames_per_second, int quality);
  ~Animation();
  void add(const BytePicture& picture);
  // The bytes of the file; nothing may be added afterwards.
  std::string finish();

 private:
  struct Encoder;
  std::unique_ptr<Encoder> encoder_;
  double milliseconds_;  // per frame
  int width_, height_, frames_ = 0;
};

}  // namespace brdf::render
