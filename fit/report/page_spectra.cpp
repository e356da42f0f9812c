// The results of a fit to a spectrum, over wavelength.
#include <algorithm>
#include <cmath>

#include "fit/report/page.h"
#include "fit/report/plain_words.h"
#include "fit/report/report.h"
#include "io/colour/channel_colours.h"
#include "io/colour/in_colour.h"

namespace brdf::fit {
namespace {

struct Band {
  double nm;
  const Estimate* estimate;
};

// A parameter with a separate value for every channel.
struct Spectrum {
  std::string symbol;
  std::vector<Band> bands;  // by wavelength
};

std::vector<Spectrum> spectra_of(const FormFit& fit) {
  std::vector<Spectrum> spectra;
  for (const Estimate& e : fit.estimates) {
    const NamedParameter parameter = named(fit, e);
    const std::optional<double> nm = io::wavelength_of(e.channel);
    if (parameter.repeats || !nm || e.status == Status::unidentified) continue;
    const auto found = std::ranges::find(spectra, parameter.symbol, &Spectrum::symbol);
    Spectrum& spectrum =
        found == spectra.end() ? spectra.emplace_back(Spectrum{parameter.symbol, {}}) : *found;
    spectrum.bands.push_back({*nm, &e});
  }
  for (Spectrum& s : spectra) std::ranges::sort(s.bands, {}, &Band::nm);
  return spectra;
}

io::Plot plot_of(const Spectrum& spectrum, bool lacks_something) {
  io::Plot plot;
  plot.title = spectrum.symbol + " over wavelength";
  plot.x_label = "wavelength, nm";
  plot.y_label = spectrum.symbol;
  io::Series line{"", {}, {}, io::Series::Style::line};
  line.colour = 0;
  for (const auto& [nm, e] : spectrum.bands) {
    const bool wide = lacks_something && std::isfinite(e->with_lack_of_fit.low);
    const Extent extent = wide ? e->with_lack_of_fit : Extent{e->low, e->high};
    const bool known = e->status == Status::free && std::isfinite(extent.low);
    line.x.push_back(nm);
    line.y.push_back(e->value);
    line.low.push_back(known ? extent.low : e->value);
    line.high.push_back(known ? extent.high : e->value);
  }
  plot.series.push_back(std::move(line));
  return plot;
}

}  // namespace

void add_spectra(io::HtmlReport& report, const FormFit& fit) {
  if (!io::is_spectrum(fit.material.channels)) return;
  report.heading("Parameters over wavelength");
  report.paragraph(
      "Each band with its 95 % confidence interval. The sphere shows the bands as a colour under D65 (CIE "
      "1931).");
  for (const Spectrum& spectrum : spectra_of(fit))
    report.plot(plot_of(spectrum, fit.lack_of_fit.beyond_scatter));
  for (const SmoothCurve& curve : fit.smooth) report.paragraph(in_words(curve));
}

}  // namespace brdf::fit
