// game/lab/volume_session.h: the settings of a session in the volume lab, as a TOML file.
//
//     version = 1
//     volume = "head.nrrd"              as on the command line; a relative path is relative to this file
//     count = 64                        samples along each axis of a generated volume; `seed` is its seed
//     moment = 1                        time step of a file with several; may be left out
//     place = [0, 0, 0, 1, 0]           middle (m), scale, turn about the vertical axis (degrees)
//     [[beside]]                        an added volume, with volume, count, seed and place; none or more
//     volume = "vortices"
//     registered = false                true: added volumes lie relative to the first one as the files say
//     device = "touch"
//     look = "surface"                  how the picture shows the volume; or "translucent"
//     level = 500.0                     density at which the picture draws the surface
//     opacity = [0, 0, 1000, 0.3]       points x, y, ... of the picture's opacity as a function of density
//     view = [29, 23, 1.6, 0, 0, 0]     camera: azimuth, elevation (degrees), distance (diagonals), aim (m)
//     [[feel]]                          a part of the body's feel (game/lab/body_feel.h); none or more
//     kind = "wall"
//     numbers = [500, 0.8, 0.2]
//     [[mode]]
//     name = "isosurface"
//     reads = 0                         volume that the mode reads; 0: the first one, 1: the first added one
//     strength = [0, 0.7]               points x, y, ... of the strength (N); `friction` is written likewise
//     level = 500.0
//     solid_below = false
//     magnet = 0.0                      strength that holds a tip near the surface (N)
//     reach_m = 0.002
//     pitch_m = 0.01
//     [[mode.filter]]                   a filter between the volume and this mode; none or more
//     kind = "smooth"                   a name of field::filter_names(); a and b are its parameters
//     a = 1.0
//     b = 0.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "field/transfer.h"
#include "game/lab/volume_lab.h"

namespace thaum::game::inline lab {

/// A volume of a session, and its placement.
struct SessionVolume {
    std::string volume{};     ///< path of a file, or name of a generated volume
    std::int64_t count = 64;  ///< number of samples along each axis of a generated volume
    std::int64_t seed = 1;    ///< seed of a generated volume
    LabPlace place{};
    std::int64_t moment = 1;  ///< number of the time step in a file with several, from 1 on
};

/// Position of the camera (game/lab/window/volume_lab_picture.h).
struct SessionView {
    double yaw{}, pitch{};  ///< azimuth and elevation of the camera (rad)
    double away{1};         ///< distance of the camera, in lengths of the volume's diagonal
    vec3 aim{};             ///< point shown in the middle of the picture (m)
};

struct VolumeSession {
    SessionVolume first{};
    std::vector<SessionVolume> beside{};
    /// true: the added volumes are placed relative to the first one as the files of both say.
    bool registered = false;
    std::string device = "touch";
    bool translucent = false;
    double level{};
    field::TransferFunction opacity{};
    std::optional<SessionView> view{};  ///< position of the camera; std::nullopt: the usual one
    std::vector<FeelPart> feel{};
    std::vector<LabMode> modes{};
};

std::string session_text(const VolumeSession& session);
/// Reads a session. The error names file, line and key.
Expected<VolumeSession> read_session(const Config& file);

Expected<void> save_session(const VolumeSession& session, const std::filesystem::path& file);
/// Reads a session from a file. Relative paths of volumes, which are relative to that file, become relative
/// to the working directory.
Expected<VolumeSession> load_session(const std::filesystem::path& file);

}  // namespace thaum::game::inline lab
