// Lobes of a surface with a fitted normal. Rows hold f_r cos_i of the surface divided by cos_i of their own
// frame.
#include <algorithm>
#include <cmath>

#include "fit/solve/workspace.h"

namespace brdf::fit {
namespace {

// Step of central differences. For a lobe of width w the error is step^2/w^3 of its height, plus 1e-16/step
// from rounding.
constexpr double kTiltStep = 1e-5;

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
  tilt_batch(directions, normal, w.tilted);
  Directions<double> out = w.tilted.view();
  out.count = rows;
  divide(out.wi_z, directions.wi_z, rows, w.cosine_ratio.data());
  return out;
}

void SampleStream::fill_tilted(const Shapes& shapes, std::size_t first, std::size_t rows,
                               Workspace& w) const {
  const double* const ratio = w.cosine_ratio.data();
  for (double* lobe : w.lobes) scale(ratio, rows, lobe);
  if (!shapes.derivatives) return;
  for (const TermModel& term : model_.terms())
    for (std::size_t q = 0; q < std::size_t(term.normal_partial); ++q)
      for (double* column : w.derivatives[term.first_partial + q]) scale(ratio, rows, column);
  std::ranges::fill(w.by_normal, 0.0);
  for (int a = 0; a < 2; ++a)
    for (const double side : {1.0, -1.0}) {
      const Directions<double> directions = tilt(moved(shapes.normal, a, side * kTiltStep), first, rows, w);
      for (std::size_t t = 0; t < model_.terms().size(); ++t) {
        const TermModel& term = model_.terms()[t];
        LobeColumns& columns = w.moved_terms[t];
        columns.evaluate(shapes.shape[t], shapes.tangent_phi, Partial::none, directions, detector_);
        for (std::size_t k = 0; k < term.lobes; ++k) {
          double* out = w.derivatives[term.first_partial + std::size_t(term.normal_partial + a)][k];
          add_product(side / (2 * kTiltStep), columns.lobe(k), ratio, rows, out);
        }
      }
    }
}

}  // namespace brdf::fit
