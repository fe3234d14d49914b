// fluid/saved.h: saves a fluid and its spring surface as bytes, and restores them. A restored fluid continues
// with the same bits as if it had never been interrupted.
//
//     magic, version, length of the body | body | XXH3 hash of everything before
//     body: shape of the solids, data of the caller, fluid (settings, flags, samples),
//           spring surface (settings, flags, nodes)
//
// All numbers are little-endian. Only samples in the box and nodes of the surface are saved; ghost cells and
// mirror images are computed from them.
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

/// Description of the solids by name, because bytes cannot hold a function. The name has up to 32
/// characters from a to z and _. There are up to 16 numbers.
struct NamedShape {
    std::string name{};             ///< name of the shape; empty: no solids inside the box
    std::vector<double> numbers{};  ///< parameters of the shape; the caller defines their meaning and units
    bool operator==(const NamedShape&) const = default;
};

/// Makes the function Settings::solid for a shape. The error says what is wrong with the name or the numbers.
/// Not called if the name is empty.
using SolidFactory = std::function<Expected<std::function<double(vec3)>>(const NamedShape& shape)>;

/// Contents of a saved file.
struct SavedFluid {
    Fluid fluid;
    SpringSurface surface;
    NamedShape shape;
    Bytes caller_data;  ///< bytes that the caller gave to `save`
};

inline constexpr std::uint32_t saved_version = 2;

/// The saved fluid and surface as bytes, which `restore` reads; they include `caller_data`.
Bytes save(const Fluid& fluid, const SpringSurface& surface, const NamedShape& shape,
           std::span<const std::byte> caller_data = {});

/// Restores a fluid. The error says what is wrong: not a saved fluid, cut off, another version,
/// damaged, a setting out of range, or samples that do not fit the grid or are impossible. Memory is
/// allocated only if the bytes can fill it.
Expected<SavedFluid> restore(std::span<const std::byte> bytes, const SolidFactory& solid_of);

}  // namespace thaum::fluid
