// Tests the atomic replacement of files: failures, signals, and remains of killed runs.
#include "io/files/output.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "io/files/error.h"
#include "io/files/file_buffer.h"
#include "io/files/leftovers.h"
#include "io/files/provenance.h"
#include "io/files/shell.h"
#include "io/files/temporary.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::ptrdiff_t entries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(Output, ReplacesTheOldFileAndLeavesNoTemporary) {
  const io::TemporaryFolder folder;
  const fs::path path = folder.path() / "a.txt";
  write_file_atomically(path, "old");
  write_file_atomically(path, "new");
  EXPECT_EQ(content(path), "new");
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(Output, KeepsTheOldFileWhenWritingThrows) {
  const io::TemporaryFolder folder;
  const fs::path path = folder.path() / "a.txt";
  write_file_atomically(path, "old");
  const auto broken = [](std::ostream& out) {
    out << "half";
    throw std::runtime_error("broken");
  };
  EXPECT_THROW(write_file_atomically(path, broken), std::runtime_error);
  EXPECT_EQ(content(path), "old");
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(Output, FollowsLinks) {
  const io::TemporaryFolder folder;
  fs::create_symlink(folder.path() / "real.txt", folder.path() / "link.txt");
  write_file_atomically(folder.path() / "link.txt", "x");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link.txt"));
  EXPECT_EQ(content(folder.path() / "real.txt"), "x");
}

TEST(Output, AMissingFolderIsBadInputAndAFullDeviceAnEnvironmentError) {
  const io::TemporaryFolder folder;
  EXPECT_THROW(write_file_atomically(folder.path() / "no" / "a.txt", "x"), InputError);
  EXPECT_THROW(write_file_atomically("/dev/full", "x"), EnvironmentError);
  EXPECT_FALSE(fs::is_regular_file("/dev/full"));
}

// Runs `child` in a process of its own and returns the exit status of that process, as waitpid() gives it.
int status_of_child(const std::function<void()>& child) {
  const pid_t process = ::fork();
  if (process == 0) {
    child();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(process, &status, 0);
  return status;
}

TEST(Output, KeepsThePermissionsOfWhatItReplaces) {
  const io::TemporaryFolder folder;
  const fs::path path = folder.path() / "a.txt";
  write_file_atomically(path, "old");
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  write_file_atomically(path, "new");
  EXPECT_EQ(content(path), "new");
  EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(Output, DoesNotReplaceAReadOnlyFileNorALinkToItself) {
  const io::TemporaryFolder folder;
  const fs::path path = folder.path() / "a.txt", loop = folder.path() / "loop";
  write_file_atomically(path, "old");
  fs::permissions(path, fs::perms::owner_read);
  EXPECT_THAT(message_of([&] { write_file_atomically(path, "new"); }), testing::HasSubstr("is read-only"));
  EXPECT_EQ(content(path), "old");
  fs::create_symlink("loop", loop);
  EXPECT_THAT(message_of([&] { write_file_atomically(loop, "x"); }), testing::HasSubstr("symbolic links"));
  EXPECT_TRUE(fs::is_symlink(loop));
}

TEST(Output, SaysWhyTheFirstFailedWriteFailed) {
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  FileBuffer buffer(full);
  std::ostream out(&buffer);
  out << "x" << std::flush;
  errno = 0;
  out << "y" << std::flush;
  EXPECT_FALSE(out);
  EXPECT_EQ(buffer.error(), ENOSPC);
  ::close(full);
}

TEST(Output, AFileThatMayNotGrowIsAnEnvironmentErrorAndNoEnd) {
  const io::TemporaryFolder folder;
  const int status = status_of_child([&] {
    remove_temporaries_on_signals();
    const rlimit small{16, 16};
    ::setrlimit(RLIMIT_FSIZE, &small);
    try {
      write_file_atomically(folder.path() / "a.txt", std::string(1000, 'x'));
    } catch (const EnvironmentError& error) {
      ::_exit(std::string(error.what()).find("File too large") != std::string::npos ? 7 : 8);
    }
  });
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(entries(folder.path()), 0);
}

TEST(Output, ASignalRemovesTheTemporaryAndEndsTheProcessAsItWould) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) {
    const io::TemporaryFolder folder;
    const fs::path path = folder.path() / "a.txt";
    write_file_atomically(path, "old");
    const int status = status_of_child([&] {
      const rlimit no_core{0, 0};
      ::setrlimit(RLIMIT_CORE, &no_core);
      std::signal(signal, SIG_DFL);  // the program that runs the tests may ignore some signals
      remove_temporaries_on_signals();
      write_file_atomically(path, [&](std::ostream& out) {
        out << "half" << std::flush;
        if (entries(folder.path()) == 2) ::raise(signal);
      });
    });
    ASSERT_TRUE(WIFSIGNALED(status)) << signal;
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_EQ(content(path), "old");
    EXPECT_EQ(entries(folder.path()), 1);
  }
}

TEST(Output, AnIgnoredSignalStaysIgnored) {
  const io::TemporaryFolder folder;
  const int status = status_of_child([&] {
    std::signal(SIGHUP, SIG_IGN);
    remove_temporaries_on_signals();
    ::raise(SIGHUP);
  });
  EXPECT_TRUE(WIFEXITED(status));
}

TEST(Output, TheNextRunRemovesWhatAKilledOneLeftOfTheSameTarget) {
  const io::TemporaryFolder folder;
  const fs::path path = folder.path() / "a.txt";
  const int status = status_of_child([&] {
    write_file_atomically(path, [](std::ostream& out) {
      out << "half" << std::flush;
      ::raise(SIGKILL);
    });
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(entries(folder.path()), 1);
  // These temporaries must be kept: they belong to a target with a name that begins alike, to the user, or
  // to a file that is still being written.
  for (const char* name : {"a.txt.b.1.0.tmp", "a.txt.tmp", "a.txt.1.x.tmp"})
    std::ofstream(folder.path() / name) << "x";
  const fs::path busy = folder.path() / "a.txt.1.0.tmp";
  const int held = ::open(busy.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0666);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  write_file_atomically(path, "new");
  EXPECT_EQ(content(path), "new");
  EXPECT_EQ(entries(folder.path()), 5);
  EXPECT_TRUE(fs::exists(busy));
  ::close(held);
}

// A folder belongs to the process that made it. A child that is forked meanwhile leaves the folder alone.
TEST(Output, AFolderOnTheWayIsRemovedByASignalAndByTheNextRun) {
  const io::TemporaryFolder above;
  const auto die_by = [&](int signal) {
    return status_of_child([&] {
      remove_temporaries_on_signals();
      const io::TemporaryFolder folder(above.path());
      write_file_atomically(folder.path() / "a.txt", "old");
      make_folder(folder.path() / "deeper");
      write_file_atomically(folder.path() / "deeper" / "b.txt", [&](std::ostream& out) {
        out << "half" << std::flush;
        status_of_child([] { ::raise(SIGTERM); });
        if (entries(folder.path() / "deeper") == 1) ::raise(signal);
      });
    });
  };
  EXPECT_TRUE(WIFSIGNALED(die_by(SIGTERM)));
  EXPECT_EQ(entries(above.path()), 0);
  EXPECT_TRUE(WIFSIGNALED(die_by(SIGKILL)));
  EXPECT_EQ(entries(above.path()), 1);
  {
    const io::TemporaryFolder next(above.path());
    EXPECT_EQ(entries(above.path()), 1);
    const io::TemporaryFolder beside(above.path());
    EXPECT_EQ(entries(above.path()), 2);
  }
  EXPECT_EQ(entries(above.path()), 0);
}

TEST(Output, ANameAsLongAsNamesMayBeCanBeWritten) {
  const io::TemporaryFolder folder;
  const fs::path path = folder.path() / std::string(255, 'n');
  write_file_atomically(path, "x");
  EXPECT_EQ(content(path), "x");
}

TEST(Output, TargetsAreRefusedBeforeTheWorkWhereTheyCannotBeWritten) {
  const io::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.txt";
  write_file_atomically(file, "x");
  const auto refused = [](const fs::path& path) {
    return message_of([&] { check_targets({{"-o", path}}); });
  };
  EXPECT_THAT(refused(folder.path() / "no" / "b.txt"), testing::HasSubstr("No such file or directory"));
  EXPECT_THAT(refused(folder.path()), testing::HasSubstr("Is a directory"));
  EXPECT_THAT(refused(file / "b.txt"), testing::HasSubstr("Not a directory"));
  EXPECT_THAT(refused(folder.path() / ""), testing::HasSubstr("is not the name of a file"));
  EXPECT_THAT(message_of([&] { check_folder_target({"-o", file / "b"}, {}); }), testing::HasSubstr("ot a "));
  check_targets({{"-o", folder.path() / "b.txt"}, {"--report", ""}, {"-o", "/dev/null"}});
  check_folder_target({"-o", folder.path() / "new" / "deep"}, {"b.txt"});
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(Output, AnInputIsNoTargetAndNoTargetIsNamedTwice) {
  const io::TemporaryFolder folder;
  const fs::path in = folder.path() / "in", alias = folder.path() / "alias", out = folder.path() / "out";
  write_file_atomically(in, "x");
  fs::create_symlink("in", alias);
  fs::create_hard_link(in, folder.path() / "hard");
  for (const fs::path& same : {in, alias, folder.path() / "hard", folder.path() / "." / "in"})
    EXPECT_THAT(message_of([&] { check_targets({{"-o", same}}, {in}); }), testing::HasSubstr("is the input"));
  const std::vector<Target> twice{{"-o", out}, {"--report", folder.path() / "." / "out"}};
  EXPECT_THAT(message_of([&] { check_targets(twice); }), testing::HasSubstr("is also the output of -o"));
  EXPECT_THAT(message_of([&] {
                check_folder_target({"-o", folder.path()}, {"in"}, {in});
              }),
              testing::HasSubstr("is the input"));
}

// Returns the text that a shell makes of this single word.
std::string through_a_shell(const std::string& word) {
  const io::TemporaryFolder folder;
  const fs::path script = folder.path() / "script", out = folder.path() / "out";
  std::ofstream(script) << "printf %s " << word << " > " << out.string();
  if (std::system(("bash " + script.string()).c_str()) != 0) return "the shell refused it";
  return content(out);
}

TEST(Shell, TakesEveryWordAsItWas) {
  std::vector<std::string> words{
      "",        "plain", "a b", "it's", "$(touch x);`y`\"&|<>*?~#!{}[]\\", "a\nb", "\x1b[31m'\\n'",
      "gr\xfcn", "grün",  "-o",  "a=b"};
  std::string all;
  for (int c = 1; c < 256; ++c) all += char(c);
  words.push_back(all);
  for (const std::string& word : words) {
    EXPECT_EQ(through_a_shell(shell_word(word)), word);
    for (const char c : shell_word(word)) EXPECT_FALSE(static_cast<unsigned char>(c) < 0x20 || c == 0x7f);
  }
  EXPECT_EQ(shell_word("--set"), "--set");
  EXPECT_EQ(shell_file("-n.json"), "./-n.json");
}

TEST(Provenance, HoldsTheOptionsThatDecideValues) {
  const char* const argv[] = {
      "/usr/bin/brdf", "synth",    "--set",      "a=1",      "-o",          "x.csv",
      "-oy.csv",       "-o=z.csv", "--output=a", "--report", "b.html",      "--report=c",
      "--output",      "d",        "--jobs",     "3",        "--threads=2", "it's"};
  record_command_line(int(std::size(argv)), argv);
  const auto fields = provenance_fields(provenance(3));
  ASSERT_EQ(fields.size(), 3u);
  EXPECT_EQ(fields[0].second, BRDF_VERSION);
  EXPECT_EQ(fields[1].second, "brdf synth --set a=1 'it'\\''s'");
  EXPECT_EQ(fields[2].second, "3");
}

}  // namespace
}  // namespace brdf::io
