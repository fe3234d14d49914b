// tools/plot/page.h: a report as one HTML page that needs nothing else, and its figures as files.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"
#include "tools/bench/report.h"

namespace thaum::plot {

struct SvgFile {
    std::string name;  ///< "fluid-taylor_green_moving-rms_velocity.svg": safe in any folder, no two alike
    std::string svg;
};

struct Page {
    std::string html;
    std::vector<SvgFile> figures;
    std::size_t
        not_drawn{};  ///< cases and areas beyond the most figures of a page; their rows are in the tables
};

inline constexpr std::size_t most_figures = 200;

/// Areas, cases and, by their time, rows, all sorted. Every row is in a table.
Page make_page(const bench::Report&);

/// index.html and the SVG files, in a folder that is made where it is missing.
Expected<void> write_page(const Page&, const std::filesystem::path& folder);

}  // namespace thaum::plot
