// Animated WebP, encoded by libwebp.
#pragma once

#include <memory>
#include <string>

#include "render/picture/picture.h"

namespace brdf::render {

// Encodes frames of the same size, shown in an endless loop at a constant rate. `quality` from 0 to 100:
// 100 is lossless, less is lossy. Throws InputError if the picture is too large (16,383 pixels on a side),
// EnvironmentError if the encoder fails.
class Animation {
 public:
  Animation(int width, int height, double frames_per_second, int quality);
  ~Animation();
  void add(const BytePicture& picture);
  // Returns the bytes of the file; no frame may be added afterwards.
  std::string finish();

 private:
  struct Encoder;
  std::unique_ptr<Encoder> encoder_;
  double milliseconds_;  // per frame
  int width_, height_, frames_ = 0;
};

}  // namespace brdf::render
