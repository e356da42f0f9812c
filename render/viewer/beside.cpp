#include "render/viewer/beside.h"

#include <algorithm>
#include <cmath>

#include "io/colour/in_colour.h"
#include "io/files/error.h"
#include "io/formats/read.h"

namespace brdf::render {
namespace {

constexpr std::size_t kMappedRows = 4000;  // rows in the map of residuals, few enough for a slider

const Material& selected(const Session& session) {
  return session.state().scene.objects[session.state().selected].material;
}

bool same_forms(const Material& a, const Material& b) {
  if (a.channels != b.channels || a.terms.size() != b.terms.size()) return false;
  for (std::size_t t = 0; t < a.terms.size(); ++t)
    if (!(a.terms[t].form == b.terms[t].form) || a.terms[t].shape.size() != b.terms[t].shape.size())
      return false;
  return true;
}

}  // namespace

void Beside::look(const Session& session, bool held) {
  const std::filesystem::path& file = session.state().samples;
  if (file != file_) {
    file_ = file;
    table_.reset();
    in_colour_.reset();
    map_.reset();
    compared_.reset();
    mapped_.reset();
    try {
      if (!file.empty()) table_ = io::read_samples(file);
      if (table_ && io::is_spectrum(table_->channels)) in_colour_ = io::in_colour(*table_);
    } catch (const InputError&) {
    }
  }
  const Material& material = selected(session);
  if (!held) before_ = error_;
  if (compared_ == material && table_) return;
  compared_ = material;
  error_.reset();
  if (!table_ || !solver_.error) return;
  const double error = solver_.error(material, *table_);
  if (std::isfinite(error)) error_ = error;
}

const std::vector<double>* Beside::residuals(const Session& session) {
  const io::SampleTable* table = samples_in_colour();
  if (!table) return nullptr;
  const Material& material = selected(session);
  if (mapped_ != material) {
    if (!map_) map_.emplace(*table, kMappedRows);
    mapped_ = material;
    residuals_ = map_->cells(io::in_colour(material));
  }
  const bool none = std::ranges::all_of(residuals_, [](double v) { return std::isnan(v); });
  return none ? nullptr : &residuals_;
}

void Beside::fit(const Session& session) {
  if (task_.running()) return;
  if (!solver_.fit) throw InputError("this build cannot fit");
  if (!table_) throw InputError("there are no samples: open samples first");
  object_ = session.state().selected;
  task_.start(solver_, selected(session), *table_);
}

std::string Beside::take(Session& session) {
  std::optional<Fitted> found = task_.take();
  if (!found) return "";
  fitted_ = std::move(*found);
  if (object_ >= session.state().scene.objects.size()) return "";
  session.record();
  name_ = session.state().scene.objects[object_].material_name;
  fitted_to_ = file_;
  session.state().scene.objects[object_].material = fitted_.material;
  session.record();
  return fitted_.words;
}

const std::vector<Interval>& Beside::intervals(const Session& session) const {
  static const std::vector<Interval> none;
  const ViewState& state = session.state();
  const bool its_own = state.selected == object_ && state.samples == fitted_to_ &&
                       state.scene.objects[object_].material_name == name_;
  return its_own && same_forms(fitted_.material, selected(session)) ? fitted_.intervals : none;
}

}  // namespace brdf::render
