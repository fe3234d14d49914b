#include "game/lab/volume_trace.h"

#include "core/text.h"

namespace thaum::game::inline lab {

std::string volume_trace_header() {
    return "time_s,tip_x_m,tip_y_m,tip_z_m,proxy_x_m,proxy_y_m,proxy_z_m,force_x_n,force_y_n,force_z_n,value,"
           "changed_voxels,hand_x_m,hand_y_m,hand_z_m,tool,history\n";
}

void append_volume_row(const VolumeLab& lab, const VolumeLabInput& input, const VolumeLabFigures& f,
                       std::string& rows) {
    const vec3 hand = input.target;
    rows += text(lab.seconds(), ',', f.tip.x, ',', f.tip.y, ',', f.tip.z, ',', f.proxy.x, ',', f.proxy.y, ',',
                 f.proxy.z, ',', f.force.x, ',', f.force.y, ',', f.force.z, ',', f.value, ',', f.edit.voxels,
                 ',', hand.x, ',', hand.y, ',', hand.z, ',', input.carve ? input.tool + 1 : 0, ',',
                 input.history, '\n');
}

}  // namespace thaum::game::inline lab
