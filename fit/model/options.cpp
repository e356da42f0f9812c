#include "fit/model/options.h"

#include "io/relative_scale.h"

namespace brdf::fit {

io::SampleTable arranged(io::SampleTable table, const FitOptions& options) {
  io::arrange(table, options.arrangement);
  if (options.free_scale) io::make_relative(table);
  return table;
}

}  // namespace brdf::fit
