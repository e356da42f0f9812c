// The requirement of a scene: the cheapest model with a picture that is close enough.
#pragma once

#include <filesystem>
#include <optional>

#include "trade/ledger/ledger.h"
#include "trade/recommend/scene_fit.h"

namespace brdf::trade {

enum class Judge { image, brdf };  // the error to which the tolerance applies

struct RecommendOptions {
  std::filesystem::path scene;
  std::filesystem::path reference;  // a material, or samples
  std::optional<Material> made;     // used instead of `reference`: a ready material, such as a shader
  // Costs that the ledger lacks are measured now. Empty: all costs are measured.
  std::filesystem::path ledger;
  // Models to be compared, in the catalogue or not. Empty: recommendable_models().
  std::vector<Reflectance> models;
  double tolerance = 0.05;
  Judge judge = Judge::image;
  double max_cost_ns = 0;  // 0: no limit
  std::function<void(double fraction, const std::string& what)> progress = [](double, const std::string&) {};
};

// Returns every form that can be fitted, and the ledger's variants.
std::vector<Reflectance> recommendable_models();

// A model fitted to the reference, with its cost and errors.
struct Candidate {
  Reflectance model;
  bool anisotropic = false;
  double cost_ns = 0;
  bool cost_measured = false;            // measured now, since no ledger had the cost
  double image_error = 0;                // in the scene, from the directions of the lit pixels
  std::optional<double> rendered_error;  // the same from two pictures; std::nullopt if they were not rendered
  double brdf_error = 0;                 // mean |df| cos_i / mean f cos_i over the hemispheres
  std::string reason;                    // reason for the choice or the rejection
  Material material;                     // the model with the fitted parameters
  RgbFunction values;
  std::string form() const;    // the model's name, or for a variant the name of its form
  std::string choice() const;  // the ledger's variant, or ""
  std::string label() const;
};

// Returns the material for a file: in a form of the catalogue, and for a variant the reference form with the
// variant's parameters. Returns std::nullopt for other models outside the catalogue.
std::optional<Material> material_for_file(const Candidate& candidate);

// The candidates and the choice.
struct Recommendation {
  double tolerance = 0;
  std::string metric;
  std::optional<std::size_t> chosen;
  std::size_t best = 0;               // index of the smallest error
  std::vector<Candidate> candidates;  // cheapest first
  std::vector<std::string> unneeded;  // features that this scene cannot distinguish or does not show
  std::vector<std::string> warnings;  // known violations of the chosen form
  Coverage coverage;
  bool isotropic_reference = false;            // if true, no candidate has two widths
  render::Picture picture, reference_picture;  // of the chosen candidate, otherwise of the best
  std::string costs_from;
  std::string measured_now;  // a sentence on the costs that were not read; "" if no ledger was given
};

// Compares the models on the scene and chooses one. Throws InputError.
Recommendation recommend(const RecommendOptions& options);

// Returns the candidate of the pictures and the material: the chosen candidate, otherwise the best.
const Candidate& shown(const Recommendation& r);

io::Json to_json(const Recommendation& r);
std::string to_text(const Recommendation& r);
// The files in the folder: the material (for models in the catalogue), both pictures and their difference as
// PNG, and report.html, which is written last and holds the pictures. Each file is complete or absent.
// recommendation_files() returns their names.
std::vector<std::string> recommendation_files();
void write_recommendation(const std::filesystem::path& folder, const Recommendation& r);

// Fits of one form with the scene's own weighting and over the whole hemisphere, judged at positions of
// light and camera that neither fit has used.
struct HeldOut {
  std::string scene, material, form;
  double scene_weighted = 0, hemisphere_wide = 0;  // image errors, mean over the held-out positions
};
std::vector<HeldOut> compare_held_out(const std::filesystem::path& scenes,
                                      const std::filesystem::path& materials,
                                      const std::function<void(double, const std::string&)>& progress);

}  // namespace brdf::trade
