// The file name `-`: standard input for a file that is read, standard output for a file that is written.
#pragma once

#include <string>
#include <vector>

#include "cli/options/terminal.h"
#include "io/files/output.h"

namespace CLI {
class App;
}

namespace brdf::cli {

// Makes `-` name a stream in the options of all verbs that read a table or a material, or write one file of
// text. Other options that take a file refuse `-`, so that no file of this name is ever written. Standard
// input can be read once: a second `-` among the inputs is refused.
void use_streams(CLI::App& app);

// Returns true if the name of a file means a stream. The parser has replaced `-` by such a name.
bool is_stream(const std::string& file);

// Throws InputError for an output that is a stream. `content` names the output in the message: "the results
// are a folder".
void require_file(const io::Target& output, const std::string& content);

// Throws InputError if a file that an option of the parsed verb would write is a file that another option
// reads, and keeps all files that the verb reads from then on. A state of the viewer may be saved over
// itself.
void keep_inputs(const CLI::App& verb);

// Returns the stream for the text of a verb with these outputs: stderr if one of them is standard output.
// Throws InputError if more than one of them, or one of them and --json, is standard output.
TextStream text_stream(const std::vector<io::Target>& outputs, bool json = false);

}  // namespace brdf::cli
