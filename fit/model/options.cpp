#include "fit/model/options.h"

#include <stdexcept>

#include "io/columns/layout.h"
#include "io/files/text.h"
#include "io/samples/aperture.h"

namespace brdf::fit {

double aperture_of(const io::SampleTable& table, const FitOptions& options) {
  return options.aperture ? *options.aperture : io::stated_aperture(table).value_or(0);
}

double FitOptions::resolved_aperture() const {
  if (!aperture) throw std::logic_error("the aperture of a fit is read before prepared() has set it");
  return *aperture;
}

std::string constants_text(const FitOptions& options) {
  std::string text;
  for (const auto* all : {&options.fix, &options.start})
    for (const NamedValues& named : *all)
      for (std::size_t k = 0; named.constants && k < named.constants->nm.size(); ++k)
        for (const double x :
             {named.constants->nm[k], named.constants->index[k].n, named.constants->index[k].k}) {
          io::append_number(text, x);
          text += ' ';
        }
  if (options.budget) text += options.budget->text;
  return text + io::layout_text(options.supplied.layout);
}

}  // namespace brdf::fit
