// ecs/fields.h: the macros with which a struct lists its fields, each once and by its own name.
//
//     struct Velocity {
//         vec3 linear{};   // m/s
//         THAUM_COMPONENT(Velocity, linear);
//     };
//
// The macros declare a function template. A source that includes the struct therefore spends no time on
// compiling the list: it is instantiated only where a World declares the component (ecs/component.h).
#pragma once
#include <string_view>

/// Makes the surrounding struct a component with the name of its type and these fields, which must be listed
/// in the order of their memory.
#define THAUM_COMPONENT(Type, ...)                  \
    static constexpr std::string_view name = #Type; \
    THAUM_FIELDS(Type, __VA_ARGS__)

/// Lists the fields of the surrounding struct, so that a component may have a field of its type.
#define THAUM_FIELDS(Type, ...)                         \
    template <class Visit>                              \
    static constexpr void visit_fields(Visit&& visit) { \
        THAUM_VISIT_EACH(Type, __VA_ARGS__)             \
    }                                                   \
    using ListedFields = Type

/// Lists the fields of a struct from a library that does not use components. Write it in the namespace of the
/// struct.
#define THAUM_FIELDS_OF(Type, ...)                               \
    template <class Visit>                                       \
    constexpr void visit_fields_of(const Type*, Visit&& visit) { \
        THAUM_VISIT_EACH(Type, __VA_ARGS__)                      \
    }

// Expands to visit("a", &Type::a); visit("b", &Type::b); ... for up to 256 fields. A macro cannot call
// itself. Each scan of the text therefore expands one call, and THAUM_PASSES_256 has the text scanned again
// and again.
#define THAUM_VISIT_EACH(Type, ...) __VA_OPT__(THAUM_PASSES_256(THAUM_VISIT_ONE(Type, __VA_ARGS__)))
#define THAUM_VISIT_ONE(Type, field, ...)          \
    visit(std::string_view(#field), &Type::field); \
    __VA_OPT__(THAUM_VISIT_AGAIN THAUM_PARENTHESES(Type, __VA_ARGS__))
#define THAUM_VISIT_AGAIN() THAUM_VISIT_ONE
#define THAUM_PARENTHESES ()
#define THAUM_PASSES_256(...) THAUM_PASSES_64(THAUM_PASSES_64(THAUM_PASSES_64(THAUM_PASSES_64(__VA_ARGS__))))
#define THAUM_PASSES_64(...) THAUM_PASSES_16(THAUM_PASSES_16(THAUM_PASSES_16(THAUM_PASSES_16(__VA_ARGS__))))
#define THAUM_PASSES_16(...) THAUM_PASSES_4(THAUM_PASSES_4(THAUM_PASSES_4(THAUM_PASSES_4(__VA_ARGS__))))
#define THAUM_PASSES_4(...) THAUM_PASS(THAUM_PASS(THAUM_PASS(THAUM_PASS(__VA_ARGS__))))
#define THAUM_PASS(...) __VA_ARGS__
