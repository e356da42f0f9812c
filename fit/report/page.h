// The parts of a page about a fit, in the order in which a reader asks. Each adds its heading, and nothing
// where it has nothing to show.
#pragma once

#include <memory>
#include <string>

#include "fit/assess/result.h"
#include "fit/model/options.h"
#include "io/page/html_report.h"
#include "io/samples/samples.h"
#include "measured/measured.h"

namespace brdf::fit {

// The best form in one sentence, and what must be known at once; the mark is amber where anything is in
// doubt.
void add_verdict(io::HtmlReport& report, const FitResult& result);

// The fitted material, the samples and the difference on a sphere that turns (io/page/sphere/page.h); nothing
// where the channels are no colours.
void add_sphere(io::HtmlReport& report, const FormFit& fit, const io::SampleTable& table);
// Of samples that were prepared, whose material has no io::sphere::obstacle().
void add_sphere(io::HtmlReport& report, const FormFit& fit, const std::string& title,
                const std::shared_ptr<const measured::MeasuredReflectance>& seen);

// Samples and the fitted curve in the plane of incidence, up to three channels and four angles of the light.
// The curve is evaluated every half degree and where a sample is; `aperture` is the detector's, in degrees.
void add_slices(io::HtmlReport& report, const FormFit& fit, const io::SampleTable& table, double aperture);

// Mean of ln(fitted/measured) over the half angles.
void add_deviation(io::HtmlReport& report, const FormFit& fit, const io::SampleTable& table, double aperture);

// Of a spectrum: each band's weights over wavelength, with their intervals.
void add_spectra(io::HtmlReport& report, const FormFit& fit);

// Parameters by their plain names, a column for each channel; every interval folded beneath.
void add_parameters(io::HtmlReport& report, const FormFit& fit);

// All forms, best first; what few ask for folded beneath.
void add_ranking(io::HtmlReport& report, const FitResult& result);

// What was fitted: rows, residual, scatter.
void add_samples(io::HtmlReport& report, const FitResult& result, const io::SampleTable& table,
                 const FitOptions& options);

// Correlations, minima and the steps of --form auto, folded.
void add_workings(io::HtmlReport& report, const FitResult& result);

}  // namespace brdf::fit
