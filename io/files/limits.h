// Size limits of inputs (docs/formats.md). They are far beyond any measurement and still fit the memory of
// an ordinary machine. Larger inputs are refused with a message instead of filling the memory.
#pragma once

#include <cstddef>

namespace brdf::io {

inline constexpr std::size_t kLargestFile = std::size_t{1} << 30;  // bytes
// Bytes. In memory a JSON document takes ten times as much.
inline constexpr std::size_t kLargestJson = std::size_t{1} << 26;
inline constexpr std::size_t kLongestLine = std::size_t{1} << 24;  // bytes
inline constexpr std::size_t kMostRows = 4'000'000;                // of a table; a MERL file has 1.46 million
inline constexpr std::size_t kMostChannels = 4096;
inline constexpr std::size_t kMostPixels = std::size_t{1} << 26;  // of a picture: 8192 x 8192
// Pixels per line of a picture. OpenEXR keeps up to 256 whole lines in memory.
inline constexpr std::size_t kWidestPicture = std::size_t{1} << 18;
inline constexpr std::size_t kLongestName = 200;  // bytes of a channel's name; the limit of OpenEXR is 255
inline constexpr std::size_t kDeepestJson = 100;  // nesting depth of objects and arrays
inline constexpr double kLargestAzimuth = 1e6;    // degrees; sin_degrees is accurate up to this angle

}  // namespace brdf::io
