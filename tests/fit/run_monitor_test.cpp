#include "fit/run_monitor.h"

#include <gtest/gtest.h>

#include <thread>

#include "base/error.h"

namespace regarment {
namespace {

bool holds(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// Says the same again and again until `heard`: the monitor may be asked before it listens.
void say_until(const std::atomic<bool>& heard, RunMonitor& monitor, int run, int evaluation,
               double best) {
  while (!heard) {
    monitor.evaluated(run, evaluation, best);
    std::this_thread::yield();
  }
}

TEST(RunMonitor, TellsRunEvaluationSmallestErrorAndTimeLeft) {
  RunMonitor monitor(2, 100);
  std::atomic<bool> heard_first{false}, heard_second{false};
  std::string first, second;
  double first_fraction = -1, second_fraction = -1;
  const Progress progress(
      DetailedCallback([&](std::string_view stage, double fraction, std::string_view detail) {
        EXPECT_EQ(stage, "fit");
        EXPECT_TRUE(fraction >= 0 && fraction < 1) << fraction;
        if (!heard_first && holds(detail, "run 1 ")) {
          first = detail, first_fraction = fraction;
          heard_first = true;
        }
        if (!heard_second && holds(detail, "run 2 ")) {
          second = detail, second_fraction = fraction;
          heard_second = true;
        }
        return true;
      }));
  const std::jthread runs([&] {
    say_until(heard_first, monitor, 0, 30, 0.125);
    say_until(heard_second, monitor, 1, 7, 0.5);
    monitor.finished(0);
    monitor.finished(1);
  });
  monitor.watch(progress);
  EXPECT_TRUE(holds(first, "run 1 of 2, evaluation 30 of 100")) << first;
  EXPECT_TRUE(holds(first, "0.125")) << first;
  EXPECT_TRUE(holds(first, " s left")) << first;
  EXPECT_DOUBLE_EQ(first_fraction, 30.0 / 200);
  // The smallest error is that of all runs, not of the one that spoke last.
  EXPECT_TRUE(holds(second, "run 2 of 2, evaluation 7 of 100")) << second;
  EXPECT_TRUE(holds(second, "0.125")) << second;
  EXPECT_DOUBLE_EQ(second_fraction, 37.0 / 200);
}

TEST(RunMonitor, ARunThatIsOverCountsInFull) {
  RunMonitor monitor(2, 10);
  std::atomic<bool> heard{false};
  double fraction_then = -1;
  monitor.evaluated(0, 4, 1.0);
  monitor.finished(0);
  const std::jthread run([&] {
    say_until(heard, monitor, 1, 5, 2.0);
    monitor.finished(1);
  });
  monitor.watch(Progress(DetailedCallback([&](std::string_view, double fraction, auto) {
    if (!heard) fraction_then = fraction;
    heard = true;
    return true;
  })));
  EXPECT_DOUBLE_EQ(fraction_then, 15.0 / 20);
}

TEST(RunMonitor, ReturnsAtOnceWhenAllRunsAreOver) {
  RunMonitor monitor(3, 10);
  for (const int run : {2, 0, 1}) monitor.finished(run);
  monitor.watch({});
}

TEST(RunMonitor, AStopReachesTheRunsAndIsPassedOnAfterTheirEnd) {
  RunMonitor monitor(2, 10);
  std::atomic<int> told{0}, asked{0};
  std::atomic<bool> returned{false};
  const auto run = [&](int index) {
    try {
      for (;;) {
        monitor.evaluated(index, 1, 1.0);
        std::this_thread::yield();
      }
    } catch (const Stopped&) {
      ++told;
    }
    // Whoever ends last holds the other back, so that the monitor has a run to wait for.
    while (told < 2) std::this_thread::yield();
    EXPECT_FALSE(returned);
    monitor.finished(index);
  };
  const std::jthread first(run, 0), second(run, 1);
  const Progress no(DetailedCallback([&](std::string_view, double, std::string_view) {
    ++asked;
    return false;
  }));
  EXPECT_THROW(monitor.watch(no), Stopped);
  returned = true;
  EXPECT_EQ(told, 2);
  EXPECT_EQ(asked, 1);  // not again after "stop"
}

TEST(RunMonitor, WhatProgressThrowsIsPassedOn) {
  struct Odd {};
  RunMonitor monitor(1, 10);
  const std::jthread run([&] {
    EXPECT_THROW(for (;;) monitor.evaluated(0, 1, 1.0), Stopped);
    monitor.finished(0);
  });
  const Progress odd(
      DetailedCallback([](std::string_view, double, std::string_view) -> bool { throw Odd(); }));
  EXPECT_THROW(monitor.watch(odd), Odd);
}

}  // namespace
}  // namespace regarment
