#include "render/viewer/session.h"

#include <algorithm>

#include "io/files/output.h"
#include "io/material/material_json.h"
#include "render/gpu/held.h"

namespace brdf::render {
namespace {

// Returns the parts of the state that leaving would lose, without the settings of the view.
ViewState work_of(const ViewState& state) {
  ViewState work;
  work.scene = state.scene;
  work.scene.camera = {};
  work.scene.exposure = 0;
  work.scene.tone_map = {};
  work.scene.shading = {};
  work.material = state.material;
  work.kept = state.kept;
  work.samples = state.samples;
  return work;
}

}  // namespace

Session::Session(ViewState state, std::filesystem::path file)
    : state_(std::move(state)), history_(state_), file_(std::move(file)), opened_(state_), kept_(state_) {}

std::string Session::undo() {
  record();
  const ViewState before = state_;
  const ViewState* back = history_.back();
  if (!back) return "";
  state_ = *back;
  return what_differs(before, state_);
}

std::string Session::redo() {
  record();
  const ViewState before = state_;
  const ViewState* forth = history_.forth();
  if (!forth) return "";
  state_ = *forth;
  return what_differs(before, state_);
}

void Session::arrived(const std::filesystem::path& file) {
  file_ = file;
  opened_ = kept_ = state_;
  forms_.clear();
}

void Session::open(const std::filesystem::path& file, const std::function<void()>& check) {
  record();
  const ViewState before = state_;
  try {
    open_file(state_, file);
    give_room(state_);
    check();
  } catch (...) {
    state_ = before;
    throw;
  }
  // Samples are opened in addition to the present state and replace nothing. A material that was changed
  // stays marked as changed.
  if (state_.samples == before.samples)
    arrived(file);
  else
    kept_.samples = opened_.samples = state_.samples;
  record();
}

void Session::revert() {
  record();
  state_ = opened_;
  record();
}

void Session::save_state(const std::filesystem::path& file, int width, int height) {
  ViewState saved = state_;
  saved.scene.camera.width = width;
  saved.scene.camera.height = height;
  io::write_file_atomically(file, state_text(saved));
  kept_ = state_;
}

void Session::save_material(const std::filesystem::path& file) {
  const Object& object = state_.scene.objects.at(state_.selected);
  io::MaterialFile written{object.material, {}};
  written.name = object.material_name;
  io::write_material_file(file, written);
  if (kept_.scene.objects.size() == state_.scene.objects.size())
    kept_.scene.objects[state_.selected].material = object.material;
}

bool Session::changed() const {
  return work_of(state_) != work_of(kept_);
}

std::string Session::title() const {
  const std::string name = file_.empty() ? "brdf" : file_.filename().string() + " - brdf";
  return changed() ? "* " + name : name;
}

std::string Session::name_of_a() const {
  const Object& object = state_.scene.objects.at(state_.selected);
  const auto& kept = kept_.scene.objects;
  const bool same = state_.selected < kept.size() && kept[state_.selected].material == object.material;
  const std::string name = object.material_name.empty() ? "material" : object.material_name;
  return same ? name : name + " (changed)";
}

const Term* Session::in_file(std::size_t term) const {
  const auto& objects = opened_.scene.objects;
  if (state_.selected >= objects.size()) return nullptr;
  const std::vector<Term>& terms = objects[state_.selected].material.terms;
  const std::vector<Term>& own = state_.scene.objects[state_.selected].material.terms;
  if (term >= terms.size() || term >= own.size() || !(terms[term].form == own[term].form)) return nullptr;
  const bool same_layout = terms[term].weights.size() == own[term].weights.size() &&
                           terms[term].shape.size() == own[term].shape.size();
  return same_layout ? &terms[term] : nullptr;
}

void Session::switch_form(std::size_t term, const Reflectance& form) {
  Term& own = state_.scene.objects[state_.selected].material.terms.at(term);
  std::vector<Term>& known = forms_[{state_.selected, term}];
  const auto of = [&](const Reflectance& wanted) {
    return std::ranges::find_if(known, [&](const Term& t) { return t.form == wanted; });
  };
  if (const auto old = of(own.form); old != known.end())
    *old = own;
  else
    known.push_back(own);
  const auto kept = of(form);
  if (kept != known.end() && kept->weights.size() == own.weights.size())
    own = *kept;
  else
    render::switch_form(own, form);
}

std::string object_name(const Object& object, std::size_t place) {
  std::string name = std::to_string(place + 1) + " ";
  if (!object.label.empty()) return name + object.label;
  if (object.mesh != Object().mesh) name += std::filesystem::path(object.mesh).stem().string() + ", ";
  return name + object.material_name;
}

}  // namespace brdf::render
