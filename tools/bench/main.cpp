// Runs the benchmarks alone, until the `thaum` program does.
#include <cstdio>
#include <string_view>

#include "tools/bench/bench.h"

int main(int argc, char** argv) {
    thaum::bench::Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (argument == "--quick") {
            options.quick = true;
        } else if (argument == "--stress") {
            options.stress = true;
        } else if (argument == "--json" && i + 1 < argc) {
            options.json = argv[++i];
        } else if (argument.starts_with("-")) {
            std::fprintf(stderr, "usage: thaum_bench_main [AREA ...] [--json FILE] [--quick] [--stress]\n");
            return 2;
        } else {
            options.areas.emplace_back(argument);
        }
    }
    return thaum::bench::run(options);
}
