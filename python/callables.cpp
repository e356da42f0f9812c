#include "python/callables.h"

#include <algorithm>
#include <cmath>

#include "python/waiting.h"

namespace brdf::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

Numbers rows(std::size_t count, std::size_t columns) {
  return Numbers({py::ssize_t(count), py::ssize_t(columns)});
}

void set_row(Numbers& to, std::size_t k, const Vec3<double>& w) {
  double* const row = to.mutable_data() + 3 * k;
  row[0] = w.x, row[1] = w.y, row[2] = w.z;
}

Numbers rows_of(std::span<const Vec3<double>> directions) {
  Numbers out = rows(directions.size(), 3);
  for (std::size_t k = 0; k < directions.size(); ++k) set_row(out, k, directions[k]);
  return out;
}

// A direction in every row.
Numbers repeated(const Vec3<double>& direction, std::size_t count) {
  Numbers out = rows(count, 3);
  for (std::size_t k = 0; k < count; ++k) set_row(out, k, direction);
  return out;
}

// Requires that a result that the Python side has checked has this many numbers.
const double* data_of(const Numbers& array, std::size_t count) {
  if (std::size_t(array.size()) != count) throw std::logic_error("the shape of a result was not checked");
  return array.data();
}

void go_on_unless(const std::atomic<bool>& stop) {
  if (stop) throw Stopped{};
}

class CallableReflectance final : public ReflectanceModel {
 public:
  CallableReflectance(const Callables& functions, const std::atomic<bool>& stop)
      : functions_(functions), stop_(stop) {
    info_.name = "eval";
    info_.family = "python";
    info_.channels = functions.channels;
    info_.outside = info_.all_round = true;
  }
  const ReflectanceInfo& info() const override { return info_; }
  void eval(const ParameterValues<double>& p, const Directions<double>& d, double* out) const override {
    write(p.channel, d, false, out);
  }
  void eval_cos(const ParameterValues<double>& p, const Directions<double>& d, double* out) const override {
    write(p.channel, d, true, out);
  }
  using ReflectanceModel::eval;
  using ReflectanceModel::eval_cos;

 private:
  void write(std::size_t channel, const Directions<double>& d, bool times_cosine, double* out) const {
    evaluate(d);
    const bool has_cosine = functions_.returns == SampleValue::f_cos_i;
    for (std::size_t k = 0; k < d.count; ++k) {
      double& to = out[k];
      to = d.wi_z[k] > 0 && d.wo_z[k] > 0 ? values_[k * functions_.channels.size() + channel] : 0;
      if (to != 0 && times_cosine && !has_cosine) to *= d.wi_z[k];
      if (to != 0 && !times_cosine && has_cosine) to /= d.wi_z[k];
    }
  }

  // One call gives the values of all channels, so the last call is kept for the next channel.
  void evaluate(const Directions<double>& d) const {
    std::vector<double> at;
    at.reserve(6 * d.count);
    for (const double* const row : {d.wi_x, d.wi_y, d.wi_z, d.wo_x, d.wo_y, d.wo_z})
      at.insert(at.end(), row, row + d.count);
    if (at == at_) return;
    go_on_unless(stop_);
    at_.clear();
    const py::gil_scoped_acquire lock;
    Numbers wi = rows(d.count, 3), wo = rows(d.count, 3);
    for (std::size_t k = 0; k < d.count; ++k) {
      set_row(wi, k, {d.wi_x[k], d.wi_y[k], d.wi_z[k]});
      set_row(wo, k, {d.wo_x[k], d.wo_y[k], d.wo_z[k]});
    }
    const Numbers result = functions_.eval(wi, wo).cast<Numbers>();
    const std::size_t count = d.count * functions_.channels.size();
    const double* const from = data_of(result, count);
    values_.assign(from, from + count);
    at_ = std::move(at);
  }

  const Callables& functions_;
  const std::atomic<bool>& stop_;
  ReflectanceInfo info_;
  mutable std::vector<double> at_, values_;
};

class CallableSampler final : public DirectionSampler {
 public:
  CallableSampler(const Callables& functions, const std::atomic<bool>& stop)
      : functions_(functions), stop_(stop) {
    facts_.draws = !functions.sample.is_none();
    facts_.gives_pdf = functions.gives_pdf;
    facts_.has_density = !functions.density.is_none();
    facts_.has_eval = !functions.eval.is_none();
    facts_.in_float = false;
    if (functions.gives_value) facts_.values = {{"", functions.value}};
    facts_.randoms = functions.randoms;
    facts_.pdf_name = "the pdf that sample returns";
    facts_.eval_returns = functions.returns;
    facts_.no_sampler = "no sample is given";
    facts_.no_density = "no pdf is given";
    facts_.no_eval = "no eval is given";
    facts_.before_quantity = "value=\"";
    facts_.after_quantity = "\"";
  }
  const SamplerFacts& facts() const override { return facts_; }

  void draw(const Material&, const Vec3<double>& wo, std::span<const double> u, bool,
            std::span<Draw> out) const override {
    go_on_unless(stop_);
    const py::gil_scoped_acquire lock;
    Numbers numbers = rows(out.size(), facts_.randoms);
    std::ranges::copy(u, numbers.mutable_data());
    const py::tuple result = functions_.sample(numbers, repeated(wo, out.size()));
    const auto part = [&](std::size_t k) {
      return result[k].is_none() ? Numbers() : result[k].cast<Numbers>();
    };
    const Numbers wi = part(0), pdf = part(1), value = part(2), valid = part(3);
    const std::size_t count = out.size(), channels = functions_.channels.size();
    const double* const w = data_of(wi, 3 * count);
    const double* const p = facts_.gives_pdf ? data_of(pdf, count) : nullptr;
    const double* const v = facts_.values.empty() ? nullptr : data_of(value, count * channels);
    const double* const is_sample = result[3].is_none() ? nullptr : data_of(valid, count);
    for (std::size_t k = 0; k < count; ++k) {
      Draw& d = out[k];
      d.wi = {w[3 * k], w[3 * k + 1], w[3 * k + 2]};
      d.pdf = p ? per_solid_angle(functions_.measure, p[k], d.wi, wo) : std::nan("");
      d.valid = !is_sample || is_sample[k] != 0;
      for (std::size_t c = 0; v && c < 3; ++c) d.values[0][c] = v[k * channels + std::min(c, channels - 1)];
      d.used = facts_.randoms;
    }
  }

  void density(const Material&, const Vec3<double>& wo, std::span<const Vec3<double>> wi, bool,
               std::span<double> out) const override {
    go_on_unless(stop_);
    const py::gil_scoped_acquire lock;
    const Numbers result = functions_.density(rows_of(wi), repeated(wo, wi.size())).cast<Numbers>();
    const double* const p = data_of(result, wi.size());
    for (std::size_t k = 0; k < wi.size(); ++k) out[k] = per_solid_angle(functions_.measure, p[k], wi[k], wo);
  }

 private:
  const Callables& functions_;
  const std::atomic<bool>& stop_;
  SamplerFacts facts_;
};

}  // namespace

Material material_of_functions(const Callables& functions, const std::atomic<bool>& stop) {
  return make_material(Reflectance(std::make_shared<const CallableReflectance>(functions, stop)),
                       functions.channels);
}

std::unique_ptr<const DirectionSampler> sampler_of_functions(const Callables& functions,
                                                             const std::atomic<bool>& stop) {
  return std::make_unique<const CallableSampler>(functions, stop);
}

}  // namespace brdf::python
