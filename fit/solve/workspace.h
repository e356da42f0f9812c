// What the passes over the samples share: the columns of a block of rows, and where each column's sums go.
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

// Columns of one block. Entries beyond the last row stay 0 in `slope`, which every sum is multiplied by.
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

  // Whose lobes these are.
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

  // Of a fitted normal: the directions in its frame, cos_i there over that of the rows, and the derivatives
  // by its components.
  DirectionArrays<double> tilted{0};
  std::vector<double> cosine_ratio, by_normal;
  std::vector<LobeColumns> moved_terms;

 private:
  void make_room_for_normals(const Model& model);
};

using Contributions = std::vector<std::vector<Contribution>>;

// Of the columns (lobes, partials, residual) of one channel; the residual has none.
Contributions contributions(const Model& model, std::span<const double> p, std::size_t channel);

void add_mapped(const Contributions& map, const Matrix& raw, Matrix& out);

// The matrix of the solver's parameters as seen by one channel's columns.
Matrix of_columns(const Contributions& map, const Matrix& m);

// What stands above the diagonal below it too.
void mirror(Matrix& m);

ResidualInputs residual_inputs(const FitData& data, std::size_t channel, std::size_t first, std::size_t rows,
                               const double* f);

}  // namespace brdf::fit
