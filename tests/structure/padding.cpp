// Components that padding.sh tries to compile, each alone: -DCOMPONENT=Tight must compile, every other type must not.
#include "ecs/component.h"

namespace {

using namespace thaum;
using ecs::field;

/// 24 bytes, all of which belong to a field.
struct Tight {
    std::array<std::uint16_t, 2> pair{};
    std::uint32_t count{};
    glm::dvec2 place{};
    static constexpr std::string_view name = "Tight";
    static constexpr auto fields() {
        return std::tuple(field("pair", &Tight::pair), field("count", &Tight::count),
                          field("place", &Tight::place));
    }
};

/// Seven bytes between the fields.
struct PaddedInside {
    std::uint8_t kind{};
    double value{};
    static constexpr std::string_view name = "PaddedInside";
    static constexpr auto fields() {
        return std::tuple(field("kind", &PaddedInside::kind), field("value", &PaddedInside::value));
    }
};

/// Three bytes after the last field.
struct PaddedAtTheEnd {
    std::uint32_t value{};
    std::uint8_t kind{};
    static constexpr std::string_view name = "PaddedAtTheEnd";
    static constexpr auto fields() {
        return std::tuple(field("value", &PaddedAtTheEnd::value), field("kind", &PaddedAtTheEnd::kind));
    }
};

/// Padding in the elements of an array.
struct HoldsPadded {
    std::array<PaddedInside, 2> both{};
    static constexpr std::string_view name = "HoldsPadded";
    static constexpr auto fields() { return std::tuple(field("both", &HoldsPadded::both)); }
};

/// A field without an entry in the list.
struct UnlistedField {
    float listed{};
    float unlisted{};
    static constexpr std::string_view name = "UnlistedField";
    static constexpr auto fields() { return std::tuple(field("listed", &UnlistedField::listed)); }
};

/// Three bytes of padding, and a byte that is listed four times, so that the sizes add up.
struct ListedTwice {
    std::uint32_t value{};
    std::uint8_t kind{};
    static constexpr std::string_view name = "ListedTwice";
    static constexpr auto fields() {
        return std::tuple(field("value", &ListedTwice::value), field("a", &ListedTwice::kind),
                          field("b", &ListedTwice::kind), field("c", &ListedTwice::kind),
                          field("d", &ListedTwice::kind));
    }
};

/// Six bytes of padding inside a number.
struct LongDouble {
    long double value{};
    static constexpr std::string_view name = "LongDouble";
    static constexpr auto fields() { return std::tuple(field("value", &LongDouble::value)); }
};

}  // namespace

// World::declare asks for the same description.
ecs::ComponentInfo described() { return ecs::component_info<COMPONENT>(); }
