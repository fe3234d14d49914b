// Tests of reading reports of the benchmark: the output of to_json is read back unchanged, and an invalid
// report is refused in one line that names the place.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.h"
#include "core/text.h"
#include "tools/bench/report.h"
#include "unit/message_of.h"

namespace thaum::bench {
namespace {

Report sample() {
    Report report{"1.2.3", {"cpu", 2, "Release"}, {}};
    Row row;
    row.area = "fluid";
    row.name = "vortex";
    row.setting = {{"n", std::int64_t{32}}, {"share", 0.25}, {"solver", std::string("thaum")}};
    row.time_us = Times{1.5, 2.5, 3.5};
    row.error = ErrorMeasure{"rms", 0.125};
    row.front = row.is_default = true;
    row.metrics = {{"energy_j", 1e-300}, {"steps", 7}};
    row.hash = "00ff";
    report.rows = {row, {.area = "tick", .name = "bare"}};
    return report;
}

TEST(ReportReader, ReadsBackAWrittenReport) {
    const auto json = to_json(sample());
    const auto read = from_json(json).value();
    EXPECT_EQ(to_json(read), json);
}

TEST(ReportReader, NullIsANumberThatIsNotFinite) {
    auto report = sample();
    report.rows[0].error->value = std::numeric_limits<double>::infinity();
    const auto read = from_json(to_json(report)).value();
    EXPECT_TRUE(std::isnan(read.rows[0].error->value));
}

TEST(ReportReader, KeysThatAreNotKnownArePassedOver) {
    const auto read = from_json(R"({"rows": [{"area": "a", "case": "b", "colour": [1]}], "x": {}})").value();
    EXPECT_EQ(read.rows.size(), 1U);
    EXPECT_EQ(read.version, "unknown");
}

void expect_refused(std::string_view json, std::string_view part) {
    const auto message = message_of(from_json(json));
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(ReportReader, NamesTheFault) {
    expect_refused("", "not JSON from byte 1");
    expect_refused("{\"rows\": [", "not JSON from byte");
    expect_refused("{\"rows\": [NaN]}", "not JSON");
    expect_refused("{\"rows\": \xFF}", "not JSON");
    expect_refused("[]", "no list 'rows'");
    expect_refused("{}", "no list 'rows'");
    expect_refused("{\"rows\": {}}", "no list 'rows'");
    expect_refused("{\"rows\": [3]}", "row 0: it must be an object");
    expect_refused("{\"rows\": [{\"case\": \"b\"}]}", "row 0: 'area' must be a text");
    expect_refused("{\"rows\": [{\"area\": \"a\", \"case\": 1}]}", "row 0: 'case' must be a text");
    const auto with = [](std::string_view more) {
        return text("{\"rows\": [{\"area\": \"a\", \"case\": \"b\"}, {\"area\": \"a\", \"case\": \"b\", ",
                    more, "}]}");
    };
    expect_refused(with("\"time_us\": 3"), "row 1: 'time_us' must be an object");
    expect_refused(with("\"time_us\": {\"median\": \"NaN\"}"), "row 1: 'time_us.median' must be a number");
    expect_refused(with("\"error\": {\"value\": 1}"), "row 1: in 'error': 'name' must be a text");
    expect_refused(with("\"error\": {\"name\": \"e\", \"value\": \"nan\"}"),
                   "'error.value' must be a number");
    expect_refused(with("\"setting\": {\"n\": []}"), "'setting.n' must be a number");
    expect_refused(with("\"metrics\": {\"n\": true}"), "'metrics.n' must be a number");
    expect_refused(with("\"front\": 1"), "'front' must be true or false");
    expect_refused(with("\"hash\": 1"), "'hash' must be a text");
    expect_refused(with("\"metrics\": {\"n\": 1e999}"), "a number is too large");
}

TEST(ReportReader, RefusesReportsThatWouldGrowWithoutBounds) {
    std::string names = "\"n0\": 0", rows = "{\"area\": \"a\", \"case\": \"b\"}";
    for (int i = 1; i < 200; ++i) append_text(names, text(", \"n", i, "\": 0"));
    expect_refused(text("{\"rows\": [{\"area\": \"a\", \"case\": \"b\", \"metrics\": {", names, "}}]}"),
                   "more than 128");
    std::string many = rows;
    for (int i = 0; i < 200'000; ++i) many += "," + rows;
    expect_refused(text("{\"rows\": [", many, "]}"), "more than 200000 rows");
    expect_refused(std::string(1'000'000, '['), "not JSON");
}

TEST(ReportReader, EverySlipIsRefusedInOneLineOrRead) {
    const auto original = to_json(sample());
    Random random{7};
    int refused = 0, read = 0;
    for (int i = 0; i < 5000; ++i) {
        auto json = original;
        const auto at = static_cast<std::size_t>(random.below(json.size()));
        if (random.below(2) == 0) {
            json[at] = static_cast<char>(random.below(256));
        } else {
            json.erase(at, 1 + static_cast<std::size_t>(random.below(30)));
        }
        const auto report = from_json(json);
        ++(report ? read : refused);
        const auto said = report ? std::string() : report.error().message;
        ASSERT_EQ(said.find('\n'), std::string::npos) << said;
    }
    EXPECT_GT(refused, 1000);
    EXPECT_GT(read, 500);
}

}  // namespace
}  // namespace thaum::bench
