thaum_test(test_render
    SOURCES accuracy/render_occlusion_test.cpp accuracy/render_perceptual_test.cpp accuracy/render_scan_accuracy_test.cpp unit/render_detail_test.cpp unit/render_mesh_test.cpp unit/render_patches_test.cpp unit/render_quality_test.cpp unit/render_overlay_test.cpp unit/render_picture_test.cpp
        unit/render_ribbons_test.cpp unit/render_scan_test.cpp unit/render_volume_test.cpp unit/render_window_test.cpp
    LINK thaum_render_audit)
