#include "fe_contact/engine/threads.h"
#include <atomic>
#include <gtest/gtest.h>
#include <numeric>
#include <stdexcept>

namespace rimpact::fe {
namespace {

TEST(Threads, SharesCoverEverythingOnce) {
  std::vector<int> touched(17, 0);
  share(touched.size(), 4, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) ++touched[i];
  });
  EXPECT_EQ(touched, std::vector<int>(17, 1));
}

/// An exception that leaves a thread ends the program: it must reach the caller, after the others have done their part.
TEST(Threads, WhatAWorkerThrowsReachesTheCaller) {
  for (int thrower = 0; thrower < 3; ++thrower) {
    std::atomic<int> ended{0};
    const auto body = [&](int w) {
      if (w == thrower) throw std::bad_alloc();
      ++ended;
    };
    EXPECT_THROW(on_each_thread(3, body), std::bad_alloc);
    EXPECT_EQ(ended, 2);
  }
}

} // namespace
} // namespace rimpact::fe
