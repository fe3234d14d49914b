#include "game/lab/lab_trace.h"

#include "core/text.h"

namespace thaum::game::inline lab {

std::string lab_trace_header(bool times) {
    std::string header =
        "time_s,energy_m5_s2,momentum_x_m4_s,momentum_y_m4_s,momentum_z_m4_s,speed_m_s,divergence,cfl,"
        "substeps,"
        "fell_back,pressure_iterations,cells,mixing,surface_j,surface_substeps,ladle_x_m,ladle_y_m,ladle_z_m";
    for (std::size_t s = 1; s <= fluid::max_substances; ++s) header += text(",substance_", s, "_m3");
    if (times) header += ",fluid_us,surface_us";
    return header + "\n";
}

void append_lab_row(const LabState& lab, const LabFigures& f, bool times, std::string& rows) {
    const auto& p = f.momentum;
    rows += text(lab.seconds(), ',', f.fluid.energy, ',', p.x, ',', p.y, ',', p.z, ',', f.fluid.speed, ',',
                 f.fluid.divergence, ',', f.cfl, ',', f.fluid.substeps, ',', f.fluid.fell_back ? 1 : 0, ',',
                 f.fluid.pressure_iterations, ',', f.fluid.cells, ',', f.mixing, ',',
                 fluid::energy(lab.brew.surface), ',', f.surface.steps);
    rows += lab.ladle ? text(',', lab.ladle->x, ',', lab.ladle->y, ',', lab.ladle->z) : std::string(",,,");
    for (const double amount : f.amounts) rows += text(',', amount);
    if (times) rows += text(',', fixed(f.fluid_us, 1), ',', fixed(f.surface_us, 1));
    rows += '\n';
}

}  // namespace thaum::game::inline lab
