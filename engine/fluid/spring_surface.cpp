#include "fluid/spring_surface.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/text.h"

// The equation of motion is x'' = -K x - 2 d x' + f(x), where x are the heights of the nodes, K is the
// stiffness of the springs divided by the mass of a node, d the damping, and f the force of the probes
// divided by that mass. The stages of Runge-Kutta, with heights h0 to h3 and velocities v0 to v3, need only
// the accelerations a0 to a3, because the velocities are combinations of them:
//
//     h1 = h0 + t/2 v0     h2 = h1 + t^2/4 a0     h3 = h0 + t v0 + t^2/2 a1
//     v1 = v0 + t/2 a0     v2 = v0 + t/2 a1       v3 = v0 + t a2
//     h += t v0 + t^2/6 (a0 + a1 + a2)            v += t/6 (a0 + 2 a1 + 2 a2 + a3)
namespace thaum::fluid {
namespace {

/// Largest phase by which the stiffest mode of oscillation may advance in a sub-step (rad). As long as the
/// phase is at most 2, for frequency and for damping, no step can add energy. At 1 the stiffest mode loses
/// less than 1.4 % of its energy, and all modes that are five times slower lose less than 1e-6.
constexpr double max_phase = 1;

/// Stiffnesses of the springs and of gravity (`level`), divided by the mass of a node (1/s^2), and the rate
/// at which drag slows a node (1/s).
struct SpringNetwork {
    std::size_t stride{}, first{}, end{};  ///< index distance between rows; nodes from `first` to
                                           ///< before `end`, in x and in z, move
    double structural{}, shear{}, level{}, drag{};
    double mass{};  ///< mass of a node (kg)
    bool mirrored{};
};

SpringNetwork spring_network(const SpringSurfaceSettings& s) {
    const double a = surface_node_spacing(s);
    const double mass = s.areal_mass * a * a;
    const std::size_t rim = s.rim == Rim::pinned ? 1 : 0;
    return {.stride = surface_row_stride(s),
            .first = rim,
            .end = s.nodes - rim,
            .structural = (1 - s.shear) * s.tension / mass,
            .shear = s.shear * s.tension / (2 * mass),
            .level = s.level / s.areal_mass,
            .drag = 2 * s.damping,
            .mass = mass,
            .mirrored = s.rim == Rim::free};
}

/// Upper bound of the square of the surface's highest angular frequency (1/s^2).
double highest_squared_frequency(const SpringNetwork& net) {
    return std::max(8 * net.structural, 4 * net.structural + 8 * net.shear) + net.level;
}

struct Span {
    std::size_t begin, end;
};

/// Range of array indices of the moving nodes of row z.
Span row(const SpringNetwork& net, std::size_t z) {
    const std::size_t at = (z + 1) * net.stride + 1;
    return {at + net.first, at + net.end};
}

/// Range of array indices of the moving nodes of row z, extended to whole vectors of four. close_rows resets
/// the extra values, up to three, to zero.
Span vectors(const SpringNetwork& net, std::size_t z) {
    const auto [begin, end] = row(net, z);
    return {begin, begin + (end - begin + 3) / 4 * 4};
}

void close_rows(const SpringNetwork& net, double* values) {
    for (std::size_t z = net.first; z < net.end; ++z) {
        for (std::size_t i = row(net, z).end; i < vectors(net, z).end; ++i) values[i] = 0;
    }
}

// ---- springs ---------------------------------------------------------------------------------------------

/// Acceleration by the springs and by gravity (m/s^2). Opposite neighbours are summed in pairs, so that a
/// mirror image gives the same bits.
inline double spring_acceleration(const SpringNetwork& net, const double* h, std::size_t i) {
    const std::size_t s = net.stride;
    const double middle = h[i];
    const double sides = (h[i - 1] + h[i + 1]) + (h[i - s] + h[i + s]);
    const double corners = (h[i - s - 1] + h[i + s + 1]) + (h[i - s + 1] + h[i + s - 1]);
    return net.structural * (sides - 4 * middle) + net.shear * (corners - 4 * middle) - net.level * middle;
}

/// Writes the mirror images of the heights beyond a free rim, so that waves are reflected without inversion.
/// Shear springs (diagonal ones) that would lead outwards then act as if they lay along the rim.
void mirror(const SpringNetwork& net, double* h) {
    if (!net.mirrored) return;
    const std::size_t n = net.end, s = net.stride;
    std::copy_n(h + s + 1, n, h + 1);
    std::copy_n(h + n * s + 1, n, h + (n + 1) * s + 1);
    for (std::size_t z = 0; z < n + 2; ++z) {
        h[z * s] = h[z * s + 1];
        h[z * s + n + 1] = h[z * s + n];
    }
}

// ---- probes ----------------------------------------------------------------------------------------------

/// Rectangle of nodes under a probe, and the weight of each in the force and in the mean height; the weights
/// add up to 1.
struct Footprint {
    std::size_t x0{}, x1{}, z0{}, z1{};  ///< nodes from (x0, z0) to before (x1, z1); empty if x0 == x1
    const double* weights{};             ///< weights, row by row
    double squares{};                    ///< sum of the squared weights
    double height{};                     ///< height of the probe (m)
};

struct ProbeFootprints {
    std::array<Footprint, surface_probe_capacity> prints{};
    std::size_t count{};
};

template <class Visit>
void each_node(const SpringNetwork& net, const Footprint& print, Visit visit) {
    const double* weight = print.weights;
    for (std::size_t z = print.z0; z < print.z1; ++z) {
        for (std::size_t x = print.x0; x < print.x1; ++x) visit((z + 1) * net.stride + x + 1, *weight++);
    }
}

bool is_on_surface(const SpringSurfaceSettings& s, const SurfaceProbe& p) {
    const double half = s.side / 2;
    return std::abs(p.place.x) <= half && std::abs(p.place.y) <= half && std::isfinite(p.height) &&
           std::isfinite(p.radius);
}

Span nodes_within(const SpringSurfaceSettings& s, double place, double radius) {
    const double a = surface_node_spacing(s), middle = 0.5 * (s.nodes - 1), last = s.nodes - 1;
    const double from = std::clamp(std::ceil((place - radius) / a + middle), 0.0, last);
    const double to = std::clamp(std::floor((place + radius) / a + middle), 0.0, last);
    return {static_cast<std::size_t>(from), static_cast<std::size_t>(to) + 1};
}

/// Computes the nodes under a probe and their weights, proportional to (1 - (r / radius)^2)^2 at the distance
/// r.
Footprint footprint(const SpringSurfaceSettings& s, const SurfaceProbe& p, double* weights) {
    const double a = surface_node_spacing(s), middle = 0.5 * (s.nodes - 1);
    const double radius = std::clamp(p.radius, 1.5 * a, s.side);
    const Span xs = nodes_within(s, p.place.x, radius), zs = nodes_within(s, p.place.y, radius);
    Footprint print{xs.begin, xs.end, zs.begin, zs.end, weights, 0, p.height};
    double sum = 0;
    double* weight = weights;
    for (std::size_t z = zs.begin; z < zs.end; ++z) {
        const double dz = a * (static_cast<double>(z) - middle) - p.place.y;
        for (std::size_t x = xs.begin; x < xs.end; ++x) {
            const double dx = a * (static_cast<double>(x) - middle) - p.place.x;
            const double within = std::max(0.0, 1 - (dx * dx + dz * dz) / (radius * radius));
            sum += * weight++ = within * within;
        }
    }
    for (double* w = weights; w != weight; ++w) {
        *w /= sum;
        print.squares += *w * *w;
    }
    return print;
}

double height_under(const SpringNetwork& net, const Footprint& print, const double* h) {
    double sum = 0;
    each_node(net, print, [&](std::size_t i, double w) { sum += w * h[i]; });
    return sum;
}

/// Upward force of the surface on a probe (N). The surface can only push a probe that is above it, and only
/// pull a probe that has broken through it (`inside`).
double contact_force(const SpringSurfaceSettings& s, const Footprint& print, bool inside, double height) {
    const double gap = s.contact * (height - print.height);
    return inside ? std::clamp(gap, -s.cling, 0.0) : std::clamp(gap, 0.0, s.pop_through);
}

/// Lets the probe break through the surface when the force reaches `pop_through`, or tears the surface off it
/// when the pull reaches `cling`.
void update_inside(const SpringSurfaceSettings& s, const Footprint& print, std::uint32_t& inside,
                   double height) {
    const double gap = s.contact * (height - print.height);
    if (inside != 0 ? gap <= -s.cling && gap < 0 : gap >= s.pop_through && gap > 0) inside = 1 - inside;
}

// ---- one step --------------------------------------------------------------------------------------------

/// Arrays, constants and probes of one call of advance().
struct SurfaceStepContext {
    const SpringSurfaceSettings& settings;
    const SpringNetwork net;
    const ProbeFootprints footprints;
    std::array<std::uint32_t, surface_probe_capacity>& inside;
    double* h;
    double* v;
    double* stage;  ///< heights of the nodes in one Runge-Kutta stage (m)
    std::array<double*, 4> a;
    std::array<double, surface_probe_capacity> impulse{};  ///< upward impulse on each probe (N s)
};

/// Adds the probes' forces to the accelerations of the nodes in a Runge-Kutta stage, and force times `share`
/// (s) to the impulses on the probes.
void add_probes(SurfaceStepContext& m, const double* h, double* a, double share) {
    for (std::size_t p = 0; p < m.footprints.count; ++p) {
        const Footprint& print = m.footprints.prints[p];
        if (print.x0 == print.x1) continue;
        const double force =
            contact_force(m.settings, print, m.inside[p] != 0, height_under(m.net, print, h));
        if (force == 0) continue;
        m.impulse[p] += share * force;
        const double per_mass = force / m.net.mass;
        // The nodes of a pinned rim do not move, so their acceleration is never used.
        each_node(m.net, print, [&](std::size_t i, double w) { a[i] -= per_mass * w; });
    }
}

using Values = const double* __restrict;

/// Accelerations `a` of the nodes: those by the springs at the heights h, minus drag times velocity v.
void accelerate(const SpringNetwork& net, Values h, Values v, double* __restrict a) {
    for (std::size_t z = net.first; z < net.end; ++z) {
        const auto [begin, end] = vectors(net, z);
        for (std::size_t i = begin; i < end; ++i) a[i] = spring_acceleration(net, h, i) - net.drag * v[i];
    }
}

/// Accelerations `a` of the nodes in a later Runge-Kutta stage. The velocities in this stage are
/// `v + t * before`, where `before` are the accelerations of an earlier stage.
void accelerate(const SpringNetwork& net, Values h, Values v, Values before, double t, double* __restrict a) {
    for (std::size_t z = net.first; z < net.end; ++z) {
        const auto [begin, end] = vectors(net, z);
        for (std::size_t i = begin; i < end; ++i)
            a[i] = spring_acceleration(net, h, i) - net.drag * (v[i] + t * before[i]);
    }
}

void close_array(const SpringNetwork& net, double* values) {
    close_rows(net, values);
    mirror(net, values);
}

/// Writes the heights of the nodes in a Runge-Kutta stage: `h + t * v`, from heights h and velocities v.
void place_stage(const SpringNetwork& net, Values h, Values v, double t, double* __restrict stage) {
    for (std::size_t z = net.first; z < net.end; ++z) {
        const auto [begin, end] = vectors(net, z);
        for (std::size_t i = begin; i < end; ++i) stage[i] = h[i] + t * v[i];
    }
    close_array(net, stage);
}

/// Writes the heights of the nodes in a later Runge-Kutta stage: `h + t * v + t2 * a`, where `a` are
/// accelerations.
void place_stage(const SpringNetwork& net, Values h, Values v, double t, Values a, double t2,
                 double* __restrict stage) {
    for (std::size_t z = net.first; z < net.end; ++z) {
        const auto [begin, end] = vectors(net, z);
        for (std::size_t i = begin; i < end; ++i) stage[i] = (h[i] + t * v[i]) + t2 * a[i];
    }
    close_array(net, stage);
}

void combine_stages(const SurfaceStepContext& m, double t) {
    double* __restrict h = m.h;
    double* __restrict v = m.v;
    const Values a0 = m.a[0], a1 = m.a[1], a2 = m.a[2], a3 = m.a[3];
    for (std::size_t z = m.net.first; z < m.net.end; ++z) {
        const auto [begin, end] = vectors(m.net, z);
        for (std::size_t i = begin; i < end; ++i) {
            const double inner = a1[i] + a2[i];
            h[i] += t * v[i] + t * t / 6 * (a0[i] + inner);
            v[i] += t / 6 * ((a0[i] + a3[i]) + 2 * inner);
        }
    }
    close_array(m.net, h);
    close_rows(m.net, v);
}

/// One step of classical Runge-Kutta over t (s).
void runge_kutta(SurfaceStepContext& m, double t) {
    const auto& [a0, a1, a2, a3] = m.a;
    accelerate(m.net, m.h, m.v, a0);
    add_probes(m, m.h, a0, t / 6);
    place_stage(m.net, m.h, m.v, t / 2, m.stage);
    accelerate(m.net, m.stage, m.v, a0, t / 2, a1);
    add_probes(m, m.stage, a1, t / 3);
    place_stage(m.net, m.h, m.v, t / 2, a0, t * t / 4, m.stage);
    accelerate(m.net, m.stage, m.v, a1, t / 2, a2);
    add_probes(m, m.stage, a2, t / 3);
    place_stage(m.net, m.h, m.v, t, a1, t * t / 2, m.stage);
    accelerate(m.net, m.stage, m.v, a2, t, a3);
    add_probes(m, m.stage, a3, t / 6);
    combine_stages(m, t);
}

void update_all_inside(SurfaceStepContext& m) {
    for (std::size_t p = 0; p < m.footprints.count; ++p) {
        const Footprint& print = m.footprints.prints[p];
        if (print.x0 != print.x1)
            update_inside(m.settings, print, m.inside[p], height_under(m.net, print, m.h));
    }
}

ProbeReaction reaction(const SurfaceStepContext& m, std::size_t p, double seconds) {
    const Footprint& print = m.footprints.prints[p];
    if (print.x0 == print.x1) return {};
    return {.force = m.impulse[p] / seconds,
            .height = height_under(m.net, print, m.h),
            .inside = m.inside[p] != 0};
}

// ---- sleep -----------------------------------------------------------------------------------------------

double sum_of_squares(std::span<const double> values) {
    std::array<double, 4> sums{};
    for (std::size_t i = 0; i + 4 <= values.size(); i += 4) {
        for (std::size_t lane = 0; lane < 4; ++lane) sums[lane] += values[i + lane] * values[i + lane];
    }
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// Whether the surface may fall asleep: an upper bound of its energy is below the limit that
/// SpringSurfaceSettings::still sets.
bool is_still(const SpringSurface& surface, const SpringNetwork& net) {
    const double most =
        net.mass / 2 *
        (sum_of_squares(surface.velocity) + highest_squared_frequency(net) * sum_of_squares(surface.height));
    return most <= surface.settings.tension * surface.settings.still * surface.settings.still;
}

void fall_asleep(SpringSurface& surface) {
    std::ranges::fill(surface.height, 0.0);
    std::ranges::fill(surface.velocity, 0.0);
    surface.asleep = 1;
}

/// Whether a probe touches the level surface; if so, the surface wakes.
bool touches_level(const SpringSurface& surface, const ProbeFootprints& footprints) {
    for (std::size_t p = 0; p < footprints.count; ++p) {
        const Footprint& print = footprints.prints[p];
        if (print.x0 != print.x1 && contact_force(surface.settings, print, surface.inside[p] != 0, 0) != 0)
            return true;
    }
    return false;
}

/// Footprints (nodes under a probe, with weights) of the probes that are on the surface; their weights are
/// written from `weights` on. Any other probe is marked as not having broken through.
ProbeFootprints probe_footprints(SpringSurface& surface, std::span<const SurfaceProbe> probes,
                                 double* weights) {
    ProbeFootprints footprints{.count = std::min(probes.size(), surface_probe_capacity)};
    for (std::size_t p = 0; p < surface_probe_capacity; ++p) {
        if (p >= footprints.count || !is_on_surface(surface.settings, probes[p])) {
            surface.inside[p] = 0;
            continue;
        }
        Footprint& print = footprints.prints[p];
        print = footprint(surface.settings, probes[p], weights);
        weights += (print.x1 - print.x0) * (print.z1 - print.z0);
    }
    return footprints;
}

double stiffness_of_probes(const SpringSurfaceSettings& s, const SpringNetwork& net,
                           const ProbeFootprints& footprints) {
    double sum = 0;
    for (const Footprint& print : footprints.prints) sum += s.contact * print.squares / net.mass;
    return sum;
}

/// Number of sub-steps of a call, and the length of each (s). If dt would need more than max_steps of them,
/// they cover less than dt, because longer ones would be unstable.
std::pair<std::uint32_t, double> sub_steps(const SpringSurfaceSettings& s, const SpringNetwork& net,
                                           const ProbeFootprints& footprints, double dt) {
    const double rate = std::max(
        std::sqrt(highest_squared_frequency(net) + stiffness_of_probes(s, net, footprints)), net.drag);
    const double wanted = std::max(1.0, std::ceil(dt * rate / max_phase));
    if (wanted <= s.max_steps) return {static_cast<std::uint32_t>(wanted), dt / wanted};
    return {s.max_steps, max_phase / rate};
}

std::size_t array_size(const SpringSurfaceSettings& s) {
    return (s.nodes + std::size_t{2}) * surface_row_stride(s);
}

}  // namespace

SpringSurface make_spring_surface(const SpringSurfaceSettings& settings) {
    THAUM_ASSERT(checked(settings), "settings of the surface are wrong: call checked() first");
    SpringSurface surface{.settings = settings};
    surface.height.assign(array_size(settings), 0);
    surface.velocity.assign(array_size(settings), 0);
    return surface;
}

void refresh_after_edit(SpringSurface& surface) {
    const SpringNetwork net = spring_network(surface.settings);
    const std::size_t n = surface.settings.nodes;
    for (std::size_t z = 0; z < n && !net.mirrored; ++z) {
        for (std::size_t x = 0; x < n; x += z == 0 || z == n - 1 ? 1 : n - 1) {
            surface.height[surface_node_index(surface.settings, x, z)] = 0;
            surface.velocity[surface_node_index(surface.settings, x, z)] = 0;
        }
    }
    mirror(net, surface.height.data());
    surface.asleep = 0;
}

SpringSurfaceStep advance(SpringSurface& surface, SpringSurfaceScratch& scratch,
                          std::span<const SurfaceProbe> probes, double dt) {
    const SpringSurfaceSettings& s = surface.settings;
    const SpringNetwork net = spring_network(s);
    const std::size_t size = array_size(s);
    scratch.values.resize((5 + surface_probe_capacity) * size);
    double* const values = scratch.values.data();
    const ProbeFootprints footprints = probe_footprints(surface, probes, values + 5 * size);
    SpringSurfaceStep result;
    // A probe that has broken through stays inside while the surface sleeps.
    for (std::size_t p = 0; p < footprints.count; ++p) result.probes[p].inside = surface.inside[p] != 0;
    if (!(dt > 0)) return result;
    dt = std::min(dt, longest_surface_call);
    result.seconds = dt;
    if (surface.asleep != 0 && !touches_level(surface, footprints)) return result;
    surface.asleep = 0;
    const auto [steps, t] = sub_steps(s, net, footprints, dt);
    result.steps = steps;
    result.seconds = t * steps;
    result.visited = steps * static_cast<std::uint32_t>((net.end - net.first) * (net.end - net.first));
    SurfaceStepContext context{
        s, net, footprints, surface.inside, surface.height.data(), surface.velocity.data(), values, {}};
    for (std::size_t i = 0; i < 4; ++i) context.a[i] = values + (i + 1) * size;
    for (std::uint32_t i = 0; i < steps; ++i) {
        update_all_inside(context);
        runge_kutta(context, t);
    }
    for (std::size_t p = 0; p < footprints.count; ++p)
        result.probes[p] = reaction(context, p, result.seconds);
    const bool held = std::ranges::any_of(context.impulse, [](double impulse) { return impulse != 0; });
    if (!held && is_still(surface, net)) fall_asleep(surface);
    return result;
}

double energy(const SpringSurface& surface) {
    const SpringNetwork net = spring_network(surface.settings);
    const double* h = surface.height.data();
    const double* v = surface.velocity.data();
    double sum = 0;
    for (std::size_t z = net.first; z < net.end; ++z) {
        const auto [begin, end] = row(net, z);
        for (std::size_t i = begin; i < end; ++i) sum += v[i] * v[i] - h[i] * spring_acceleration(net, h, i);
    }
    return net.mass / 2 * sum;
}

double stiffest_frequency(const SpringSurfaceSettings& settings) {
    return std::sqrt(highest_squared_frequency(spring_network(settings)));
}

double mode_frequency(const SpringSurfaceSettings& settings, std::uint32_t p, std::uint32_t q) {
    const SpringNetwork net = spring_network(settings);
    const double parts = net.mirrored ? settings.nodes : settings.nodes - 1;
    const double x = pi * p / parts, z = pi * q / parts;
    const double sx = det::sin(x / 2), sz = det::sin(z / 2);
    // 1 - cos x cos z, in a form that loses no digits for slow modes.
    const double corners = 2 * (sx * sx + sz * sz) - 4 * sx * sx * sz * sz;
    return std::sqrt(4 * net.structural * (sx * sx + sz * sz) + 4 * net.shear * corners + net.level);
}

double height_at(const SpringSurface& surface, vec2 place) {
    const SpringSurfaceSettings& s = surface.settings;
    const double half = s.side / 2;
    if (!(std::abs(place.x) <= half && std::abs(place.y) <= half)) return 0;
    const double last = s.nodes - 1, a = surface_node_spacing(s);
    const double x = std::clamp(place.x / a + last / 2, 0.0, last);
    const double z = std::clamp(place.y / a + last / 2, 0.0, last);
    const double x0 = std::min(std::floor(x), last - 1), z0 = std::min(std::floor(z), last - 1);
    const std::size_t i = surface_node_index(s, static_cast<std::size_t>(x0), static_cast<std::size_t>(z0));
    const double* h = surface.height.data() + i;
    const double* next = h + surface_row_stride(s);
    const double low = h[0] + (x - x0) * (h[1] - h[0]), high = next[0] + (x - x0) * (next[1] - next[0]);
    return low + (z - z0) * (high - low);
}

double transmitted(const SpringSurfaceSettings& settings, double depth, double density) {
    if (!std::isfinite(depth) || !std::isfinite(density)) return 0;
    const double fall = std::max(0.0, depth) / settings.reach * std::max(0.0, density);
    return std::isfinite(fall) ? det::exp(-fall) : 0;
}

Expected<SpringSurfaceSettings> checked(const SpringSurfaceSettings& s) {
    struct Bound {
        const char* name;
        double value, low, high;
    };
    const std::array bounds{
        Bound{"nodes", static_cast<double>(s.nodes), 3, 129},
        Bound{"side", s.side, 1e-3, 1e3},
        Bound{"tension", s.tension, 0, 1e12},
        Bound{"shear", s.shear, 0, 1},
        Bound{"areal_mass", s.areal_mass, 1e-6, 1e9},
        Bound{"level", s.level, 0, 1e12},
        Bound{"damping", s.damping, 0, 1e6},
        Bound{"contact", s.contact, 0, 1e12},
        Bound{"pop_through", s.pop_through, 0, 1e9},
        Bound{"cling", s.cling, 0, 1e9},
        Bound{"reach", s.reach, 1e-6, 1e6},
        Bound{"still", s.still, 0, 1},
        Bound{"most_steps", static_cast<double>(s.max_steps), 1, 1000},
    };
    for (const Bound& b : bounds) {
        if (!(b.value >= b.low && b.value <= b.high))
            return fail(text("surface: ", b.name, " is ", b.value, "; it must be ", b.low, " to ", b.high));
    }
    return s;
}

}  // namespace thaum::fluid
