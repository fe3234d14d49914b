#include "core/processor.h"

#include <cpuid.h>

namespace thaum {
namespace {

/// A processor feature and the CPUID bit that reports it.
struct Feature {
    const char* name;
    unsigned leaf;
    bool in_ebx;  ///< true: the bit is in EBX; false: in ECX
    unsigned bit;
};

constexpr Feature features[] = {
    {" ssse3", 1, false, 9},       {" cx16", 1, false, 13},  {" sse4_1", 1, false, 19},
    {" sse4_2", 1, false, 20},     {" movbe", 1, false, 22}, {" popcnt", 1, false, 23},
    {" avx", 1, false, 28},        {" f16c", 1, false, 29},  {" bmi1", 7, true, 3},
    {" avx2", 7, true, 5},         {" bmi2", 7, true, 8},    {" lahf_lm", 0x80000001, false, 0},
    {" abm", 0x80000001, false, 5}};

bool has(const Feature& feature) {
    unsigned eax = 0, ebx = 0, ecx = 0, edx = 0;
    if (__get_cpuid_count(feature.leaf, 0, &eax, &ebx, &ecx, &edx) == 0) return false;
    return ((feature.in_ebx ? ebx : ecx) >> feature.bit & 1U) != 0;
}

/// Returns true if the operating system saves the AVX registers when it switches threads.
bool system_keeps_wide_registers() {
    if (!has({"", 1, false, 27})) return false;  // bit OSXSAVE: without it, XGETBV cannot be used
    unsigned low = 0, high = 0;
    __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    return (low & 6U) == 6U;
}

void add(FeatureNames& names, const char* name) {
    while (*name != '\0' && names.length + 1 < sizeof names.text) names.text[names.length++] = *name++;
    names.text[names.length] = '\0';
}

}  // namespace

FeatureNames missing_of_x86_64_v3() noexcept {
    FeatureNames names{};
    for (const Feature& feature : features) {
        if (!has(feature)) add(names, feature.name);
    }
    if (!system_keeps_wide_registers()) add(names, " xsave");
    return names;
}

}  // namespace thaum
