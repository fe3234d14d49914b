// haptics/modes.h: haptic modes, the building blocks of what a volume feels like (Lundin, Cooper, Persson,
// Evestedt, Ynnerman 2007, "Enabling design and interactive selection of haptic modes", section 3).
//
//     field (scalar or vector) --.
//     settings (strength, ...) --+--> mode --> primitives at the proxy of the last tick --> balance
//     proxy of the last tick ----'
//
// A mode reads a field at the proxy of the last tick and adds haptic primitives there. A transfer function
// maps the property that the mode reads to the strength of its primitives. Modes are independent of each
// other, so any of them act together, up to primitive_capacity primitives.
//
// A mode always adds the same number of primitives, because the servo takes a change of the number for a
// switch, and fades. Where the mode cannot push, its primitives have strength 0 and any direction. That is
// where the gradient or vector has length zero, where the field or the strength is not finite, and where the
// strength of a point or line would be negative.
//
// A directed force makes the whole set an active source, with a budget of energy (haptics/energy.h). So
// together with gradient, force or vortex_core the other modes count as active too.
//
// A caller that changes the modes or settings also changes HapticModel::set_number, so that the servo fades
// from the old force to the new one.
//
// A mode is one .cpp in haptics/modes that registers a Mode. Link to thaum_modes, which keeps all of them.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/registry.h"
#include "field/filters.h"
#include "field/transfer.h"
#include "haptics/primitives/primitives.h"

namespace thaum::haptics {

/// State of the hand in the last tick, from which modes compute their primitives (device frame).
struct ModeInput {
    vec3 proxy{};           ///< position of the proxy, the point on which the primitives act (m)
    vec3 tip{};             ///< position of the tip (m)
    vec3 step{};            ///< expected motion of the tip until the servo uses the primitives (m)
    double stiffness{300};  ///< stiffness of the spring between tip and proxy (N/m)
    vec3 motion{};          ///< motion of the tip in a tick (m); zero: at rest, or not known

    /// Force of the spring on the hand (N).
    vec3 pull() const { return stiffness * (proxy - tip); }
    /// Expected place of the tip when the servo uses the primitives (m).
    vec3 next_tip() const { return tip + step; }
};

/// Settings of a mode. A mode ignores the settings that it has no use for.
struct ModeSettings {
    /// Strength of the primitives (N) as a function of the mode's property (Mode::property). A negative
    /// strength reverses a direction that the field gives, such as the side from which a surface is felt.
    field::TransferFunction strength{};
    /// Coefficient of friction as a function of the field's value (mode surface) or of the tip's depth in
    /// metres (mode isosurface).
    field::TransferFunction friction{};
    double level{};      ///< isosurface: value of the field on the surface
    bool solid_below{};  ///< isosurface: the solid has smaller values than the level, not larger ones
    /// Isosurface: strength with which a magnetic surface holds a tip that is outside, within `reach` (N). It
    /// lets go at the end of the reach. So the spring between tip and proxy pulls with at most its stiffness
    /// times the reach.
    double magnet{};
    /// Isosurface: depth at which the surface lets the proxy through, and largest distance at which a proxy
    /// finds it. Snap modes: distance within which they act (m).
    double reach{0.002};
    double pitch{0.01};  ///< snap to grid: distance between the grid's points (m)
    bool operator==(const ModeSettings&) const = default;
};

/// Kind of field that a mode reads.
enum class FieldKind : std::uint32_t { scalar, vector };

/// Makes a scalar or vector field the one type that modes read.
inline field::AnyField any_field(field::ScalarField field) { return {.scalar = field}; }
inline field::AnyField any_field(field::VectorField field) { return {.vector = field}; }

/// A kind of haptic mode (a way to feel a field), as its .cpp file registers it.
struct Mode {
    std::string_view name{};      ///< name of the mode, such as "follow"
    std::string_view about{};     ///< description for a menu of what the hand feels
    std::string_view property{};  ///< quantity that the strength's transfer function maps, such as "length of
                                  ///< the vector"
    FieldKind reads{};
    bool slope{};                ///< true: the property is the length of a gradient (field's units per m)
    bool derivatives{};          ///< the mode reads derivatives of the field, not the value alone
    std::uint32_t primitives{};  ///< number of primitives that the mode adds
    /// The mode creates no energy in any field: it only resists motion and never pushes.
    bool passive{};
    /// The mode gives no force outside the box of its field's samples (field::SampleBox).
    bool ends_at_box{};
    /// Adds the mode's primitives to the set. The caller has checked that the set has room for them.
    void (*add)(const field::AnyField& field, const ModeSettings& settings, const ModeInput& input,
                PrimitiveSet& set){};
};

/// Registers a mode when the program starts.
using ModeRegistration = Registration<Mode>;

/// All kinds of haptic modes, sorted by name.
inline std::span<const Mode> modes() { return registry_of<Mode>().all(); }

/// The haptic mode of this name; null if there is none.
inline const Mode* find_mode(std::string_view name) { return registry_of<Mode>().find(name); }

/// Haptic modes that read fields of this kind, sorted by name.
std::vector<const Mode*> modes_for(FieldKind kind);

/// A mode and the filter through which it reads a field.
struct ModeOffer {
    const Mode* mode{};
    std::optional<field::FilterKind> through{};  ///< filter whose result the mode reads, such as a gradient;
                                                 ///< std::nullopt: it reads the field itself
};

/// All ways to feel a field of this kind. First come the modes that read the field itself. Then come those
/// that read its gradient (of a scalar field), or its length, divergence and curl (of a vector field).
std::vector<ModeOffer> mode_offers(FieldKind kind);

/// The version of a filtered field that a mode should read: the quick one, which has values only, if the mode
/// needs no derivatives.
const field::AnyField& field_for(const Mode& mode, const field::FilteredField& filtered);

/// A mode in use, with the field that it reads and its settings. The field must outlive it.
struct ModeUse {
    const Mode* mode{};
    field::AnyField field{};
    ModeSettings settings{};
};

/// Adds the primitives of all modes to the set, in the order of `uses`. A mode without room for its
/// primitives, and one that does not read its field's kind, adds none. Returns the number of modes that were
/// left out. No allocation.
std::size_t add_modes(std::span<const ModeUse> uses, const ModeInput& input, PrimitiveSet& set) noexcept;

// ---- for the modes themselves -----------------------------------------------------------------------------

/// Length and direction of a vector. If it is zero or not finite, the length
/// is 0 and the direction arbitrary.
struct Direction {
    vec3 unit{1, 0, 0};
    double length{};
};
/// Length and direction of `v`.
Direction direction_of(vec3 v) noexcept;

/// Direction and length of (curl V) x V, which points towards the core of a vortex. This is eq. 2 of Lundin
/// and others 2007 without its minus sign, which would point away from the core.
Direction towards_core(const field::Vector& here) noexcept;

/// Value of a transfer function at x as a strength (N): clamped to +- primitive_limit, and 0 if x or the
/// value is not finite.
double strength_at(const field::TransferFunction& strength, double x) noexcept;

/// Largest strength of a primitive whose point, line or plane is not at the proxy (N); it is more than any
/// device renders. Such a primitive moves the proxy. Without this limit, two nearly parallel planes that
/// contradict each other would throw the proxy to where they meet, metres away.
inline constexpr double max_pull = 10;

/// Place that a proxy heads for along a plane with this normal (m). It is the expected place of the tip,
/// moved back along the plane towards the proxy by friction: by `friction` (N) over the spring's stiffness at
/// most.
vec3 held_back(const ModeInput& input, vec3 normal, double friction) noexcept;

/// Adds a primitive. One with a fault, such as a negative strength or a place that is not finite, is added
/// with strength 0. The number of primitives thus stays the same, as the servo expects.
void add_or_rest(PrimitiveSet& set, const Primitive& primitive) noexcept;

/// Adds a directed force or a plane; a negative strength reverses its direction.
void add_turned(PrimitiveSet& set, Primitive primitive) noexcept;

}  // namespace thaum::haptics
