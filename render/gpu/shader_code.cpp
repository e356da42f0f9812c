#include "render/gpu/shader_code.h"

namespace brdf::render::shader_code {
namespace {

constexpr std::uint32_t kMeshVertex[] =
#include "mesh.vert.inc"
    ;
constexpr std::uint32_t kScreenVertex[] =
#include "screen.vert.inc"
    ;
constexpr std::uint32_t kGBuffer[] =
#include "gbuffer.frag.inc"
    ;
constexpr std::uint32_t kLighting[] =
#include "lighting.frag.inc"
    ;
constexpr std::uint32_t kForward[] =
#include "forward.frag.inc"
    ;
constexpr std::uint32_t kSky[] =
#include "sky.frag.inc"
    ;
constexpr std::uint32_t kClassicVertex[] =
#include "classic.vert.inc"
    ;
constexpr std::uint32_t kClassic[] =
#include "classic.frag.inc"
    ;
constexpr std::uint32_t kDisplay[] =
#include "display.frag.inc"
    ;
constexpr std::uint32_t kProof[] =
#include "proof.comp.inc"
    ;
constexpr std::uint32_t kCopy[] =
#include "copy.frag.inc"
    ;

}  // namespace

const char* const lighting_text =
#include "lighting.frag.text.inc"
    ;
const char* const forward_text =
#include "forward.frag.text.inc"
    ;

Spirv mesh_vertex() {
  return kMeshVertex;
}
Spirv screen_vertex() {
  return kScreenVertex;
}
Spirv gbuffer() {
  return kGBuffer;
}
Spirv lighting() {
  return kLighting;
}
Spirv forward() {
  return kForward;
}
Spirv sky() {
  return kSky;
}
Spirv classic_vertex() {
  return kClassicVertex;
}
Spirv classic() {
  return kClassic;
}
Spirv display() {
  return kDisplay;
}
Spirv proof() {
  return kProof;
}
Spirv copy() {
  return kCopy;
}

}  // namespace brdf::render::shader_code
