// The samples beside the material: how far it is from them, and the solver that goes on from it.
#pragma once

#include "measured/residual_map.h"
#include "render/viewer/fit_task.h"
#include "render/viewer/session.h"

namespace brdf::render {

class Beside {
 public:
  explicit Beside(const Solver& solver) : solver_(solver) {}

  // Reads the samples that the state names, where they are others than before, and compares. `held`: the
  // error so far stays as the one before. A file that cannot be read is as none: drawing says why.
  void look(const Session& session, bool held);
  const io::SampleTable* samples() const { return table_ ? &*table_ : nullptr; }
  // The same as a picture shows them: what plots draw.
  const io::SampleTable* samples_in_colour() const { return in_colour_ ? &*in_colour_ : samples(); }
  // Mean ln(A/measured) over the half angles (measured/residual_map.h); of the selected object. Null without
  // samples, and where none of their channels is A's.
  const std::vector<double>* residuals(const Session& session);
  std::optional<double> error() const { return error_; }
  std::optional<double> error_before() const { return before_; }

  bool can_fit() const { return solver_.fit && table_; }
  // From the selected object's material. Throws InputError where there is nothing to fit to.
  void fit(const Session& session);
  void stop() { task_.stop(); }
  bool fitting() const { return task_.running(); }
  double seconds() const { return task_.seconds(); }
  // What it found goes into the object, as one step; in words, empty while there is nothing. Throws what the
  // fit threw.
  std::string take(Session& session);
  // Of the last fit; none of other objects, beside other samples, or where the object has other forms now.
  const std::vector<Interval>& intervals(const Session& session) const;

 private:
  Solver solver_;
  std::filesystem::path file_;
  std::optional<io::SampleTable> table_, in_colour_;  // in_colour_: of a spectrum
  std::optional<Material> compared_, mapped_;
  std::optional<measured::ResidualMap> map_;  // made when it is first asked for
  std::vector<double> residuals_;
  std::optional<double> error_, before_;
  FitTask task_;
  std::size_t object_ = 0;
  std::string name_;                 // of the material that was fitted,
  std::filesystem::path fitted_to_;  // and the samples
  Fitted fitted_;
};

}  // namespace brdf::render
