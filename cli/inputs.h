#pragma once

#include <string>
#include <vector>

namespace brdf::cli {

// Sample files as they are named; in place of a folder those in it, in the order of their names, hidden ones left out.
// Throws InputError for a folder without any, and for one of images, which is a stack or should be.
std::vector<std::string> sample_files(const std::vector<std::string>& named);

// Whether one of them is a folder: the results are those of several files then, whatever their number.
bool names_folder(const std::vector<std::string>& named);

}  // namespace brdf::cli
