// Written tables as the programs of their users read them, in the form of materials with a measurable loss.
#pragma once

#include <functional>

#include "interop/loss.h"
#include "io/files/content.h"

namespace brdf::interop {

// f_r of every channel, 1/sr, for unit directions above the horizon.
using Values = std::function<void(const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> f)>;
// Returns a material with these values.
Material material_of(Values values, std::vector<std::string> channels);

// Returns the material evaluated in float.
Material in_float(const Material& material);

// Reads a MERL file by the rule of its own reader: the value of the cell that holds the directions (Matusik
// 2003, BRDFRead.cpp). A missing value is 0.
Material read_back_merl(const io::Content& file);
// Reads an RGL file by its own interpolation, bilinear in the warped squares (Dupuy and Jakob 2018).
Material read_back_rgl(const io::Content& file);

// Returns the loss of a table against the material, channel by channel. For a material of one channel that
// the table holds three times, the first copy counts. Returns std::nullopt if the channels of the table and
// the material differ.
std::optional<Loss> loss_of_table(const Material& wanted, const Material& table);

}  // namespace brdf::interop
