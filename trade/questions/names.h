// Names that questions share with claims, reasons and scenes, which use them to find the ledger's rows.
#pragma once

#include <array>
#include <string>

#include "brdf/names.h"
#include "io/files/numbers.h"

namespace brdf::trade {

// Key of a row of the ledger.
struct RowName {
  std::string question, choice;
};

namespace names {

// --- Forms -------------------------------------------------------------------------------------------------
// The form with which others are compared, and the form that the articles show.
inline constexpr std::string_view kReferenceForm = "cook_torrance";
inline constexpr std::string_view kArticleForm = "cook_torrance_vcavity";
inline constexpr std::string_view kDiffuseForm = "lambert";

// --- Questions ---------------------------------------------------------------------------------------------
inline constexpr const char* kMirror = "mirror direction or half vector";
inline constexpr const char* kMasking = "masking for GGX";
inline constexpr const char* kMaskingByAlbedo = "masking for GGX, by the albedo it gives";
inline constexpr const char* kFresnelOfGlass = "Fresnel of glass";
inline constexpr const char* kVariants = "cheaper inside cook_torrance";
inline constexpr const char* kSampleCounts = "samples for a fit";
inline constexpr const char* kDiffuseShading = "where to shade: diffuse";
inline constexpr const char* kHighlightShading = "where to shade: highlight";
inline std::string families(std::string_view form) {
  return "families for a material of " + std::string(form);
}
inline std::string bits(double alpha) {
  return "bits of the G-buffer, alpha " + io::short_number(alpha);
}
inline std::string lights(int count) {
  return "forward or deferred, " + std::to_string(count) + (count == 1 ? " light" : " lights");
}
inline std::string lookup(double alpha) {
  return "lookup texture, alpha " + io::short_number(alpha);
}

// --- Choices -----------------------------------------------------------------------------------------------
inline constexpr const char* kEqualHalfVector = "half vector, equal n";
inline constexpr const char* kMaskingDropped = "G dropped";
inline constexpr const char* kSlip = "the article's slip";
inline constexpr const char* kThousandSamples = "1e3 samples";
inline constexpr const char* kDeferred16 = "deferred, 16 bits";
inline constexpr const char* kEightBits = "8 bits";
inline constexpr const char* kExact = "exact";
inline constexpr const char* kCollapsed = "H = N, evaluated";
inline constexpr const char* kGouraud = "Gouraud";
inline constexpr const char* kPhong = "Phong";
inline constexpr const char* kPhongAsCoded = "Phong as coded";
inline constexpr const char* kHighlightAsCoded = "highlight as coded";
inline std::string triangles(int count, const char* way) {
  return std::to_string(count) + " triangles, " + way;
}
inline std::string texels(int size, int bits, const char* filter) {
  return std::to_string(size) + "^2, " + std::to_string(bits) + " bit, " + filter;
}

}  // namespace names

// Cheaper variants of the reference form, by the replaced factor.
enum class Variant { hammon, schlick_ggx, no_masking, no_fresnel, hammon_no_fresnel };

}  // namespace brdf::trade

namespace brdf {
template <>
inline constexpr std::array<std::string_view, 5> kNames<trade::Variant>{
    "masking by Hammon", "masking by Schlick-GGX", "masking dropped", "no Fresnel",
    "masking by Hammon, no Fresnel"};
}  // namespace brdf
