// tools/bench/measure.h: how long something takes, on a machine that also does other things.
//
// The load of a shared machine changes from one second to the next, so two things measured one after another cannot be
// compared. Contestants are therefore interleaved, A B C B C A C A B ..., one sample each, and their ratio is the median of
// the ratios within a round: what slows one round slows all in it.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "tools/bench/report.h"

namespace thaum::bench {

/// The compiler must have this value in hand here, and cannot know what happened to memory.
template <class T>
inline void do_not_optimise(const T& value) {
    asm volatile("" : : "r,m"(value) : "memory");
}

struct Contestant {
    std::function<void()> setup;  ///< before each sample, not timed; may be empty
    std::function<void()> run;    ///< timed
};

struct Plan {
    double seconds = 1;      ///< wall clock for all contestants together, setups included
    std::size_t least = 11;  ///< samples of each, even where that takes longer
    std::size_t most = 1000;
    std::size_t calls = 1;  ///< of `run` in a sample; more than 1 where one is too short for the clock
};

/// us of one call, in the order of the rounds: result[contestant][round]. A first round is not counted.
/// Every contestant is called equally often.
std::vector<std::vector<double>> measure(std::span<const Contestant> contestants, const Plan& plan);

/// us, from some time on.
double now_us();
/// us of one call.
double us_of(const std::function<void()>& run);

/// Nearest rank; samples must not be empty, 0 <= p <= 1.
double percentile(std::vector<double> samples, double p);
inline double median(std::vector<double> samples) { return percentile(std::move(samples), 0.5); }
Times times(const std::vector<double>& samples);

/// Median over the rounds of a / b.
double ratio(std::span<const double> a, std::span<const double> b);

}  // namespace thaum::bench
