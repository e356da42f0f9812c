// A measurement for the sphere of a report.
#pragma once

#include <memory>

#include "io/page/sphere/table.h"
#include "measured/measured.h"

namespace brdf::measured {

// The samples as a picture shows them, beside a fitted material shown in the same way: a spectrum in colour
// (io/colour/in_colour.h).
std::shared_ptr<const MeasuredReflectance> seen_in_colour(
    const io::SampleTable& table, const Material* fitted,
    MeasuredReflectance::Beside beside = MeasuredReflectance::Beside::fit);

// What io::sphere::add asks of a measurement, for as long as the result lives; none where `measured` is
// false:
//   io::sphere::add(report, {.title = "copper", .fitted = material, .measured = on_sphere(seen),
//                            .table = table_size(*seen)});
// Throws InputError for channels that are no colours (io/colour/channel_colours.h).
io::sphere::MeasuredPairs on_sphere(std::shared_ptr<const MeasuredReflectance> measured);

// Nodes that tell azimuths apart where the measurement does.
io::sphere::TableSize table_size(const MeasuredReflectance& measured);

}  // namespace brdf::measured
