// stirred_bowl FILE: a bowl of 32^3 cells with a spoonful of ink, stirred for six seconds. Writes the density
// of the ink as an NRRD volume (teem.sourceforge.net/nrrd), which ParaView and 3D Slicer open.
#include <iostream>

#include "core/bytes.h"
#include "core/file.h"
#include "core/hash.h"
#include "core/text.h"
#include "fluid/fluid.h"

namespace {

using namespace thaum;

constexpr double cell = 0.01;             ///< edge of a cell (m)
constexpr vec3 centre{0.16, 0.16, 0.16};  ///< centre of the bowl, a sphere (m)

fluid::Settings bowl() {
    fluid::Settings settings{.cells = {32, 32, 32}, .h = cell, .viscosity = 1e-4};
    settings.substances = {{.viscosity = 1e-3, .weight = 0.05, .diffusion = 1e-6}};
    settings.solid = [](vec3 place) {
        return glm::clamp(0.5 + (glm::length(place - centre) - 0.15) / cell, 0.0, 1.0);
    };
    return settings;
}

Bytes nrrd(const fluid::Fluid& fluid, const fluid::Samples& density) {
    const std::string header = text("NRRD0004\ntype: float\ndimension: 3\nsizes: 32 32 32\nspacings: ", cell,
                                    ' ', cell, ' ', cell, "\nendian: little\nencoding: raw\n\n");
    Bytes bytes;
    ByteWriter out(bytes);
    out.put_bytes(std::as_bytes(std::span(header)));
    fluid::each_cell(fluid.lattice, [&](int, int, int, std::size_t at) { out.put(density[at]); });
    return bytes;
}

}  // namespace

int main(int count, char** arguments) {
    auto fluid = fluid::make_fluid(bowl());
    if (!fluid || count != 2) {
        std::cerr << (fluid ? "usage: stirred_bowl FILE" : fluid.error().message) << '\n';
        return 2;
    }
    fluid::pour(*fluid, 0, centre + vec3(0.05, 0, 0), 0.06, 2e-4);
    double fastest = 0;
    for (int step = 0; step < 360; ++step) {
        const double angle = 2 * pi * step / 60;
        const vec3 outward{det::cos(angle), 0, det::sin(angle)}, along{-outward.z, 0, outward.x};
        fluid::push(*fluid, {.place = centre + 0.08 * outward, .radius = 0.04, .impulse = 6e-6 * along});
        fastest = fluid::advance(*fluid, 1.0 / 60).speed;
    }
    const auto bytes = nrrd(*fluid, fluid->state.substances[0]);
    if (const auto written = write_file(arguments[1], bytes); !written) {
        std::cerr << written.error().message << '\n';
        return 1;
    }
    std::cout << text("fastest flow ", fastest, " m/s\nhash ", hex(hash_bytes(bytes)), "\n");
}
