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
constexpr std::uint32_t kShadowVertex[] =
#include "shadow.vert.inc"
    ;
constexpr std::uint32_t kShadow[] =
#include "shadow.frag.inc"
    ;
constexpr std::uint32_t kCopy[] =
#include "copy.frag.inc"
    ;
constexpr std::uint32_t kEnvironment[] =
#include "environment.frag.inc"
    ;
constexpr std::uint32_t kLightPoints[] =
#include "light_points.frag.inc"
    ;
constexpr std::uint32_t kBackdropFragment[] =
#include "backdrop.frag.inc"
    ;
constexpr std::uint32_t kAccumulate[] =
#include "accumulate.frag.inc"
    ;
constexpr std::uint32_t kMean[] =
#include "mean.frag.inc"
    ;
constexpr std::uint32_t kPlaces[] =
#include "places.frag.inc"
    ;
constexpr std::uint32_t kEnlarge[] =
#include "enlarge.frag.inc"
    ;
constexpr std::uint32_t kPaths[] =
#include "paths.comp.inc"
    ;

}  // namespace

const Spirv mesh_vertex = kMeshVertex, screen_vertex = kScreenVertex, gbuffer = kGBuffer,
            lighting = kLighting, forward = kForward, sky = kSky, classic_vertex = kClassicVertex,
            classic = kClassic, display = kDisplay, proof = kProof, copy = kCopy,
            shadow_vertex = kShadowVertex, shadow = kShadow, environment = kEnvironment,
            light_points = kLightPoints, backdrop = kBackdropFragment, accumulate = kAccumulate, mean = kMean,
            places = kPlaces, enlarge = kEnlarge, paths = kPaths;

const char* const lighting_text =
#include "lighting.frag.text.inc"
    ;
const char* const forward_text =
#include "forward.frag.text.inc"
    ;
const char* const environment_text =
#include "environment.frag.text.inc"
    ;

}  // namespace brdf::render::shader_code
