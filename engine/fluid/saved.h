// fluid/saved.h: a fluid and the sheet on it as bytes and back. What is restored goes on to the same bits as if it had never
// been stopped.
//
//     magic, version, length of the body | body | XXH3 of all before
//     body: shape of the solids, what the caller keeps, fluid (settings, flags, samples), sheet (settings, flags, nodes)
//
// All little-endian. Of samples and nodes those in the box and on the sheet are kept: what lies outside follows from them.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/bytes.h"
#include "core/error.h"
#include "fluid/fluid.h"
#include "fluid/spring_surface.h"

namespace thaum::fluid {

/// Of the solids, as the caller calls it: bytes cannot hold a function. The name: up to 32 of a to z and _; up to 16 numbers.
struct NamedShape {
    std::string name{};             ///< empty: no solids but the edges
    std::vector<double> numbers{};  ///< m, or whatever the name asks for
    bool operator==(const NamedShape&) const = default;
};

/// Settings::solid of a shape; the error says what is wrong with its name or numbers. Not asked for the empty name.
using SolidFactory = std::function<Expected<std::function<double(vec3)>>(const NamedShape& shape)>;

/// What stands in the file.
struct SavedFluid {
    Fluid fluid;
    SpringSurface surface;
    NamedShape shape;
    Bytes caller_data;  ///< by the caller, as it was given
};

inline constexpr std::uint32_t saved_version = 2;

Bytes save(const Fluid& fluid, const SpringSurface& surface, const NamedShape& shape,
           std::span<const std::byte> caller_data = {});

/// The error names what is wrong: no saved fluid, cut off, another version, damaged, a setting out of its range, samples that
/// are not of the grid it says or that no fluid can have. No more memory is asked for than the bytes are worth.
Expected<SavedFluid> restore(std::span<const std::byte> bytes, const SolidFactory& solid_of);

}  // namespace thaum::fluid
