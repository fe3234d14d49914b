// tools/bench/areas.h: the areas (groups of benchmarks), each in a file of its own.
#pragma once
#include "tools/bench/bench.h"

namespace thaum::bench {

void audio(const Options& options, Report& report);
void ecs(const Options& options, Report& report);
void tick(const Options& options, Report& report);
/// The next three are parts of the area (group of benchmarks) `tick`: memory that ticks allocate, time of the
/// bots, and a duel with sound and tactile output.
void tick_allocations(const Options& options, Report& report);
void tick_bots(const Options& options, Report& report);
void tick_duel_felt(const Options& options, Report& report);
void physics(const Options& options, Report& report);
void primitives(const Options& options, Report& report);
void replay(const Options& options, Report& report);
/// Stress test of the area (group of benchmarks) `tick`.
void soak(const Options& options, Report& report);
void skip(const Options& options, Report& report);
/// Part of the area (group of benchmarks) `skip`: cost of sound and jackets that are not used.
void skip_senses(const Options& options, Report& report);
/// Part of the area (group of benchmarks) `skip`: cost of a scan out of view.
void skip_scan(const Options& options, Report& report);
/// Area (group of benchmarks) `coupling`: virtual coupling, alone and with Bullet.
void coupling(const Options& options, Report& report);
void wand_coupling(const Options& options, Report& report);
void haptics(const Options& options, Report& report);
/// The next two are parts of the area (group of benchmarks) `haptics`.
void surfaces(const Options& options, Report& report);
void round_bodies(const Options& options, Report& report);
/// Part of the area (group of benchmarks) `haptics`: haptic modes, and surfaces of scanned volumes.
void modes(const Options& options, Report& report);
void modes_hostile(const Options& options, Report& report);
void servo_rates(const Options& options, Report& report);
/// Stress test of the area (group of benchmarks) `haptics`.
void haptics_stress(const Options& options, Report& report);
void passivity(Report& report);
void switches(const Options& options, Report& report);
void arms(const Options& options, Report& report);
void stirring_passivity(const Options& options, Report& report);
void field(const Options& options, Report& report);
/// Part of the area (group of benchmarks) `field`: reading volumes between their samples.
void field_samples(const Options& options, Report& report);
/// Reads files of samples; part of the area `field`.
void volume_files(const Options& options, Report& report);
/// Part of the area (group of benchmarks) `field`: edits of voxels.
void carving(const Options& options, Report& report);
/// Area (group of benchmarks) `surface`: surface of the brew in the cauldron.
void surface(const Options& options, Report& report);
void tactile_mixer(const Options& options, Report& report);
/// Area (group of benchmarks) `gesture`: recognition of gestures, isolated and in continuous motion.
void gestures(const Options& options, Report& report);
void render(const Options& options, Report& report);
/// The next two are parts of the area (group of benchmarks) `render`.
void brew_pictures(const Options& options, Report& report);
void scan_pictures(const Options& options, Report& report);
void fluid(const Options& options, Report& report);
/// Part of the area (group of benchmarks) `fluid`: a hand in the fluid.
void fluid_hand(const Options& options, Report& report);
/// Part of the area (group of benchmarks) `fluid`: steps that two threads share.
void fluid_team(const Options& options, Report& report);
/// Part of the area (group of benchmarks) `fluid`: curved walls, and layers of viscosity.
void fluid_walls(const Options& options, Report& report);
/// Long stress test of the area (group of benchmarks) `fluid`.
void fluid_stress(const Options& options, Report& report);

}  // namespace thaum::bench
