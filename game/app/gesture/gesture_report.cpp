#include "game/app/gesture/gesture_report.h"

#include <algorithm>
#include <cmath>

#include "core/json.h"
#include "core/one_line.h"
#include "core/text.h"

namespace thaum::game::inline app {
namespace {

using gesture::Evaluation;

std::string share_text(double share, int digits = 2) { return fixed(100 * share, digits) + " %"; }

/// One table cell, padded on the left to `width` columns.
std::string cell(const std::string& words, std::size_t width) {
    return std::string(width > words.size() ? width - words.size() : 0, ' ') + words;
}

std::string short_name(const std::string& name) { return printable(name, 60).substr(0, 8); }

/// A count with its noun: "1 stroke", "3 strokes".
std::string number_of(std::size_t count, std::string_view thing) {
    return text(count, " ", thing, count == 1 ? "" : "s");
}

/// Text with the number of trials from which the accuracy is computed. Strokes of gestures without templates
/// do not count.
std::string trials_text(const GestureReport& r) {
    const auto& trials = r.evaluation.trials;
    const auto known = static_cast<std::size_t>(
        std::count_if(trials.begin(), trials.end(), [](const auto& trial) { return trial.known; }));
    if (!r.evaluation.open_set) return number_of(known, "trial");
    return text(number_of(known, "trial"), " of known gestures; ", trials.size() - known, " of unknown ones");
}

/// Text that says how often a gesture is shown to the player before the stroke ends, and how often the shown
/// gesture is the right one.
std::string certainty_text(const gesture::Certainty& certainty) {
    if (!(certainty.told > 0)) return "in none of the trials";
    return text(share_text(certainty.told), " of the trials, of which ", share_text(certainty.right),
                " are right");
}

std::string confusion_text(const Evaluation& e) {
    std::string out = "\nconfusion (row: drawn, column: recognised)\n" + cell("", 9);
    for (const auto& name : e.gestures) out += cell(short_name(name), 9);
    out += cell("nothing", 9) + "\n";
    for (std::size_t g = 0; g < e.gestures.size(); ++g) {
        out += cell(short_name(e.gestures[g]), 9);
        for (const auto count : e.confusion[g]) out += cell(count > 0 ? text(count) : ".", 9);
        out += "\n";
    }
    return out;
}

std::string reliability_text(const Evaluation& e) {
    std::string out = "\nreliability\n  probability     strokes  mean probability     right\n";
    for (std::size_t b = 0; b < e.reliability.size(); ++b) {
        const auto& bin = e.reliability[b];
        out += text("  ", fixed(static_cast<double>(b) / 10, 1), " to ",
                    fixed(static_cast<double>(b + 1) / 10, 1), cell(text(bin.count), 13));
        out += bin.count > 0 ? cell(share_text(bin.confidence), 18) + cell(share_text(bin.right), 10) : "";
        out += "\n";
    }
    return out;
}

/// Data of the reliability diagram as JSON. Its keys are in alphabetical order.
Json reliability_json(const Evaluation& e) {
    auto bins = Json::array();
    for (std::size_t b = 0; b < e.reliability.size(); ++b) {
        const auto& bin = e.reliability[b];
        bins.push_back({{"from", static_cast<double>(b) / 10},
                        {"probability", bin.confidence},
                        {"right", bin.right},
                        {"strokes", bin.count},
                        {"to", static_cast<double>(b + 1) / 10}});
    }
    return bins;
}

/// Words escaped as the content of an XML element, at most 120 bytes.
std::string xml_text(std::string_view words) {
    std::string out;
    for (const char c : printable(words, 120)) {
        if (c == '&') {
            out += "&amp;";
        } else if (c == '<') {
            out += "&lt;";
        } else if (c == '>') {
            out += "&gt;";
        } else {
            out += c;
        }
    }
    return out;
}

std::string pixels(double value) { return fixed(value, 2); }

constexpr double margin = 90, square = 320, gap = 110, top = 60;

std::string words_at(double x, double y, std::string_view anchor, std::string_view words) {
    return text("<text x=\"", pixels(x), "\" y=\"", pixels(y), "\" text-anchor=\"", anchor, "\">",
                xml_text(words), "</text>\n");
}

std::string confusion_svg(const Evaluation& e) {
    const std::size_t count = e.gestures.size();
    const double side = square / static_cast<double>(count);
    std::string out;
    for (std::size_t r = 0; r < count; ++r) {
        std::size_t sum = 0;
        for (const auto n : e.confusion[r]) sum += n;
        out += words_at(margin - 4, top + side * (static_cast<double>(r) + 0.7), "end",
                        printable(e.gestures[r], 12));
        for (std::size_t c = 0; c < count; ++c) {
            const double share =
                sum > 0 ? static_cast<double>(e.confusion[r][c]) / static_cast<double>(sum) : 0;
            out += text("<rect x=\"", pixels(margin + side * static_cast<double>(c)), "\" y=\"",
                        pixels(top + side * static_cast<double>(r)), "\" width=\"", pixels(side),
                        "\" height=\"", pixels(side), "\" class=\"", r == c ? "right" : "wrong",
                        "\" fill-opacity=\"", fixed(share > 0 ? 0.15 + 0.85 * share : 0, 2), "\"><title>",
                        xml_text(text(e.gestures[r], " as ", e.gestures[c], ": ", e.confusion[r][c])),
                        "</title></rect>\n");
        }
    }
    return out + words_at(margin + square / 2, top - 10, "middle", "drawn (rows), recognised (columns)");
}

std::string reliability_svg(const Evaluation& e) {
    const double left = margin + square + gap, bottom = top + square;
    std::string out = text("<line x1=\"", pixels(left), "\" y1=\"", pixels(bottom), "\" x2=\"",
                           pixels(left + square), "\" y2=\"", pixels(top), "\"/>\n");
    out += text("<rect x=\"", pixels(left), "\" y=\"", pixels(top), "\" width=\"", pixels(square),
                "\" height=\"", pixels(square), "\" class=\"frame\"/>\n");
    for (const auto& bin : e.reliability) {
        if (bin.count == 0) continue;
        const double share = static_cast<double>(bin.count) / static_cast<double>(e.trials.size());
        out += text("<circle cx=\"", pixels(left + square * bin.confidence), "\" cy=\"",
                    pixels(bottom - square * bin.right), "\" r=\"", pixels(3 + 9 * std::sqrt(share)),
                    "\" class=\"right\"><title>", bin.count, " strokes, probability ",
                    share_text(bin.confidence), ", right ", share_text(bin.right), "</title></circle>\n");
    }
    out += words_at(left + square / 2, bottom + 20, "middle", "probability");
    out += words_at(left + square / 2, top - 10, "middle",
                    text("right answers; calibration error ", fixed(e.calibration_error, 4)));
    return out + words_at(left - 6, top + 5, "end", "1") + words_at(left - 6, bottom, "end", "0");
}

}  // namespace

std::string report_text(const GestureReport& r) {
    const auto& e = r.evaluation;
    std::string out =
        text(r.file, ": ", number_of(r.strokes, "stroke"), ", ", number_of(e.gestures.size(), "gesture"),
             ", ", number_of(r.users, "user"), "\nmethod ", r.method, ", protocol ", r.protocol, ", ",
             number_of(r.templates, "template"), " a gesture, ", number_of(r.repeats, "repeat"),
             ", channels ", r.channels, "\n\n");
    out += text("accuracy            ", share_text(e.accuracy), " of ", trials_text(r),
                r.at < 1 ? text(", from the first ", share_text(r.at, 0), " of each stroke") : "", "\n");
    if (r.certainty) out += text("told early          ", certainty_text(*r.certainty), "\n");
    out += text("time                ", fixed(r.median_us, 2), " us a recognition (p99 ", fixed(r.p99_us, 2),
                ")\n");
    out += text("calibration error   ", fixed(e.calibration_error, 4), " fitted to other groups\n");
    if (r.has_own_calibration)
        out += text("                    ", fixed(r.own_calibration_error, 4), " from the templates alone\n");
    if (e.open_set) {
        out += text("open set            ", share_text(e.open_set->correct_accepts), " correct accepts, ",
                    share_text(e.open_set->false_accepts), " false accepts, thresholds of other groups\n");
        out += text("                    ", share_text(e.open_set->best_correct_accepts),
                    " correct accepts at 1 % false accepts of the tested strokes\n");
    }
    return out + confusion_text(e) + reliability_text(e);
}

std::string report_json(const GestureReport& r) {
    const auto& e = r.evaluation;
    Json json{{"file", r.file},
              {"method", r.method},
              {"protocol", r.protocol},
              {"templates", r.templates},
              {"repeats", r.repeats},
              {"channels", r.channels},
              {"strokes", r.strokes},
              {"users", r.users},
              {"trials", e.trials.size()},
              {"accuracy", e.accuracy},
              {"us_per_recognition", {{"median", r.median_us}, {"p99", r.p99_us}}},
              {"calibration_error", e.calibration_error}};
    if (r.at < 1) json.set("at", r.at);
    if (r.certainty && r.certainty->told > 0)
        json.set("told_early", {{"right", r.certainty->right}, {"told", r.certainty->told}});
    if (r.certainty && !(r.certainty->told > 0)) json.set("told_early", {{"told", 0}});
    if (r.has_own_calibration) json.set("calibration_error_from_templates", r.own_calibration_error);
    if (e.open_set)
        json.set("open_set", {{"correct_accepts", e.open_set->correct_accepts},
                              {"false_accepts", e.open_set->false_accepts},
                              {"correct_accepts_at_one_percent", e.open_set->best_correct_accepts}});
    json.set("gestures", e.gestures);
    json.set("confusion", Json::array(std::vector<Json>(e.confusion.begin(), e.confusion.end())));
    json.set("reliability", reliability_json(e));
    return dump(json, 1) + "\n";
}

std::string report_svg(const GestureReport& r) {
    const double width = 2 * square + margin + gap + 40, height = square + top + 50;
    return text("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ", pixels(width), " ",
                pixels(height), "\" font-family=\"sans-serif\" font-size=\"11\">\n",
                "<style>svg{background:#fff}.right{fill:#1f6f8b}.wrong{fill:#c8402f}",
                ".frame{fill:none;stroke:#777}line{stroke:#777;stroke-dasharray:4}</style>\n") +
           words_at(margin, 20, "start",
                    text(r.method, ", ", r.protocol, ", ", number_of(r.templates, "template"), " a gesture: ",
                         share_text(r.evaluation.accuracy), " right, ", fixed(r.median_us, 2), " us")) +
           confusion_svg(r.evaluation) + reliability_svg(r.evaluation) + "</svg>\n";
}

}  // namespace thaum::game::inline app
