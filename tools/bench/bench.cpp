#include "tools/bench/bench.h"

#include <algorithm>
#include <cstdio>

#include "core/file.h"
#include "core/text.h"
#include "tools/bench/invariants.h"

namespace thaum::bench {
namespace {

const Area* area_named(std::string_view name) {
    const auto all = areas();
    const auto it = std::ranges::find(all, name, &Area::name);
    return it == all.end() ? nullptr : &*it;
}

std::string unknown_message(const std::string& name) {
    auto message = text("bench: no area \"", name, "\"; there are:");
    for (const auto& area : areas()) append_text(message, text(" ", area.name));
    return text(message, "\n");
}

bool wanted(const Options& options, const Area& area) {
    return options.areas.empty() || std::ranges::find(options.areas, area.name) != options.areas.end();
}

void print(std::FILE* to, const std::string& s) { std::fputs(s.c_str(), to); }

/// Prints the table and writes the JSON. If the JSON goes to standard output, the table goes to standard
/// error.
int publish(const Options& options, const Report& report) {
    const bool json_on_screen = options.json && *options.json == "-";
    print(json_on_screen ? stderr : stdout, to_table(report));
    if (json_on_screen) {
        print(stdout, to_json(report));
    } else if (options.json) {
        const auto written = write_text_file(*options.json, to_json(report));
        if (!written) {
            print(stderr, text("bench: ", written.error().message, "\n"));
            return 2;
        }
    }
    return 0;
}

using RunArea = void(const Options&, Report&);

/// Runs an area (a group of benchmarks). If an area cannot make its scene, it prints the reason and adds no
/// row, which counts as a fault.
void run_area(const Area& area, RunArea& run, const Options& options, Report& report) {
    const auto rows = report.rows.size(), faults = report.faults.size();
    run(options, report);
    if (report.rows.size() == rows && report.faults.size() == faults)
        report.faults.push_back(text(area.name, ": no row was measured; see the messages above"));
}

/// Tests before minutes of measurements whether the report can be written.
Expected<void> check_json(const Options& options) {
    return options.json && *options.json != "-" ? check_output(*options.json) : Expected<void>();
}

}  // namespace

int run(const Options& options) {
    for (const auto& name : options.areas) {
        if (area_named(name) == nullptr) {
            print(stderr, unknown_message(name));
            return 2;
        }
    }
    for (const auto& name : options.areas) {
        if (options.stress && area_named(name)->stress == nullptr) {
            print(stderr,
                  text("bench: ", name, " has no stress test; leave out --stress or name another area\n"));
            return 2;
        }
    }
    if (const auto free = check_json(options); !free) {
        print(stderr, text("bench: ", free.error().message, "\n"));
        return 2;
    }
    auto report = empty_report();
    for (const auto& area : areas()) {
        const auto run = options.stress ? area.stress : area.run;
        if (wanted(options, area) && run != nullptr) run_area(area, *run, options, report);
    }
    mark_fronts(report.rows);
    check_invariants(report);
    const int published = publish(options, report);
    for (const auto& fault : report.faults) print(stderr, text("bench: ", fault, "\n"));
    return published == 0 && !report.faults.empty() ? 1 : published;
}

}  // namespace thaum::bench
