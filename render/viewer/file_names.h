// File names offered by the prompt for a file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace brdf::render {

// Returns the files that can be opened (by their names: .json, samples, models) and the folders that
// complete the typed text. These are the entries of the typed folder whose names begin with the rest of the
// text. Folders end in "/". The names are sorted, at most `most` of them. Hidden entries are included only
// if the rest begins with a dot.
std::vector<std::string> names_that_go_on(const std::string& typed, std::size_t most = 200);
// Returns the typed text, extended as far as all these names agree.
std::string completed(const std::string& typed);

// The files that were opened last, the newest first. The list is a file in the user's state folder
// (XDG_STATE_HOME, otherwise ~/.local/state), with one name per line. If the list cannot be read or
// written, it is empty, and no error is reported.
std::vector<std::string> recent_files();
void remember_file(const std::filesystem::path& file);

}  // namespace brdf::render
