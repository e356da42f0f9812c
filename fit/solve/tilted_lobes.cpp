// Lobes of a surface whose normal is fitted: rows hold f_r cos_i of the surface over cos_i of their own frame.
#include <algorithm>
#include <cmath>

#include "brdf/frame.h"
#include "fit/solve/workspace.h"

namespace brdf::fit {
namespace {

// Central differences: for a lobe of width w the error is step^2/w^3 of its height, and 1e-16/step from rounding.
constexpr double kStep = 1e-5;

Vec3<double> moved(const Vec3<double>& normal, int component, double step) {
  const double x = normal.x + (component == 0 ? step : 0), y = normal.y + (component == 1 ? step : 0);
  return {x, y, std::sqrt(std::max(1 - x * x - y * y, 0.0))};
}

}  // namespace

void SampleStream::Workspace::make_room_for_normals(const Model& model) {
  tilted = DirectionArrays<double>(kBlockRows);
  cosine_ratio.resize(kBlockRows);
  for (const TermModel& term : model.terms()) moved_terms.emplace_back(term.form);
  by_normal.assign(2 * model.lobes() * kBlockRows, 0);
  for (const TermModel& term : model.terms())
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t k = 0; k < term.lobes; ++k)
        derivatives[term.first_partial + std::size_t(term.normal_partial) + a][k] =
            &by_normal[(a * model.lobes() + term.first_lobe + k) * kBlockRows];
}

Directions<double> SampleStream::tilt(const Vec3<double>& normal, std::size_t first, std::size_t rows,
                                      Workspace& w) const {
  const Directions<double> directions = data_.directions(first, rows);
  for (std::size_t j = 0; j < rows; ++j) {
    const Vec3<double> wi = in_frame_of(normal, directions.wi(j));
    w.tilted.set(j, wi, in_frame_of(normal, directions.wo(j)));
    w.cosine_ratio[j] = wi.z / directions.wi_z[j];
  }
  Directions<double> out = w.tilted.view();
  out.count = rows;
  return out;
}

void SampleStream::fill_tilted(const Shapes& shapes, std::size_t first, std::size_t rows,
                               Workspace& w) const {
  for (std::size_t k = 0; k < model_.lobes(); ++k)
    for (std::size_t j = 0; j < rows; ++j) w.lobes[k][j] *= w.cosine_ratio[j];
  if (!shapes.derivatives) return;
  for (const TermModel& term : model_.terms())
    for (std::size_t q = 0; q < std::size_t(term.normal_partial); ++q)
      for (double* column : w.derivatives[term.first_partial + q])
        for (std::size_t j = 0; j < rows; ++j) column[j] *= w.cosine_ratio[j];
  std::fill(w.by_normal.begin(), w.by_normal.end(), 0.0);
  for (int a = 0; a < 2; ++a)
    for (const double side : {1.0, -1.0}) {
      const Directions<double> directions = tilt(moved(shapes.normal, a, side * kStep), first, rows, w);
      for (std::size_t t = 0; t < model_.terms().size(); ++t) {
        const TermModel& term = model_.terms()[t];
        LobeColumns& columns = w.moved_terms[t];
        columns.evaluate(shapes.shape[t], shapes.tangent_phi, Partial::none, directions, detector_);
        for (std::size_t k = 0; k < term.lobes; ++k) {
          double* out = w.derivatives[term.first_partial + std::size_t(term.normal_partial + a)][k];
          for (std::size_t j = 0; j < rows; ++j)
            out[j] += side / (2 * kStep) * columns.lobe(k)[j] * w.cosine_ratio[j];
        }
      }
    }
}

}  // namespace brdf::fit
