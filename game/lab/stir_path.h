// game/lab/stir_path.h: how a ladle goes when no hand leads it.
#pragma once
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "game/cauldron/brew.h"

namespace thaum::game {

enum class Stirring : std::uint8_t { none, circle, figure8, file };

struct StirPath {
    Stirring kind{};
    /// Of a file: s and m, frame of the brew, by time; between them it goes straight.
    struct Point {
        double time{};
        vec3 place{};
    };
    std::vector<Point> points{};
};

/// A word of the command line: none, circle, figure8, or a CSV file with the columns time_s,x_m,y_m,z_m. The error names what is
/// wrong, of a file with its line: no such file, no numbers, times that do not rise.
Expected<StirPath> stir_path(std::string_view word);
Expected<StirPath> parse_stir_path(std::string_view csv, std::string_view name);

/// Where the ladle's end is; none: out of the brew, as before and after what a file says. The circle and the eight go round once in
/// 2.5 s, at six tenths of the basin's radius and four of its depth, to which they dip in half a second.
std::optional<vec3> ladle_at(const StirPath& path, const Basin& basin, double seconds);

}  // namespace thaum::game
