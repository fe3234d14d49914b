// core/processor.h: what the processor lacks. Compiled for any x86-64 and without the C++ library, so that it can be asked
// before anything else runs.
#pragma once

namespace thaum {

/// Names of processor features, each after a space, as /proc/cpuinfo spells them; empty: none.
struct FeatureNames {
    char text[128];
    unsigned length;
};

/// The features of x86-64-v3 that this processor or its system does not offer. FMA is not asked for: no build of ours uses it.
FeatureNames missing_of_x86_64_v3() noexcept;

}  // namespace thaum
