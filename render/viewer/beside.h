// The samples shown with the material: the material's error at the samples, and fits that start from the
// material.
#pragma once

#include "measured/residual_map.h"
#include "render/viewer/fit_task.h"
#include "render/viewer/session.h"

namespace brdf::render {

class Beside {
 public:
  explicit Beside(const Solver& solver) : solver_(solver) {}

  // Reads the samples of the state if the state has other samples than before, and computes the error.
  // `held`: error_before() stays unchanged. A file that cannot be read counts as no samples; drawing
  // reports the reason.
  void look(const Session& session, bool held);
  const io::SampleTable* samples() const { return table_ ? &*table_ : nullptr; }
  // The samples in the colours of a picture, as the plots draw them.
  const io::SampleTable* samples_in_colour() const { return in_colour_ ? &*in_colour_ : samples(); }
  // Returns the mean ln(A/measured) over the half angles (measured/residual_map.h) for the selected object.
  // Null without samples, or if the samples share no channel with A.
  const std::vector<double>* residuals(const Session& session);
  std::optional<double> error() const { return error_; }
  std::optional<double> error_before() const { return before_; }

  bool can_fit() const { return solver_.fit && table_; }
  // Starts a fit from the selected object's material. Throws InputError if there are no samples or no
  // solver.
  void fit(const Session& session);
  void stop() { task_.stop(); }
  bool fitting() const { return task_.running(); }
  double seconds() const { return task_.seconds(); }
  // Puts the result of a finished fit into the object, as one step of the history, and returns a
  // description; empty if there is no result. Throws the exception of the fit.
  std::string take(Session& session);
  // Returns the intervals of the last fit; empty for other objects or samples, or if the object's forms
  // have changed.
  const std::vector<Interval>& intervals(const Session& session) const;

 private:
  Solver solver_;
  std::filesystem::path file_;
  std::optional<io::SampleTable> table_, in_colour_;  // in_colour_: if the samples are spectra
  std::optional<Material> compared_, mapped_;
  std::optional<measured::ResidualMap> map_;  // computed when first needed
  std::vector<double> residuals_;
  std::optional<double> error_, before_;
  FitTask task_;
  std::size_t object_ = 0;
  std::string name_;                 // material that was fitted
  std::filesystem::path fitted_to_;  // samples of the last fit
  Fitted fitted_;
};

}  // namespace brdf::render
