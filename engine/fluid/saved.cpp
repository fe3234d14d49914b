#include "fluid/saved.h"

#include <algorithm>
#include <cmath>

#include "core/hash.h"
#include "core/text.h"

namespace thaum::fluid {
namespace {

constexpr std::uint64_t magic = 0x756c666d75616874;  // the bytes "thaumflu" in the file
constexpr std::size_t head_size = 20;                // bytes of magic, version and length
constexpr std::size_t hash_size = 8;
constexpr std::size_t max_shape_numbers = 16;
constexpr std::size_t max_shape_name = 32;

// Largest absolute value of a sample. No push can exceed it, and its square is still finite in float.
constexpr double max_sample = 1e18;
constexpr double max_height = 1e6;      // largest height of a node of the spring surface (m)
constexpr double max_node_speed = 1e9;  // largest speed of a node of the spring surface (m/s)

// ---- contents of the body, listed once for saving and restoring ------------------------------------------

template <class S, class F>
void each_setting(S& s, F&& f) {
    f(s.solver), f(s.h), f(s.order), f(s.sweeps);
    f(s.viscosity), f(s.lid), f(s.no_slip_at_solids);
    for (auto& cells : s.cells) f(cells);
    for (auto& edge : s.edges) f(edge);
    for (int axis = 0; axis < 3; ++axis) f(s.gravity[axis]);
}

template <class S, class F>
void each_number(S& s, F&& f) {
    f(s.viscosity), f(s.weight), f(s.diffusion);
}

template <class S, class F>
void each_surface_setting(S& s, F&& f) {
    f(s.nodes), f(s.rim), f(s.side), f(s.tension), f(s.shear), f(s.areal_mass), f(s.level), f(s.damping);
    f(s.contact), f(s.pop_through), f(s.cling), f(s.reach), f(s.still), f(s.max_steps);
}

/// Calls `f` with each array of samples in a state, and with its name.
template <class S, class F>
void each_samples(S& state, F&& f) {
    constexpr std::array along{"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis)
        f(state.velocity[axis], text("velocity along ", along[axis]));
    for (std::size_t axis = 0; axis < 3; ++axis) f(state.push[axis], text("push along ", along[axis]));
    f(state.pressure, std::string("pressure"));
    f(state.projected, std::string("last projection"));
    for (std::size_t i = 0; i < state.substances.size(); ++i)
        f(state.substances[i], text("substance ", i + 1));
}

/// Calls `f` with the array index of the first node of each row of the spring surface.
template <class F>
void each_node_row(const SpringSurfaceSettings& s, F&& f) {
    for (std::size_t z = 0; z < s.nodes; ++z) f(surface_node_index(s, 0, z));
}

// ---- saving ----------------------------------------------------------------------------------------------

template <class T>
std::span<const std::byte> row_bytes(const T* first, std::size_t count) {
    return std::as_bytes(std::span(first, count));
}

void put_fluid(const Fluid& fluid, ByteWriter& out) {
    each_setting(fluid.settings, [&](const auto& value) { out.put(value); });
    out.put(static_cast<std::uint32_t>(fluid.settings.substances.size()));
    for (const Substance& s : fluid.settings.substances)
        each_number(s, [&](double value) { out.put(value); });
    out.put(fluid.state.pushed);
    out.put(fluid.state.asleep);
    const auto wide = static_cast<std::size_t>(fluid.lattice.cells[0]);
    each_samples(fluid.state, [&](const Samples& samples, const std::string&) {
        each_row(fluid.lattice, [&](std::ptrdiff_t at) {
            out.put_bytes(row_bytes(&samples[static_cast<std::size_t>(at)], wide));
        });
    });
}

void put_surface(const SpringSurface& surface, ByteWriter& out) {
    each_surface_setting(surface.settings, [&](const auto& value) { out.put(value); });
    for (const std::uint32_t inside : surface.inside) out.put(inside);
    out.put(surface.asleep);
    for (const auto* nodes : {&surface.height, &surface.velocity})
        each_node_row(surface.settings, [&](std::size_t at) {
            out.put_bytes(row_bytes(&(*nodes)[at], surface.settings.nodes));
        });
}

// ---- restoring -------------------------------------------------------------------------------------------

Error wrong(std::string_view what) { return fail(text("saved fluid: ", what)); }
Error ends_within(std::string_view what) { return wrong(text("it ends in the middle of ", what)); }

/// Checks everything around the body of the file (magic, version, length, hash) and returns the body.
Expected<std::span<const std::byte>> opened(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    const auto begins = in.get<std::uint64_t>();
    if (in.ok() && begins != magic) return wrong("the file does not begin like one; choose another file");
    const auto version = in.get<std::uint32_t>();
    if (in.ok() && version != saved_version)
        return wrong(text("it has version ", version, ", but this program reads version ", saved_version,
                          "; load it with the program that saved it"));
    const auto length = in.get<std::uint64_t>();
    if (!in.ok()) return wrong(text("it is cut off after ", bytes.size(), " bytes; use a complete copy"));
    const std::size_t after = in.left();
    if (after < hash_size || length > after - hash_size)
        return wrong(text("it is cut off: its body has ", length, " bytes and a checksum ", hash_size,
                          ", but ", after, " bytes follow; use a complete copy"));
    if (length < after - hash_size) return wrong("more bytes follow its end; use another copy");
    const auto body = in.get_bytes(length);
    if (in.get<std::uint64_t>() != hash_bytes(bytes.first(head_size + length)))
        return wrong("it is damaged, as its checksum shows; use another copy");
    return body;
}

Expected<NamedShape> get_shape(ByteReader& in) {
    NamedShape shape{.name = in.get_string()};
    const auto is_of_name = [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; };
    if (shape.name.size() > max_shape_name || !std::ranges::all_of(shape.name, is_of_name))
        return wrong(
            text("the name of its shape is not up to ", max_shape_name, " characters from a to z and _"));
    const auto count = in.get<std::uint32_t>();
    if (in.ok() && count > max_shape_numbers)
        return wrong(text("its shape has ", count, " numbers; at most ", max_shape_numbers, " are allowed"));
    for (std::uint32_t i = 0; i < count && in.ok(); ++i) shape.numbers.push_back(in.get<double>());
    if (!in.ok()) return ends_within("the shape");
    return shape;
}

Expected<Settings> get_settings(ByteReader& in) {
    Settings settings;
    each_setting(settings, [&](auto& value) { value = in.get<std::remove_cvref_t<decltype(value)>>(); });
    const auto count = in.get<std::uint32_t>();
    if (!in.ok()) return ends_within("the settings");
    if (settings.solver > Solver::classic) return wrong("the number of its solver is unknown");
    if (std::ranges::any_of(settings.edges, [](Edge edge) { return edge > Edge::no_slip; }))
        return wrong("the number of an edge is unknown");
    if (count > max_substances)
        return wrong(text("it has ", count, " substances; at most ", max_substances, " are allowed"));
    settings.substances.resize(count);
    for (Substance& s : settings.substances) each_number(s, [&](double& value) { value = in.get<double>(); });
    if (!in.ok()) return ends_within("the substances");
    return settings;
}

/// Whether enough bytes are left for the samples that the settings require. Checked before memory is
/// allocated.
bool fits(const Settings& settings, std::size_t left) {
    std::size_t values = 7 + settings.substances.size();
    for (const int cells : settings.cells) {
        // An invalid number of cells is reported later, by make_fluid.
        if (cells < 1 || cells > max_cells) return true;
        values *= static_cast<std::size_t>(cells);
    }
    return values * sizeof(float) <= left;
}

/// Describes the first invalid value of one array of samples; empty if there is none.
std::string fault_of(const Lattice& lattice, const Samples& samples, bool of_substance) {
    bool finite = true, sound = true;
    each_row(lattice, [&](std::ptrdiff_t at) {
        for (std::ptrdiff_t i = at; i < at + lattice.cells[0]; ++i) {
            const double value = samples[static_cast<std::size_t>(i)];
            finite = finite && std::isfinite(value);
            sound = sound && std::abs(value) <= max_sample && (!of_substance || value >= 0);
        }
    });
    if (!finite) return "a value is not finite";
    return sound ? "" : "a value is out of range";
}

Expected<Fluid> get_fluid(ByteReader& in, const NamedShape& shape, const SolidFactory& solid_of) {
    auto settings = get_settings(in);
    if (!settings) return settings.error();
    if (!fits(*settings, in.left())) return wrong("it has fewer samples than its grid needs");
    if (!shape.name.empty()) {
        auto solid = solid_of(shape);
        if (!solid) return wrong(solid.error().message);
        settings->solid = std::move(*solid);
    }
    auto fluid = make_fluid(*settings);
    if (!fluid) return wrong(fluid.error().message);
    const auto pushed = in.get<bool>(), asleep = in.get<bool>();
    std::string fault;
    each_samples(fluid->state, [&](Samples& samples, const std::string& name) {
        const auto wide = static_cast<std::size_t>(fluid->lattice.cells[0]) * sizeof(float);
        each_row(fluid->lattice, [&](std::ptrdiff_t at) {
            const auto row = in.get_bytes(wide);
            if (in.ok()) std::memcpy(&samples[static_cast<std::size_t>(at)], row.data(), wide);
        });
        const auto found = fault_of(fluid->lattice, samples, name.starts_with("substance"));
        if (fault.empty() && !found.empty()) fault = name + ": " + found;
    });
    if (!in.ok()) return ends_within("the samples");
    if (!fault.empty()) return wrong(fault);
    refresh_after_edit(*fluid);
    fluid->state.pushed = pushed;
    fluid->state.asleep = asleep && !pushed;
    return fluid;
}

std::string fault_of(const SpringSurface& surface) {
    bool sound = true;
    each_node_row(surface.settings, [&](std::size_t at) {
        for (std::size_t i = at; i < at + surface.settings.nodes; ++i)
            sound = sound && std::abs(surface.height[i]) <= max_height &&
                    std::abs(surface.velocity[i]) <= max_node_speed;
    });
    return sound ? "" : "surface: a node is not finite, too far from level or too fast";
}

Expected<SpringSurface> get_surface(ByteReader& in) {
    SpringSurfaceSettings asked;
    each_surface_setting(asked, [&](auto& value) { value = in.get<std::remove_cvref_t<decltype(value)>>(); });
    if (!in.ok()) return ends_within("the settings of the surface");
    if (asked.rim > Rim::free) return wrong("surface: the number of the rim is unknown");
    const auto settings = checked(asked);
    if (!settings) return wrong(settings.error().message);
    SpringSurface surface = make_spring_surface(*settings);
    for (std::uint32_t& inside : surface.inside) inside = in.get<std::uint32_t>();
    const auto asleep = in.get<std::uint32_t>();
    const std::size_t wide = settings->nodes * sizeof(double);
    for (auto* nodes : {&surface.height, &surface.velocity})
        each_node_row(*settings, [&](std::size_t at) {
            const auto row = in.get_bytes(wide);
            if (in.ok()) std::memcpy(&(*nodes)[at], row.data(), wide);
        });
    if (!in.ok()) return ends_within("the surface");
    if (std::ranges::any_of(surface.inside, [](std::uint32_t inside) { return inside > 1; }) || asleep > 1)
        return wrong("surface: a flag is neither 0 nor 1");
    if (const auto fault = fault_of(surface); !fault.empty()) return wrong(fault);
    refresh_after_edit(surface);
    surface.asleep = asleep != 0 && energy(surface) == 0 ? 1 : 0;
    return surface;
}

}  // namespace

Bytes save(const Fluid& fluid, const SpringSurface& surface, const NamedShape& shape,
           std::span<const std::byte> caller_data) {
    Bytes body;
    ByteWriter out(body);
    out.put_string(shape.name);
    out.put(static_cast<std::uint32_t>(shape.numbers.size()));
    for (const double number : shape.numbers) out.put(number);
    out.put(static_cast<std::uint32_t>(caller_data.size()));
    out.put_bytes(caller_data);
    put_fluid(fluid, out);
    put_surface(surface, out);
    Bytes bytes;
    ByteWriter file(bytes);
    file.put(magic);
    file.put(saved_version);
    file.put(static_cast<std::uint64_t>(body.size()));
    file.put_bytes(body);
    file.put(hash_bytes(bytes));
    return bytes;
}

Expected<SavedFluid> restore(std::span<const std::byte> bytes, const SolidFactory& solid_of) {
    const auto body = opened(bytes);
    if (!body) return body.error();
    ByteReader in(*body);
    auto shape = get_shape(in);
    if (!shape) return shape.error();
    const auto caller_data = in.get_bytes(in.get<std::uint32_t>());
    if (!in.ok()) return ends_within("the data of the caller");
    auto fluid = get_fluid(in, *shape, solid_of);
    if (!fluid) return fluid.error();
    auto surface = get_surface(in);
    if (!surface) return surface.error();
    if (in.left() != 0) return wrong("unexpected bytes follow the surface");
    return SavedFluid{std::move(*fluid), std::move(*surface), std::move(*shape),
                      Bytes(caller_data.begin(), caller_data.end())};
}

}  // namespace thaum::fluid
