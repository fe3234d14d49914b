// gesture/stroke_csv.h: reads strokes, sessions and labels from CSV text.
//
//     strokes    user,gesture,sample,t,x,y[,z][,force]   one row a point; rows of equal user, gesture and
//                                                        sample are one stroke
//     sessions   user,t,x,y[,z][,force]                  continuous motion of each user
//     labels     user,gesture,t_start,t_end              gestures within the sessions
//
// The form of tables is that of core/table.h; columns with other titles are ignored. Times are in seconds and
// must not run backwards within a stroke or session.
#pragma once
#include <string_view>
#include <vector>

#include "core/error.h"
#include "gesture/stroke.h"

namespace thaum::gesture {

inline constexpr std::size_t max_csv_points = 20'000'000;
inline constexpr std::size_t max_csv_strokes = 200'000;

/// Strokes of one file.
struct StrokeSet {
    std::vector<Stroke> strokes;
    bool has_depth = false;  ///< true if some z differs from zero
    bool has_force = false;  ///< true if some force differs from zero
};

/// Continuous motion of one user.
struct Session {
    std::string user;
    std::vector<StrokePoint> points;
};

/// The sessions (continuous motion of one user each) of one file.
struct SessionSet {
    std::vector<Session> sessions;
    bool has_depth = false;
    bool has_force = false;
};

/// A label: within a session (continuous motion), the user meant this part as a stroke of a gesture.
struct SessionLabel {
    std::string user;
    std::string gesture;
    double start{};  ///< time at which the labelled gesture begins (s)
    double end{};    ///< time at which the labelled gesture ends (s)
};

/// @{
/// Reads strokes, sessions or labels of sessions from the text of a file. `name` is the file's name for
/// errors. The error names file, line and fault.
Expected<StrokeSet> read_strokes(std::string_view csv, std::string_view name);
Expected<SessionSet> read_sessions(std::string_view csv, std::string_view name);
Expected<std::vector<SessionLabel>> read_labels(std::string_view csv, std::string_view name);
/// @}

/// CSV text from which read_strokes reads the same strokes.
std::string to_csv(std::span<const Stroke> strokes);

}  // namespace thaum::gesture
