// Data shared by the passes over the samples: the columns of a block of rows, and the targets of each
// column's sums.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "brdf/directions.h"
#include "fit/solve/columns.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// The shapes of one group at the current parameters, ready to be evaluated.
struct SampleStream::Shapes {
  std::vector<std::vector<double>> shape;  // [term]
  Angle tangent_phi{};
  Vec3<double> normal{0, 0, 1};
  bool derivatives = true;

  bool operator==(const Shapes& other) const {
    return shape == other.shape && tangent_phi == other.tangent_phi && normal.x == other.normal.x &&
           normal.y == other.normal.y && derivatives == other.derivatives;
  }
};

// Columns of one block. Entries beyond the last row stay 0 in `slope`, by which every sum is multiplied.
struct SampleStream::Workspace {
  explicit Workspace(const Model& model)
      : lobes(model.lobes()), derivatives(model.partials()), scaled(model.lobes() + model.partials() + 1) {
    for (const TermModel& t : model.terms()) {
      terms.emplace_back(t.form);
      for (std::size_t q = 0; q < t.partials; ++q) derivatives[t.first_partial + q].resize(t.lobes);
    }
    storage.resize((scaled.size() + 7 + model.size()) * kBlockRows);
    double* next = storage.data();
    const auto take = [&] { return std::exchange(next, next + kBlockRows); };
    for (double*& column : scaled) column = take();
    for (double** column : {&f, &r, &slope, &rho, &root, &curvature, &mixed}) *column = take();
    for (std::size_t k = 0; k < model.size(); ++k) scores.push_back(take());
    if (model.fits_normal()) make_room_for_normals(model);
  }

  // The stream, shapes and rows of the lobes that the workspace holds.
  std::uint64_t stream = 0;
  Shapes shapes;
  std::size_t first = 0, rows = 0;

  std::vector<LobeColumns> terms;
  std::vector<double*> lobes;                     // of all terms
  std::vector<std::vector<double*>> derivatives;  // [partial][lobe of its term]
  std::vector<double> storage;
  std::vector<double*> scaled;  // lobes, then partials, then the residual
  double *f, *r, *slope, *rho, *root, *curvature, *mixed;
  std::vector<double*> scores;  // [slot]

  // For a fitted normal: the directions in its frame, the ratio of cos_i in that frame to cos_i of the
  // rows, and the derivatives by its components.
  DirectionArrays<double> tilted{0};
  std::vector<double> cosine_ratio, by_normal;
  std::vector<LobeColumns> moved_terms;

 private:
  void make_room_for_normals(const Model& model);
};

using Contributions = std::vector<std::vector<Contribution>>;

// Returns the contributions of the columns (lobes, partials, residual) of one channel. The residual
// contributes nothing.
Contributions contributions(const Model& model, std::span<const double> p, std::size_t channel);

// Adds the products of one channel's columns, `raw`, to the matrix of the solver's parameters, `out`.
void add_mapped(const Contributions& map, const Matrix& raw, Matrix& out);

// Transforms a matrix of the solver's parameters to the columns of one channel.
Matrix of_columns(const Contributions& map, const Matrix& m);

// Copies the entries above the diagonal to their mirrored places below.
void mirror(Matrix& m);

// Returns the inputs of the residuals of one channel for `rows` rows, beginning with `first`. `f` holds the
// values of the model.
ResidualInputs residual_inputs(const FitData& data, std::size_t channel, std::size_t first, std::size_t rows,
                               const double* f);

}  // namespace brdf::fit
