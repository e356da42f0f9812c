#include "measured/cells.h"

#include <cmath>

#include "io/files/error.h"
#include "io/files/parallel.h"
#include "io/formats/merl.h"
#include "io/samples/degrees.h"
#include "measured/tabulated.h"

namespace brdf::measured {

io::SampleTable at_merl_cells(const std::shared_ptr<const MeasuredReflectance>& measured) {
  if (measured->turning() == Turning::turned)
    throw InputError("the reflectance changes when the sample is rotated, which MERL files cannot represent");
  const Tabulated kept(measured);
  io::SampleTable all;
  io::merl::add_cell_directions(all);
  std::vector<Seen> seen(all.rows());
  io::parallel_for(all.rows(), [&](std::size_t k) {
    seen[k] =
        kept.at(io::unit_vector(all.theta_i[k], all.phi_i[k]), io::unit_vector(all.theta_o[k], all.phi_o[k]));
  });
  io::SampleTable out;
  out.set_channels(measured->channels());
  for (std::size_t k = 0; k < all.rows(); ++k) {
    if (!seen[k].measured) continue;
    out.add_directions(all.theta_i[k], all.phi_i[k], all.theta_o[k], all.phi_o[k]);
    for (std::size_t c = 0; c < out.values.size(); ++c) out.values[c].push_back(std::fmax(seen[k].f[c], 0));
  }
  return out;
}

}  // namespace brdf::measured
