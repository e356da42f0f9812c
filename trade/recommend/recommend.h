// What a scene requires: the cheapest model whose picture is close enough.
#pragma once

#include <filesystem>
#include <optional>

#include "trade/ledger/ledger.h"
#include "trade/recommend/scene_fit.h"

namespace brdf::trade {

enum class Judge { image, brdf };  // which error the tolerance is about

struct RecommendOptions {
  std::filesystem::path scene;
  std::filesystem::path reference;  // a material, or samples
  std::optional<Material> made;     // instead: one that is ready, as a shader's
  std::filesystem::path ledger;     // empty: costs are measured now, as are those that it lacks
  // What is compared, in the catalogue or not; empty: recommendable_models().
  std::vector<Reflectance> models;
  double tolerance = 0.05;
  Judge judge = Judge::image;
  double max_cost_ns = 0;  // 0: any
  std::function<void(double fraction, const std::string& what)> progress = [](double, const std::string&) {};
};

// Every form that can be fitted, and the ledger's variants.
std::vector<Reflectance> recommendable_models();

struct Candidate {
  Reflectance model;
  bool anisotropic = false;
  double cost_ns = 0;
  bool cost_measured = false;            // now, because no ledger had it
  double image_error = 0;                // in the scene, from the lit pixels' directions
  std::optional<double> rendered_error;  // the same from two pictures, where they were rendered
  double brdf_error = 0;                 // mean |df| cos_i / mean f cos_i over the hemispheres
  std::string reason;                    // why it was chosen or not
  Material material;                     // the model with the fitted parameters
  RgbFunction values;
  std::string form() const;    // the model's name; of a variant that of its form
  std::string choice() const;  // the ledger's variant, or ""
  std::string label() const;
};

// The material as its file has it: in a form of the catalogue, for a variant the reference form with its
// parameters. Nothing for what is not in the catalogue.
std::optional<Material> material_for_file(const Candidate& candidate);

struct Recommendation {
  double tolerance = 0;
  std::string metric;
  std::optional<std::size_t> chosen;
  std::size_t best = 0;               // the smallest error
  std::vector<Candidate> candidates;  // cheapest first
  std::vector<std::string> unneeded;  // features that this scene cannot tell apart, or does not show
  std::vector<std::string> warnings;  // what the chosen form is known to violate
  Coverage coverage;
  bool isotropic_reference = false;            // then no candidate has two widths
  render::Picture picture, reference_picture;  // of the chosen one, else of the best
  std::string costs_from;
  std::string measured_now;  // a sentence on the costs that were not read; "" where no ledger was given
};

// Throws InputError.
Recommendation recommend(const RecommendOptions& options);

// The chosen candidate, else the best: what pictures and material are of.
const Candidate& shown(const Recommendation& r);

io::Json to_json(const Recommendation& r);
std::string to_text(const Recommendation& r);
// Material file (of what is in the catalogue), both pictures with their difference as PNG, and report.html
// in the folder, which is written last and holds the pictures. Each file is whole; their names first.
std::vector<std::string> recommendation_files();
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
