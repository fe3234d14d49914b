// ecs/component.h: the requirements on a component type, and the description of it that the World has at run
// time.
//
// A component is a trivially copyable struct without padding that names itself and its fields:
//
//     struct Velocity {
//         vec3 linear{};   // m/s
//         THAUM_COMPONENT(Velocity, linear);
//     };
//
// The names make snapshots self-describing; ecs/diff.h prints them. The absence of padding is checked where a
// World declares the component, once in a program. Without padding, the bytes of a component are a function
// of its value, so they can be hashed. An empty struct with a name is a tag. A tag costs one bit per entity,
// and adding or removing it moves no data.
//
// State that is one large array of numbers, such as the samples of a fluid, is a blob. A World has one array
// per blob, which no entity owns. Systems declare access to it as to a component:
//
//     struct FluidSamples {
//         using Element = float;
//         static constexpr std::string_view name = "FluidSamples";
//     };
//
// A component that is large, and whose entities often gain and lose others, may say
//
//     static constexpr bool stays_in_place = true;
//
// Its values then lie by the numbers of the entities, outside the tables (ecs/table.h). A reference to one is
// valid until the next entity of any kind is created, or room is reserved.
//
// ecs/resource.h has values that systems share outside the World's state.
#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/assert.h"
#include "core/maths.h"
#include "core/random.h"
#include "core/text.h"
#include "ecs/entity.h"
#include "ecs/fields.h"

namespace thaum::ecs {

/// Greatest number of components and resources (values that systems share) of a World.
inline constexpr std::size_t max_components = 128;

/// A set of components and resources (values that systems share), each by its number in one World.
struct Mask {
    std::array<std::uint64_t, max_components / 64> words{};

    /// Adds the component or resource with this number to the set.
    void set(std::uint32_t id) { words[id / 64] |= std::uint64_t{1} << (id % 64); }
    void clear(std::uint32_t id) { words[id / 64] &= ~(std::uint64_t{1} << (id % 64)); }
    /// Whether the component or resource with this number is in the set.
    bool test(std::uint32_t id) const { return ((words[id / 64] >> (id % 64)) & 1U) != 0; }
    /// Whether this set contains every member of the set `o`.
    bool contains(const Mask& o) const {
        return (words[0] & o.words[0]) == o.words[0] && (words[1] & o.words[1]) == o.words[1];
    }
    /// Whether the sets have a member in common.
    bool intersects(const Mask& o) const { return ((words[0] & o.words[0]) | (words[1] & o.words[1])) != 0; }
    Mask& operator|=(const Mask& o) {
        for (std::size_t i = 0; i < words.size(); ++i) words[i] |= o.words[i];
        return *this;
    }
    bool operator==(const Mask&) const = default;
};

/// Components and resources that the running system declared to read and write.
struct Access {
    Mask reads;
    Mask writes;
    std::string_view system;

    /// Whether the system declared that it reads the component, or that it writes it.
    bool allows(std::uint32_t number, bool write) const {
        return writes.test(number) || (!write && reads.test(number));
    }
};

/// A function that is called with a component's bytes right after it was added, or right before it is removed
/// (or its entity destroyed). A hook may read the World and change components, but must not add, remove,
/// create or destroy.
struct Hook {
    void (*call)(void* context, Entity entity, const void* component) = nullptr;
    void* context = nullptr;
};

/// The scalar types that a snapshot can hold.
enum class Scalar : std::uint8_t { f32, f64, i8, i16, i32, i64, u8, u16, u32, u64 };
constexpr std::array<std::uint8_t, 10> scalar_sizes{4, 8, 1, 2, 4, 8, 1, 2, 4, 8};

/// One scalar of a component, such as "position.x" at byte 0.
struct FieldInfo {
    std::string name;
    std::uint32_t offset{};
    Scalar scalar{};
};

namespace detail {
/// A stand-in for a visitor (a function called with each field), with which the concept `Described` tests
/// whether a type lists its fields.
struct AnyVisit {};
}  // namespace detail

/// A type that lists its own fields (ecs/fields.h). A type of a library that does not use components has a
/// free function `visit_fields_of` instead; Described accepts both.
template <class T>
concept NamesFields = requires {
    typename T::ListedFields;
};
template <class T>
concept Described = NamesFields<T> || requires(const T* null, detail::AnyVisit visit) {
    visit_fields_of(null, visit);
};

template <class T>
concept Tag = std::is_empty_v<T>;

namespace detail {

/// Calls visit(name, pointer to member) for each field of T.
template <Described T, class Visit>
constexpr void for_each_field(Visit&& visit) {
    if constexpr (NamesFields<T>) {
        T::visit_fields(visit);
    } else {
        visit_fields_of(static_cast<const T*>(nullptr), visit);
    }
}

template <class T>
inline constexpr bool is_array = false;
template <class T, std::size_t N>
inline constexpr bool is_array<std::array<T, N>> = true;

template <class T>
constexpr Scalar scalar_of() {
    if constexpr (std::is_enum_v<T>) {
        return scalar_of<std::underlying_type_t<T>>();
    } else {
        // The bytes of a long double include padding.
        static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool> && sizeof(T) <= 8,
                      "a field is a number, an enum, a vector, an array or a described struct");
        constexpr int log2 = sizeof(T) == 1 ? 0 : sizeof(T) == 2 ? 1 : sizeof(T) == 4 ? 2 : 3;
        if (std::is_floating_point_v<T>) return sizeof(T) == 4 ? Scalar::f32 : Scalar::f64;
        const int base = static_cast<int>(std::is_signed_v<T> ? Scalar::i8 : Scalar::u8);
        return static_cast<Scalar>(base + log2);
    }
}

template <class C, class M>
std::size_t offset_of(M C::*member) {
    alignas(C) static const std::array<std::byte, sizeof(C)> storage{};
    const auto* object = reinterpret_cast<const C*>(storage.data());
    return static_cast<std::size_t>(reinterpret_cast<const std::byte*>(&(object->*member)) - storage.data());
}

/// Describes every scalar of a T that begins at byte `offset` of a component: appends its name, place and
/// type to `out`.
template <class T>
void append_scalars(const std::string& prefix, std::size_t offset, std::vector<FieldInfo>& out);

/// Describes `count` adjacent values of type T, such as those of a vector or an array. Each is named by its
/// letter in `letters`, or by its index if there are no letters.
template <class T>
void append_elements(const std::string& prefix, std::size_t offset, std::size_t count,
                     std::string_view letters, std::vector<FieldInfo>& out) {
    for (std::size_t i = 0; i < count; ++i) {
        std::string name = prefix;
        name += letters.empty() ? text("[", i, "]") : text(".", letters[i]);
        append_scalars<T>(name, offset + i * sizeof(T), out);
    }
}

template <class T>
void append_scalars(const std::string& prefix, std::size_t offset, std::vector<FieldInfo>& out) {
    if constexpr (std::is_same_v<T, glm::dvec2>) {
        append_elements<double>(prefix, offset, 2, "xy", out);
    } else if constexpr (std::is_same_v<T, glm::dvec3>) {
        append_elements<double>(prefix, offset, 3, "xyz", out);
    } else if constexpr (std::is_same_v<T, glm::dquat>) {
        append_elements<double>(prefix, offset, 4, "xyzw", out);
    } else if constexpr (std::is_same_v<T, glm::vec3>) {
        append_elements<float>(prefix, offset, 3, "xyz", out);
    } else if constexpr (std::is_same_v<T, Entity>) {
        append_scalars<std::uint32_t>(prefix + ".index", offset, out);
        append_scalars<std::uint32_t>(prefix + ".generation", offset + 4, out);
    } else if constexpr (std::is_same_v<T, Random>) {
        append_scalars<std::uint64_t>(prefix + ".state", offset, out);
    } else if constexpr (is_array<T>) {
        append_elements<typename T::value_type>(prefix, offset, std::tuple_size_v<T>, "", out);
    } else if constexpr (Described<T>) {
        for_each_field<T>([&]<class C, class M>(std::string_view name, M C::*member) {
            append_scalars<M>(prefix.empty() ? std::string(name) : text(prefix, ".", name),
                              offset + offset_of(member), out);
        });
    } else {
        out.push_back({prefix, static_cast<std::uint32_t>(offset), scalar_of<T>()});
    }
}

/// Sum of the sizes of all scalars. It equals sizeof(T) if T has no padding.
template <class T>
constexpr std::size_t packed_size() {
    if constexpr (is_array<T>) {
        return std::tuple_size_v<T> * packed_size<typename T::value_type>();
    } else if constexpr (Described<T>) {
        std::size_t sum = 0;
        for_each_field<T>([&]<class C, class M>(std::string_view, M C::*) { sum += packed_size<M>(); });
        return sum;
    } else {
        return sizeof(T);
    }
}

/// Tests whether T and its parts list no field twice. With a field listed twice, the sizes could add up to
/// sizeof(T) in spite of padding.
template <class T>
constexpr bool lists_fields_once() {
    if constexpr (is_array<T>) {
        return lists_fields_once<typename T::value_type>();
    } else if constexpr (Described<T>) {
        bool once = true;
        for_each_field<T>([&]<class C, class M>(std::string_view name, M C::*) {
            int times = 0;
            for_each_field<T>([&](std::string_view other, auto) { times += name == other ? 1 : 0; });
            once = once && times == 1 && lists_fields_once<M>();
        });
        return once;
    } else {
        return true;
    }
}

/// How many types have a type number (an index, given before main) so far. The first World makes arrays of
/// that size and sets `closed`; from then on no type may be added.
struct TypeNumbers {
    std::uint32_t count = 0;
    std::atomic<bool> closed = false;  // atomic, since Worlds may be created on several threads
};
inline TypeNumbers& type_numbers() {
    static TypeNumbers numbers;
    return numbers;
}

inline std::uint32_t next_type_number() {
    THAUM_ASSERT(!type_numbers().closed, "a World was made before main: its types were not all numbered");
    return type_numbers().count++;
}

/// Number of a type in this process, assigned before main. A World uses it only as an index into its own
/// lists.
template <class T>
inline const std::uint32_t type_number = next_type_number();

}  // namespace detail

/// A type that gives the name of a blob (an array of numbers that no entity owns) and the type of its
/// elements.
template <class T>
concept Blob = std::is_arithmetic_v<typename T::Element> && requires {
    std::string_view(T::name);
};

/// A type that gives the name of a resource (a value that systems share beside the components) and the type
/// of its value.
template <class T>
concept ResourceType = std::is_empty_v<T> && requires {
    typename T::Value;
    std::string_view(T::name);
};

/// A type that may be a component, if it has no padding. `component_info` checks that.
template <class T>
concept Component = !Blob<T> && !ResourceType<T> && std::is_trivially_copyable_v<T> && requires {
    std::string_view(T::name);
}
&&(Tag<T> || Described<T>);

/// A component that says `static constexpr bool stays_in_place = true;`. Its value lies at the place of its
/// entity's number and stays there when the entity moves to another table (ecs/table.h).
template <class T>
concept StaysInPlace = Component<T> && !Tag<T> && requires {
    requires T::stays_in_place;
};

/// A type that a World can declare: a component or a blob (an array of numbers that no entity owns).
template <class T>
concept Declarable = Component<T> || Blob<T>;

/// A type to which systems declare access: a component, a blob (an array that no entity owns) or a resource
/// (a value that systems share).
template <class T>
concept Accessible = Declarable<T> || ResourceType<T>;

/// Description of a component or of a blob (an array of numbers that no entity owns).
struct ComponentInfo {
    std::string_view name;
    std::uint32_t size{};  ///< size of the component, 0 for a tag; size of one element for a blob (bytes)
    std::vector<FieldInfo> fields;
    bool is_blob{};
    bool stays_in_place{};
};

/// Describes a component. A component with padding, with a field that it does not list, or with one that
/// it lists twice, does not compile.
template <Component T>
ComponentInfo component_info() {
    ComponentInfo info{
        T::name, Tag<T> ? 0U : static_cast<std::uint32_t>(sizeof(T)), {}, false, StaysInPlace<T>};
    if constexpr (!Tag<T>) {
        static_assert(detail::packed_size<T>() == sizeof(T),
                      "a component lists all its fields and has no padding");
        static_assert(detail::lists_fields_once<T>(), "a component lists each field once");
        detail::append_scalars<T>("", 0, info.fields);
    }
    return info;
}

/// Describes a blob, an array of numbers that no entity owns.
template <Blob T>
ComponentInfo blob_info() {
    using Element = typename T::Element;
    return {T::name, sizeof(Element), {{"", 0, detail::scalar_of<Element>()}}, true};
}

}  // namespace thaum::ecs
