// Tests that every option of a verb has a group in the table of options.
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "cli/surface/option_table.h"

namespace brdf::cli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Groups, AnOptionWithoutAGroupIsAnError) {
  CLI::App app("", "brdf");
  CLI::App* verb = app.add_subcommand("maps", "");
  int size = 0;
  verb->add_option("--size", size, "");
  EXPECT_NO_THROW(group_options(app));
  verb->add_option("--never-declared", size, "");
  EXPECT_THAT([&] { group_options(app); },
              ThrowsMessage<std::logic_error>(HasSubstr("brdf maps --never-declared: has no group")));
}

TEST(Groups, ARowOfAVerbPrecedesTheRowOfTheName) {
  ASSERT_TRUE(find_row("synth", "--aperture"));
  EXPECT_EQ(find_row("synth", "--aperture")->group, Group::instrument);
  EXPECT_EQ(find_row("fit", "--aperture")->group, Group::measurements);
  EXPECT_EQ(find_row("fit", "--never-declared"), nullptr);
}

TEST(Groups, TheHeadingIsTheNameOfTheGroup) {
  CLI::App app("", "brdf");
  CLI::App* verb = app.add_subcommand("export", "");
  int bytes = 0;
  const CLI::Option* size = verb->add_option("--size", bytes, "");
  group_options(app);
  EXPECT_EQ(size->get_group(), "Output");
}

}  // namespace
}  // namespace brdf::cli
