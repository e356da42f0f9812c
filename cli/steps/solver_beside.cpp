#include "cli/steps/solver_beside.h"

#ifdef BRDF_HAS_FIT

#include <memory>

#include "brdf/aperture.h"
#include "fit/assess/errors.h"
#include "fit/choice.h"
#include "fit/fit.h"
#include "fit/model/constraints.h"
#include "fit/report/states.h"
#include "io/files/numbers.h"
#include "io/samples/aperture.h"

namespace brdf::cli {
namespace {

constexpr std::size_t kComparedRows = 4000;  // limit of rows while a slider moves

fit::FitOptions default_options() {
  return fit::options_of(fit::FitChoice{});
}

std::vector<Reflectance> forms_in(const Material& material) {
  std::vector<Reflectance> forms;
  for (const Term& term : material.terms) forms.push_back(term.form);
  return forms;
}

// Compares materials with one table after another. The rows of each table are prepared once.
class Comparison {
 public:
  explicit Comparison(std::size_t most_rows) : most_rows_(most_rows) {}
  double operator()(const Material& material, const io::SampleTable& table) {
    if (table.source != source_ || table.rows() != rows_) {
      data_ = fit::thinned(fit::prepare(table, default_options()), most_rows_);
      // The fit averages over this field, too.
      field_ = aperture_nodes(degrees(io::stated_aperture(table).value_or(0)));
      source_ = table.source;
      rows_ = table.rows();
    }
    if (material.channels.size() != data_.channels.size()) return fit::kUnknown;
    std::vector<std::vector<double>> model(material.channels.size(), std::vector<double>(data_.rows(), 0));
    std::vector<double> one(data_.rows());
    const Directions<double> centres = data_.directions(0, data_.rows());
    DirectionArrays<double> seen(data_.rows());
    for (const ApertureNode& node : field_) {
      for (std::size_t k = 0; k < one.size(); ++k)
        seen.set(k, centres.wi(k),
                 field_.size() == 1 ? centres.wo(k) : aperture_direction(centres.wo(k), node));
      for (std::size_t c = 0; c < model.size(); ++c)
        for (const Term& term : material.terms) {
          eval_batch(term, c, seen.view(), one.data());
          for (std::size_t k = 0; k < one.size(); ++k) model[c][k] += node.weight * one[k];
        }
    }
    return fit::relative_errors(data_, model, {0, data_.rows()}).median;
  }

 private:
  std::size_t most_rows_;
  std::string source_;
  std::size_t rows_ = 0;
  fit::FitData data_;
  std::vector<ApertureNode> field_;  // of the detector
};

// Returns the shape parameters as starting point. The weights are linear, and the solver finds their best
// values.
std::vector<fit::NamedValues> start_of(const Material& from, const fit::FitOptions& options) {
  const std::vector<Reflectance> forms = forms_in(from);
  const fit::Constraints known = fit::resolve(forms, from.channels, options);
  std::vector<fit::NamedValues> start;
  for (std::size_t t = 0; t < from.terms.size(); ++t) {
    const ReflectanceInfo& form = info(from.terms[t].form);
    for (std::size_t k = 0; k < form.shape.size(); ++k) {
      if (!known.terms[t].shape[k].idle.empty()) continue;
      fit::NamedValues one{fit::name_in_sum(forms.size(), t, form.shape[k].name), {}};
      for (const std::vector<double>& set : from.terms[t].shape) one.values.push_back(set[k]);
      start.push_back(std::move(one));
    }
  }
  return start;
}

// Adds the interval of an estimate at its position in the material's tables. Other estimates are ignored.
void add_interval(const fit::Estimate& found, const Material& material, std::vector<render::Interval>& out) {
  const bool known = found.status == fit::Status::free || found.status == fit::Status::at_bound;
  if (!known) return;
  const auto add = [&](std::size_t term, bool is_weight, std::size_t k, std::size_t sets) {
    for (std::size_t c = 0; c < sets; ++c)
      if (found.channel.empty() || sets == 1 || material.channels[c] == found.channel)
        out.push_back({term, is_weight, k, c, found.low, found.high});
  };
  for (std::size_t t = 0; t < material.terms.size(); ++t) {
    const ReflectanceInfo& form = info(material.terms[t].form);
    const auto is_it = [&](std::string_view name) {
      return fit::name_in_sum(material.terms.size(), t, name) == found.name;
    };
    const auto [along, across] = form.axes();
    for (std::size_t k = 0; k < form.shape.size(); ++k)
      if (is_it(form.shape[k].name) || ((int(k) == along || int(k) == across) && is_it(form.tied_name())))
        add(t, false, k, material.terms[t].shape.size());
    for (std::size_t k = 0; k < form.weights.size(); ++k)
      if (is_it(form.weights[k].name)) add(t, true, k, material.terms[t].weights.size());
  }
}

render::Fitted go_on(const Material& from, const io::SampleTable& table, const std::atomic<bool>& stop) {
  fit::FitOptions options = default_options();
  options.grid_starts = options.cross_validation = false;
  options.interrupted = &stop;
  options.anisotropic = is_anisotropic(from);
  for (const Term& term : from.terms) options.per_channel |= term.shape.size() > 1;
  options.start = start_of(from, options);
  const fit::FitResult result = fit::fit(table, {forms_in(from)}, options);
  const fit::FormFit& best = result.ranking.front();
  render::Fitted fitted{best.solved() ? best.material : from, {}, {}};
  for (const fit::Estimate& estimate : best.estimates)
    add_interval(estimate, fitted.material, fitted.intervals);
  fitted.words = fit::verdict_sentence(best);
  if (!best.findings.empty()) fitted.words += "; " + best.findings.front();
  return fitted;
}

}  // namespace

render::Solver solver_beside() {
  return {[compare = std::make_shared<Comparison>(kComparedRows)](
              const Material& material, const io::SampleTable& table) { return (*compare)(material, table); },
          go_on};
}

double median_deviation(const Material& material, const io::SampleTable& table) {
  return Comparison(table.rows())(material, table);
}

}  // namespace brdf::cli

#else

#include <limits>

namespace brdf::cli {

render::Solver solver_beside() {
  return {};
}

double median_deviation(const Material&, const io::SampleTable&) {
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace brdf::cli

#endif
