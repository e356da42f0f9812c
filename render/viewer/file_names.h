// What the prompt for a file's name offers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace brdf::render {

// The files that may be opened (by their names: .json, samples, models) and the folders that go on from what
// is typed: all in its folder whose names begin with the rest. Folders end in "/". In order, at most so many.
// Hidden ones only where the rest begins with a dot.
std::vector<std::string> names_that_go_on(const std::string& typed, std::size_t most = 200);
// As far as all of them agree.
std::string completed(const std::string& typed);

// The files that were opened last, the newest first; kept in the user's state folder (XDG_STATE_HOME, else
// ~/.local/state), a line each. Where that cannot be read or written there are none, and nothing is said.
std::vector<std::string> recent_files();
void remember_file(const std::filesystem::path& file);

}  // namespace brdf::render
