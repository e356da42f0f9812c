// Lookup tables of directional albedos over the cosine of the viewing angle and the roughness, for the split
// sum and for energy compensation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "brdf/material.h"
#include "interop/table_layouts.h"
#include "io/files/json.h"

namespace brdf::interop {

// dfg: scale and bias of a form whose Fresnel term is linear in f0 (two channels), otherwise the directional
// albedo (one channel). albedo: the directional albedo and its mean over projected solid angle.
enum class TableKind { dfg, albedo };

// The largest difference between the bilinear reading of the float table and the integral that a search from
// the middle of every cell has found; the true maximum is not smaller. Places without a converged
// integral have no difference and are counted.
struct ReadingError {
  double difference = 0, cosine = 0, roughness = 0;  // roughness is the root of alpha
  double read = 0, integral = 0;
  std::string channel{};
  std::size_t unknown = 0;  // places of the search without a difference
};

struct LookupTable {
  const TableLayout* layout = nullptr;
  std::size_t width = 0, height = 0;
  std::vector<std::string> channels;
  std::vector<std::vector<double>> texels;  // [channel][y width + x]
  std::string content;                      // a phrase: which albedo of which form
  double texel_bound = 0;                   // largest bound of a texel's integral
  std::size_t not_converged = 0;            // texels, counted without a meaning for their bounds
  double rounding = 0;                      // largest change of a texel by the program's number format
  ReadingError reading{};

  // Returns channel k as the program reads it: bilinear, held at the outer texels, at an x and y coordinate
  // in 0..1.
  double read(std::size_t channel, double x, double y) const;
};

// Computes the values of a table at any place.
class TableFunction {
 public:
  // Uses the first term's lobe with weight 1 and without a diffuse part, at the material's other parameters.
  // A form without a weight of the lobe is used as it is. Throws InputError for a sum of terms, for
  // anisotropic materials and for channels with different shapes.
  TableFunction(const Material& material, TableKind kind, bool bias_first);

  const std::vector<std::string>& channels() const { return channels_; }
  const std::string& content() const { return content_; }
  // Returns a phrase: the lobe of which form, without the weights.
  std::string lobe_name() const;
  // Returns whether the form has a width, an exponent or a parameter called roughness, which the table's
  // roughness sets.
  bool has_roughness() const { return !widths_.empty() || root_ >= 0; }

  struct Values {
    std::vector<double> values;
    double bound = 0;
    bool converged = true;
  };
  // Returns the values at this cosine in 0..1 and this alpha in 0..1. An alpha below the form's range is held
  // at its end.
  Values directional(double cosine, double alpha) const;
  // Returns the mean of the directional albedo over projected solid angle.
  Values mean(double alpha) const;
  // Returns the lobe itself, with f0 = 1, at this alpha.
  Term at_alpha(double alpha) const;

 private:
  Term term_;
  TableKind kind_;
  bool bias_first_, splits_ = false;
  std::vector<std::size_t> widths_;  // indices into the shape
  int root_ = -1;                    // the same of the parameter that takes the root of alpha
  std::vector<std::string> channels_;
  std::string content_;
};

// Computes the table, the error of its reading, and the rounding of the program's format.
LookupTable lookup_table(const Material& material, TableKind kind, const TableLayout& layout);

// Returns the cosine and alpha of a coordinate.
struct TablePlace {
  double cosine, alpha;
};
TablePlace place_at(const TableLayout& layout, double x, double y);

// Returns sentences on the table: its errors, its layout and what of the layout is supposed.
std::vector<std::string> sentences(const LookupTable& table);
io::Json to_json(const LookupTable& table);

}  // namespace brdf::interop
