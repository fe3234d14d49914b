// tools/bench/measure.h: measures run times on a machine that is also busy with other work.
//
// The load of a shared machine changes within seconds, so two contestants measured one after the other cannot
// be compared. They therefore alternate, A B C B C A C A B ..., with one sample each. Their ratio is the
// median of the ratios within a round, because a slow round slows all of them.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "tools/bench/report.h"

namespace thaum::bench {

/// Forces the compiler to compute this value and to assume that memory has changed.
template <class T>
inline void do_not_optimise(const T& value) {
    asm volatile("" : : "r,m"(value) : "memory");
}

struct Contestant {
    std::function<void()> setup;  ///< runs before each sample and is not timed; may be empty
    std::function<void()> run;    ///< the timed work
};

struct Plan {
    double seconds = 1;      ///< wall-clock time for all contestants together, setups included (s)
    std::size_t least = 11;  ///< least number of samples of each contestant, even if that takes longer
    std::size_t most = 1000;
    std::size_t calls = 1;  ///< calls of `run` in a sample; above 1 if one call is too short for the clock
};

/// Times of one call (us) in the order of the rounds: result[contestant][round]. The first round is not
/// counted. All contestants are called equally often.
std::vector<std::vector<double>> measure(std::span<const Contestant> contestants, const Plan& plan);

/// Time since an unspecified moment (us).
double now_us();
/// Time of one call (us).
double us_of(const std::function<void()>& run);

/// Percentile by nearest rank. Samples must not be empty, 0 <= p <= 1.
double percentile(std::vector<double> samples, double p);
inline double median(std::vector<double> samples) { return percentile(std::move(samples), 0.5); }
Times times(const std::vector<double>& samples);

/// Median of a / b over the rounds.
double ratio(std::span<const double> a, std::span<const double> b);

}  // namespace thaum::bench
