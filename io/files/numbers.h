// Numbers for people, and the usual statistics of a few of them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace brdf::io {

// So many significant digits, without trailing zeros.
std::string short_number(double x, int digits = 4);
// A share: 0.123 is "12.3 %", so many significant digits.
std::string percent(double share, int digits = 3);
// The same to a tenth of a percent.
std::string percent_to_tenths(double share);

// "1 row", "2 rows", "0 directions", "2 entries".
std::string plural(std::size_t n, const std::string& word);

// "a, b, c".
std::string joined(const std::vector<std::string>& words, const std::string& separator = ", ");

// The value below which this share of the values lies (the upper of two for a share between them); NaN of
// none.
double quantile(std::vector<double> values, double share);
double median(std::vector<double> values);

}  // namespace brdf::io
