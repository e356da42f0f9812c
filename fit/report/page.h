// The sections of a page about a fit, in the order of a reader's questions. Each function adds its heading,
// or nothing if it has nothing to show.
#pragma once

#include <memory>
#include <string>

#include "fit/assess/result.h"
#include "fit/model/options.h"
#include "io/page/html_report.h"
#include "io/samples/samples.h"
#include "measured/measured.h"

namespace brdf::fit {

// Adds the best form in one sentence, with the most important warnings. The mark is amber if anything is in
// doubt.
void add_verdict(io::HtmlReport& report, const FitResult& result);

// Adds the fitted material, the samples and their difference on a sphere that can be rotated
// (io/page/sphere/page.h). Adds nothing if the channels are not colours.
void add_sphere(io::HtmlReport& report, const FormFit& fit, const io::SampleTable& table);
// Adds the sphere for prepared samples. The caller has ensured that io::sphere::obstacle() reports no
// obstacle for the material.
void add_sphere(io::HtmlReport& report, const FormFit& fit, const std::string& title,
                const std::shared_ptr<const measured::MeasuredReflectance>& seen);

// Adds plots of the samples and the fitted curve in the plane of incidence, for up to three channels and
// twelve angles of incidence, four of which are drawn until the reader switches others on. The curve is
// evaluated every half degree and at each sample. `aperture` is that of the detector, in degrees.
void add_slices(io::HtmlReport& report, const FormFit& fit, const io::SampleTable& table, double aperture);

// Adds a map of the mean of ln(fitted/measured) over the half angles.
void add_deviation(io::HtmlReport& report, const FormFit& fit, const io::SampleTable& table, double aperture);

// For a spectrum, adds the weights of each band over wavelength, with their intervals.
void add_spectra(io::HtmlReport& report, const FormFit& fit);

// Adds the parameters by their plain names, one column for each channel, with all intervals in a folded
// table below.
void add_parameters(io::HtmlReport& report, const FormFit& fit);

// Adds all forms, best first, with the less common figures in a folded table below.
void add_ranking(io::HtmlReport& report, const FitResult& result);

// Adds the facts about the fitted samples: rows, residual, noise.
void add_samples(io::HtmlReport& report, const FitResult& result, const io::SampleTable& table,
                 const FitOptions& options);

// Adds correlations, minima and the steps of --form auto, folded.
void add_workings(io::HtmlReport& report, const FitResult& result);

}  // namespace brdf::fit
