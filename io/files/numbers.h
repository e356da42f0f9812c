// Formats numbers for people and computes quantiles.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace brdf::io {

// Formats a number with `digits` significant digits, without trailing zeros.
std::string short_number(double x, int digits = 4);
// Formats a fraction as a percentage with `digits` significant digits: 0.123 becomes "12.3 %".
// All digits before the decimal point are kept up to a million percent: 1.3 with two digits becomes "130 %".
std::string percent(double share, int digits = 3);
// Formats a fraction as a percentage rounded to a tenth of a percent.
std::string percent_to_tenths(double share);

// Returns a count with its noun: "1 row", "2 rows", "0 directions", "2 entries".
std::string plural(std::size_t n, const std::string& word);

// Joins words with a separator: "a, b, c".
std::string joined(const std::vector<std::string>& words, const std::string& separator = ", ");
// Joins numbers, as to_text() writes them.
std::string joined_numbers(const std::vector<double>& numbers, const std::string& separator = ", ");

// Throws InputError "OPTION VALUE: must be between LOW and HIGH UNIT" unless low <= value <= high.
void require_between(const std::string& option, double value, double low, double high,
                     const std::string& unit = "");

// Returns the quantile of the values for `share` in [0, 1]: the element of rank floor(share * n), so that
// the median of an even number of values is the upper of the two in the middle. Returns NaN if `values` is
// empty.
double quantile(std::vector<double> values, double share);
double median(std::vector<double> values);

}  // namespace brdf::io
