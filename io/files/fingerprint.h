// A short name for what a result was made of.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace brdf::io {

// The 64 bits of FNV-1a (Fowler, Noll and Vo) over the texts one after another, in hexadecimal digits: tells
// what has changed, and is no defence against what was made to be equal.
std::string fingerprint(std::initializer_list<std::string_view> texts);

}  // namespace brdf::io
