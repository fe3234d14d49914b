// game/lab/stir_path.h: predefined paths of a ladle.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/table.h"
#include "game/brew/brew.h"

namespace thaum::game::inline lab {

enum class Stirring : std::uint8_t { none, circle, figure8, file };

struct StirPath {
    Stirring kind{};
    /// Point of a path from a file: a time (s) and a position (m, brew's frame). Points are sorted by time.
    /// Between two points the ladle moves in a straight line.
    struct Point {
        double time{};
        vec3 place{};
    };
    std::vector<Point> points{};
};

/// Parses a word of the command line: none, circle, figure8, or the path of a CSV file with the columns
/// time_s,x_m,y_m,z_m. The error says what is wrong, and for a file in which line: no such file, no numbers,
/// or times that do not increase.
Expected<StirPath> stir_path(std::string_view word);
/// Column titles of a path file; the file may omit them.
inline constexpr std::string_view stir_path_titles = "time_s,x_m,y_m,z_m";
/// Parses the text of a path file. `name`: file name for the error.
Expected<StirPath> parse_stir_path(std::string_view csv, std::string_view name);
/// Reads all rows of a path file.
Expected<StirPath> read_stir_path(TableReader& table);

/// Position of the ladle's end (m, brew's frame); std::nullopt: the ladle is out of the brew, as before and
/// after the times of a file. Circle and figure of eight take 2.5 s a turn. They run at 0.6 of the basin's
/// radius and 0.4 of its depth, after half a second in which the ladle enters from above.
std::optional<vec3> ladle_at(const StirPath& path, const Basin& basin, double seconds);

}  // namespace thaum::game::inline lab
