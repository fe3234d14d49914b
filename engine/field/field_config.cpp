#include "field/field_config.h"

#include "core/text.h"

namespace thaum::field {

TransferFunction read_transfer(const ConfigTable& table, std::string_view key, Range range,
                               const std::vector<double>& fallback) {
    const auto numbers = table.numbers(key, range, 2 * max_transfer_points, fallback);
    if (numbers.size() % 2 != 0) {
        table.report(key, text("'", key, "' must be pairs of x and y"));
        return {};
    }
    std::vector<vec2> points;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) points.emplace_back(numbers[i], numbers[i + 1]);
    const auto function = transfer_function(points);
    if (function) return *function;
    table.report(key, text("'", key, "': ", function.error().message));
    return {};
}

Filter read_filter(const ConfigTable& table, Range range) {
    const auto names = filter_names();
    return {static_cast<FilterKind>(table.choice("kind", {names.begin(), names.end()})),
            table.number("a", range, 0), table.number("b", range, 0)};
}

}  // namespace thaum::field
