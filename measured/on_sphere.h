// Prepares a measurement for the sphere of a report.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "io/page/sphere/table.h"
#include "measured/measured.h"

namespace brdf::measured {

// Returns the measurement in the colours of a picture, relative to the fitted material converted in the
// same way. A spectrum is converted to colour (io/colour/in_colour.h).
std::shared_ptr<const MeasuredReflectance> seen_in_colour(
    const io::SampleTable& table, const Material* fitted,
    MeasuredReflectance::Beside beside = MeasuredReflectance::Beside::fit);

// Returns the function that io::sphere::add needs for a measurement. The function keeps the measurement
// alive and returns std::nullopt if `measured` is false:
//   io::sphere::add(report, {.title = "copper", .fitted = material, .measured = on_sphere(seen),
//                            .table = table_size(*seen)});
// Throws InputError for channels that are not colours (io/colour/channel_colours.h).
io::sphere::MeasuredPairs on_sphere(std::shared_ptr<const MeasuredReflectance> measured);

// Returns the words that pictures of a measurement need: "smoothed measurements (scatter 5.1 % removed)", or
// "smoothed measurements (scatter not known)".
std::string smoothed_words(const std::optional<double>& scatter);

// Returns a table size that distinguishes azimuths of the sample if the measurement does.
io::sphere::TableSize table_size(const MeasuredReflectance& measured);

}  // namespace brdf::measured
