#include "trade/questions/evaluations.h"

#include <list>

#include "brdf/forms.h"
#include "render/proof/shader_proof.h"

namespace brdf::trade {
namespace {

constexpr std::size_t kBatch = 1024;           // stays in the second-level cache
constexpr std::size_t kShaderBatch = 1 << 14;  // a dispatch must outlast its own overhead

template <class T>
std::vector<T> defaults(std::span<const ParameterInfo> table) {
  std::vector<T> values;
  for (const ParameterInfo& p : table) values.push_back(T(p.initial));
  return values;
}

// One form at its defaults over given directions, in one of the ways.
class Way {
 public:
  virtual ~Way() = default;
  virtual void run() = 0;
  virtual std::vector<double> values() const = 0;
};

class PairByPair : public Way {
 public:
  PairByPair(const Reflectance& form, const Columns<double>& in, std::size_t count)
      : material_(make_material(form, {"fr"})), directions_(count), out_(count) {
    for (std::size_t k = 0; k < count; ++k) {
      const auto at = [&](std::size_t c) { return in[c][k % in[c].size()]; };
      directions_.set(k, {at(0), at(1), at(2)}, {at(3), at(4), at(5)});
    }
  }
  void run() override {
    const Directions<double> d = directions_.view();
    for (std::size_t k = 0; k < out_.size(); ++k) eval(material_, d.wi(k), d.wo(k), std::span(&out_[k], 1));
    timing::keep(out_[0]);
  }
  std::vector<double> values() const override { return out_; }

 private:
  Material material_;
  DirectionArrays<double> directions_;
  std::vector<double> out_;
};

template <class T>
class Batch : public Way {
 public:
  Batch(const Reflectance& form, const Columns<double>& in, std::size_t count)
      : form_(form),
        weights_(defaults<T>(info(form).weights)),
        shape_(defaults<T>(info(form).shape)),
        slab_(6, count),
        count_(count) {
    for (std::size_t c = 0; c < 6; ++c)
      for (std::size_t k = 0; k < count; ++k) slab_.column(c)[k] = T(in[c][k % in[c].size()]);
  }
  void run() override {
    const auto at = [this](std::size_t c) { return slab_.column(c); };
    form_->eval(ParameterValues<T>{weights_, weights_, shape_},
                Directions<T>{at(0), at(1), at(2), at(3), at(4), at(5), count_}, slab_.output());
    timing::keep(*slab_.output());
  }
  std::vector<double> values() const override { return {slab_.output(), slab_.output() + count_}; }

 private:
  Reflectance form_;
  std::vector<T> weights_, shape_;
  Slab<T> slab_;
  std::size_t count_;
};

std::vector<render::ProofConfiguration> configurations(const Reflectance& form, const Columns<double>& in,
                                                       std::size_t count) {
  render::ProofConfiguration c;
  const ReflectanceInfo& about = info(form);
  for (std::size_t k = 0; k < about.shape.size(); ++k) c.shape[k] = float(about.shape[k].initial);
  for (std::size_t k = 0; k < about.weights.size(); ++k) c.weights[k].fill(float(about.weights[k].initial));
  std::vector<render::ProofConfiguration> all;
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      c.wi[axis] = float(in[axis][k % in[axis].size()]);
      c.wo[axis] = float(in[3 + axis][k % in[axis].size()]);
    }
    all.push_back(c);
  }
  return all;
}

class Shader : public Way {
 public:
  Shader(render::Device& device, const Reflectance& form, const Columns<double>& in, std::size_t count)
      : batch_(device, form, configurations(form, in, count)) {}
  void run() override { batch_.run(); }
  std::vector<double> values() const override {
    std::vector<double> first;
    for (const render::ProofValues& v : batch_.values()) first.push_back(double(v[0]));
    return first;
  }

 private:
  render::ShaderBatch batch_;
};

// A way of this kind over any directions.
using MakeWay = std::function<std::unique_ptr<Way>(const Columns<double>&, std::size_t)>;

std::vector<double> values_of(const MakeWay& make, const Columns<double>& in, std::size_t count) {
  const std::unique_ptr<Way> way = make(in, count);
  way->run();
  return way->values();
}

// Errors of a way against given values: everyday, extreme and in the picture.
void set_errors(LedgerRow& row, const MakeWay& way, const MakeWay& exact, const PicturePoints* picture) {
  const auto error = [&](const Domain& domain) {
    const Points points = sample(domain, 4096);
    return error_of(values_of(way, points.columns, points.count()),
                    values_of(exact, points.columns, points.count()), Measure::relative, 0, domain, points);
  };
  row.quantity = "f_r";
  row.error = error(pairs_domain(0, 80));
  const Domain grazing = pairs_domain(85, 89.99);
  row.extremes.push_back({describe(grazing), error(grazing).max});
  if (picture)
    row.image_error = image_error(values_of(way, picture->columns, picture->count()),
                                  values_of(exact, picture->columns, picture->count()), *picture);
}

// On a software driver a dispatch costs the processor's time, of all its threads.
timing::Options timed_on(render::Device* device, int rounds) {
  timing::Options options;
  options.rounds = rounds;
  if (!device) {
    options.clock = timing::Clock::thread;
    return options;
  }
  options.clock = render::is_software(*device) ? timing::Clock::process : timing::Clock::wall;
  options.least_seconds = 5e-3;  // many dispatches in a row: their buffers do not fit the cache together
  return options;
}

constexpr const char* kShaderNote =
    "three channels, f_r and f_r cos_i; all threads of the driver; per pair of directions";

}  // namespace

std::vector<double> values_at(const Material& material, const Columns<double>& in, std::size_t count) {
  std::vector<double> out(count), channels(material.channels.size());
  for (std::size_t k = 0; k < count; ++k) {
    eval(material, {in[0][k], in[1][k], in[2][k]}, {in[3][k], in[4][k], in[5][k]}, channels);
    out[k] = channels[0];
  }
  return out;
}

EvaluationTimes evaluation_times(const std::vector<Reflectance>& forms, int rounds) {
  const Points points = sample(pairs_domain(0, 80), kBatch);
  std::list<Batch<float>> batches;
  for (const Reflectance& form : forms) batches.emplace_back(form, points.columns, kBatch);
  std::vector<std::function<void()>> calls;
  for (Batch<float>& batch : batches) calls.push_back([&batch] { batch.run(); });
  timing::Options options = timed_on(nullptr, rounds);
  options.least_seconds = 1e-3;  // ratios to a form of 0.05 ns
  return {timing::interleaved(calls, options), double(kBatch)};
}

std::vector<LedgerRow> batch_rows(const EvaluationOptions& options) {
  const Reflectance form = cook_torrance{};
  struct Kind {
    const char* name;
    MakeWay make;
    std::size_t count;
    std::string note;
  };
  std::vector<Kind> kinds{
      {"a material, pair by pair",
       [&](const Columns<double>& in, std::size_t n) { return std::make_unique<PairByPair>(form, in, n); },
       kBatch, "eval() of a material"},
      {"batch, double",
       [&](const Columns<double>& in, std::size_t n) { return std::make_unique<Batch<double>>(form, in, n); },
       kBatch, "one channel"},
      {"batch, float",
       [&](const Columns<double>& in, std::size_t n) { return std::make_unique<Batch<float>>(form, in, n); },
       kBatch, "one channel"}};
  if (options.device)
    kinds.push_back({"shader on the driver",
                     [&](const Columns<double>& in, std::size_t n) {
                       return std::make_unique<Shader>(*options.device, form, in, n);
                     },
                     kShaderBatch, std::string(kShaderNote) + "; on " + options.device->name()});
  const Domain domain = pairs_domain(0, 80);
  const Points points = sample(domain, kBatch);
  std::vector<std::unique_ptr<Way>> ways;
  std::vector<std::function<void()>> calls;
  for (const Kind& kind : kinds) {
    ways.push_back(kind.make(points.columns, kind.count));
    calls.push_back([way = ways.back().get()] { way->run(); });
  }
  const std::vector<timing::Timing> timings =
      timing::interleaved(calls, timed_on(options.device, options.quick ? 21 : 41));
  std::vector<LedgerRow> rows;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    LedgerRow row;
    row.question = "one by one or in batches";
    row.choice = kinds[k].name;
    row.exact = kinds[0].name;
    set_cost(row, timings[k], double(kinds[k].count));
    row.cost_ratio *= double(kBatch) / double(kinds[k].count);
    set_errors(row, kinds[k].make, kinds[0].make, options.picture);
    row.domain = describe(domain) + "; cook_torrance at its defaults";
    row.note = kinds[k].note;
    rows.push_back(std::move(row));
  }
  mark_dominated(rows);
  return rows;
}

std::vector<LedgerRow> shader_rows(const EvaluationOptions& options) {
  std::vector<Reflectance> forms{cook_torrance{}};
  for (const Reflectance& form : catalogue())
    if (info(form).canonical && form != forms[0]) forms.push_back(form);
  const Domain domain = pairs_domain(0, 80);
  const Points points = sample(domain, kShaderBatch);
  std::vector<std::unique_ptr<Way>> ways;
  std::vector<std::function<void()>> calls;
  for (const Reflectance& form : forms) {
    ways.push_back(std::make_unique<Shader>(*options.device, form, points.columns, kShaderBatch));
    calls.push_back([way = ways.back().get()] { way->run(); });
  }
  const std::vector<timing::Timing> timings =
      timing::interleaved(calls, timed_on(options.device, options.quick ? 21 : 41));
  // Each is judged by the library's own float values, so none can dominate another.
  std::vector<LedgerRow> rows;
  for (std::size_t k = 0; k < forms.size(); ++k) {
    LedgerRow row;
    row.question = "a family in the shader";
    row.choice = info(forms[k]).name;
    row.exact = "cook_torrance";
    set_cost(row, timings[k], double(kShaderBatch));
    const Reflectance form = forms[k];
    set_errors(
        row,
        [&](const Columns<double>& in, std::size_t n) {
          return std::make_unique<Shader>(*options.device, form, in, n);
        },
        [&](const Columns<double>& in, std::size_t n) { return std::make_unique<Batch<float>>(form, in, n); },
        options.picture);
    row.quantity = "f_r, shader against the library";
    row.domain = describe(domain) + "; at the table's defaults";
    row.note = std::string(kShaderNote) + "; on " + options.device->name();
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace brdf::trade
