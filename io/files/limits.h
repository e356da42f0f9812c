// The largest things that are read (docs/formats.md): far beyond any measurement, and what a machine of
// ordinary size holds. What is larger is refused by name instead of filling the memory.
#pragma once

#include <cstddef>

namespace brdf::io {

inline constexpr std::size_t kLargestFile = std::size_t{1} << 30;  // bytes
inline constexpr std::size_t kLargestJson = std::size_t{1}
                                            << 26;  // bytes: in memory it is ten times as large
inline constexpr std::size_t kLongestLine = std::size_t{1} << 24;  // bytes
inline constexpr std::size_t kMostRows = 4'000'000;                // of a table; a MERL file has 1.46 million
inline constexpr std::size_t kMostChannels = 4096;
inline constexpr std::size_t kMostPixels = std::size_t{1} << 26;  // of a picture: 8192 x 8192
// Pixels of a line: OpenEXR holds up to 256 whole lines.
inline constexpr std::size_t kWidestPicture = std::size_t{1} << 18;
inline constexpr std::size_t kLongestName = 200;  // bytes of a channel's name; OpenEXR's own limit is 255
inline constexpr std::size_t kDeepestJson = 100;  // objects and arrays in each other
inline constexpr double kLargestAzimuth = 1e6;    // degrees: what sin_degrees is accurate for

}  // namespace brdf::io
