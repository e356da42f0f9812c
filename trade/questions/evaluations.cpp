#include "trade/questions/evaluations.h"

#include <memory>

#include "render/proof/shader_proof.h"
#include "trade/questions/materials.h"
#include "trade/questions/names.h"

namespace brdf::trade {
namespace {

constexpr std::size_t kBatch = 1024;           // fits in the second-level cache
constexpr std::size_t kShaderBatch = 1 << 14;  // a dispatch must last longer than its own overhead

template <class T>
std::vector<T> defaults(std::span<const ParameterInfo> table) {
  std::vector<T> values;
  for (const ParameterInfo& p : table) values.push_back(T(p.initial));
  return values;
}

// Returns pair k of the directions, which are repeated cyclically.
DirectionRow<double> repeated(const Columns<double>& in, std::size_t k) {
  return row_at<DirectionRow>(in, k % count_of(in));
}

// A form at its defaults over given directions, run by one of the methods.
struct Run {
  std::function<void()> run;
  std::function<std::vector<double>()> values;
};
using MakeRun = std::function<Run(const Columns<double>& in, std::size_t count)>;

MakeRun pair_by_pair(const Reflectance& form) {
  struct State {
    Material material;
    DirectionArrays<double> directions;
    std::vector<double> out;
  };
  return [form](const Columns<double>& in, std::size_t count) {
    const auto s = std::make_shared<State>(
        State{make_material(form, {"fr"}), DirectionArrays<double>(count), std::vector<double>(count)});
    for (std::size_t k = 0; k < count; ++k) {
      const DirectionRow<double> row = repeated(in, k);
      s->directions.set(k, row.wi, row.wo);
    }
    const auto run = [s] {
      const Directions<double> d = s->directions.view();
      for (std::size_t k = 0; k < d.count; ++k) eval(s->material, d.wi(k), d.wo(k), std::span(&s->out[k], 1));
      timing::keep(s->out[0]);
    };
    return Run{run, [s] { return s->out; }};
  };
}

template <class T>
MakeRun batch(const Reflectance& form) {
  struct State {
    Reflectance form;
    std::vector<T> weights, shape;
    Slab<T> slab;
  };
  return [form](const Columns<double>& in, std::size_t count) {
    const auto s = std::shared_ptr<State>(
        new State{form, defaults<T>(info(form).weights), defaults<T>(info(form).shape), Slab<T>(6, count)});
    for (std::size_t k = 0; k < count; ++k) {
      const auto numbers = fields_of(repeated(in, k));
      for (std::size_t c = 0; c < 6; ++c) s->slab.column(c)[k] = T(numbers[c]);
    }
    const auto run = [s, count] {
      const auto at = [&](std::size_t c) { return s->slab.column(c); };
      s->form->eval(ParameterValues<T>{s->weights, s->weights, s->shape},
                    Directions<T>{at(0), at(1), at(2), at(3), at(4), at(5), count}, s->slab.output());
      timing::keep(*s->slab.output());
    };
    return Run{run, [s, count] { return std::vector<double>(s->slab.output(), s->slab.output() + count); }};
  };
}

std::vector<render::ProofConfiguration> configurations(const Reflectance& form, const Columns<double>& in,
                                                       std::size_t count) {
  render::ProofConfiguration c;
  const ReflectanceInfo& about = info(form);
  for (std::size_t k = 0; k < about.shape.size(); ++k) c.shape[k] = float(about.shape[k].initial);
  for (std::size_t k = 0; k < about.weights.size(); ++k) c.weights[k].fill(float(about.weights[k].initial));
  std::vector<render::ProofConfiguration> all;
  for (std::size_t k = 0; k < count; ++k) {
    const DirectionRow<double> row = repeated(in, k);
    c.wi = {float(row.wi.x), float(row.wi.y), float(row.wi.z)};
    c.wo = {float(row.wo.x), float(row.wo.y), float(row.wo.z)};
    all.push_back(c);
  }
  return all;
}

MakeRun shader(render::Device& device, const Reflectance& form) {
  return [&device, form](const Columns<double>& in, std::size_t count) {
    const auto s = std::make_shared<render::ShaderBatch>(device, form, configurations(form, in, count));
    const auto values = [s] {
      std::vector<double> first;
      for (const render::ProofValues& v : s->values()) first.push_back(double(v[0]));
      return first;
    };
    return Run{[s] { s->run(); }, values};
  };
}

Values values_of(const MakeRun& make) {
  return [make](const Columns<double>& in) {
    const Run run = make(in, count_of(in));
    run.run();
    return run.values();
  };
}

// Runs that are timed in turn. Each has its own number of directions, and is judged by `exact`.
struct Timed {
  std::string name;
  MakeRun make;
  std::size_t count;
  std::string note;
  MakeRun exact;
};
std::vector<LedgerRow> rows_of(const std::string& question, const std::vector<Timed>& runs,
                               const timing::Options& clock, const PicturePoints* picture) {
  std::vector<std::function<void()>> calls;
  for (const Timed& timed : runs)
    calls.push_back(timed.make(sample(direction_domain(0, 80), timed.count).columns, timed.count).run);
  const std::vector<timing::Timing> timings = timing::interleaved(calls, clock);
  std::vector<LedgerRow> rows;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    LedgerRow row;
    row.question = question;
    row.choice = runs[k].name;
    row.exact = runs[0].name;
    row.quantity = "f_r";
    row.note = runs[k].note;
    set_cost(row, timings[k], double(runs[k].count));
    row.cost_ratio *= double(runs[0].count) / double(runs[k].count);
    const Values values = values_of(runs[k].make), exact = values_of(runs[k].exact);
    Yardstick({direction_domain(0, 80), {direction_domain(85, 89.99)}, 4096, 4096}, exact, picture, exact)
        .judge(row, values, values);
    rows.push_back(std::move(row));
  }
  return rows;
}

// With a software driver, a dispatch is timed by the processor time of all its threads.
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

std::string shader_note(const render::Device& device) {
  return "three channels, f_r and f_r cos_i; all threads of the driver, per pair of directions; device: " +
         device.name();
}

}  // namespace

Values values_of(const Material& material) {
  return [&material](const Columns<double>& in) {
    std::vector<double> out(count_of(in)), channels(material.channels.size());
    for (std::size_t k = 0; k < out.size(); ++k) {
      const auto row = row_at<DirectionRow>(in, k);
      eval(material, row.wi, row.wo, channels);
      out[k] = channels[0];
    }
    return out;
  };
}

EvaluationTimes evaluation_times(const std::vector<Reflectance>& forms, int rounds) {
  const Points points = sample(direction_domain(0, 80), kBatch);
  std::vector<std::function<void()>> calls;
  for (const Reflectance& form : forms) calls.push_back(batch<float>(form)(points.columns, kBatch).run);
  timing::Options options = timed_on(nullptr, rounds);
  options.least_seconds = 1e-3;  // ratios to a form of 0.05 ns
  return {timing::interleaved(calls, options), double(kBatch)};
}

std::vector<LedgerRow> batch_rows(const EvaluationOptions& options) {
  const Reflectance form = reference_form();
  const MakeRun exact = pair_by_pair(form);
  std::vector<Timed> runs{{"a material, pair by pair", exact, kBatch, "eval() of a material", exact},
                          {"batch, double", batch<double>(form), kBatch, "one channel", exact},
                          {"batch, float", batch<float>(form), kBatch, "one channel", exact}};
  if (options.device)
    runs.push_back({"shader on the driver", shader(*options.device, form), kShaderBatch,
                    shader_note(*options.device), exact});
  std::vector<LedgerRow> rows = rows_of("one by one or in batches", runs,
                                        timed_on(options.device, options.quick ? 21 : 41), options.picture);
  for (LedgerRow& row : rows) row.domain += "; " + std::string(info(form).name) + " at its defaults";
  mark_dominated(rows);
  return rows;
}

std::vector<LedgerRow> shader_rows(const EvaluationOptions& options) {
  std::vector<Reflectance> forms{reference_form()};
  for (const Reflectance& form : catalogue())
    if (info(form).canonical && form != forms[0]) forms.push_back(form);
  // Each form is judged by the library's own float values, hence no form can dominate another.
  std::vector<Timed> runs;
  for (const Reflectance& form : forms)
    runs.push_back({std::string(info(form).name), shader(*options.device, form), kShaderBatch,
                    shader_note(*options.device), batch<float>(form)});
  std::vector<LedgerRow> rows = rows_of("a family in the shader", runs,
                                        timed_on(options.device, options.quick ? 21 : 41), options.picture);
  for (LedgerRow& row : rows) {
    row.quantity = "f_r, shader against the library";
    row.domain += "; at the table's defaults";
  }
  return rows;
}

}  // namespace brdf::trade
