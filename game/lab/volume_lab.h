// game/lab/volume_lab.h: a volume to feel, examine and carve: `thaum lab VOLUME`, with or without a window.
//
//     VolumeLabInput (hand, tool, changed settings) -> step of 1 ms -> VolumeLab, VolumeLabFigures
//
// A scalar volume becomes a body of voxels, so a carved change is felt and drawn at once. A vector volume is
// a flow and cannot be carved. The hand holds a simulated device. Modes and walls act on its proxy, a point
// to which the device's tip is coupled by a spring.
//
// More volumes may be added, also at the same place. They are felt and seen, but not carved. Each volume has
// a place of its own that moves its feel and its picture together.
//
// A session is deterministic: the same inputs, from a person or a script, give the same bits. Frame: the
// device's, whose origin is the middle of the workspace. The volume's middle lies there, scaled so that it
// fits.
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

namespace thaum::game::inline lab {

/// Largest number of servo steps, each of which computes the force anew, in a tick of 1 ms. With this number
/// a step takes 0.2 ms.
inline constexpr int max_steps_per_tick = 5;

/// Ticks between two uses of a carving tool (dabs) while it is held.
inline constexpr Tick ticks_of_a_dab = 8;

struct LabMode {
    std::string name{};  ///< name of a mode, a way to feel a field, in haptics::modes()
    /// Number of the volume that the haptic mode reads: 0 is the first one, then the added ones.
    std::size_t volume{};
    std::vector<field::Filter> filters{};  ///< filters applied to the volume before the mode reads it
    haptics::ModeSettings settings{};
    bool operator==(const LabMode&) const = default;
};

/// Placement of a volume, relative to a volume that fills the workspace around its middle.
struct LabPlace {
    vec3 origin{};    ///< position of the volume's middle (m)
    double yaw{};     ///< rotation about the vertical axis (rad)
    double scale{1};  ///< factor on the volume's size, 0.05 to 20
    bool operator==(const LabPlace&) const = default;
};

inline constexpr double min_place_scale = 0.05, max_place_scale = 20;

/// Settings that can change during a session.
struct VolumeLabSettings {
    std::vector<LabMode> modes{};  ///< haptic modes (ways to feel a field) that act together
    /// parts of the force law (feel) by which the body as a whole is felt; empty: only the modes are felt
    std::vector<FeelPart> feel{};
    /// Opacity of the picture as a function of density; `feel` may use it.
    field::TransferFunction opacity{};
    /// Places of the first volume and of the added volumes. Volumes without a place are in the middle.
    std::vector<LabPlace> places{};
};

/// Materials, tools and devices that the lab has read from data files.
struct VolumeLabData {
    field::Materials materials;
    std::vector<field::Tool> tools;    ///< tools, sorted by name
    std::vector<std::string> devices;  ///< names of all device models, sorted
    haptics::DeviceSpec device;
};

/// Reads materials, tools and the device's model. The error names file, line and key.
Expected<VolumeLabData> load_volume_lab_data(const std::filesystem::path& assets, const std::string& device);

/// Reads a device model. The error names file, line and key.
Expected<haptics::DeviceSpec> load_lab_device(const std::filesystem::path& assets, const std::string& name);

/// The samples of a volume in the forms in which modes, filters and the body's feel read them.
struct LabSource {
    field::BlockAverages averages{};  ///< means of the densities over blocks of samples
    haptics::SmoothGrid density{};
    field::StaggeredGrid flow{};
    field::Placed<field::Scalar> placed_density{};  ///< density in the lab's frame
    BodyMaterials materials{};
};

/// The field that one haptic mode (a way to feel a field) reads: filters on a volume's samples, placed in the
/// lab. It keeps references to LabSource and to its own members.
struct LabField {
    field::FilteredField filtered{};
    field::PlacedField placed{};
};

/// A volume in addition to the first one.
struct VolumeBeside {
    field::Volume source{};
    field::SampleRange range{};  ///< range of the samples; for vectors, of their lengths
    double usual_level{};        ///< density that separates the body from its surroundings
    /// true: placed relative to the first volume as both files say, and moved together with it
    bool registered = false;
    field::Placement fitted{}, placement{};
    LabSource views{};
};

struct VolumeLab {
    field::Volume source{};  ///< the explored volume; a scalar one has its samples in `body` instead
    field::Voxels body{};    ///< body of voxels; empty for a vector volume
    field::CarvingHistory history{};
    field::SampleRange range{};  ///< range of the samples as read; for vectors, of their lengths
    double usual_level{};        ///< density that separates the body from its surroundings (field/volume.h)
    /// Placement in which the volume fills the workspace, before the person moves it.
    field::Placement fitted{};
    field::Placement placement{};  ///< present placement: `fitted`, moved and scaled as the person wants
    std::vector<std::unique_ptr<VolumeBeside>> beside{};
    VolumeLabData data{};
    VolumeLabSettings settings{};
    std::unique_ptr<LabSource> views = std::make_unique<LabSource>();
    std::vector<std::unique_ptr<LabField>> fields{};  ///< fields that the modes read, one for each mode, in
                                                      ///< the order of settings.modes
    /// law of the forces by which the body is felt, as settings.feel describes it
    haptics::VolumeFeel feel{};
    haptics::MaterialTable material_table{};

    haptics::SimulatedDevice device{};
    haptics::SimulatedState hand{};
    haptics::Servo servo{};
    haptics::ServoState servo_state{};
    haptics::HapticModel model{};
    int steps_per_tick = 1;  ///< servo steps (computations of the force) in a tick; set by set_servo_rate
    /// Positions of the device's tip at the last servo steps, newest first, if a tick has several steps (m).
    std::array<vec3, max_steps_per_tick> tips{};
    /// largest displacement at the device's tip by which the person has moved a volume since the last step
    /// (m)
    double moved{};
    Tick tick{};
    vec3 last_dab{};       ///< position of the tool at its last use (m)
    bool carving = false;  ///< true: the tool is held
    bool edited = false;   ///< true: the body was carved

    bool carvable() const { return source.components == 1; }
    double seconds() const { return thaum::seconds(tick); }
};

struct VolumeLabInput {
    vec3 target{};       ///< target position of the hand (m)
    bool carve = false;  ///< true: the tool is held
    std::size_t tool{};  ///< index into VolumeLab::data.tools
    int history = 0;     ///< step in the history of changes: -1 undo, 1 redo, 0 neither
    std::optional<VolumeLabSettings> change{};
};

/// Results of one step.
struct VolumeLabFigures {
    /// positions of the device's tip and its proxy, the point that modes and walls hold or lead (m); force on
    /// the hand (N)
    vec3 tip{}, proxy{}, force{};
    /// value of the volume where the hand feels it (at the proxy), without filters: density, or length of the
    /// vector
    double value{};
    field::Edit edit{};     ///< changes by the tool in this step
    std::string refused{};  ///< reason why a change of settings was rejected; empty: it was not
};

/// Makes a session. The error says what is wrong with the volume, such as too few samples along an axis.
Expected<VolumeLab> make_volume_lab(field::Volume volume, VolumeLabData data);

/// Computes the force `steps_per_tick` times in a tick, 1 to max_steps_per_tick. With several servo steps,
/// each one only reads the tip, lets the modes act, finds their balance and gives the force. The servo's
/// safety stage and its account of energy are left out, because they count in ticks of 1 ms. The force is
/// then limited only by the device's peak, and only the device, the hand and the drag of the body's feel damp
/// the motion. So this must only be used with a simulated device.
void set_servo_rate(VolumeLab& lab, int steps_per_tick);

/// Puts the hand at rest at a position of the workspace.
void rest_hand(VolumeLab& lab, vec3 place);

/// Replaces the device in the hand. The hand then rests at the top of the new workspace, which the volumes
/// fill. Body, history, clock and settings are kept.
void change_device(VolumeLab& lab, haptics::DeviceSpec device);

/// Adds a volume to the others. A registered one is placed relative to the first as both files say, at the
/// same scale. Any other fills the workspace around its middle, as the first one does. The error says what is
/// wrong, such as a file without a placement.
Expected<void> add_volume_beside(VolumeLab& lab, field::Volume volume, bool registered = false);

/// Maximum number of volumes added to the first one.
inline constexpr std::size_t max_volumes_beside = 7;

/// One volume of the lab, by its number.
struct VolumeRef {
    const field::Volume& source;
    field::SampleRange range{};
    double usual_level{};
    const field::Placement& placement;

    haptics::FieldKind kind() const {
        return source.components == 1 ? haptics::FieldKind::scalar : haptics::FieldKind::vector;
    }
    /// Smallest distance between samples (m, lab frame).
    double finest_spacing() const;
};
/// Volume by its number, which must exist: 0 to beside.size().
VolumeRef volume_of(const VolumeLab& lab, std::size_t number);

/// Kind of field (scalar or vector) of the first volume, without filters.
haptics::FieldKind kind_of(const VolumeLab& lab);

/// Density at a position in the lab's frame, or length of the vector there, without filters.
double value_at(const VolumeLab& lab, vec3 place);

/// A mode with strengths that suit the volume's range and the device. If `filters` is empty, a mode that
/// cannot read the volume directly gets the filter that it needs. For example, an isosurface in a flow is an
/// isosurface of the flow's speed. The error lists the existing modes.
Expected<LabMode> lab_mode(const VolumeLab& lab, const std::string& name,
                           std::vector<field::Filter> filters = {}, std::size_t volume = 0);

/// Changes filters, modes, feel and places. On error nothing changes. The error names an unsuitable filter,
/// or a mode that does not exist or cannot read the filters' result, or says that there are too many modes.
Expected<void> change_volume_lab(VolumeLab& lab, const VolumeLabSettings& settings);

/// Computes one step of 1 ms.
VolumeLabFigures step_volume_lab(VolumeLab& lab, const VolumeLabInput& input);

/// The volume in its present state, for saving: densities as floats if it was edited, otherwise as read.
field::Volume volume_now(const VolumeLab& lab);

/// Hash of the state of body, hand and servo (the computation of the force).
std::uint64_t lab_hash(const VolumeLab& lab);

}  // namespace thaum::game::inline lab
