#include "render/viewer/viewer.h"

#include "render/viewer/controller.h"

namespace brdf::render {

ViewerReport view(const ViewerOptions& options) {
  return Controller(options).run();
}

}  // namespace brdf::render
