// Fuzzes the readers of strokes and gestures. Whatever is accepted must be recognised without a fault.
#include <cmath>

#include "core/gzip.h"
#include "core/text.h"
#include "fuzz/fuzz.h"
#include "game/match/own_gestures.h"
#include "gesture/gesture_file.h"
#include "gesture/recogniser.h"
#include "gesture/stroke_csv.h"
#include "gesture/trials/stroke_networks.h"

namespace thaum::fuzz {
namespace {

using gesture::Gesture;
using gesture::StrokePoint;

/// A stroke along an arc of the given angle (rad), with a force.
std::vector<StrokePoint> arc(double angle) {
    std::vector<StrokePoint> points;
    for (int i = 0; i < 40; ++i) {
        const double a = angle * i / 39;
        points.push_back({0.02 * i, {det::cos(a), det::sin(a), 0.1 * a}, 1 + 0.1 * a});
    }
    return points;
}

/// Fault that occurs when recognising a stroke; empty: none.
std::string fault_of(const std::vector<StrokePoint>& stroke) {
    const std::vector<Gesture> gestures{{"arc", {}, {arc(3)}}, {"circle", {.closed = true}, {arc(2 * pi)}}};
    static const auto recogniser = gesture::Recogniser::make(gestures);
    static gesture::RecogniserSpace space;
    const auto r = recogniser->recognise(stroke, space);
    if (!(r.probability >= 0 && r.probability <= 1)) return text("a probability of ", r.probability);
    if (!std::isfinite(r.distance)) return "a distance that is not finite";
    for (const double out : gesture::direction_input(stroke)) {
        if (!std::isfinite(out)) return "a direction that is not finite";
    }
    return "";
}

Outcome read_stroke_file(const std::string& input, const Places&) {
    const auto set = gesture::read_strokes(input, "strokes.csv");
    if (!set) return {.refusal = set.error().message};
    for (const auto& stroke : set->strokes) {
        if (auto fault = fault_of(stroke.points); !fault.empty()) return {.fault = fault};
    }
    const auto again = gesture::read_strokes(gesture::to_csv(set->strokes), "again.csv");
    if (!again) return {.fault = again.error().message};
    if (again->strokes.size() != set->strokes.size())
        return {.fault = "other strokes after writing and reading"};
    return {.accepted = true};
}

Outcome read_gesture_file(const std::string& input, const Places&) {
    const auto config = Config::parse(input, "gesture.toml", gesture::gesture_file_version);
    if (!config) return {.refusal = config.error().message};
    const auto read = gesture::read_gesture(*config);
    if (!read) return {.refusal = read.error().message};
    const auto made = gesture::Recogniser::make(std::span(&*read, 1));
    if (!made) return {.refusal = made.error().message};
    gesture::RecogniserSpace space;
    const auto r = made->recognise(read->strokes[0], space);
    if (!(r.probability >= 0 && r.probability <= 1))
        return {.fault = text("a probability of ", r.probability)};
    return {.accepted = true};
}

Outcome read_gzip(const std::string& input, const Places&) {
    const auto bytes = std::as_bytes(std::span(input.data(), input.size()));
    const auto unpacked = unpack_gzip(bytes, 1U << 16U);
    if (!unpacked) return {.refusal = unpacked.error().message};
    return {.accepted = true};
}

std::vector<std::string> stroke_seeds(const Places&) {
    return {
        gesture::to_csv(std::vector<gesture::Stroke>{{"u", "arc", "0", arc(2)}, {"v", "arc", "1", arc(3)}}),
        "user,gesture,sample,t,x,y\n1,o,0,0,1,2\n1,o,0,0.5,3,4\n1,v,0,0,5,6\n"};
}

std::vector<std::string> gesture_seeds(const Places&) {
    return {gesture::to_file({"arc", {.rotation = 0.3, .planar = true}, {arc(2), arc(2.5)}}),
            gesture::to_file({"circle", {.direction_sensitive = false, .closed = true}, {arc(2 * pi)}})};
}

/// Recorded gestures of two players, as they are written in the header of a match's log: a line with the
/// name, then the text of a gesture. If they are accepted, a match with them must be able to read a stroke.
Outcome read_profile(const std::string& input, const Places& places) {
    static const auto data = game::load_match_data(places.assets, {});
    if (!data) return {.fault = data.error().message};
    const auto end = input.find('\n');
    const auto name = input.substr(0, end), toml = end == std::string::npos ? "" : input.substr(end + 1);
    const auto bytes = std::as_bytes(std::span(toml));
    game::MatchSetup setup;
    for (const std::uint32_t player : {0U, 1U}) {
        const auto used = game::use_profile(*data,
                                            {{.kind = std::string(game::gesture_kind),
                                              .name = name,
                                              .player = player,
                                              .bytes = {bytes.begin(), bytes.end()}}},
                                            setup);
        if (!used) return {.refusal = used.error().message};
    }
    static gesture::RecogniserSpace space;
    const auto r = setup.gestures[1]->recogniser().recognise(arc(3), space);
    if (!(r.probability >= 0 && r.probability <= 1))
        return {.fault = text("a probability of ", r.probability)};
    return {.accepted = true};
}

std::vector<std::string> profile_seeds(const Places&) {
    return {"v\n" + gesture::to_file({"v", {.rotation = 0.3}, {arc(2), arc(2.5)}}),
            "circle\n" + gesture::to_file({"circle", {.closed = true}, {arc(2 * pi)}})};
}

/// Seed: the text "strokes, strokes, strokes", compressed by gzip.
std::vector<std::string> gzip_seeds(const Places&) {
    static constexpr unsigned char words[] = {
        0x1f, 0x8b, 0x08, 0x00, 0x00, 0x00, 0x00, 0x00, 0x02, 0xff, 0x2b, 0x2e, 0x29, 0xca, 0xcf, 0x4e,
        0x2d, 0xd6, 0x51, 0x28, 0x46, 0x63, 0x00, 0x00, 0x0d, 0x04, 0xfc, 0x21, 0x19, 0x00, 0x00, 0x00};
    return {std::string(reinterpret_cast<const char*>(words), sizeof words)};
}

}  // namespace

const Reader stroke_reader{"strokes", stroke_seeds, mutate_text, read_stroke_file};
const Reader gesture_reader{"gesture", gesture_seeds, mutate_text, read_gesture_file};
const Reader profile_reader{"profile", profile_seeds, mutate_text, read_profile};
const Reader gzip_reader{"gzip", gzip_seeds, mutate_bytes, read_gzip};

}  // namespace thaum::fuzz
