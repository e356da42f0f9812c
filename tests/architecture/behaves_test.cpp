// Tests that the library does not change the program that it is linked into. behaves.py searches the
// sources; this test does the work of the library and compares the process before and after.
#include <fcntl.h>
#include <glog/logging.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cfenv>
#include <clocale>
#include <csignal>
#include <filesystem>
#include <locale>

#include "brdf/material.h"
#include "fit/fit.h"
#include "io/formats/read.h"
#include "synth/instrument.h"
#include "validate/form/checks.h"

extern char** environ;

namespace brdf {
namespace {

// The state of a process that a library could change.
struct Process {
  int rounding = std::fegetround(), traps = fegetexcept(), log_level = FLAGS_minloglevel;
  bool log_to_stderr = FLAGS_logtostderr;
  std::string c_locale = std::setlocale(LC_ALL, nullptr), cpp_locale = std::locale().name(),
              folder = std::filesystem::current_path();
  mode_t mask = current_mask();
  std::size_t files = open_files();
  std::vector<std::string> environment;
  std::vector<void (*)(int)> handlers;

  Process() {
    for (char** e = environ; *e; ++e) environment.emplace_back(*e);
    for (int signal = 1; signal < 32; ++signal) {
      struct sigaction action = {};
      sigaction(signal, nullptr, &action);
      handlers.push_back(action.sa_handler);
    }
  }
  friend bool operator==(const Process&, const Process&) = default;

 private:
  static mode_t current_mask() {
    const mode_t mask = umask(0);
    umask(mask);
    return mask;
  }
  // Counts sockets, too: an unchanged count shows that the library listens on no socket.
  static std::size_t open_files() {
    std::size_t count = 0;
    for (int k = 0; k < 1024; ++k) count += fcntl(k, F_GETFD) >= 0;
    return count;
  }
};

io::SampleTable few_samples(const Reflectance& form) {
  synth::Instrument instrument;
  instrument.grid.parts = {"in_plane"};
  instrument.grid.step = 10;
  return synth::measure(make_material(form, {"fr"}), instrument);
}

TEST(Library, NeverPrintsAndLeavesTheProcessAsItWas) {
  const Reflectance form =
      *find_form_if([](const ReflectanceInfo& f) { return f.canonical && f.fittable(); });
  const Process before;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  io::SampleTable table = few_samples(form);
  const fit::FitResult result = fit::fit(table, fit::canonical_models(), {});
  fit::fit(table, {}, {});
  // Samples that no solver can fit.
  for (double& value : table.values[0]) value = 1e300;
  fit::fit(table, {{form}}, {});
  validate::check_energy(validate::Subject::material("m", result.ranking.front().material), {});
  EXPECT_THROW(io::read_samples(std::filesystem::path("no such file")), InputError);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(before == Process());
}

}  // namespace
}  // namespace brdf
