// Components that padding.sh tries to compile: Tight must compile, and with -DPADDED each of the others must
// cause an error in its line.
#include "ecs/component.h"

namespace {

using namespace thaum;

/// 24 bytes without padding: all belong to a field.
struct Tight {
    std::array<std::uint16_t, 2> pair{};
    std::uint32_t count{};
    glm::dvec2 place{};
    THAUM_COMPONENT(Tight, pair, count, place);
};

/// Seven bytes of padding between the fields.
struct PaddedInside {
    std::uint8_t kind{};
    double value{};
    THAUM_COMPONENT(PaddedInside, kind, value);
};

/// Three bytes of padding after the last field.
struct PaddedAtTheEnd {
    std::uint32_t value{};
    std::uint8_t kind{};
    THAUM_COMPONENT(PaddedAtTheEnd, value, kind);
};

/// Padding within each element of an array.
struct HoldsPadded {
    std::array<PaddedInside, 2> both{};
    THAUM_COMPONENT(HoldsPadded, both);
};

/// A field that is missing in the list of fields.
struct UnlistedField {
    float listed{};
    float unlisted{};
    THAUM_COMPONENT(UnlistedField, listed);
};

/// Three bytes of padding, and a byte that is listed four times, so that the sizes add up.
struct ListedTwice {
    std::uint32_t value{};
    std::uint8_t kind{};
    THAUM_COMPONENT(ListedTwice, value, kind, kind, kind, kind);
};

/// A long double has six bytes of padding inside.
struct LongDouble {
    long double value{};
    THAUM_COMPONENT(LongDouble, value);
};

}  // namespace

// World::declare checks a component by the same function, so it refuses the same faults.
const auto tight = ecs::component_info<Tight>();
#ifdef PADDED
const auto padded_inside = ecs::component_info<PaddedInside>();
const auto padded_at_the_end = ecs::component_info<PaddedAtTheEnd>();
const auto holds_padded = ecs::component_info<HoldsPadded>();
const auto unlisted_field = ecs::component_info<UnlistedField>();
const auto listed_twice = ecs::component_info<ListedTwice>();
const auto long_double = ecs::component_info<LongDouble>();
#endif
