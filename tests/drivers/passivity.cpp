// Tests passive sources of force (such as walls and springs) in every haptic scenario: computes the energy
// that they have created from the tables of forces written by the scenarios. Arguments: the folder, and the
// largest energy allowed (J).
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "core/file.h"
#include "tests/scenes/passivity.h"

int main(int count, char** arguments) {
    namespace fs = std::filesystem;
    if (count != 3) return 2;
    const double most = std::atof(arguments[2]);
    constexpr std::size_t max_bytes = 128U << 20U;
    bool good = true;
    int tables = 0, tethered = 0;
    double moved = 0;
    for (const auto& entry : fs::directory_iterator(arguments[1])) {
        const auto name = entry.path().filename().string();
        if (!name.ends_with(".forces.csv")) continue;
        const auto csv = thaum::read_text_file(entry.path(), max_bytes);
        const auto energy = csv ? thaum::bench::passive_energy(*csv)
                                : thaum::Expected<thaum::bench::PassiveEnergy>(csv.error());
        if (!energy) {
            std::printf("%s: %s\n", name.c_str(), energy.error().message.c_str());
            good = false;
            continue;
        }
        const bool holds = energy->created <= most;
        std::printf("%s %-55s created %.6f J (booked %.6f), moved %.3f J, held %.4f J\n",
                    holds ? "ok  " : "FAIL", name.c_str(), energy->created, energy->max_booked, energy->moved,
                    energy->held);
        good = good && holds;
        ++tables;
        tethered += energy->held > 1e-4 ? 1 : 0;
        moved += energy->moved;
    }
    std::printf("%d tables, %d with something held, %.3f J moved\n", tables, tethered, moved);
    const bool proves_something = tables >= 15 && tethered >= 6 && moved > 0.5;
    if (!proves_something) std::printf("too few tables or too little motion to prove anything\n");
    return good && proves_something ? 0 : 1;
}
