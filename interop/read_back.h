// Written tables as their users' programs read them, as materials that a loss can be measured of.
#pragma once

#include <functional>
#include <memory>

#include "interop/loss.h"
#include "io/files/content.h"

namespace brdf::interop {

// A material of these values: f_r of every channel, 1/sr, for unit directions above the horizon.
using Values = std::function<void(const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> f)>;
Material material_of(Values values, std::vector<std::string> channels);

// The material as float evaluates it.
Material in_float(const Material& material);

// A MERL file by its own reader's rule, the cell that holds the directions (Matusik 2003, BRDFRead.cpp); no
// value is 0.
Material read_back_merl(const io::Content& file);
// An RGL file by its own interpolation, bilinear in the warped squares (Dupuy and Jakob 2018).
Material read_back_rgl(const io::Content& file);

// Of a table against the material, channel by channel; of one channel written three times the first. Nothing
// where the table has other channels than the material.
std::optional<Loss> loss_of_table(const Material& wanted, const Material& table);

}  // namespace brdf::interop
