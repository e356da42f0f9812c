// Options --environment, --rotate and --samples of render and view.
#pragma once

namespace CLI {
class App;
}

namespace brdf::render {
struct Job;
}

namespace brdf::cli {

// Adds the options. `samples` receives the number of samples; its present value is the default.
void add_environment_options(CLI::App& verb, render::Job& job, int& samples);

}  // namespace brdf::cli
