#include "io/samples/arrange.h"

#include "io/samples/repetition.h"
#include "io/samples/table_rules.h"

namespace brdf::io {

Supplied supplied_for(Supplied supplied, const Arrangement& asked) {
  supplied.polarised = asked.polarisation != Polarisation::keep;
  return supplied;
}

void arrange(SampleTable& table, const Arrangement& asked) {
  if (asked.polarisation != Polarisation::keep) choose_polarisation(table, asked.polarisation);
  if (asked.repeats == Repeats::average) average_repeats(table);
  if (asked == Arrangement()) return;
  leave_out_repetitions(table);  // rows may have become equal
  check_table(table);
}

}  // namespace brdf::io
