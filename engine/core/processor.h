// core/processor.h: finds the processor features that are missing. It is compiled for any x86-64 and without
// the C++ library, so it can run before anything else.
#pragma once

namespace thaum {

/// Names of processor features as in /proc/cpuinfo, each after a space. Empty if there are none.
struct FeatureNames {
    char text[128];
    unsigned length;
};

/// Returns the features of x86-64-v3 that this processor or its operating system lacks. FMA is not checked:
/// none of our builds uses it.
FeatureNames missing_of_x86_64_v3() noexcept;

}  // namespace thaum
