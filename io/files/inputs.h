// The files that a command has read as inputs: no output of the command replaces them.
#pragma once

#include <filesystem>

namespace brdf::io {

// From here on, files that are read count as inputs, and write_file_atomically() refuses to replace them. For
// programs that run one command. A library call may write again to a file that an earlier call has read.
void keep_inputs();

// Counts a file as an input. Without effect before keep_inputs().
void note_input(const std::filesystem::path& path);
// Returns whether the file was counted, under any of its names.
bool is_kept_input(const std::filesystem::path& path);

}  // namespace brdf::io
