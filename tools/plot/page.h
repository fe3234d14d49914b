// tools/plot/page.h: a report as one HTML page without other files, and its figures as SVG files.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"
#include "tools/bench/report.h"

namespace thaum::plot {

struct SvgFile {
    std::string name;  ///< unique name, safe in any folder: "fluid-taylor_green_moving-rms_velocity.svg"
    std::string svg;
};

struct Page {
    std::string html;
    std::vector<SvgFile> figures;
    /// Number of cases and areas (groups of benchmarks) that got no figure because the page already has as
    /// many as it may have (max_figures). They are still in the tables.
    std::size_t not_drawn{};
};

inline constexpr std::size_t max_figures = 200;

/// Makes a page with all areas (groups of benchmarks), cases and rows; rows are sorted by time. Every row is
/// in a table.
Page make_page(const bench::Report&);

/// Writes index.html and the SVG files. Makes the folder if it is missing.
Expected<void> write_page(const Page&, const std::filesystem::path& folder);

}  // namespace thaum::plot
