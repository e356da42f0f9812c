#include "fit/prepared.h"

#include "fit/assess/metric_choice.h"

namespace brdf::fit {

Prepared prepared(const io::SampleTable& table, const FitOptions& asked) {
  Prepared out{asked, {}, {}, {}};
  out.options.aperture = aperture_of(table, asked);
  out.data = prepare(table, out.options);
  out.noise.neighbours = io::relative_noise(table, out.data.row);
  out.metric = choose_metric(table, out.data, out.noise.neighbours.value, out.options);
  if (out.options.metric != out.metric.metric) {
    out.options.metric = out.metric.metric;
    out.data = prepare(table, out.options);  // excludes rows that have no residual under this metric
  }
  return out;
}

}  // namespace brdf::fit
