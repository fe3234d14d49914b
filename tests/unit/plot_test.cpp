// Tests of benchmark reports drawn as pictures: every row is shown, and the output is well-formed XML for any
// report.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/file.h"
#include "core/text.h"
#include "tools/plot/axis.h"
#include "tools/plot/figure.h"
#include "tools/plot/markup.h"
#include "tools/plot/page.h"
#include "tools/plot/svg.h"
#include "unit/message_of.h"
#include "unit/xml.h"

namespace thaum::plot {
namespace {

using bench::Row;

Row competitor(std::string name, std::string solver, std::int64_t n, double us, double error) {
    Row row;
    row.area = "fluid";
    row.name = std::move(name);
    row.setting = {{"solver", std::move(solver)}, {"n", n}, {"dt_ms", std::int64_t{1}}};
    row.time_us = bench::Times{us / 2, us, us * 2};
    row.error = bench::ErrorMeasure{"rms", error};
    return row;
}

bench::Report two_solvers() {
    bench::Report report{"1.2.3", {"A & B", 2, "Release"}, {}};
    for (const std::int64_t n : {16, 32, 64}) {
        const auto size = static_cast<double>(n);
        report.rows.push_back(competitor("vortex", "thaum", n, size * 10, 1 / size));
        report.rows.push_back(competitor("vortex", "other", n, size * 15, 2 / size));
    }
    bench::mark_fronts(report.rows);
    report.rows[2].is_default = true;
    report.rows[2].hash = "00ff";
    return report;
}

std::vector<const Row*> all(const bench::Report& report) {
    std::vector<const Row*> rows;
    for (const auto& row : report.rows) rows.push_back(&row);
    return rows;
}

std::size_t count(std::string_view text, std::string_view part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

void expect_well_formed(const Page& page) {
    // The first line, which declares the document type, is not XML.
    EXPECT_EQ(test::xml_fault(std::string_view(page.html).substr(page.html.find('\n'))), "");
    for (const auto& figure : page.figures) EXPECT_EQ(test::xml_fault(figure.svg), "") << figure.name;
}

// ---- axes of a figure -------------------------------------------------------------------------------------

TEST(PlotAxis, MapsPowersOfTenInEqualSteps) {
    const auto axis = log_axis(std::array{1e-3, 1.0}, 100, 400);
    EXPECT_DOUBLE_EQ(axis.at(1e-3), 100);
    EXPECT_DOUBLE_EQ(axis.at(1e-2), 200);
    EXPECT_DOUBLE_EQ(axis.at(1e-1), 300);
    EXPECT_DOUBLE_EQ(axis.at(1), 400);
    EXPECT_DOUBLE_EQ(axis.at(std::sqrt(1e-3)), 250);
}

TEST(PlotAxis, GrowsUpwardsOnAPage) {
    const auto axis = log_axis(std::array{1.0, 100.0}, 330, 30);
    EXPECT_DOUBLE_EQ(axis.at(1), 330);
    EXPECT_DOUBLE_EQ(axis.at(10), 180);
    EXPECT_DOUBLE_EQ(axis.at(100), 30);
}

TEST(PlotAxis, EndsAreTheNextOfOneTwoFive) {
    const auto axis = log_axis(std::array{0.3, 7.0}, 0, 1);
    EXPECT_DOUBLE_EQ(axis.low, std::log10(0.2));
    EXPECT_DOUBLE_EQ(axis.high, 1);
    const auto on_steps = log_axis(std::array{0.2, 5.0}, 0, 1);
    EXPECT_DOUBLE_EQ(on_steps.low, std::log10(0.2));
    EXPECT_DOUBLE_EQ(on_steps.high, std::log10(5));
}

TEST(PlotAxis, TicksStandWhereTheirValuesAre) {
    for (const double high : {3.0, 1e3, 1e9, 1e80}) {
        const auto axis = log_axis(std::array{0.002, high}, 50, 750);
        const auto all_ticks = ticks(axis);
        EXPECT_GE(all_ticks.size(), 2U);
        EXPECT_LE(all_ticks.size(), 9U);
        for (const auto& tick : all_ticks)
            EXPECT_NEAR(axis.at(std::stod(tick.label)), tick.at_px, 1e-9) << tick.label;
    }
}

TEST(PlotAxis, ZeroHasItsOwnMargin) {
    const auto axis = log_axis(std::array{0.0, 1.0, 10.0}, 100, 400);
    EXPECT_LT(axis.at(0), axis.at(1) - 10);
    EXPECT_GE(axis.at(0), 100);
    EXPECT_EQ(ticks(axis).front().label, "0");
}

TEST(PlotAxis, HoldsOneValueAndTheWidestSpan) {
    const auto one = log_axis(std::array{2.0}, 0, 100);
    EXPECT_DOUBLE_EQ(one.at(1), 0);
    EXPECT_DOUBLE_EQ(one.at(5), 100);
    const auto nothing = log_axis(std::array{0.0}, 0, 100);
    EXPECT_TRUE(std::isfinite(nothing.at(0)));
    const std::array ends{std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()};
    const auto wide = log_axis(ends, 0, 100);
    for (const double v : ends) EXPECT_TRUE(wide.at(v) >= 0 && wide.at(v) <= 100);
    EXPECT_LE(ticks(wide).size(), 9U);
}

// ---- figures of a report ----------------------------------------------------------------------------------

TEST(PlotFigure, WordsAreSeriesNumbersAreLabelsAndEqualSettingsAreNeither) {
    const auto report = two_solvers();
    const auto figures = front_figures(all(report));
    ASSERT_EQ(figures.size(), 1U);
    EXPECT_EQ(figures[0].series, (std::vector<std::string>{"other", "thaum"}));
    EXPECT_EQ(figures[0].points.size(), 6U);
    for (const auto& p : figures[0].points) EXPECT_TRUE(p.label.starts_with("n ")) << p.label;
    EXPECT_TRUE(std::ranges::is_sorted(figures[0].points, {}, &Point::time_us));
}

TEST(PlotFigure, ErrorsOfTwoKindsAreTwoFigures) {
    auto report = two_solvers();
    report.rows[0].error->name = "divergence";
    EXPECT_EQ(front_figures(all(report)).size(), 2U);
}

TEST(PlotFigure, ValuesThatAreNotFiniteAreNotDrawn) {
    auto report = two_solvers();
    report.rows[0].error->value = NAN;
    report.rows[1].time_us->median = INFINITY;
    EXPECT_EQ(front_figures(all(report)).at(0).points.size(), 4U);
}

TEST(PlotSvg, EveryPointStandsWhereTheAxesSay) {
    const auto report = two_solvers();
    const auto figure = front_figures(all(report)).at(0);
    const auto axes = axes_of(figure);
    const auto svg = to_svg(figure);
    EXPECT_EQ(test::xml_fault(svg), "");
    for (const auto& p : figure.points) {
        const auto place =
            text("translate(", px(axes.time.at(p.time_us)), ",", px(axes.error.at(p.error)), ")");
        EXPECT_NE(svg.find(place), std::string::npos) << place;
        EXPECT_NE(svg.find(text("<title>", escaped(p.tooltip), "</title>")), std::string::npos);
    }
}

TEST(PlotSvg, JoinsTheFrontAndRingsTheDefaultOnly) {
    const auto report = two_solvers();
    const auto figure = front_figures(all(report)).at(0);
    const auto svg = to_svg(figure);
    const auto axes = axes_of(figure);
    std::string joined;
    for (const auto& p : figure.points) {
        if (p.front)
            joined +=
                text(joined.empty() ? "" : " ", px(axes.time.at(p.time_us)), ",", px(axes.error.at(p.error)));
    }
    EXPECT_EQ(count(joined, ","), 3U);  // commas of all points of "thaum", and of none of "other"
    EXPECT_NE(svg.find(text("points=\"", joined, "\"")), std::string::npos);
    EXPECT_EQ(count(svg, "r=\"10.00\""), 1U);
    EXPECT_EQ(count(svg, "n 32 (default)"), 1U);
}

TEST(PlotSvg, RatiosAreBarsFromOne) {
    bench::Report report{"1", {}, {}};
    for (const double ratio : {0.5, 1.0, 4.0, -1.0, std::nan("")}) {
        Row row;
        row.area = "ecs";
        row.name = text("case", report.rows.size());
        row.metrics = {{"ratio_to_raw", ratio}, {"ns_per_entity", 3}};
        report.rows.push_back(row);
    }
    const auto figures = ratio_figures(all(report));
    ASSERT_EQ(figures.size(), 1U);
    EXPECT_EQ(figures[0].bars.size(), 3U);
    const auto svg = to_svg(figures[0]);
    EXPECT_EQ(test::xml_fault(svg), "");
    EXPECT_EQ(count(svg, "height=\"14.00\""), 3U);
    // One decade, from 0.5 to 5, is 420 px wide.
    EXPECT_NE(svg.find(text("width=\"", px(420 * std::log10(2)), "\" height=\"14.00\"")), std::string::npos);
    EXPECT_NE(svg.find(text("width=\"", px(420 * std::log10(4)), "\" height=\"14.00\"")), std::string::npos);
}

// ---- pages with all figures and tables --------------------------------------------------------------------

TEST(PlotPage, EveryRowIsInATable) {
    auto report = two_solvers();
    report.rows.push_back({.area = "tick", .name = "bare"});
    const auto page = make_page(report);
    expect_well_formed(page);
    EXPECT_EQ(count(page.html, "<tr"), report.rows.size() + 2);  // two of the rows are headings
    for (const auto* part : {"A &amp; B", "front, default", "00ff", "median us", "<svg", "<h3>bare</h3>"})
        EXPECT_NE(page.html.find(part), std::string::npos) << part;
    EXPECT_EQ(page.html.find("<script"), std::string::npos);
    ASSERT_EQ(page.figures.size(), 1U);
    EXPECT_EQ(page.figures[0].name, "fluid-vortex-rms.svg");
}

TEST(PlotPage, HostileNamesStayWordsAndStayInTheFolder) {
    auto report = two_solvers();
    const std::string evil = "</svg><script>alert(1)</script>&\"'\x01\xEF\xBF\xBF../../x";
    for (auto& row : report.rows) {
        row.area = row.name = evil;
        row.error->name = evil;
        row.setting[0].first = evil;
        row.setting[0].second = text(row.setting.size(), evil, bench::shown(row.setting[0].second));
        row.metrics = {{evil, NAN}};
    }
    const auto page = make_page(report);
    expect_well_formed(page);
    EXPECT_EQ(page.html.find("<script"), std::string::npos);
    ASSERT_EQ(page.figures.size(), 1U);
    EXPECT_EQ(page.figures[0].name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-."),
              std::string::npos);
    EXPECT_EQ(page.figures[0].name.find(".."), std::string::npos);
}

TEST(PlotPage, NamesThatLookAlikeGetFilesOfTheirOwn) {
    auto report = two_solvers();
    for (std::size_t i = 0; i < report.rows.size(); ++i) report.rows[i].name = i % 2 == 0 ? "a b" : "a/b";
    const auto page = make_page(report);
    ASSERT_EQ(page.figures.size(), 2U);
    EXPECT_NE(page.figures[0].name, page.figures[1].name);
}

TEST(PlotPage, AHundredThousandRowsAreAPage) {
    bench::Report report{"1", {}, {}};
    for (int i = 0; i < 100'000; ++i) {
        const std::string name = i < 50'000 ? "one" : text("case", i % 500);
        report.rows.push_back(competitor(name, text("s", i % 9), i, 1 + i % 1000, 1.0 / (1 + i % 777)));
        report.rows.back().front = i % 100 == 0;
    }
    const auto page = make_page(report);
    EXPECT_EQ(count(page.html, "<tr>"), 100'000U + 501);
    EXPECT_EQ(page.figures.size(), max_figures);
    EXPECT_EQ(page.not_drawn, 501 - max_figures);
}

TEST(PlotPage, AnEmptyReportIsAPage) {
    const auto page = make_page({"1", {}, {}});
    expect_well_formed(page);
    EXPECT_TRUE(page.figures.empty());
}

TEST(PlotPage, IsWrittenWholeOrTheErrorNamesTheFolder) {
    const TemporaryFolder above;
    const auto folder = above.path() / "deep";
    const auto page = make_page(two_solvers());
    ASSERT_TRUE(write_page(page, folder).has_value());
    EXPECT_EQ(read_text_file(folder / "index.html", 1U << 24U).value(), page.html);
    EXPECT_EQ(read_text_file(folder / page.figures[0].name, 1U << 24U).value(), page.figures[0].svg);
    EXPECT_NE(message_of(write_page(page, folder / "index.html" / "x")).find("index.html"),
              std::string::npos);
}

TEST(PlotMarkup, CutsBetweenLetters) {
    EXPECT_EQ(cut("abc", 3), "abc");
    EXPECT_EQ(cut("abcd", 3), "ab\xE2\x80\xA6");
    EXPECT_EQ(cut("\xC3\xA4\xC3\xB6\xC3\xBC", 2), "\xC3\xA4\xE2\x80\xA6");
    EXPECT_EQ(letters_of("\xC3\xA4\xC3\xB6"), 2U);
}

}  // namespace
}  // namespace thaum::plot
