// --environment, --rotate and --samples of render and view.
#pragma once

namespace CLI {
class App;
}

namespace brdf::render {
struct Job;
}

namespace brdf::cli {

// `samples`: where the number of samples goes, which keeps its value as the default.
void add_environment_options(CLI::App& verb, render::Job& job, int& samples);

}  // namespace brdf::cli
