// What a scene requires: the cheapest model whose picture is close enough.
#pragma once

#include <filesystem>
#include <optional>

#include "trade/ledger/ledger.h"
#include "trade/recommend/scene_fit.h"

namespace brdf::trade {

enum class Judge { image, brdf };

struct RecommendOptions {
  std::filesystem::path scene;
  std::filesystem::path reference;  // a material, or samples
  std::filesystem::path ledger;     // empty: costs are measured now
  double tolerance = 0.05;
  Judge judge = Judge::image;
  double max_cost_ns = 0;  // 0: any
  std::function<void(double fraction, const std::string& what)> progress = [](double, const std::string&) {};
};

struct Candidate {
  std::string form;
  std::string choice;  // "" for the form itself, or the ledger's variant
  bool anisotropic = false;
  double cost_ns = 0;
  double image_error = 0;                // in the scene, from the lit pixels' directions
  std::optional<double> rendered_error;  // the same from two pictures, where they were rendered
  double brdf_error = 0;                 // mean |df| cos_i / mean f cos_i over the hemispheres
  std::string reason;                    // why it was chosen or not
  Material material;                     // of a form; for a variant its parent with the variant's parameters
  RgbFunction reflectance;
  std::string label() const;
};

struct Recommendation {
  double tolerance = 0;
  std::string metric;
  std::optional<std::size_t> chosen;
  std::size_t best = 0;               // the smallest error
  std::vector<Candidate> candidates;  // cheapest first
  std::vector<std::string> unneeded;  // features that this scene cannot tell apart, or does not show
  std::vector<std::string> warnings;  // what the chosen form is known to violate
  Coverage coverage;
  render::Picture picture, reference_picture;  // of the chosen one, else of the best
  std::string costs_from;
};

// Throws InputError.
Recommendation recommend(const RecommendOptions& options);

// The chosen candidate, else the best: what pictures and material are of.
const Candidate& shown(const Recommendation& r);

io::Json to_json(const Recommendation& r);
std::string to_text(const Recommendation& r);
// Material file, both pictures with their difference as PNG, and report.html in the folder.
void write_recommendation(const std::filesystem::path& folder, const Recommendation& r);

// Fits of one form under a scene's own weighting and over the whole hemisphere, judged at light and camera
// positions that neither has seen.
struct HeldOut {
  std::string scene, material, form;
  double scene_weighted = 0, hemisphere_wide = 0;  // image errors, mean over the held-out positions
};
std::vector<HeldOut> compare_held_out(const std::filesystem::path& scenes,
                                      const std::filesystem::path& materials,
                                      const std::function<void(double, const std::string&)>& progress);

}  // namespace brdf::trade
