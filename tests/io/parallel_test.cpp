#include "io/files/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace brdf::io {
namespace {

TEST(Parallel, EveryJobIsDoneOnce) {
  for (const unsigned threads : {1u, 3u}) {
    std::vector<std::atomic<int>> done(100);
    parallel_for(
        done.size(), [&](std::size_t k) { ++done[k]; }, threads);
    for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
  }
}

TEST(Parallel, OfSeveralFailuresTheOneOfTheFirstJobIsThrown) {
  std::atomic<bool> has_later_failed = false;
  const auto job = [&](std::size_t k) {
    if (k == 0) {
      while (!has_later_failed) std::this_thread::yield();
      throw std::runtime_error("0");
    }
    has_later_failed = true;
    throw std::runtime_error(std::to_string(k));
  };
  try {
    parallel_for(20, job, 2);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "0");
  }
}

TEST(Parallel, HandsOverInOrderAndPassesExceptionsOn) {
  std::vector<int> seen;
  int last = 0;
  parallel_in_order(
      50, 4, [&](int done, int) { last = done; }, [](int i) { return i * i; },
      [&](int v) { seen.push_back(v); });
  for (int i = 0; i < 50; ++i) EXPECT_EQ(seen[std::size_t(i)], i * i);
  EXPECT_EQ(last, 50);
  const auto fail = [](int i) { return i == 3 ? throw std::runtime_error("three") : i; };
  EXPECT_THROW(parallel_in_order(9, 2, {}, fail, [](int) {}), std::runtime_error);
}

}  // namespace
}  // namespace brdf::io
