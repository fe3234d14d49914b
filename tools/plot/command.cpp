// thaum plot: draws a benchmark's report as pictures and a page.
#include <cstdio>

#include "core/file.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/command_line/arguments.h"
#include "tools/plot/page.h"

namespace thaum::game::inline app {
namespace {

constexpr std::string_view plot_help =
    R"(usage: thaum plot REPORT.json [--out DIR]

Draws the report of `thaum bench --json REPORT.json` as SVG files: run time
against error with the Pareto front and the default marked, or bars of ratios
for cases without an error. The page index.html has all tables and figures.

  --out DIR     folder for the files, made if it is missing (default: out/plot);
                files of an earlier report are replaced
)";

constexpr std::size_t longest_report = std::size_t{256} << 20U;

int run_plot(const std::vector<std::string>& words) {
    static constexpr Option options[] = {{"--out", 1}};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    if (arguments->plain().size() != 1) return refuse({"plot needs one report: thaum plot REPORT.json"});
    const auto& file = arguments->plain().front();
    const auto json = read_text_file(file, longest_report);
    if (!json) return refuse(json.error());
    const auto report = bench::from_json(*json);
    if (!report) return refuse({text(file, ": ", report.error().message)});
    const std::filesystem::path folder = arguments->value("--out").value_or("out/plot");
    const auto page = plot::make_page(*report);
    if (const auto written = plot::write_page(page, folder); !written) return refuse(written.error());
    std::printf("%s: %zu rows, %zu figures\n", (folder / "index.html").c_str(), report->rows.size(),
                page.figures.size());
    return done;
}

const CommandRegistration registration_of_plot({.name = "plot", .help = plot_help, .run = run_plot});

}  // namespace

}  // namespace thaum::game::inline app
