// game/lab/volume_lab.h: a volume alone, to feel, read and carve: `thaum lab VOLUME`, with or without a window.
//
//     VolumeLabInput (hand, tool, changed settings) -> step of 1 ms -> VolumeLab, VolumeLabFigures
//
// A scalar volume becomes a body of voxels, so what is carved is at once what is felt and drawn. A vector volume is
// a flow and can only be read. The hand holds a simulated device, and the modes' primitives act on its proxy.
//
// More volumes may lie beside the first one, also within it. They are felt and seen, but not carved. Each volume has a
// place of its own that moves its feel and its picture together.
//
// A deterministic session: the same inputs give the same bits, from a person or a script. Frame: the device's, whose
// origin is the middle of the workspace. The volume's middle lies there, scaled so that it fits.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/units.h"
#include "field/block_averages.h"
#include "field/carving_history.h"
#include "field/carving_tools.h"
#include "field/filters.h"
#include "field/materials.h"
#include "field/volume.h"
#include "field/voxels.h"
#include "game/lab/body_feel.h"
#include "haptics/device.h"
#include "haptics/modes.h"
#include "haptics/servo.h"
#include "haptics/simulated.h"
#include "haptics/volume/smooth_grid.h"

namespace thaum::game {

/// Largest number of servo steps in a tick: 0.2 ms each.
inline constexpr int most_steps_per_tick = 5;

/// Ticks from one use of a tool to the next while it is held.
inline constexpr Tick ticks_of_a_dab = 8;

struct LabMode {
    std::string name{};                    ///< name of one of haptics::modes()
    std::size_t volume{};                  ///< volume that it reads: 0 is the first one, then those beside it
    std::vector<field::Filter> filters{};  ///< between the data and this mode
    haptics::ModeSettings settings{};
    bool operator==(const LabMode&) const = default;
};

/// Place of a volume, relative to one that fills the workspace about its middle.
struct LabPlace {
    vec3 origin{};    ///< place of the volume's middle (m)
    double yaw{};     ///< turn about the upright axis (rad)
    double scale{1};  ///< 0.05 to 20
    bool operator==(const LabPlace&) const = default;
};

inline constexpr double least_place_scale = 0.05, most_place_scale = 20;

/// Settings that can change during a session.
struct VolumeLabSettings {
    std::vector<LabMode> modes{};       ///< modes that act together
    std::vector<FeelPart> feel{};       ///< feel of the body as a whole; none: it is not felt so
    field::TransferFunction opacity{};  ///< opacity of the picture by the density, by which the feel goes
    std::vector<LabPlace>
        places{};  ///< places of the first volume and of those beside it; missing ones lie in the middle
};

/// Data files that the lab uses.
struct VolumeLabData {
    field::Materials materials;
    std::vector<field::Tool> tools;    ///< sorted by name
    std::vector<std::string> devices;  ///< names of all models, sorted
    haptics::DeviceSpec device;
};

/// Reads materials, tools and the device's model. The error names file, line and key.
Expected<VolumeLabData> load_volume_lab_data(const std::filesystem::path& assets, const std::string& device);

/// Reads the model of a device. The error names file, line and key.
Expected<haptics::DeviceSpec> load_lab_device(const std::filesystem::path& assets, const std::string& name);

/// Views of the samples.
struct LabSource {
    field::BlockAverages averages{};  ///< of the densities
    haptics::SmoothGrid density{};
    field::StaggeredGrid flow{};
    field::Placed<field::Scalar> placed_density{};  ///< in the lab's frame, as the next
    BodyMaterials materials{};
};

/// What one mode reads: filters behind a volume's samples, placed in the lab. It refers to LabSource and to itself.
struct LabField {
    field::FilteredField filtered{};
    field::PlacedField placed{};
};

/// A volume beside the first one.
struct VolumeBeside {
    field::Volume source{};
    field::SampleRange range{};  ///< as VolumeLab::range
    double usual_level{};        ///< as VolumeLab::usual_level
    /// It lies to the first volume as their files say, and goes with that one's place.
    bool registered = false;
    field::Placement fitted{}, placement{};
    LabSource views{};
};

struct VolumeLab {
    field::Volume
        source{};  ///< what is explored; a scalar one has no samples here, they are the body's densities
    field::Voxels body{};  ///< empty for a vector volume
    field::CarvingHistory history{};
    field::SampleRange range{};    ///< range of the samples as read; for vectors: of their lengths
    double usual_level{};          ///< level that tells the body from what is around it (field/volume.h)
    field::Placement fitted{};     ///< fills the workspace
    field::Placement placement{};  ///< present place
    std::vector<std::unique_ptr<VolumeBeside>> beside{};
    VolumeLabData data{};
    VolumeLabSettings settings{};
    std::unique_ptr<LabSource> views = std::make_unique<LabSource>();
    std::vector<std::unique_ptr<LabField>> fields{};  ///< one per mode
    haptics::VolumeFeel feel{};                       ///< what settings.feel says
    haptics::MaterialTable material_table{};

    haptics::SimulatedDevice device{};
    haptics::SimulatedState hand{};
    haptics::Servo servo{};
    haptics::ServoState servo_state{};
    haptics::HapticModel model{};
    int steps_per_tick = 1;  ///< servo steps in a tick; set by set_servo_rate
    /// Places of the tip at the last steps, if there are several in a tick; the newest one first (m).
    std::array<vec3, most_steps_per_tick> tips{};
    double moved{};  ///< longest way of a volume at the tip since the last step (m)
    Tick tick{};
    vec3 last_dab{};       ///< place of the tool at its last use (m)
    bool carving = false;  ///< the tool is held
    bool edited = false;   ///< the body was carved

    bool carvable() const { return source.components == 1; }
    double seconds() const { return thaum::seconds(tick); }
};

struct VolumeLabInput {
    vec3 target{};       ///< where the hand wants to be (m)
    bool carve = false;  ///< the tool is held
    std::size_t tool{};  ///< index into VolumeLab::data.tools
    int history = 0;     ///< -1: undo, 1: redo
    std::optional<VolumeLabSettings> change{};
};

/// Results of one step.
struct VolumeLabFigures {
    vec3 tip{}, proxy{}, force{};  ///< m, m, N
    double value{};         ///< at the proxy, without filters: the density, or the length of the vector
    field::Edit edit{};     ///< changes by this step's use of the tool
    std::string refused{};  ///< reason why a change of settings was rejected; empty: none
};

/// Makes a session. The error says what is wrong with the volume, such as too few samples along an axis.
Expected<VolumeLab> make_volume_lab(field::Volume volume, VolumeLabData data);

/// Lets the servo step more often than once in a tick, from 1 to most_steps_per_tick times. More than one step is the pure
/// one, tip -> modes -> balance -> force: the servo's safety stage and observer count in ticks of 1 ms. The force ends at
/// the device's peak, and no damping acts but that of device and hand. So it is for a simulated device alone.
void set_servo_rate(VolumeLab& lab, int steps_per_tick);

/// Puts the hand at rest at a place of the workspace.
void rest_hand(VolumeLab& lab, vec3 place);

/// Puts another device into the hand, which then rests at the top of the workspace. Body, history, clock and settings
/// stay; the volumes fill the new workspace.
void change_device(VolumeLab& lab, haptics::DeviceSpec device);

/// Adds a volume beside the others. A registered one lies to the first one as their files say, at the same scale;
/// otherwise it fills the workspace about its middle, as the first one does. The error says what is wrong with it, such
/// as a file without a place.
Expected<void> add_volume_beside(VolumeLab& lab, field::Volume volume, bool registered = false);

/// Largest number of volumes beside the first one.
inline constexpr std::size_t most_volumes_beside = 7;

/// One volume of the lab, by its number.
struct VolumeRef {
    const field::Volume& source;
    field::SampleRange range{};
    double usual_level{};
    const field::Placement& placement;

    haptics::FieldKind kind() const {
        return source.components == 1 ? haptics::FieldKind::scalar : haptics::FieldKind::vector;
    }
    /// Smallest distance between samples, in the lab's frame (m).
    double finest_spacing() const;
};
/// The number must be that of a volume: 0 to beside.size().
VolumeRef volume_of(const VolumeLab& lab, std::size_t number);

/// Kind of the first volume's own field.
haptics::FieldKind kind_of(const VolumeLab& lab);

/// Density at a place of the lab, or length of the vector there, without filters.
double value_at(const VolumeLab& lab, vec3 place);

/// Mode with strengths that suit the volume's range and the device. Without filters, a mode that does not read such a
/// volume gets the filter through which it does: an isosurface of a flow is one of its speed. The error lists the modes
/// that there are.
Expected<LabMode> lab_mode(const VolumeLab& lab, const std::string& name,
                           std::vector<field::Filter> filters = {}, std::size_t volume = 0);

/// Changes filters, modes, feel and places. The error names a filter that does not fit, a mode that does not exist or does not read
/// what the filters give, or says that there is no room for all modes; then nothing changes.
Expected<void> change_volume_lab(VolumeLab& lab, const VolumeLabSettings& settings);

/// Computes one step of 1 ms.
VolumeLabFigures step_volume_lab(VolumeLab& lab, const VolumeLabInput& input);

/// The volume as it is now, for saving: densities as floats after an edit, otherwise as they were read.
field::Volume volume_now(const VolumeLab& lab);

/// Hash of the state: body, hand and servo.
std::uint64_t lab_hash(const VolumeLab& lab);

}  // namespace thaum::game
